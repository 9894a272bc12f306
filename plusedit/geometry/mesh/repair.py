"""Meshes as they are found made into proper surfaces, one for each connected part.

A proper surface has at most two faces at an edge, which face the same way, and one umbrella of
faces at a vertex (see `topology`). What is done for that, in this order:

1. Vertices at exactly the same place are joined; faces with fewer than three different corners
   and copies of faces are left out (`cleaning`).
2. Faces are turned over so that neighbors across edges with two faces face the same way; a part
   for which that can't be done is one-sided and can't become a surface (`orientation`).
3. Corners are joined to vertices only across edges with exactly two faces. Edges with more become
   borders, and a vertex where faces only touch falls into one for each umbrella.

Nothing is moved: every vertex of a part has the coordinates that it has in the file.
"""

from collections.abc import Iterator
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.mesh.cleaning import Kept, cleaned
from plusedit.geometry.mesh.orientation import (
    Orientation,
    half_edges_over,
    oriented,
    turned_over,
)
from plusedit.geometry.mesh.polygons import Numbers, PolygonMesh, fixed, rows_of
from plusedit.geometry.mesh.topology import (
    SharedEdges,
    first_of_each,
    opposites,
    pairs,
    shared_edges,
    umbrellas,
)

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]

FLAT = 1e-12  # of an area to the squared sides around it: less is rounding of points on a line


@dataclass(frozen=True)
class Repairs:
    """How often what was done."""

    joined: int = 0
    """vertices at the place of another one"""
    repeated: int = 0
    """faces that named a place twice in a row, and have three corners or more without that"""
    degenerate: int = 0
    """faces with fewer than three different corners"""
    copies: int = 0
    """faces with the same sides as one before"""
    backs: int = 0
    """faces that were the backs of others, where most had one"""
    one_sided: int = 0
    """parts like a Moebius strip, beside others"""
    flat: int = 0
    """parts whose corners all lie on a line, beside others"""
    turned: int = 0
    """faces turned over, in parts where others were not"""
    inside_out: int = 0
    """closed parts turned over"""
    opened: int = 0
    """edges with more than two faces"""
    split: int = 0
    """vertices where faces only touched"""

    @property
    def notes(self) -> tuple[str, ...]:
        """A sentence for each kind of repair that was needed."""
        counts = {field.name: getattr(self, field.name) for field in fields(self)}
        return tuple(
            SENTENCES[kind][count > 1].format(count) for kind, count in counts.items() if count
        )


SENTENCES = {
    "joined": (
        "1 vertex at the same place as another was joined with it",
        "{} vertices at the same places as others were joined with them",
    ),
    "repeated": (
        "1 face had a corner twice in a row; it has it once now",
        "{} faces had a corner twice in a row; they have it once now",
    ),
    "degenerate": (
        "1 face with fewer than three different corners was left out",
        "{} faces with fewer than three different corners were left out",
    ),
    "copies": (
        "1 copy of a face was left out",
        "{} copies of faces were left out",
    ),
    "backs": (
        "1 face that was only the back of another was left out",
        "{} faces that were only the backs of others were left out",
    ),
    "one_sided": (
        "1 part is one-sided like a Moebius strip and was left out",
        "{} parts are one-sided like a Moebius strip and were left out",
    ),
    "flat": (
        "1 part without any area was left out",
        "{} parts without any area were left out",
    ),
    "turned": (
        "1 face was turned over to face the way its neighbors do",
        "{} faces were turned over to face the way their neighbors do",
    ),
    "inside_out": (
        "1 closed part was inside out and was turned",
        "{} closed parts were inside out and were turned",
    ),
    "opened": (
        "1 edge with more than two faces was cut open",
        "{} edges with more than two faces were cut open",
    ),
    "split": (
        "1 vertex where faces only touched was split",
        "{} vertices where faces only touched were split",
    ),
}


@dataclass(frozen=True, eq=False)
class Part:
    """A connected part of a mesh as a proper surface of its own."""

    mesh: PolygonMesh
    faces: Numbers
    """(f,) what its faces were numbered, ascending"""
    corners: Numbers
    """(c,) what its corners were numbered: values by corner follow as values[corners]"""
    vertices: Numbers
    """(n,) what its vertices were numbered, ascending; those that were split come repeatedly"""


@dataclass(frozen=True, eq=False)
class Repaired:
    """The connected parts of a mesh, the one with the most faces first, and what was done."""

    parts: tuple[Part, ...]
    repairs: Repairs

    @property
    def notes(self) -> tuple[str, ...]:
        """A sentence for each kind of repair that was needed."""
        return self.repairs.notes


