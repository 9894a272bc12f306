"""How far points are from a curve that goes along them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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

    Looked for on the chords between even samples of every piece, and by Newton's method on all
    parts of the curve whose chords are about as near as the nearest.
    """
    ends = pieces(curve).parameters
    u = np.unique(np.linspace(ends[:-1], ends[1:], BETWEEN + 1, axis=1))
    chords = _Chords.of(curve.at(u))
    share = max(1, BLOCK // len(u))
    found = [chords.near(points[k : k + share]) for k in range(0, len(points), share)]
    row = np.concatenate([rows + share * k for k, (rows, _) in enumerate(found)])
    place = np.concatenate([places for _, places in found])
    low, high = u[place], u[place + 1]
    start = low + chords.along(points[row], place) * (high - low)
    feet, distance = _descended(curve, points[row], start, (low, np.nextafter(high, low)))
    order = np.lexsort((distance, row))
    first = order[np.searchsorted(row[order], np.arange(len(points)))]
    return Residual(points, feet[first])


@dataclass(frozen=True, eq=False)
class _Chords:
    """Chords from each sample of a curve to the next."""

    samples: Floats
    """(k + 1, dim)"""
    lengths: Floats
    """(k,)"""
    bows: Floats
    """(k,) about how far the curve strays from its chord, rather more"""

    @classmethod
    def of(cls, samples: Floats) -> "_Chords":
        bends = np.linalg.norm(np.diff(samples, n=2, axis=0), axis=1) / 4.0
        bows = np.maximum(np.append(bends, 0.0), np.append(0.0, bends))
        return cls(samples, np.linalg.norm(np.diff(samples, axis=0), axis=1), bows)

    def near(self, points: Floats) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """(r,) numbers of points and of chords where the foot may lie, one at least for each."""
        middle = self.samples.mean(axis=0)  # far from the origin squares would be rounding
        at, samples = points - middle, self.samples - middle
        squares = (samples**2).sum(axis=1) - 2.0 * at @ samples.T + (at**2).sum(axis=1)[:, None]
        distances = np.sqrt(np.maximum(squares, 0.0))
        closest = np.minimum(distances[:, :-1], distances[:, 1:]) - self.lengths
        rows, places = np.nonzero(closest <= distances.min(axis=1, keepdims=True))
        ends = self.samples[places], self.samples[places + 1]
        shares = self.along(points[rows], places)[:, None]
        away = points[rows] - (1.0 - shares) * ends[0] - shares * ends[1]
        apart, bows = np.linalg.norm(away, axis=1), self.bows[places]
        starts = np.searchsorted(rows, np.arange(len(points)))
        kept = apart - bows <= np.minimum.reduceat(apart + bows, starts)[rows]
        return rows[kept], places[kept]

    def along(self, points: Floats, places: NDArray[np.intp]) -> Floats:
        """(r,) how far along a chord each the places nearest to points are, from 0 to 1."""
        start = self.samples[places]
        way = self.samples[places + 1] - start
        length = (way * way).sum(axis=1)
        ahead = ((points - start) * way).sum(axis=1)
        shares: Floats = np.divide(ahead, length, out=np.zeros_like(ahead), where=length > 0.0)
        return np.minimum(np.maximum(shares, 0.0), 1.0)


def _descended(
    curve: PlusCurve, points: Floats, start: Floats, between: tuple[Floats, Floats]
) -> tuple[Floats, Floats]:
    """(r, dim) feet of points between two parameters each, and (r,) squared distances."""
    low, high = between
    best, damping = np.clip(start, low, high), np.ones(len(points))
    feet = curve.at(best)
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
    return feet, distance
