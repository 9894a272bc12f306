"""Rational Gaussian (RaG) functions: Gaussians about the nodes, divided by their sum.

    b_i = G_i / sum_k G_k,   G_i(u) = exp(-(u - x_i)^2 / (2 sigma_i^2));

on a closed basis G_i is the sum over all images x_i + m, m any integer.
"""

from dataclasses import dataclass, field
from functools import cached_property
from math import ceil

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import register
from plusedit.geometry.domain import clamped, wrapped

USUAL_WIDTH = 0.6  # of the node spacing: smooth, and still close to the control points
FARTHEST = 9.5  # in sigma: a Gaussian that much farther away is lost beside the nearest
NARROW = 1e-60  # a narrower Gaussian is as much of a step; the fourth power of this fits a double
FLAT = 2.0  # a closed Gaussian wider than this differs from a constant by exp(-2 pi^2 4) = 5e-35

Indices = NDArray[np.intp]


@register("rag")
@dataclass(frozen=True)
class RationalGaussian:
    """n rational Gaussians of width `sigma`, in units of the parameter."""

    size: int
    sigma: float | tuple[float, ...]
    """positive; one number for all or one for each control line"""
    closed: bool = False
    given_nodes: tuple[float, ...] | None = field(default=None, metadata={"key": "nodes"})
    """increasing, in [0, 1], on a closed basis in [0, 1); None: evenly spread"""

    def __post_init__(self) -> None:
        if self.size < 2:
            raise ValueError(f"points: a RaG curve needs at least 2 of them, got {self.size}")
        widths = np.atleast_1d(np.array(self.sigma, dtype=np.float64))
        if isinstance(self.sigma, tuple) and len(widths) != self.size:
            raise ValueError(f"sigma: expected one number or {self.size}, got {len(widths)}")
        if not np.isfinite(widths).all() or widths.min() <= 0.0:
            raise ValueError(f"sigma: must be positive and finite, got {widths.min():g}")
        if self.given_nodes is not None:
            _check_nodes(self.given_nodes, self.size, closed=self.closed)

    @classmethod
    def of_size(cls, size: int) -> "RationalGaussian":
        """Open, nodes evenly spread, sigma 0.6 of their spacing."""
        return cls(size, USUAL_WIDTH / (size - 1))

    def __hash__(self) -> int:
        # Asked for with every look into a cache; nodes and widths may be many.
        return self._hash

    @property
    def nodes(self) -> Floats:
        return self._nodes

    def values(self, u: Floats, *, derivative: int = 0) -> Floats:
        shares, _, columns = self._shares(u, derivative)
        return self._gathered(shares[derivative], columns)

    def reaches(self, u: Floats, *, derivative: int = 0) -> Floats:
        return self.both(u, derivative=derivative)[1]

    def both(self, u: Floats, *, derivative: int = 0) -> tuple[Floats, Floats]:
        shares, distance, columns = self._shares(u, derivative)
        reach = distance * shares[derivative]
        if derivative:
            reach += derivative * shares[derivative - 1]
        return self._gathered(shares[derivative], columns), self._gathered(reach, columns)

    def _shares(self, u: Floats, highest: int) -> tuple[list[Floats], Floats, Indices | None]:
        """Gaussians divided by the sum of all, (m, t), and derivatives; of every image its own.

        With them the distances u - x_i - m, and the numbers of the t terms if they are not all.
        The derivative of log G is z = -distance / sigma^2, so

            b' = b y,   b'' = b (y^2 + z' - mean(y^2 + z')),   y = z - mean(z),

        the means weighted by b. Only differences of z count, and of z'; they are taken from the
        largest Gaussian, beside which the others may be next to nothing.
        """
        places, widths, heights = self._terms
        inside = wrapped(u) if self.closed else clamped(u)
        columns = None
        if self._count < len(places):
            first = np.searchsorted(places, inside - self._farthest)
            first = np.minimum(first, len(places) - self._count)
            columns = first[:, None] + np.arange(self._count)
            places, widths, heights = places[columns], widths[columns], heights[columns]
        distance = inside[:, None] - places
        exponent = -0.5 * (distance / widths) ** 2
        # The largest exponent cancels in the quotient; kept in, a small sigma gives 0 / 0.
        exponent -= exponent.max(axis=1, keepdims=True)
        b = heights * np.exp(exponent)
        b /= b.sum(axis=1, keepdims=True)
        shares = [b]
        if highest:
            y = _from_mean(-distance / widths**2, b)
            shares.append(b * y)
        if highest == 2:
            bend = np.broadcast_to(-1.0 / widths**2, b.shape)
            shares.append(b * (_from_mean(y**2, b) + _from_mean(bend, b)))
        return shares, distance, columns

    def _gathered(self, terms: Floats, columns: Indices | None) -> Floats:
        """(m, n) the terms (m, t) of all images added up."""
        if columns is None:
            images = terms.shape[1] // self.size
            total: Floats = terms.reshape(len(terms), images, self.size).sum(axis=1)
            return total
        # No two of so few neighbors are images of the same node.
        total = np.zeros((len(terms), self.size))
        np.put_along_axis(total, columns % self.size, terms, axis=1)
        return total

    @cached_property
    def _hash(self) -> int:
        return hash((self.size, self.sigma, self.closed, self.given_nodes))

    @cached_property
    def _nodes(self) -> Floats:
        if self.given_nodes is not None:
            return np.array(self.given_nodes)
        return np.arange(self.size) / (self.size if self.closed else self.size - 1)

    @cached_property
    def _widths(self) -> Floats:
        widths = np.broadcast_to(np.array(self.sigma, dtype=np.float64), (self.size,))
        return np.clip(widths, NARROW, FLAT if self.closed else None)

    @cached_property
    def _heights(self) -> Floats:
        """One, but for closed Gaussians taken narrower than they are: their constant is sigma."""
        widths = np.broadcast_to(np.array(self.sigma, dtype=np.float64), (self.size,))
        return np.maximum(widths / self._widths, 1.0)

    @cached_property
    def _terms(self) -> tuple[Floats, Floats, Floats]:
        """The nodes and all their images that may count, rising, with widths and heights."""
        beyond = max(1, ceil(FARTHEST * float(self._widths.max()))) if self.closed else 0
        images = np.arange(-beyond, beyond + 1, dtype=np.float64)
        places = (images[:, None] + self._nodes).ravel()
        return places, np.tile(self._widths, len(images)), np.tile(self._heights, len(images))

    @cached_property
    def _farthest(self) -> float:
        """The distance from which on a Gaussian is lost beside that of the nearest node."""
        x = self._nodes
        ends = [x[0] + 1.0 - x[-1]] if self.closed else [2.0 * x[0], 2.0 * (1.0 - x[-1])]
        empty = max([*np.diff(x), *ends]) / 2.0
        least, most = float(self._widths.min()), float(self._widths.max())
        return 1.001 * most * float(np.hypot(FARTHEST, empty / least))

    @cached_property
    def _count(self) -> int:
        """How many neighbors lie within that distance, or all terms if that is no fewer."""
        places = self._terms[0]
        last = np.searchsorted(places, places + 2.0 * self._farthest, side="right")
        count = int((last - np.arange(len(places))).max())
        return count if count <= self.size // 2 else len(places)


def _from_mean(of: Floats, b: Floats) -> Floats:
    """(m, t) every entry less the mean of its row weighted by b."""
    if not len(b):
        return of
    largest = b.argmax(axis=1)[:, None]
    rows = of - np.take_along_axis(of, largest, axis=1)
    differences: Floats = rows - np.einsum("mi,mi->m", b, rows)[:, None]
    return differences


def _check_nodes(nodes: tuple[float, ...], size: int, *, closed: bool) -> None:
    x = np.array(nodes, dtype=np.float64)
    if len(x) != size:
        raise ValueError(f"nodes: expected {size} numbers, got {len(x)}")
    if not np.isfinite(x).all():
        raise ValueError("nodes: has a value that is not finite")
    if (np.diff(x) <= 0.0).any():
        raise ValueError("nodes: must increase")
    if x[0] < 0.0 or x[-1] > 1.0 or (closed and x[-1] >= 1.0):
        raise ValueError(f"nodes: must lie in [0, 1{')' if closed else ']'}")
