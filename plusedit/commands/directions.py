"""Edits of directions, on any number of control lines and planes of any shapes.

What is turned, stretched or set becomes given: it follows its neighbours no longer until it is
reset. Of a control plane both directions are meant, or the one that `side` names.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np

from plusedit.commands.base import (
    Command,
    Landing,
    NetCommand,
    Side,
    Targets,
    edit_nets,
    fitted,
    ways_of,
)
from plusedit.document.design import Design
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.net import ControlNet

Plane = tuple[int, int]
"""Two axes: a positive angle turns from the first to the second."""

TOP: Plane = (0, 1)


def redirected(
    design: Design,
    targets: Targets,
    change: Callable[[Geometry, Floats], Floats],
    side: Side = "both",
    landings: tuple[Landing, ...] = (),
) -> Design:
    """The design with the directions meant replaced by what `change` makes of them.

    `change` gets those by u and those by v one after the other, (k, dim) each.
    """

    def edited(shape_id: ShapeId, geometry: Geometry, rows: list[int]) -> ControlNet:
        net, vectors = geometry.net, geometry.vectors
        given, automatic = net.given_vectors.copy(), net.automatic_vectors.copy()
        ways = list(ways_of(geometry, side))
        for way in ways:
            given[way, rows] = change(geometry, vectors[way, rows])
            automatic[way, rows] = False
        for landing in landings:
            way = 1 if landing.way == "v" and len(given) > 1 else 0
            if landing.shape_id == shape_id and way in ways:
                given[way, landing.number] = fitted(landing.vector, geometry.dimension)
        return net.with_vectors(given, automatic)

    return edit_nets(design, targets, edited)


def unchanged(design: Design, targets: Targets) -> Design:
    """The very same design, once it is sure that the targets are there and may be edited."""
    return edit_nets(design, targets, lambda _, geometry, rows: geometry.net)


def quarter_exact(angle: float) -> tuple[float, float]:
    """Cosine and sine, free of rounding at multiples of a quarter turn."""
    quarters = angle / (pi / 2.0)
    if quarters == round(quarters):
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(quarters) % 4]
    return cos(angle), sin(angle)


def turned(vectors: Floats, angle: float, plane: Plane = TOP) -> Floats:
    """Vectors (k, dim) turned by `angle` in radians. ValueError if they don't have the plane."""
    first, second = plane
    if max(plane) >= vectors.shape[1]:
        raise ValueError("a plane curve can be turned in the top view only")
    c, s = quarter_exact(angle)
    result = vectors.copy()
    result[:, first] = c * vectors[:, first] - s * vectors[:, second]
    result[:, second] = s * vectors[:, first] + c * vectors[:, second]
    return result


@dataclass(frozen=True, eq=False)
class Turn(NetCommand):
    """Turn directions by the same angle, and stretch them by the same factor if one is given.

    They are turned in one plane of coordinates; what they have across that plane stays.
    """

    angle: float
    """in radians, counter-clockwise as seen in the plane"""
    plane: Plane = TOP
    factor: float = 1.0
    landing: Landing | None = None
    """of one of the directions: where it is to point exactly"""
    side: Side = "both"

    @property
    def verb(self) -> str:
        return "Rotate" if self.factor == 1.0 else "Stretch"

    def apply(self, design: Design) -> Design:
        if self.angle == 0.0 and self.factor == 1.0 and self.landing is None:
            return unchanged(design, self.targets)

        def changed(_: Geometry, directions: Floats) -> Floats:
            return turned(directions, self.angle, self.plane) * self.factor

        landings = () if self.landing is None else (self.landing,)
        return redirected(design, self.targets, changed, self.side, landings)


