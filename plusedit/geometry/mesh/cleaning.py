"""Vertices at one place joined, and faces left out that bound nothing.

Places are the same where all coordinates are equal as numbers, whichever bits they have: 0 and -0
are. Copies of a face have the same sides in any order. Both are found by hashing
rows to 64 bits (the mixing of splitmix64; Steele, Lea and Flood, Fast Splittable Pseudorandom
Number Generators, 2014), which is many times faster than sorting the rows themselves.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import PolygonMesh, starts_of

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]
Hashes = NDArray[np.uint64]

GOLDEN = np.uint64(0x9E3779B97F4A7C15)
MIXING = ((30, np.uint64(0xBF58476D1CE4E5B9)), (27, np.uint64(0x94D049BB133111EB)))


class Kept(NamedTuple):
    """Faces of a mesh, with the numbers that they and their corners had."""

    mesh: PolygonMesh
    faces: Indices
    """(f,)"""
    corners: Indices
    """(c,)"""

    def taken(self, chosen: Flags) -> "Kept":
        """The faces that are marked (f,); all vertices stay."""
        if chosen.all():
            return self
        marked = np.repeat(chosen, self.mesh.sizes)
        starts = starts_of(self.mesh.sizes[chosen])
        mesh = PolygonMesh(self.mesh.vertices, self.mesh.corners[marked], starts)
        return Kept(mesh, self.faces[chosen], self.corners[marked])


def cleaned(mesh: PolygonMesh) -> tuple[Kept, dict[str, int]]:
    """The faces with three different places or more, each once, and what was done how often.

    Of vertices at one place the first stands for all, of copies of a face the first stays.
    """
    welded = first_at_place(mesh.vertices)[mesh.corners]
    kept, repeated, degenerate = _with_three_corners(mesh, welded)
    copy, back = _copies(kept.mesh)
    return kept.taken(~(copy | back)), {
        "joined": _distinct(mesh.corners) - _distinct(welded),
        "repeated": repeated,
        "degenerate": degenerate,
        "copies": int(np.count_nonzero(copy)),
        "backs": int(np.count_nonzero(back)),
    }


def first_at_place(vertices: Floats) -> Indices:
    """(n,) the lowest number of a vertex at exactly the same place."""
    places = np.ascontiguousarray(vertices + 0.0)  # -0 + 0 is 0: equal numbers get equal bits
    x, y, z = places.view(np.uint64).T
    hashes = _mixed(_mixed(_mixed(x) + y) + z)
    firsts = _lowest_of_equals(hashes)
    if (places[firsts] != places).any():  # two places with one hash
        first, inverse = np.unique(places, axis=0, return_index=True, return_inverse=True)[1:]
        firsts = first[inverse.ravel()]
    return firsts


def _lowest_of_equals(values: Hashes) -> Indices:
    """(k,) where in a row each value stands first."""
    order = np.argsort(values)
    begins = np.ones(len(values), dtype=np.bool_)
    np.not_equal(values[order[1:]], values[order[:-1]], out=begins[1:])
    lowest = np.arange(len(values))
    if not begins.all():
        starts = np.flatnonzero(begins)
        lowest[order] = np.repeat(
            np.minimum.reduceat(order, starts), np.diff(starts, append=len(values))
        )
    return lowest


def _distinct(numbers: NDArray[np.integer]) -> int:
    return int(np.count_nonzero(np.bincount(numbers))) if len(numbers) else 0


def _with_three_corners(mesh: PolygonMesh, welded: Indices) -> tuple[Kept, int, int]:
    """Faces between other vertices `welded` (c,), without repetitions.

    Then how many faces had any and are still there, and how many are not.
    """
    stays = welded != welded[mesh.following]
    sizes = np.bincount(mesh.owners[stays], minlength=mesh.face_count)
    proper = sizes >= 3
    large = np.flatnonzero(sizes > 3)
    proper[large[_different(mesh, welded, large) < 3]] = False
    stays &= np.repeat(proper, mesh.sizes)
    clean = PolygonMesh(mesh.vertices, welded[stays].astype(np.int32), starts_of(sizes[proper]))
    repeated = int(np.count_nonzero(proper & (sizes < mesh.sizes)))
    kept = Kept(clean, np.flatnonzero(proper), np.flatnonzero(stays))
    return kept, repeated, int(np.count_nonzero(~proper))


def _different(mesh: PolygonMesh, welded: Indices, faces: Indices) -> Indices:
    """How many different vertices each of some faces has."""
    chosen = np.zeros(mesh.face_count, dtype=np.bool_)
    chosen[faces] = True
    marked = np.repeat(chosen, mesh.sizes)
    uses = mesh.owners[marked].astype(np.int64) * mesh.vertex_count + welded[marked]
    uses.sort()  # twenty times faster than a set of them
    new = np.ones(len(uses), dtype=np.bool_)
    np.not_equal(uses[1:], uses[:-1], out=new[1:])
    counts = np.bincount(uses[new] // mesh.vertex_count, minlength=mesh.face_count)
    return counts[faces]


def _copies(mesh: PolygonMesh) -> tuple[Flags, Flags]:
    """(f,) true for faces with the sides of one before, and for backs of a double-sided mesh.

    The sides of a polygon, in any order, determine it: with their directions the face, without
    them the face or its back.
    """
    tails = mesh.corners.astype(np.uint64)
    heads = tails[mesh.following]
    below, above = np.minimum(tails, heads), np.maximum(tails, heads)
    copy = ~_first_of_rows(mesh, tails, heads)
    back = ~_first_of_rows(mesh, below, above) & ~copy
    # A few faces back to back bound something flat; only where most are, that is all they do.
    if 4 * np.count_nonzero(back) < np.count_nonzero(~copy):
        back[:] = False
    return copy, back


def _first_of_rows(mesh: PolygonMesh, tails: Hashes, heads: Hashes) -> Flags:
    """(f,) true for faces of which none before has the same sides from `tails` to `heads`."""
    if not mesh.face_count:
        return np.zeros(0, dtype=np.bool_)
    # Two sums of different hashes: 128 bits agree by chance for no two faces of any file.
    mixed = _mixed(tails << np.uint64(32) | heads)
    sums = [np.add.reduceat(hashes, mesh.starts[:-1]) for hashes in (mixed, _mixed(mixed))]
    first = _lowest_of_equals(sums[0])
    single: Flags = (first == np.arange(mesh.face_count)) | (sums[1] != sums[1][first])
    return single


def _mixed(numbers: Hashes) -> Hashes:
    """Numbers spread over all of 64 bits, different ones to different ones."""
    mixed = numbers + GOLDEN
    for shift, factor in MIXING:
        mixed ^= mixed >> np.uint64(shift)
        mixed *= factor
    mixed ^= mixed >> np.uint64(31)
    return mixed
