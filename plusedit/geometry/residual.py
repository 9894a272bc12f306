"""How far points are from a curve that goes along them."""

from dataclasses import dataclass

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.pieces import pieces

BETWEEN = 24  # samples between two of the parameters where to look first
BLOCK = 1 << 20  # distances worked on at a time
STEPS = 10  # of Newton's method to the feet


@dataclass(frozen=True, eq=False)
class Residual:
    """Points and their feet on a curve."""

    points: Floats
    """(m, dim)"""
    feet: Floats
    """(m, dim) the nearest points of the curve"""

    @property
    def distances(self) -> Floats:
        """(m,)"""
        lengths: Floats = np.linalg.norm(self.points - self.feet, axis=1)
        return lengths

    @property
    def largest(self) -> float:
        """The largest distance."""
        return float(self.distances.max())

    @property
    def rms(self) -> float:
        """The root of the mean square of the distances."""
        return float(np.sqrt(np.mean(self.distances**2)))


def residual(curve: PlusCurve, points: Floats) -> Residual:
    """The points (m, dim) with the points of the curve that are nearest to them.

    Looked for among even samples of every piece, and from the nearest of these by Newton's method.
    """
    ends = pieces(curve).parameters
    u = np.unique(np.linspace(ends[:-1], ends[1:], BETWEEN + 1, axis=1))
    samples = curve.at(u)
    nearest = np.empty(len(points), dtype=np.intp)
    share = max(1, BLOCK // len(samples))
    squares = (samples**2).sum(axis=1)
    for start in range(0, len(points), share):
        part = points[start : start + share]
        nearest[start : start + share] = (squares - 2.0 * part @ samples.T).argmin(axis=1)
    at, low = u[nearest], u[np.maximum(nearest - 1, 0)]
    high = u[np.minimum(nearest + 1, len(u) - 1)]
    feet, best, damping = samples[nearest], at, np.ones(len(points))
    distance = ((points - feet) ** 2).sum(axis=1)
    for _ in range(STEPS):
        place, velocity, acceleration = curve.derivatives(best)
        away = points - place
        square = (velocity**2).sum(axis=1)
        slope = square - (away * acceleration).sum(axis=1)
        # Where the curve bends away faster than the point is far, Newton's step leads astray.
        slope = np.where(slope > 0.0, slope, square)
        step = (away * velocity).sum(axis=1)
        ahead = np.divide(step, slope, out=np.zeros_like(step), where=slope > 0.0)
        there = np.clip(best + damping * ahead, low, high)
        found = curve.at(there)
        nearer = ((points - found) ** 2).sum(axis=1)
        better = nearer < distance
        damping = np.where(better, 1.0, 0.25 * damping)
        best = np.where(better, there, best)
        feet = np.where(better[:, None], found, feet)
        distance = np.where(better, nearer, distance)
    return Residual(points, feet)
