"""A curve as chains of chords: which of them its point nearest to something may lie on.

The curve over a chord strays from it by a known distance at most. So a chord that is farther away
than another by more than both stray is out of the question. In coarser chains each chord goes
along a few of the next finer one; only where a coarse one is near enough finer ones are looked at.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tessellate import Axes, seen_along, tessellation

STRAY = 1e-4  # of the size of the curve: how far it may lie from the finest chords
TOGETHER = 4  # chords that one of the next coarser chain goes along
FEW = 1 << 12  # distances that are worked out faster than chosen
MOST = 12  # chords for one thing; more are equally near at the center of a circle

Numbers: TypeAlias = NDArray[np.intp]


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

    @cached_property
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


@dataclass(frozen=True, eq=False)
class Candidates:
    """Pairs of things and chords, by their numbers; of every thing one at least."""

    row: Numbers
    """(r,) the things, rising"""
    place: Numbers
    """(r,) the chords"""
    distances: Floats
    """(r,) from each other"""
    shares: Floats
    """(r,) how far along the chord the place nearest to the thing is, from 0 to 1"""

    def taken(self, order: Numbers) -> "Candidates":
        """Some of them, in that order."""
        distances, shares = self.distances.take(order), self.shares.take(order)
        return Candidates(self.row.take(order), self.place.take(order), distances, shares)


Measure: TypeAlias = Callable[[Numbers, Chords, Numbers], tuple[Floats, Floats]]
"""From numbers of things, and chords and their numbers, (r,) each: distances, and shares."""


@lru_cache(maxsize=32)
def chains(curve: PlusCurve, axes: Axes) -> tuple[Chords, ...]:
    """Chains of chords of the curve as it is seen along `axes`, the coarsest first."""
    rough = curve.at(np.linspace(0.0, 1.0, 33))
    size = float((rough.max(axis=0) - rough.min(axis=0)).max())
    stray = STRAY * max(size, np.finfo(np.float64).tiny / STRAY)
    u = tessellation(curve, stray, axes=axes).parameters
    found = [Chords(u, seen_along(curve.at(u), axes), np.full(len(u) - 1, stray))]
    while len(found[-1]) > TOGETHER:
        found.append(found[-1].coarser)
    return tuple(reversed(found))


def candidates(chain: tuple[Chords, ...], count: int, measure: Measure) -> Candidates:
    """The finest chords that the points of the curve nearest to `count` things may lie on."""
    few = [level for level, chords in enumerate(chain) if count * len(chords) <= FEW]
    start = few[-1] if few else 0
    row, place = np.indices((count, len(chain[start]))).reshape(2, -1)
    near = _near(row, chain[start], place, measure)
    for chords in chain[start + 1 :]:
        row, place = _parted(near, len(chords))
        near = _near(row, chords, place, measure)
    return _nearest_few(near)


def _near(row: Numbers, chords: Chords, place: Numbers, measure: Measure) -> Candidates:
    """Those pairs that are not out of the question."""
    found = Candidates(row, place, *measure(row, chords, place))
    strays = chords.strays.take(place)
    least = np.minimum.reduceat(found.distances + strays, firsts(row))
    # Written so that what is not a number stays: no thing is left without a chord.
    return found.taken(np.flatnonzero(~(found.distances - strays > least.take(row))))


def _parted(near: Candidates, count: int) -> tuple[Numbers, Numbers]:
    """The same things with the parts of their chords, of which there are `count`."""
    parts = (TOGETHER * near.place[:, None] + np.arange(TOGETHER)).ravel()
    inside = parts < count
    return np.repeat(near.row, TOGETHER)[inside], parts[inside]


def _nearest_few(near: Candidates) -> Candidates:
    """The nearest chords of each thing, where it has too many."""
    first = firsts(near.row)
    if np.diff(first, append=len(near.row)).max() <= MOST:
        return near
    order = np.lexsort((near.distances, near.row))
    return near.taken(order[np.arange(len(order)) - first[near.row] < MOST])


def firsts(row: Numbers) -> Numbers:
    """Where each of the numbers 0, 1, 2, ... begins among those that rise, and hold them all."""
    return np.searchsorted(row, np.arange(row[-1] + 1))


def products(vectors: Floats, others: Floats) -> Floats:
    """(r,) the inner products of vectors (r, dim)."""
    found: Floats = np.einsum("rd,rd->r", vectors, others)
    return found


def lengths(vectors: Floats) -> Floats:
    """(r,) of vectors (r, dim)."""
    return np.sqrt(products(vectors, vectors))