def repaired(mesh: PolygonMesh) -> Repaired:
    """The connected parts of `mesh` as proper surfaces.

    ValueError, with a sentence for people, where nothing would be left: there are no faces, none
    has three different corners or any area, or all parts are one-sided.
    """
    kept, counts = cleaned(mesh)
    if not kept.mesh.face_count:
        raise ValueError(
            "no face has three different corners" if mesh.face_count else "there are no faces"
        )
    shared, first, second, found = _sides(kept.mesh)
    counts["one_sided"], counts["flat"], usable = _usable(kept.mesh, found)
    if not usable.all():
        kept = kept.taken(usable)
        shared, first, second, found = _sides(kept.mesh)
    touched = _ends_of(kept.mesh, shared, shared.counts > 2)
    counts |= found.counts() | {"opened": int(np.count_nonzero(shared.counts > 2))}
    if found.turned.any():
        first, second = (half_edges_over(kept.mesh, found.turned, ends) for ends in (first, second))
        kept = turned_over(kept, found.turned)
    glued = opposites(len(kept.corners), first, second)
    umbrella_of = umbrellas(kept.mesh.following, glued)
    several = _vertices_of_several(kept.mesh, umbrella_of)
    counts["split"] = len(np.setdiff1d(several, touched, assume_unique=True))
    return Repaired(tuple(_parts(kept, found.component_of, umbrella_of)), Repairs(**counts))


def _sides(mesh: PolygonMesh) -> tuple[SharedEdges, Indices, Indices, Orientation]:
    """The edges, the pairs of half-edges to be glued, and the faces to be turned for that."""
    shared = shared_edges(mesh.corners, mesh.following, mesh.vertex_count)
    first, second = pairs(shared)
    apart = mesh.owners[first] != mesh.owners[second]
    first, second = first[apart], second[apart]
    return shared, first, second, oriented(mesh, first, second)


def _usable(mesh: PolygonMesh, found: Orientation) -> tuple[int, int, Flags]:
    """How many parts are one-sided, how many have no area, and (f,) the faces of all others."""
    one_sided = found.one_sided
    flat = _flat(mesh, found.component_of) & ~one_sided
    bad = one_sided | flat
    if bad.all():
        raise ValueError(
            "the mesh is one-sided like a Moebius strip: no side of it can be the front"
            if one_sided.any()
            else "the faces have no area: the corners of each lie on one line"
        )
    return int(one_sided.sum()), int(flat.sum()), ~bad[found.component_of]


def _flat(mesh: PolygonMesh, component_of: Numbers) -> Flags:
    """(parts,) true for those without area."""
    points = mesh.vertices[mesh.corners]
    sides = points[mesh.following] - points
    squares = np.bincount(component_of[mesh.owners], np.einsum("cd,cd->c", sides, sides))
    flat: Flags = np.bincount(component_of, mesh.areas) <= FLAT * squares
    return flat


def _ends_of(mesh: PolygonMesh, shared: SharedEdges, chosen: Flags) -> Indices:
    """The vertices at the ends of the edges that are marked (e,), ascending."""
    half_edges = shared.corners[shared.firsts[chosen]]
    ends = [mesh.corners[half_edges], mesh.corners[mesh.following[half_edges]]]
    return np.unique(np.concatenate(ends)).astype(np.intp)


def _vertices_of_several(mesh: PolygonMesh, umbrella_of: Numbers) -> Indices:
    """The vertices that have more than one umbrella, ascending."""
    return np.flatnonzero(np.bincount(mesh.corners[first_of_each(umbrella_of)]) > 1)


def _parts(kept: Kept, component_of: Numbers, umbrella_of: Numbers) -> Iterator[Part]:
    """The parts, each a slice of all faces and umbrellas once these are sorted by part."""
    mesh = kept.mesh
    sizes = np.bincount(component_of)
    ranks = np.empty_like(sizes)
    ranks[np.argsort(-sizes, kind="stable")] = np.arange(len(sizes))
    faces = np.argsort(ranks[component_of], kind="stable")
    corners, starts = rows_of(mesh.sizes, faces)

    firsts = first_of_each(umbrella_of)
    numbers, part_of = mesh.corners[firsts], ranks[component_of[mesh.owners[firsts]]]
    umbrellas_sorted = np.lexsort((numbers, part_of))
    renumbered = np.empty_like(umbrellas_sorted)
    renumbered[umbrellas_sorted] = np.arange(len(umbrellas_sorted))
    vertices, rows = numbers[umbrellas_sorted], renumbered[umbrella_of[corners]]

    face_ends = np.cumsum(np.sort(sizes)[::-1])
    vertex_ends = np.cumsum(np.bincount(part_of))
    face, vertex = 0, 0
    for face_end, vertex_end in zip(face_ends.tolist(), vertex_ends.tolist(), strict=True):
        begin, end = starts[face], starts[face_end]
        part = PolygonMesh(
            mesh.vertices[vertices[vertex:vertex_end]],
            (rows[begin:end] - vertex).astype(np.int32),
            starts[face : face_end + 1] - begin,
        )
        yield Part(
            part,
            fixed(kept.faces[faces[face:face_end]].astype(np.int32)),
            fixed(kept.corners[corners[begin:end]].astype(np.int32)),
            fixed(vertices[vertex:vertex_end].astype(np.int32)),
        )
        face, vertex = face_end, vertex_end
