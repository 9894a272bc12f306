"""Domains of the parameters (u, v) of a mesh surface, and the images of a control plane.

A domain is the plane divided by a group of motions x -> sign x + shift:

    plane      only the identity               sheets, whatever has one rim
    cylinder   (u + m, v)                      two rims
    torus      (u + m, v + H n)                one handle
    pillow     +-(u, v) + (2 W m, n)           closed without handles: a flat sphere with four
                                               cone points (0, 0), (0, 1/2), (W, 1/2), (W, 0)

A control plane counts at every image of its center. The image by (sign, shift) has at x the value
that the plane itself has at sign (x - shift): so places are moved to the plane, and the gradients
by x get the sign.
"""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from math import ceil, inf, isfinite
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

Signs = NDArray[np.float64]
"""Each 1 or -1."""


class Images(NamedTuple):
    """Motions x -> sign x + shift of a domain's group."""

    shifts: Floats
    """(k, 2)"""
    signs: Signs
    """(k,)"""


class Reduced(NamedTuple):
    """Places moved into the domain's cell: place = sign * reduced + shift for some shift."""

    places: Floats
    """(m, 2)"""
    signs: Signs
    """(m,) what derivatives at the reduced places are to be multiplied by"""


@dataclass(frozen=True)
class Domain:
    """What the domains have in common. Those of equal numbers are equal."""

    kind: ClassVar[str]
    """as in files"""

    def __post_init__(self) -> None:
        for name, value in self.sizes.items():
            if not (isfinite(value) and value > 0.0):
                raise ValueError(f"{name}: must be positive and finite, got {value}")

    @property
    def sizes(self) -> dict[str, float]:
        """The numbers that belong to the kind, by their names in files."""
        return asdict(self)

    @property
    def periods(self) -> tuple[float, float]:
        """By u and by v; infinite where nothing repeats."""
        return inf, inf

    @property
    def cell(self) -> tuple[float, float]:
        """How far the cell reaches from (0, 0) by u and by v; infinite where nothing repeats."""
        return self.periods

    @property
    def turns(self) -> bool:
        """Whether some images have the sign -1."""
        return False

    def images(self, reach: float, reach_v: float | None = None) -> Images:
        """All images of a `shifted` center that may lie within `reach` of a place in the cell.

        `reach` is the distance by u and, unless another is given, by v. The first image is the
        identity.
        """
        reaches = reach, reach if reach_v is None else reach_v
        shifts = _shifts(self.periods, reaches, more=0)
        signs = np.ones(len(shifts))
        if self.turns:
            # The sum of two places in the cell, not their difference, is what a shift is to match.
            turned = _shifts(self.periods, reaches, more=1)
            shifts = np.concatenate([shifts, turned])
            signs = np.concatenate([signs, -np.ones(len(turned))])
        return Images(shifts, signs)

    def reduced(self, places: Floats) -> Floats:
        """(m, 2) the places' images in the cell."""
        return self.reduction(places).places

    def reduction(self, places: Floats) -> Reduced:
        """The same, with the signs of the motions."""
        moved = self.shifted(places)
        return Reduced(moved, np.ones(len(moved)))

    def shifted(self, places: Floats) -> Floats:
        """(m, 2) the places moved by whole periods to between zero and the periods.

        What belongs to the places, as gradients do, stays as it is; in a pillow half of them are
        not in the cell.
        """
        moved = np.array(places, dtype=np.float64).reshape(-1, 2)
        for axis, period in enumerate(self.periods):
            if period < inf:
                moved[:, axis] = np.mod(moved[:, axis], period)
                # A place just below zero is rounded up to the whole period.
                moved[moved[:, axis] >= period, axis] = 0.0
        return moved

    def nearest(self, places: Floats, to: Floats) -> Floats:
        """(m, 2) of every place the image nearest to its own of the places `to`; the given one
        where another is not nearer."""
        away = places - to
        moved = np.array(places, dtype=np.float64)
        for axis, period in enumerate(self.periods):
            if period < inf:
                moved[:, axis] -= period * np.ceil(away[:, axis] / period - 0.5)
        if self.turns:
            turned = Domain.nearest(_Translations(self.periods), -places, to)
            first, second = (((row - to) ** 2).sum(axis=1) for row in (moved, turned))
            moved = np.where((second < first)[:, None], turned, moved)
        return moved


