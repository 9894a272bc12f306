"""In which order the vertices of a sheet are eliminated from its equations.

Eliminating a vertex joins all of its neighbors with each other. *Nested dissection* keeps that
within bounds (George, Nested dissection of a regular finite element mesh, 1973): the vertices are
halved where they lie in space, those along the cut come last, and both halves, which nothing joins
any more, are treated likewise. On a surface the cuts are short, about the root of the number n of
vertices; the factors then have about n log n entries. Orders by least degree need as few on most
meshes, but on regular ones, and around a vertex with many neighbors, they are found a hundred
times more slowly.

All pieces of one size are halved at once.
"""

from typing import NamedTuple

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.sheet import Flags, Indices

SMALL = 32  # vertices: pieces that stay in one
BUSY = 10.0  # times the root of n: a vertex in more edges comes after all others
FEW = 2000  # vertices, of which any order will do
TANGLED = 0.25  # of all vertices in the first cut: they don't lie as they hang together


class _Pieces(NamedTuple):
    """Sets of vertices that nothing joins, each with the places in the order that it fills."""

    members: Indices
    """(m,) vertices, piece by piece"""
    sizes: Indices
    """(k,) of the pieces, none zero"""
    places: Indices
    """(k,) the first place in the order of each"""

    @property
    def owners(self) -> Indices:
        """(m,) the piece of every member."""
        return np.repeat(np.arange(len(self.sizes)), self.sizes)

    @property
    def starts(self) -> Indices:
        """(k,) where each piece begins among the members."""
        return np.cumsum(self.sizes) - self.sizes

    @property
    def along(self) -> Indices:
        """(m,) how many members of the same piece come before each."""
        return np.arange(len(self.members)) - np.repeat(self.starts, self.sizes)

    def taken(self, chosen: Flags) -> "_Pieces":
        """The pieces that are marked (k,)."""
        members = self.members[np.repeat(chosen, self.sizes)]
        return _Pieces(members, self.sizes[chosen], self.places[chosen])


def elimination_places(points: Floats, first: Indices, second: Indices) -> Indices | None:
    """(n,) the place of every vertex in the order of elimination, 0 to n - 1.

    `points` are (n, 3), `first` and `second` (e,) the vertices that are neighbors, each pair at
    least once and in any order. None where the vertices are scattered, so that it doesn't help to
    know where they lie.
    """
    count = len(points)
    edges = np.stack([first, second])[:, first != second]
    busy = np.bincount(edges.ravel(), minlength=count) > BUSY * np.sqrt(count) + 2.0 * SMALL
    found = np.empty(count, dtype=np.intp)
    found[busy] = np.arange(count - np.count_nonzero(busy), count)
    calm = np.flatnonzero(~busy)
    pieces = _without_empty(_Pieces(calm, np.array([len(calm)]), np.zeros(1, dtype=np.intp)))
    while len(pieces.sizes):
        small = pieces.sizes <= SMALL
        _place(found, pieces.taken(small))
        pieces = pieces.taken(~small)
        if len(pieces.sizes):
            pieces, cuts, edges = _halved(points, pieces, edges)
            if count > FEW and cuts.sizes.max(initial=0) > TANGLED * count:
                return None
            _place(found, cuts)
    return found


def _place(found: Indices, pieces: _Pieces) -> None:
    """Give the members of pieces the places of these, as they come."""
    found[pieces.members] = np.repeat(pieces.places, pieces.sizes) + pieces.along


def _halved(points: Floats, pieces: _Pieces, edges: Indices) -> tuple[_Pieces, _Pieces, Indices]:
    """The halves of pieces, what is cut out between them, and the edges (2, e) within pieces."""
    pieces = _sorted(points, pieces)
    owners, count = pieces.owners, len(pieces.sizes)
    above = pieces.along >= np.repeat(pieces.sizes // 2, pieces.sizes)
    piece_of, is_above = np.full(len(points), -1), np.zeros(len(points), dtype=np.bool_)
    piece_of[pieces.members], is_above[pieces.members] = owners, above
    ends = piece_of[edges]
    edges = edges[:, (ends[0] == ends[1]) & (ends[0] >= 0)]
    across = np.zeros(len(points), dtype=np.bool_)
    across[edges[:, is_above[edges[0]] != is_above[edges[1]]]] = True
    beside = across[pieces.members]
    # The vertices beside the cut of the half that has fewer are enough to part both.
    upper = np.bincount(owners[beside & above], minlength=count)
    lower = np.bincount(owners[beside & ~above], minlength=count)
    cut = beside & (above == (upper < lower)[owners])
    sizes = np.bincount(3 * owners + np.where(cut, 2, above), minlength=3 * count).reshape(-1, 3)
    places = pieces.places[:, None] + np.cumsum(sizes, axis=1) - sizes
    halves = _Pieces(pieces.members[~cut], sizes[:, :2].ravel(), places[:, :2].ravel())
    cuts = _Pieces(pieces.members[cut], sizes[:, 2], places[:, 2])
    return _without_empty(halves), _without_empty(cuts), edges


def _sorted(points: Floats, pieces: _Pieces) -> _Pieces:
    """Pieces with their members sorted along the axis in which each is longest."""
    owners, starts = pieces.owners, pieces.starts
    places = points[pieces.members]
    low = np.minimum.reduceat(places, starts)
    extents = np.maximum.reduceat(places, starts) - low
    axes = extents.argmax(axis=1)
    rows = np.arange(len(axes))
    longest = np.maximum(extents[rows, axes], np.finfo(np.float64).tiny)
    along = places[np.arange(len(places)), axes[owners]] - low[rows, axes][owners]
    # One sort by piece and place: in its piece every member is between 0 and 1 along the axis.
    order = np.argsort(owners + 0.999 * along / longest[owners])
    return pieces._replace(members=pieces.members[order])


def _without_empty(pieces: _Pieces) -> _Pieces:
    there = pieces.sizes > 0
    return pieces._replace(sizes=pieces.sizes[there], places=pieces.places[there])
