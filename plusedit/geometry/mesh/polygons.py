"""Polygon meshes: vertices in space and faces of three corners or more.

The corners of all faces stand in one row, face after face: face i has the vertices
`corners[starts[i]:starts[i + 1]]`, counter-clockwise as seen from its front. A number of that row
is the number of a *corner*; what differs from face to face at one vertex, such as texture
coordinates or surface parameters, is kept by corner.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.mesh.triangulation import triangulated

if TYPE_CHECKING:
    from plusedit.geometry.mesh.subdivision import Subdivided
    from plusedit.geometry.mesh.topology import Topology

Indices = NDArray[np.intp]
Numbers = NDArray[np.int32]
"""Of vertices, corners or faces; -1 where there is none."""

Kind = TypeVar("Kind", bound=np.generic)

MOST = int(np.iinfo(np.int32).max)  # corners that can be numbered


class Triangles(NamedTuple):
    """A mesh cut into triangles, with the corners that they have."""

    triangles: Numbers
    """(t, 3) vertices"""
    owners: Numbers
    """(t,) the face in which each triangle lies, ascending"""
    corners: Numbers
    """(t, 3) the corners of the mesh, where `triangles` has their vertices"""


class Taken(NamedTuple):
    """Some faces of a mesh as a mesh of their own, without vertices that they do not use."""

    mesh: "PolygonMesh"
    vertex_numbers: Numbers
    """(n',) what the vertices were numbered, ascending"""
    corner_numbers: Numbers
    """(c',) what the corners were numbered"""


@dataclass(frozen=True, eq=False)
class PolygonMesh:
    """Vertices and faces; never changed in place.

    Compared by identity, so that it can key a cache. Faces may share vertices in any manner and
    vertices may be used by no face; ValueError where a number points at no vertex or a face has
    fewer than three corners.
    """

    vertices: Floats
    """(n, 3)"""
    corners: Numbers
    """(c,) the vertex of every corner"""
    starts: Numbers
    """(f + 1,) the first corner of every face, and c"""

    def __post_init__(self) -> None:
        vertices = frozen(self.vertices, shape=(None, 3), name="vertices")
        corners, starts = _numbers(self.corners, "corners"), _numbers(self.starts, "starts")
        _check_faces(corners, starts, len(vertices))
        object.__setattr__(self, "vertices", vertices)
        object.__setattr__(self, "corners", corners)
        object.__setattr__(self, "starts", starts)

    @classmethod
    def of(cls, vertices: ArrayLike, faces: Iterable[Sequence[int]]) -> "PolygonMesh":
        """The mesh of rows of three coordinates and of faces, each a row of vertex numbers."""
        if isinstance(faces, np.ndarray) and faces.ndim == 2:
            return cls.of_rows(vertices, faces)
        rows = list(faces)
        sizes = np.array([len(row) for row in rows], dtype=np.int64)
        corners = np.array([number for row in rows for number in row], dtype=np.int64)
        return cls(np.reshape(vertices, (-1, 3)), _numbers(corners, "corners"), starts_of(sizes))

    @classmethod
    def of_rows(cls, vertices: ArrayLike, faces: ArrayLike) -> "PolygonMesh":
        """The mesh of faces (f, k) that have k corners each, such as triangles."""
        rows = np.asarray(faces)
        count, size = rows.shape
        corners, starts = _numbers(rows.ravel(), "corners"), starts_of(np.full(count, size))
        return cls(np.asarray(vertices, dtype=np.float64), corners, starts)

    @property
    def vertex_count(self) -> int:
        return len(self.vertices)

    @property
    def face_count(self) -> int:
        return len(self.starts) - 1

    @cached_property
    def sizes(self) -> Numbers:
        """(f,) how many corners each face has."""
        return fixed(np.diff(self.starts))

    @cached_property
    def owners(self) -> Numbers:
        """(c,) the face of every corner."""
        return fixed(np.repeat(np.arange(self.face_count, dtype=np.int32), self.sizes))

    @cached_property
    def following(self) -> Numbers:
        """(c,) the next corner of the same face, counter-clockwise."""
        after = np.arange(1, len(self.corners) + 1, dtype=np.int32)
        after[self.starts[1:] - 1] = self.starts[:-1]
        return fixed(after)

    @cached_property
    def preceding(self) -> Numbers:
        """(c,) the corner before in the same face."""
        before = np.arange(-1, len(self.corners) - 1, dtype=np.int32)
        before[self.starts[:-1]] = self.starts[1:] - 1
        return fixed(before)

    @property
    def faces(self) -> list[tuple[int, ...]]:
        """Every face as a tuple of vertex numbers; slow, for files and tests."""
        row, starts = self.corners.tolist(), self.starts.tolist()
        return [tuple(row[a:b]) for a, b in pairwise(starts)]

    @cached_property
    def centers(self) -> Floats:
        """(f, 3) the mean of every face's corners."""
        sums = self.sums(self.vertices[self.corners])
        return fixed(sums / self.sizes[:, None])

    @cached_property
    def area_vectors(self) -> Floats:
        """(f, 3) normals to the front of every face, as long as its area.

        Of a polygon that is not flat, the area of its projection along the normal of its
        best-fitting plane (Newell's method).
        """
        around = self.vertices[self.corners]
        if (self.sizes == 3).all():
            first, second, third = around.reshape(-1, 3, 3).transpose(1, 0, 2)
            return fixed(0.5 * np.cross(second - first, third - first))
        # Sums over differences lose no digits far from the origin.
        around -= np.repeat(around[self.starts[:-1]], self.sizes, axis=0)
        return fixed(0.5 * self.sums(np.cross(around, around[self.following])))

    @cached_property
    def areas(self) -> Floats:
        """(f,) the areas of the faces."""
        return fixed(np.linalg.norm(self.area_vectors, axis=1))

    def sums(self, values: Floats) -> Floats:
        """(f, ...) the sum of the values (c, ...) of every face's corners."""
        if not self.face_count:
            return np.zeros((0, *values.shape[1:]))
        summed: Floats = np.add.reduceat(values, self.starts[:-1], axis=0)
        return summed

    @cached_property
    def used(self) -> NDArray[np.bool_]:
        """(n,) true for vertices of some face."""
        marks = np.zeros(self.vertex_count, dtype=np.bool_)
        marks[self.corners] = True
        return fixed(marks)

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lowest and the highest coordinates (3,) of the faces; zeros where there are none."""
        if not self.face_count:
            return np.zeros(3), np.zeros(3)
        points = self.vertices[self.used]
        return points.min(axis=0), points.max(axis=0)

    @cached_property
    def diagonal(self) -> float:
        """The length of the diagonal of the box around the faces."""
        low, high = self.bounds
        return float(np.linalg.norm(high - low))

    def triangles(self) -> tuple[Numbers, Numbers]:
        """(t, 3) vertices of triangles that make up the faces, and (t,) the face of each.

        A face of k corners gives k - 2 triangles, as `triangulation` cuts them; they turn the way
        the faces do and have no vertices of their own.
        """
        return self.triangulation.triangles, self.triangulation.owners

    @cached_property
    def triangulation(self) -> Triangles:
        """The same triangles together with the corners that they have."""
        corners = triangulated(self.vertices[self.corners], self.starts)
        owners = np.repeat(np.arange(self.face_count, dtype=np.int32), self.sizes - 2)
        return Triangles(fixed(self.corners[corners]), fixed(owners), fixed(corners))

    @cached_property
    def topology(self) -> "Topology":
        """How the faces hang together."""
        from plusedit.geometry.mesh.topology import Topology

        return Topology(self)

    def taken(self, face_numbers: "Sequence[int] | Numbers | Indices") -> Taken:
        """The faces of these numbers, in this order, with only the vertices that they use."""
        faces = np.asarray(face_numbers, dtype=np.int64)
        corner_numbers, starts = rows_of(self.sizes, faces)
        kept = np.zeros(self.vertex_count, dtype=np.bool_)
        kept[self.corners[corner_numbers]] = True
        renumbered = np.cumsum(kept, dtype=np.int32) - 1
        corners = renumbered[self.corners[corner_numbers]]
        numbers = np.flatnonzero(kept).astype(np.int32)
        mesh = PolygonMesh(self.vertices[numbers], corners, starts)
        return Taken(mesh, fixed(numbers), fixed(corner_numbers.astype(np.int32)))

    def subdivided(self, times: int) -> "Subdivided":
        """The mesh with every edge halved `times` times, and what values by corner become."""
        from plusedit.geometry.mesh.subdivision import subdivided

        return subdivided(self, times)

    def with_vertices(self, vertices: Floats) -> "PolygonMesh":
        """The same faces with as many other vertices (n, 3)."""
        if np.shape(vertices) != self.vertices.shape:
            raise ValueError(
                f"vertices: expected shape {self.vertices.shape}, got {np.shape(vertices)}"
            )
        return PolygonMesh(vertices, self.corners, self.starts)


def starts_of(sizes: NDArray[np.integer]) -> Numbers:
    """(f + 1,) where faces of these sizes (f,) begin in the row of corners, and its length."""
    starts = np.zeros(len(sizes) + 1, dtype=np.int64)
    np.cumsum(sizes, out=starts[1:])
    if starts[-1] > MOST:
        raise ValueError(f"faces: have {starts[-1]} corners, more than the {MOST} that fit")
    return starts.astype(np.int32)


def rows_of(sizes: NDArray[np.integer], rows: NDArray[np.integer]) -> tuple[Indices, Numbers]:
    """Where the entries of some rows stand if rows of these sizes (f,) follow each other.

    Then the starts, as of `starts_of`, of the chosen rows put together.
    """
    chosen = sizes[rows]
    starts, before = starts_of(chosen), np.cumsum(sizes) - sizes
    places: Indices = np.arange(starts[-1]) + np.repeat(before[rows] - starts[:-1], chosen)
    return places, starts


def fixed(array: NDArray[Kind]) -> NDArray[Kind]:
    """The array itself, read-only from now on."""
    array.flags.writeable = False
    return array


def _numbers(values: ArrayLike, name: str) -> Numbers:
    """A read-only copy as 32-bit numbers; ValueError where it is no row of whole numbers."""
    given = np.asarray(values)
    if given.ndim != 1 or (given.size and not np.issubdtype(given.dtype, np.integer)):
        raise ValueError(f"{name}: expected a row of whole numbers, got {given.dtype}{given.shape}")
    if given.size and (given.max() > MOST or given.min() < -MOST):
        raise ValueError(f"{name}: has a number beyond {MOST}")
    return fixed(given.astype(np.int32))


def _check_faces(corners: Numbers, starts: Numbers, vertex_count: int) -> None:
    if len(starts) == 0 or starts[0] != 0 or starts[-1] != len(corners):
        raise ValueError(f"starts: must lead from 0 to the number of corners, {len(corners)}")
    sizes = np.diff(starts)
    if sizes.size and sizes.min() < 3:
        face = int(sizes.argmin())
        raise ValueError(f"face {face}: has {sizes[face]} corners, a polygon has three or more")
    wrong = (corners < 0) | (corners >= vertex_count)
    if wrong.any():
        corner = int(wrong.argmax())
        face = int(np.searchsorted(starts, corner, side="right")) - 1
        raise ValueError(
            f"face {face}: names vertex {corners[corner]}, there are vertices 0 to"
            f" {vertex_count - 1}"
            if vertex_count
            else f"face {face}: names vertex {corners[corner]}, there are no vertices"
        )
