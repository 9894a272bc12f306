"""Large and thin faces split before a mesh gets parameters.

A control plane holds as far as its face reaches. A face many times larger than the others, or a
long sliver, spoils the surface around it and the map of all of it; split into faces of ordinary
size it does no harm. Edges are halved that are the longest of the triangles on both sides
(Rivara, New longest-edge algorithms for the refinement and/or improvement of unstructured
triangulations, 1997): angles stay bounded, neighbors stay joined along whole edges, and the
splitting reaches only as far as edges get longer from triangle to triangle. A split mesh has the
same shape as before, with more control planes: what S means changes with it.

Polygons that need no splitting stay what they are.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.bisection import Bisection
from plusedit.geometry.mesh.polygons import Numbers, PolygonMesh, fixed, rows_of

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]

LARGE = 4.0  # radii of a face to the median of them
THIN = 0.08  # 4 pi area / perimeter^2, 1 for a circle: less is 20 times as long as wide
SLIM = 0.2  # the same; less is 7 times as long as wide, which does no harm to a few faces
SHARE = 0.05  # of the area: as many slim faces are more than a few
EDGE = 1.5  # of an even triangle to the root of its area
LONGEST = 1.4  # of the edge wanted: halves are then within a factor 1.4 of it both ways
FEWEST = 4000  # faces wanted where the mesh has fewer
ROOM = 8  # times the faces wanted: a mesh of needles is not split any further
STOPPED = "some faces are so thin that they were not split down to the size of the others"


@dataclass(frozen=True, eq=False)
class Uneven:
    """The faces of a mesh that should be split; false where there are none."""

    large: Flags
    """(f,) true where the radius is more than four times the median"""
    thin: Flags
    """(f,) true for long slivers"""

    def __bool__(self) -> bool:
        return bool(self.faces.any())

    @cached_property
    def faces(self) -> Flags:
        """(f,) both kinds."""
        return fixed(self.large | self.thin)

    @property
    def why(self) -> str:
        """A phrase for people: "12 large and 3 thin faces"; empty where there are none."""
        large = int(np.count_nonzero(self.large))
        thin = int(np.count_nonzero(self.thin & ~self.large))
        kinds = [f"{count} {name}" for count, name in ((large, "large"), (thin, "thin")) if count]
        return f"{' and '.join(kinds)} face{'' if large + thin == 1 else 's'}" if kinds else ""


@dataclass(frozen=True, eq=False)
class Refined:
    """A mesh with some faces split, and what became of each of them."""

    mesh: PolygonMesh
    """vertices of the mesh before keep their numbers, new ones follow"""
    parents: Numbers
    """(f',) the face of the mesh before in which each face lies, ascending"""
    sources: Numbers
    """(c', 3) corners of that face between which each corner lies"""
    shares: Floats
    """(c', 3) how much of each it has; rows sum to one"""
    notes: tuple[str, ...]
    """what to tell; empty where nothing was split"""

    def along(self, values: Floats) -> Floats:
        """(c', k) what values (c, k) by corner of the mesh before are at the corners now.

        They are taken as linear in each triangle, as surface parameters and texture coordinates
        are; values of faces that were not split come back to the bit.
        """
        mixed: Floats = np.einsum("cs,csk->ck", self.shares, values[self.sources])
        return mixed


def needs_refining(mesh: PolygonMesh) -> Uneven:
    """The faces much larger than most, and those that are thin and longer than most.

    Thin are slivers and, where a good part of the area consists of them, faces 7 times as long as
    wide.

    The radius of a face is the distance of its farthest corner from the mean of its corners.
    """
    if not mesh.face_count:
        nothing = np.zeros(0, dtype=np.bool_)
        return Uneven(nothing, nothing)
    points = mesh.vertices[mesh.corners]
    away = np.linalg.norm(points - np.repeat(mesh.centers, mesh.sizes, axis=0), axis=1)
    radii = np.maximum.reduceat(away, mesh.starts[:-1])
    sides = np.linalg.norm(points[mesh.following] - points, axis=1)
    round_area = mesh.sums(sides) ** 2 / (4.0 * np.pi)
    longest = np.maximum.reduceat(sides, mesh.starts[:-1])
    long = longest > 2.0 * edge_wanted(mesh, mesh.face_count)
    thin, slim = (long & (mesh.areas < least * round_area) for least in (THIN, SLIM))
    if mesh.areas[slim].sum() > SHARE * mesh.areas.sum():
        thin = slim
    return Uneven(fixed(radii > LARGE * float(np.median(radii))), fixed(thin))


def edge_wanted(mesh: PolygonMesh, faces: int) -> float:
    """The edge of even triangles, of which it takes that many to cover the mesh."""
    return EDGE * float(np.sqrt(mesh.areas.sum() / max(faces, 1)))


def refined(mesh: PolygonMesh, *, wanted: int | None = None) -> Refined:
    """The mesh with large and thin faces split down to the size of the others.

    `wanted` is about how many faces there should be if they were even, by default as many as
    there are, but at least 4000. Where that is more than there are, all faces are split down to
    it, not only those that stand out. Without a face that stands out the mesh comes back as it
    is, unless `wanted` is given.
    """
    uneven = needs_refining(mesh)
    count = max(mesh.face_count, FEWEST) if wanted is None else wanted
    if not mesh.face_count or not (uneven or wanted is not None):
        return _unsplit(mesh)
    marked = np.ones_like(uneven.faces) if count > mesh.face_count else uneven.faces
    cut = mesh.triangulation
    beyond = LONGEST * edge_wanted(mesh, count)
    bisection = Bisection(mesh.vertices, cut.triangles.astype(np.intp), marked[cut.owners], beyond)
    most = ROOM * max(count, mesh.face_count)
    while (going := bisection.step()) and bisection.count < most:
        pass
    return _put_together(mesh, bisection, (uneven.why, STOPPED if going else ""))


def _unsplit(mesh: PolygonMesh) -> Refined:
    faces = fixed(np.arange(mesh.face_count, dtype=np.int32))
    corners = np.arange(len(mesh.corners), dtype=np.int32)
    return Refined(mesh, faces, *_as_they_were(corners), ())


def _as_they_were(corners: Numbers) -> tuple[Numbers, Floats]:
    """Sources and shares of corners of the mesh that are still corners."""
    shares = np.zeros((len(corners), 3))
    shares[:, 0] = 1.0
    return fixed(np.repeat(corners[:, None], 3, axis=1)), fixed(shares)


def _put_together(mesh: PolygonMesh, bisection: Bisection, remarks: tuple[str, str]) -> Refined:
    """Faces of which nothing was split as they were, the triangles of all others for them."""
    cut, pieces = mesh.triangulation, bisection.pieces
    whole = np.bincount(cut.owners[pieces.roots], minlength=mesh.face_count) == mesh.sizes - 2
    if whole.all():
        return _unsplit(mesh)
    pieces = pieces.taken(~whole[cut.owners[pieces.roots]])
    owners = np.concatenate([np.flatnonzero(whole), cut.owners[pieces.roots]]).astype(np.int32)
    sizes = np.concatenate([mesh.sizes[whole], np.full(len(pieces.roots), 3)])
    faces = np.argsort(owners, kind="stable")
    order, starts = rows_of(sizes, faces)
    old = np.flatnonzero(np.repeat(whole, mesh.sizes)).astype(np.int32)
    sources, shares = _as_they_were(old)
    vertices = np.concatenate([mesh.corners[old], pieces.vertices.ravel().astype(np.int32)])
    sources = np.concatenate([sources, np.repeat(cut.corners[pieces.roots], 3, axis=0)])[order]
    shares = np.concatenate([shares, pieces.shares.reshape(-1, 3)])[order]
    split = PolygonMesh(bisection.points, vertices[order], starts)
    return Refined(
        split, fixed(owners[faces]), fixed(sources), fixed(shares), _notes(mesh, split, remarks)
    )


def _notes(mesh: PolygonMesh, split: PolygonMesh, remarks: tuple[str, str]) -> tuple[str, ...]:
    why, stopped = remarks
    faces = "1 face was" if mesh.face_count == 1 else f"{mesh.face_count} faces were"
    told = f"{faces} split into {split.face_count}"
    return tuple(filter(None, [f"{told} because of {why}" if why else told, stopped]))
