"""Which of many parts of a shape its point nearest to something may lie on.

The shape strays from each part by a known distance at most. So a part that is farther away than
another by more than both stray is out of the question. Coarse parts each stand for a few finer
ones, which follow each other; only where a coarse one is near enough finer ones are looked at.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol, Self, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

TOGETHER = 4  # parts that a coarser one stands for
FEW = 1 << 12  # distances that are worked out faster than chosen

Numbers: TypeAlias = NDArray[np.intp]


class Parts(Protocol):
    """Parts that a shape is taken for."""

    @property
    def strays(self) -> Floats:
        """(k,) how far the shape may lie from each."""
        ...


class FineParts(Parts, Protocol):
    """Parts that coarser ones can stand for."""

    def coarser(self) -> Self:
        """Parts that stand for several of these each, which follow each other."""
        ...


P = TypeVar("P", bound=Parts)
F = TypeVar("F", bound=FineParts)
Measure: TypeAlias = Callable[[Numbers, P, Numbers], Floats]
"""From numbers of things, and parts and their numbers: (r,) how far they are from each other."""


@dataclass(frozen=True, eq=False)
class Candidates:
    """Pairs of things and parts, by their numbers; of every thing one at least."""

    row: Numbers
    """(r,) the things, rising"""
    place: Numbers
    """(r,) the parts"""
    distances: Floats
    """(r,) from each other"""

    def taken(self, order: Numbers) -> "Candidates":
        """Some of them, in that order."""
        return Candidates(self.row.take(order), self.place.take(order), self.distances.take(order))

    def nearest(self, most: int) -> "Candidates":
        """The nearest parts of each thing, as many at most."""
        first = firsts(self.row)
        if np.diff(first, append=len(self.row)).max() <= most:
            return self
        order = np.lexsort((self.distances, self.row))
        return self.taken(order[np.arange(len(order)) - first[self.row] < most])


def levels(finest: F) -> tuple[F, ...]:
    """Ever coarser parts, down to a few; the coarsest first."""
    found = [finest]
    while len(found[-1].strays) > TOGETHER:
        found.append(found[-1].coarser())
    return tuple(reversed(found))


def candidates(chain: Sequence[P], count: int, measure: Measure[P]) -> Candidates:
    """The finest parts of some levels that may be nearest to `count` things."""
    few = [level for level, parts in enumerate(chain) if count * len(parts.strays) <= FEW]
    start = few[-1] if few else 0
    row, place = np.indices((count, len(chain[start].strays))).reshape(2, -1)
    found = sifted(row, chain[start], place, measure)
    for parts in chain[start + 1 :]:
        row, place = _divided(found, len(parts.strays))
        found = sifted(row, parts, place, measure)
    return found


def sifted(row: Numbers, parts: P, place: Numbers, measure: Measure[P]) -> Candidates:
    """Those pairs that are not out of the question."""
    found = Candidates(row, place, measure(row, parts, place))
    strays = parts.strays.take(place)
    least = np.minimum.reduceat(found.distances + strays, firsts(row))
    # Written so that what is not a number stays: no thing is left without a part.
    return found.taken(np.flatnonzero(~(found.distances - strays > least.take(row))))


def _divided(found: Candidates, count: int) -> tuple[Numbers, Numbers]:
    """The same things with the finer parts, of which there are `count`."""
    parts = (TOGETHER * found.place[:, None] + np.arange(TOGETHER)).ravel()
    inside = parts < count
    return np.repeat(found.row, TOGETHER)[inside], parts[inside]


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