@dataclass(frozen=True)
class PlaneDomain(Domain):
    """Nothing repeats."""

    kind = "plane"


@dataclass(frozen=True)
class CylinderDomain(Domain):
    """u repeats after 1."""

    kind = "cylinder"

    @property
    def periods(self) -> tuple[float, float]:
        return 1.0, inf


@dataclass(frozen=True)
class TorusDomain(Domain):
    """u repeats after 1, v after the height."""

    height: float = 1.0
    kind = "torus"

    @property
    def periods(self) -> tuple[float, float]:
        return 1.0, self.height


@dataclass(frozen=True)
class PillowDomain(Domain):
    """The cell is [0, 2 width] x [0, 1/2]; its rims are sewn up by turning about cone points."""

    width: float = 1.0
    kind = "pillow"

    @property
    def periods(self) -> tuple[float, float]:
        return 2.0 * self.width, 1.0

    @property
    def cell(self) -> tuple[float, float]:
        return 2.0 * self.width, 0.5

    @property
    def cone_points(self) -> Floats:
        """(4, 2) in the order of the chain that the pillow is laid out along."""
        width = self.width
        return np.array([[0.0, 0.0], [0.0, 0.5], [width, 0.5], [width, 0.0]])

    @property
    def turns(self) -> bool:
        return True

    def reduction(self, places: Floats) -> Reduced:
        moved, signs = self.shifted(places), np.ones(len(places))
        u, v = moved.T
        # Of the two images that every place of the rims v = 0 and v = 1/2 has, always the same.
        other = (v > 0.5) | (((v == 0.5) | (v == 0.0)) & (u > self.width))
        signs[other] = -1.0
        moved[other] = self.shifted(-moved[other])
        return Reduced(moved, signs)


@dataclass(frozen=True)
class _Translations(Domain):
    """Only the translations of a domain."""

    by: tuple[float, float]

    @property
    def sizes(self) -> dict[str, float]:
        return {}

    @property
    def periods(self) -> tuple[float, float]:
        return self.by


DOMAINS: Mapping[str, type[Domain]] = {
    each.kind: each for each in (PlaneDomain, CylinderDomain, TorusDomain, PillowDomain)
}


def domain_of(kind: str, sizes: Mapping[str, float]) -> Domain:
    """The domain of that kind; ValueError for another kind or other sizes than it has."""
    if kind not in DOMAINS:
        raise ValueError(f"domain: {kind!r} is none of {', '.join(map(repr, DOMAINS))}")
    wanted = {field.name for field in fields(DOMAINS[kind])}
    if set(sizes) != wanted:
        expected = f"the keys {sorted(wanted)}" if wanted else "no other keys"
        raise ValueError(f"domain: a {kind} has {expected}, got {sorted(sizes)}")
    return DOMAINS[kind](**{name: float(value) for name, value in sizes.items()})


def _shifts(periods: tuple[float, float], reaches: tuple[float, float], *, more: int) -> Floats:
    """(k, 2) multiples of the periods by which places in a cell, give or take the reaches, may
    differ, and so many more; the least first."""
    steps = []
    for period, reach in zip(periods, reaches, strict=True):
        most = ceil(reach / period)
        numbers = np.arange(-most, most + 1 + (more if period < inf else 0), dtype=np.float64)
        numbers = numbers[np.argsort(np.abs(numbers), kind="stable")]
        steps.append(period * numbers if period < inf else np.zeros(1))
    return np.stack(np.meshgrid(*steps, indexing="ij"), axis=-1).reshape(-1, 2)
