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
        return self._quotients(u, derivative, reach=False)

    def reaches(self, u: Floats, *, derivative: int = 0) -> Floats:
        return self._quotients(u, derivative, reach=True)

    def _quotients(self, u: Floats, derivative: int, *, reach: bool) -> Floats:
        """Derivatives of G_i / sum G, or of sum (u - x_i - m) G / sum G, by the quotient rule."""
        gaussians, moments = self._sums(u, derivative)
        totals = [g.sum(axis=1, keepdims=True) for g in gaussians]
        numerators = moments if reach else gaussians
        b: Floats = numerators[0] / totals[0]
        if derivative == 0:
            return b
        first: Floats = (numerators[1] - b * totals[1]) / totals[0]
        if derivative == 1:
            return first
        second: Floats = (numerators[2] - 2.0 * first * totals[1] - b * totals[2]) / totals[0]
        return second

    def _sums(self, u: Floats, highest: int) -> tuple[list[Floats], list[Floats]]:
        """Sums over the images of G and of (u - x_i - m) G, and their derivatives, (m, n) each."""
        distance = (wrapped(u) if self.closed else clamped(u))[:, None] - self._nodes
        if self.closed:
            distance -= np.round(distance)
        distance = distance[..., None] - self._images
        width = self._widths[:, None]
        exponent = -0.5 * (distance / width) ** 2
        # The largest exponent cancels in the quotient; kept in, a small sigma gives 0 / 0.
        exponent -= exponent.max(axis=(1, 2), keepdims=True)
        g = self._heights[:, None] * np.exp(exponent)
        slope = -distance / width**2
        gaussians, moments = [g.sum(axis=2)], [(distance * g).sum(axis=2)]
        if highest >= 1:
            first = slope * g
            gaussians.append(first.sum(axis=2))
            moments.append((g + distance * first).sum(axis=2))
        if highest >= 2:
            second = (slope**2 - 1.0 / width**2) * g
            gaussians.append(second.sum(axis=2))
            moments.append((2.0 * first + distance * second).sum(axis=2))
        return gaussians, moments

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
        return np.minimum(widths, FLAT) if self.closed else widths

    @cached_property
    def _heights(self) -> Floats:
        """One, but for closed Gaussians taken narrower than they are: their constant is sigma."""
        widths = np.broadcast_to(np.array(self.sigma, dtype=np.float64), (self.size,))
        return widths / self._widths

    @cached_property
    def _images(self) -> Floats:
        if not self.closed:
            return np.zeros(1)
        # From -1/2 to 1/2 to the nearest image; another one may be as near.
        count = max(1, ceil(FARTHEST * float(self._widths.max()) - 0.5))
        return np.arange(-count, count + 1, dtype=np.float64)


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
