"""A curve as chains of chords that stray from it by a known distance, coarse ones and fine ones."""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.candidates import TOGETHER, Numbers, lengths, levels, products
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tessellate import Axes, seen_along, tessellation

STRAY = 1e-4  # of the size of the curve: how far it may lie from the finest chords


@dataclass(frozen=True, eq=False)
class Chords:
    """The k chords that join points of a curve, as it is seen."""

    u: Floats
    """(k + 1,) the parameters of the points"""
    points: Floats
    """(k + 1, dim)"""
    strays: Floats
    """(k,) how far the curve over each chord may lie from it"""

    def __len__(self) -> int:
        return len(self.strays)

    @cached_property
    def ways(self) -> Floats:
        """(k, dim) from where they begin to where they end."""
        return np.diff(self.points, axis=0)

    @cached_property
    def paces(self) -> Floats:
        """(k, dim) vectors along them: times a vector, these give the share it has of the chord."""
        headings, length = unit(self.ways), lengths(self.ways)[:, None]
        return np.divide(headings, length, out=np.zeros_like(headings), where=length > 0.0)

    def coarser(self) -> "Chords":
        """Chords that go along several of these each."""
        first = np.arange(0, len(self), TOGETHER)
        ends = np.append(first, len(self))
        joined = Chords(self.u[ends], self.points[ends], np.zeros(len(first)))
        place = np.arange(len(self)) // TOGETHER
        starts, stops = (
            joined.from_points(at, place)[0] for at in (self.points[:-1], self.points[1:])
        )
        away = np.maximum(starts, stops) + self.strays
        return Chords(joined.u, joined.points, np.maximum.reduceat(away, first))

    def from_points(self, points: Floats, place: Numbers) -> tuple[Floats, Floats]:
        """(r,) distances of points (r, dim) from the chords of those numbers, and (r,) the shares.

        That is how far along its chord the place nearest to each point is, from 0 to 1.
        """
        away = points - self.points.take(place, axis=0)
        shares = np.clip(products(away, self.paces.take(place, axis=0)), 0.0, 1.0)
        away -= shares[:, None] * self.ways.take(place, axis=0)
        return lengths(away), shares


@lru_cache(maxsize=32)
def chains(curve: PlusCurve, axes: Axes) -> tuple[Chords, ...]:
    """Chains of chords of the curve as it is seen along `axes`, the coarsest first."""
    rough = curve.at(np.linspace(0.0, 1.0, 33))
    size = float((rough.max(axis=0) - rough.min(axis=0)).max())
    stray = STRAY * max(size, np.finfo(np.float64).tiny / STRAY)
    u = tessellation(curve, stray, axes=axes).parameters
    return levels(Chords(u, seen_along(curve.at(u), axes), np.full(len(u) - 1, stray)))
