"""Triangles halved across their longest edges, neighbors together.

An edge may be halved once it is the longest of all its triangles; then the triangles on both sides
are halved by it, and no edge has a vertex in its middle. To halve any other edge, the longest edge
of its triangle is halved first, for which that of the next triangle may have to be, and so on:
every step leads to a longer edge, so it ends (Rivara's longest-edge propagation path). All edges
that may be halved are halved at once.

Halving alone cuts a needle into ever smaller needles. So where the triangle that was there at the
beginning, the *root*, is thin, edges within it are turned to the other diagonal where that leaves
the larger smallest angle (`flipping`), and are halved themselves only once no edge around the root
has to be.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flipping import KEY, Pieces, edge_keys, flipped, slender

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]

# Which of equally long edges is the longest is drawn by lot, else one after the other would be.
LOT = np.uint64(0x9E3779B97F4A7C15)


class _Edges(NamedTuple):
    """The edges of some triangles."""

    ends: Indices
    """(e, 2) vertices, ascending"""
    sides: Indices
    """(t, 3) the edges of every triangle: corner 0 to 1, 1 to 2, 2 to 0"""
    longest: Indices
    """(t,) which of a triangle's edges is the longest, 0 to 2"""
    halved: Flags
    """(e,) true for those to halve now"""


class Bisection:
    """Triangles whose edges beyond a length are halved, step by step.

    Those of marked triangles are, and what has to be for that.
    """

    def __init__(self, points: Floats, triangles: Indices, marked: Flags, beyond: float) -> None:
        self.points = points
        """(n, 3) the vertices, new ones at the end"""
        self._beyond = beyond
        self._marked = marked
        self._slender = slender(points, triangles)
        numbers = np.arange(len(triangles))
        shares = np.broadcast_to(np.eye(3), (len(numbers), 3, 3))
        self._all = Pieces(triangles, numbers, shares)
        self._awake = self._all.taken(marked)
        # Most triangles are never reached; until then they are only looked up by their edges.
        self._asleep = ~marked
        keys = edge_keys(triangles[~marked]).ravel()
        order = np.argsort(keys)
        self._sleepers = np.flatnonzero(~marked)[order // 3]
        self._sleeping_keys = keys[order]
        self._resting: list[Pieces] = []

    @property
    def count(self) -> int:
        """How many triangles there are now."""
        made = sum(len(pieces.roots) for pieces in (self._awake, *self._resting))
        return made + int(np.count_nonzero(self._asleep))

    @property
    def pieces(self) -> Pieces:
        """All triangles, in no particular order."""
        return self._awake.joined(self._all.taken(self._asleep), *self._resting)

    def step(self) -> bool:
        """Halve every edge that may be halved now; false where none has to be any more."""
        edges = self._edges()
        if not edges.halved.any():
            return False
        self._halve(edges)
        thin = self._slender[self._awake.roots]
        if thin.any():
            turned = flipped(self.points, self._awake.taken(thin))
            self._awake = self._awake.taken(~thin).joined(turned)
        return True

    def _edges(self) -> _Edges:
        """The edges of all triangles that something is asked of."""
        while True:
            keys, inverse = np.unique(edge_keys(self._awake.vertices), return_inverse=True)
            sides = inverse.reshape(-1, 3)
            ends = np.stack(np.divmod(keys, KEY), axis=1)
            steps = self.points[ends[:, 1]] - self.points[ends[:, 0]]
            lengths = np.sqrt(np.einsum("ed,ed->e", steps, steps))
            moving = (lengths > self._beyond)[sides].any(axis=1)
            lengths[self._of_needles(sides, lengths)] = 0.0
            ranks = np.empty(len(keys), dtype=np.intp)
            ranks[np.lexsort((keys.astype(np.uint64) * LOT, lengths))] = np.arange(len(keys))
            longest = ranks[sides].argmax(axis=1) if len(sides) else np.zeros(0, dtype=np.intp)
            asked = self._asked(sides, longest, lengths > self._beyond)
            if not self._wake(keys[asked]):
                break
        halved = asked & _longest_of_all(sides, longest, len(keys))
        if not moving.all():
            self._resting.append(self._awake.taken(~moving))
            self._awake = self._awake.taken(moving)
        return _Edges(ends, sides[moving], longest[moving], halved)

    def _of_needles(self, sides: Indices, lengths: Floats) -> Flags:
        """(e,) true inside slender roots that have a long edge around.

        Once the edges around are halved, those inside can be turned across and are short.
        """
        roots = self._awake.roots
        one = np.empty(len(lengths), dtype=np.intp)
        one[sides] = roots[:, None]
        inside = np.bincount(sides.ravel(), minlength=len(one)) == 2
        inside[sides[one[sides] != roots[:, None]]] = False
        waiting = np.zeros(len(self._slender), dtype=np.bool_)
        waiting[roots[(~inside & (lengths > self._beyond))[sides].any(axis=1)]] = True
        held: Flags = inside & (self._slender & waiting)[one]
        return held

    def _asked(self, sides: Indices, longest: Indices, long: Flags) -> Flags:
        """(e,) true for edges to be halved, now or once others have been for that."""
        asked = np.zeros(len(long), dtype=np.bool_)
        asked[sides[self._marked[self._awake.roots]]] = True
        asked &= long
        first = _of_longest(sides, longest)
        reached = asked.copy()
        while reached.any():
            before = asked.copy()
            asked[first[reached[sides].any(axis=1)]] = True
            reached = asked & ~before
        return asked

    def _wake(self, keys: Indices) -> bool:
        """Have triangles that never were reached take part if they have one of these edges."""
        begins = np.searchsorted(self._sleeping_keys, keys)
        counts = np.searchsorted(self._sleeping_keys, keys, side="right") - begins
        places = np.repeat(begins - np.cumsum(counts) + counts, counts) + np.arange(counts.sum())
        found = np.unique(self._sleepers[places])
        woken = found[self._asleep[found]]
        self._asleep[woken] = False
        self._awake = self._awake.joined(self._all.taken(woken))
        return len(woken) > 0

    def _halve(self, edges: _Edges) -> None:
        numbers = np.cumsum(edges.halved) - 1 + len(self.points)
        middles = self.points[edges.ends[edges.halved]].mean(axis=1)
        self.points = np.concatenate([self.points, middles])
        longest = _of_longest(edges.sides, edges.longest)
        split = edges.halved[longest]
        whole = self._awake.taken(split).turned(edges.longest[split])
        middle, share = numbers[longest[split]], whole.shares[:, :2].mean(axis=1)
        halves = whole.with_corner(1, middle, share), whole.with_corner(0, middle, share)
        self._awake = self._awake.taken(~split).joined(*halves)


def _of_longest(sides: Indices, longest: Indices) -> Indices:
    """(t,) the longest edge of every triangle."""
    return sides[np.arange(len(sides)), longest]


def _longest_of_all(sides: Indices, longest: Indices, count: int) -> Flags:
    """(e,) true for edges that are the longest of each of their triangles."""
    uses = np.bincount(sides.ravel(), minlength=count)
    agreed: Flags = np.bincount(_of_longest(sides, longest), minlength=count) == uses
    return agreed
