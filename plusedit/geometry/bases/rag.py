"""Rational Gaussian (RaG) functions: Gaussians about the nodes, divided by their sum.

    b_i = G_i / sum_k G_k,   G_i(u) = exp(-(u - x_i)^2 / (2 sigma_i^2));

on a closed basis G_i is the sum over all images x_i + m, m any integer.
"""

from dataclasses import dataclass, field
from functools import cached_property
from math import ceil

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import register
from plusedit.geometry.domain import clamped, wrapped

USUAL_WIDTH = 0.6  # of the node spacing: smooth, and still close to the control points
FARTHEST = 9.5  # in sigma: an image that far away is lost beside the nearest one
NARROW = 1e-60  # a narrower Gaussian is as much of a step; the fourth power of this fits a double
FLAT = 2.0  # a closed Gaussian wider than this differs from a constant by exp(-2 pi^2 4) = 5e-35


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
        shares, _ = self._shares(u, derivative)
        total: Floats = shares[derivative].sum(axis=2)
        return total

    def reaches(self, u: Floats, *, derivative: int = 0) -> Floats:
        shares, distance = self._shares(u, derivative)
        reach = distance * shares[derivative]
        if derivative:
            reach += derivative * shares[derivative - 1]
        total: Floats = reach.sum(axis=2)
        return total

    def _shares(self, u: Floats, highest: int) -> tuple[list[Floats], Floats]:
        """Every image of every Gaussian, divided by the sum of all, (m, n, images); derivatives.

        With them the distances u - x_i - m. The derivative of log G is z = -distance / sigma^2, so

            b' = b y,   b'' = b (y^2 + z' - mean(y^2 + z')),   y = z - mean(z),

        the means weighted by b. Only differences of z count, and of z'; they are taken from the
        largest Gaussian, beside which the others may be next to nothing.
        """
        distance = self._distances(u)
        width = self._widths[:, None]
        exponent = -0.5 * (distance / width) ** 2
        # The largest exponent cancels in the quotient; kept in, a small sigma gives 0 / 0.
        exponent -= exponent.max(axis=(1, 2), keepdims=True)
        b = self._heights[:, None] * np.exp(exponent)
        b /= b.sum(axis=(1, 2), keepdims=True)
        shares = [b]
        if highest:
            y = _from_mean(-distance / width**2, b)
            shares.append(b * y)
        if highest == 2:
            bend = np.broadcast_to(-1.0 / width**2, b.shape)
            shares.append(b * (_from_mean(y**2, b) + _from_mean(bend, b)))
        return shares, distance

    def _distances(self, u: Floats) -> Floats:
        """(m, n, images) of u from the nodes and their images."""
        if not self.closed:
            return (clamped(u)[:, None] - self._nodes)[..., None]
        distance = wrapped(u)[:, None] - self._nodes
        distance -= np.round(distance)
        return distance[..., None] - self._images

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
    def _images(self) -> Floats:
        # From -1/2 to 1/2 to the nearest image; another one may be as near.
        count = max(1, ceil(FARTHEST * float(self._widths.max()) - 0.5))
        return np.arange(-count, count + 1, dtype=np.float64)


def _from_mean(of: Floats, b: Floats) -> Floats:
    """Every entry less the mean of its row weighted by b, rows being all but the first axis."""
    rows, shares = of.reshape(len(of), -1), b.reshape(len(b), -1)
    if not len(rows):
        return of
    largest = shares.argmax(axis=1)[:, None]
    rows = rows - np.take_along_axis(rows, largest, axis=1)
    means = np.einsum("mi,mi->m", shares, rows)
    differences: Floats = (rows - means[:, None]).reshape(b.shape)
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