@dataclass(frozen=True, eq=False)
class SetDirection(Command):
    """Give one line or plane a direction, or None to let it follow its neighbours again."""

    shape_id: ShapeId
    number: int
    direction: Floats | None
    side: Side = "both"
    """of a plane: which one is given. Both can be reset, but not be given the same direction"""

    @property
    def label(self) -> str:
        return "Reset direction" if self.direction is None else "Set direction"

    def apply(self, design: Design) -> Design:
        targets = {self.shape_id: (self.number,)}
        if self.direction is None:
            return ResetDirections(targets, self.side).apply(design)
        direction = self.direction

        def given(geometry: Geometry, _: Floats) -> Floats:
            if self.side == "both" and not isinstance(geometry, PlusCurve):
                raise ValueError("the directions by u and by v are set one at a time")
            return fitted(direction, geometry.dimension)[None]

        return redirected(design, targets, given, self.side)


@dataclass(frozen=True, eq=False)
class SetAngle(NetCommand):
    """Point directions the same way in a plane; lengths stay, what has none gets length 1."""

    angle: float
    """in radians from the first axis of the plane towards the second"""
    plane: Plane = TOP
    side: Side = "both"

    @property
    def verb(self) -> str:
        return "Set angle of"

    def apply(self, design: Design) -> Design:
        def pointed(_: Geometry, directions: Floats) -> Floats:
            if max(self.plane) >= directions.shape[1]:
                raise ValueError("the angle of a plane curve is that in the top view")
            columns = list(self.plane)
            length = np.linalg.norm(directions[:, columns], axis=1)
            length[~directions.any(axis=1)] = 1.0
            result = directions.copy()
            result[:, columns] = length[:, None] * np.array(quarter_exact(self.angle))
            return result

        return redirected(design, self.targets, pointed, self.side)


@dataclass(frozen=True, eq=False)
class SetLength(NetCommand):
    """Give directions the same length; a direction of no length must point somewhere first."""

    length: float
    side: Side = "both"

    @property
    def verb(self) -> str:
        return "Set length of"

    def apply(self, design: Design) -> Design:
        def stretched(geometry: Geometry, directions: Floats) -> Floats:
            if not self.length >= 0.0:
                raise ValueError("a length can't be negative; reverse the direction instead")
            now = np.linalg.norm(directions, axis=1, keepdims=True)
            if self.length > 0.0 and not now.all():
                noun = "line" if isinstance(geometry, PlusCurve) else "plane"
                raise ValueError(f"a control {noun} without a direction can't be made longer")
            scale = np.divide(self.length, now, out=np.zeros_like(now), where=now > 0.0)
            longer: Floats = directions * scale
            return longer

        return redirected(design, self.targets, stretched, self.side)


@dataclass(frozen=True, eq=False)
class ScaleDirections(NetCommand):
    """Multiply directions by a number; a negative one reverses them."""

    factor: float
    side: Side = "both"

    @property
    def verb(self) -> str:
        return "Stretch"

    def apply(self, design: Design) -> Design:
        if self.factor == 1.0:
            return unchanged(design, self.targets)
        return redirected(design, self.targets, lambda _, d: d * self.factor, self.side)


@dataclass(frozen=True, eq=False)
class ReverseDirections(NetCommand):
    """Point directions the other way."""

    side: Side = "both"

    @property
    def verb(self) -> str:
        return "Reverse"

    def apply(self, design: Design) -> Design:
        # 0 - d and not -d: a zero direction would else become -0 and look changed in the file.
        return redirected(design, self.targets, lambda _, d: 0.0 - d, self.side)


@dataclass(frozen=True, eq=False)
class ResetDirections(NetCommand):
    """Let directions follow the neighbouring control points again; those of a face are its own."""

    side: Side = "both"

    @property
    def verb(self) -> str:
        return "Reset"

    def apply(self, design: Design) -> Design:
        def reset(_: ShapeId, geometry: Geometry, rows: list[int]) -> ControlNet:
            net = geometry.net
            meant = np.ix_(list(ways_of(geometry, self.side)), rows)
            if net.automatic_vectors[meant].all():
                return net
            automatic = net.automatic_vectors.copy()
            automatic[meant] = True
            return net.with_vectors(net.given_vectors, automatic)

        return edit_nets(design, self.targets, reset)
