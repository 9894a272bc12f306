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
from plusedit.geometry.residual import residual
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_nearest import nearest_places

OF_CURVES = 257  # points of a curve, at least; 8 to a line of longer ones
MOST = 2049
OF_SURFACES = 41  # points of a surface, each way


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
    """(m, 3) the points of a surface that are nearest to others (m, 3)."""
    return surface.derivatives_at(nearest_places(surface, points), highest=0)[0]


def parts_of(around: Floats) -> Floats:
    """Numbers as parts of their sum; even parts where it is zero."""
    total = float(around.sum())
    return around / total if total > 0.0 else np.full(len(around), 1.0 / len(around))
