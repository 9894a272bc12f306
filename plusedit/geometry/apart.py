"""How far shapes are from each other: from points all over the one to the nearest of the other.

Points lie so close together that the largest distance among them is an estimate, from below, of
the one-sided Hausdorff distance; means count every point by the length or area around it.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.pieces import surface_pieces
from plusedit.geometry.residual import residual
from plusedit.geometry.surface import PlusSurface

OF_CURVES = 257  # points of a curve, at least; 8 to a line of longer ones
MOST = 2049
OF_SURFACES = 41  # points of a surface, each way
LOOKED_AT = 49  # samples each way among which the nearest is looked for, and more of many pieces
BLOCK = 1 << 20  # distances worked out at a time
STEPS = 12  # toward the feet, at most
DONE = 1e-12  # of the size: steps shorter than that are the last


@dataclass(frozen=True, eq=False)
class Gap:
    """Points of one shape, and how far each is from another."""

    points: Floats
    """(m, dim)"""
    distances: Floats
    """(m,)"""
    shares: Floats
    """(m,) of the length or area, one together"""
    feet: Floats | None = None
    """(m, dim) the nearest points of the other shape, where they are known"""

    @cached_property
    def worst(self) -> int:
        """The number of the point that is farthest away."""
        return int(self.distances.argmax())

    @property
    def largest(self) -> float:
        """Its distance."""
        return float(self.distances[self.worst])

    @cached_property
    def rms(self) -> float:
        """The root of the mean square."""
        scale = self.largest or 1.0
        return scale * float(np.sqrt(self.shares @ (self.distances / scale) ** 2))


@dataclass(frozen=True, eq=False)
class SurfacePoints:
    """Points of a surface at every pair of even parameters."""

    u: Floats
    v: Floats
    points: Floats
    """(m_u, m_v, 3)"""

    @classmethod
    def of(cls, surface: PlusSurface) -> "SurfacePoints":
        even = Grid.uniform(OF_SURFACES)
        return cls(even.parameters, even.parameters, surface.sample(even, even))

    @cached_property
    def shares(self) -> Floats:
        """(m_u m_v,) the areas around the points, one together."""
        p = self.points
        across = np.cross(p[1:, 1:] - p[:-1, :-1], p[1:, :-1] - p[:-1, 1:])
        areas = np.linalg.norm(across, axis=2)
        around = np.zeros(p.shape[:2])
        for rows in (slice(None, -1), slice(1, None)):
            for columns in (slice(None, -1), slice(1, None)):
                around[rows, columns] += areas
        return parts_of(around.ravel())


def curve_gap(first: PlusCurve, second: PlusCurve) -> Gap:
    """From the points of one curve to another of the same dimension."""
    points = first.sample(Grid.uniform(min(max(OF_CURVES, 8 * len(first.lines) + 1), MOST)))
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    around = np.append(steps, 0.0) + np.append(0.0, steps)
    found = residual(second, points)
    return Gap(points, found.distances, parts_of(around), found.feet)


def surface_gap(points: Floats, shares: Floats, second: PlusSurface) -> Gap:
    """From points (m, 3) of one shape to a surface."""
    feet = feet_on_surface(second, points)
    return Gap(points, np.linalg.norm(points - feet, axis=1), shares, feet)


def feet_on_surface(surface: PlusSurface, points: Floats) -> Floats:
    """(m, 3) the points of a surface that are nearest to others (m, 3).

    Looked for among samples, and from the nearest of these by the method of Gauss and Newton.
    """
    u, v = (_looked_at(grid) for grid in surface_pieces(surface))
    places = _nearest_samples(surface, points, u, v)
    feet = surface.derivatives_at(places, highest=0)[0]
    going = np.arange(len(points))
    damping = np.ones(len(points))
    least = DONE * float(np.ptp(points, axis=0).max())
    for _ in range(STEPS):
        at, goal = places[going], points[going]
        found = surface.derivatives_at(at, highest=1)
        step = damping[going, None] * _steps(surface, at, goal - found[0], *found[1:])
        ahead = _inside(surface, at + step)
        there = surface.derivatives_at(ahead, highest=0)[0]
        better = _squares(goal - there) < _squares(goal - found[0])
        moved = _squares(there - found[0]) > least**2
        places[going[better]], feet[going[better]] = ahead[better], there[better]
        damping[going] = np.where(better, 1.0, 0.3 * damping[going])
        going = going[moved]
        if not len(going):
            break
    return feet


def parts_of(around: Floats) -> Floats:
    """Numbers as parts of their sum; even parts where it is zero."""
    total = float(around.sum())
    return around / total if total > 0.0 else np.full(len(around), 1.0 / len(around))


def _looked_at(grid: Grid) -> Floats:
    """Parameters, even ones and some of the pieces."""
    ends = grid.parameters
    return np.union1d(np.linspace(0.0, 1.0, LOOKED_AT), (ends[1:] + ends[:-1]) / 2.0)


def _nearest_samples(surface: PlusSurface, points: Floats, u: Floats, v: Floats) -> Floats:
    """(m, 2) the parameters, of those that are looked at, where the surface is nearest."""
    samples = surface.at(u, v).reshape(-1, 3)
    middle = samples.mean(axis=0)  # far from the origin the squares below would be rounding
    samples, squares = samples - middle, _squares(samples - middle)
    nearest = np.empty(len(points), dtype=np.intp)
    share = max(1, BLOCK // len(samples))
    for start in range(0, len(points), share):
        part = slice(start, start + share)
        products = (points[part] - middle) @ samples.T
        nearest[part] = (squares - 2.0 * products).argmin(axis=1)
    return np.stack([u[nearest // len(v)], v[nearest % len(v)]], axis=1)


def _steps(
    surface: PlusSurface, places: Floats, away: Floats, along_u: Floats, along_v: Floats
) -> Floats:
    """(m, 2) how the parameters move so that the tangent planes come nearest."""
    uu, uv = _products(along_u, along_u), _products(along_u, along_v)
    vv = _products(along_v, along_v)
    by = np.stack([_products(away, along_u), _products(away, along_v)], axis=1)
    area = uu * vv - uv * uv
    is_flat = area <= 1e-14 * (uu + vv) ** 2
    area = np.where(is_flat, 1.0, area)
    both = np.stack([vv * by[:, 0] - uv * by[:, 1], uu * by[:, 1] - uv * by[:, 0]], axis=1)
    both /= area[:, None]
    # Alone, each way goes as far as is good for itself.
    squares = np.stack([uu, vv], axis=1)
    alone = np.divide(by, squares, out=np.zeros_like(by), where=squares > 0.0)
    # At an edge that holds one way back the other goes on alone; at a pole only one counts.
    beyond = (places + both < 0.0) & (places <= 0.0) | (places + both > 1.0) & (places >= 1.0)
    held = beyond & ~np.array(surface.closed)
    held |= is_flat[:, None] & (squares < squares.max(axis=1, keepdims=True))
    return np.where(held, 0.0, np.where(held[:, ::-1] | is_flat[:, None], alone, both))


def _inside(surface: PlusSurface, places: Floats) -> Floats:
    """The places, moved into the domain where the surface is open."""
    return np.where(np.array(surface.closed), places, np.clip(places, 0.0, 1.0))


def _squares(vectors: Floats) -> Floats:
    return _products(vectors, vectors)


def _products(vectors: Floats, others: Floats) -> Floats:
    product: Floats = np.einsum("md,md->m", vectors, others)
    return product
