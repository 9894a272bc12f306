"""How far the surface of a mesh is from the mesh: from its points to the surface, and back.

Both are taken as triangles with the same corners: those of the mesh, and the same ones moved to the
surface. Faces of coarse meshes are split before, for a surface bends between far corners. Of a
point the distance is looked for among the triangles around the corner that it comes from, and those
whose middles are nearest; where none of them is the nearest of all it comes out too large.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh, fixed

FEWEST = 4000  # faces: coarser meshes are split until they have as many
MOST_TIMES = 5  # that they are split
AROUND, NEARBY = 8, 8  # triangles looked at around the corner itself, and by their middles
SHARE = 8192  # points worked on at a time

Indices = NDArray[np.intp]


@dataclass(frozen=True)
class Spread:
    """Some distances in three numbers, in the unit of the points."""

    rms: float
    """root of the mean square"""
    median: float
    largest: float

    @classmethod
    def of(cls, distances: Floats) -> "Spread":
        """That of distances (m,); zeros where there are none."""
        if not len(distances):
            return cls(0.0, 0.0, 0.0)
        largest = float(distances.max())
        scale = largest if largest > 0.0 else 1.0
        rms = scale * float(np.sqrt(np.mean((distances / scale) ** 2)))
        return cls(rms, float(np.median(distances)), largest)


@dataclass(frozen=True, eq=False)
class Deviation:
    """Distances between a mesh and a surface that goes with it."""

    from_mesh: Floats
    """(m,) of points of the mesh from the surface: its vertices first, then points between"""
    from_surface: Floats
    """(m,) of the points of the surface that go with them from the mesh"""
    used: NDArray[np.bool_]
    """(n,) true for vertices of some face; those of none have the distance 0"""
    diagonal: float
    """of the box around the mesh"""

    @property
    def by_vertex(self) -> Floats:
        """(n,) of the vertices of the mesh from the surface."""
        return self.from_mesh[: len(self.used)]

    @cached_property
    def to_surface(self) -> Spread:
        """From the mesh to the surface."""
        return Spread.of(self._counting(self.from_mesh))

    @cached_property
    def to_mesh(self) -> Spread:
        """From the surface back to the mesh."""
        return Spread.of(self._counting(self.from_surface))

    def _counting(self, distances: Floats) -> Floats:
        count = len(self.used)
        return np.concatenate([distances[:count][self.used], distances[count:]])


def deviation(surface: MeshSurface) -> Deviation:
    """The distances between a surface, evaluated to full accuracy, and its mesh.

    Planes that were edited are away from the mesh as far as they were moved.
    """
    mesh = surface.mesh
    finer = mesh.subdivided(times_for(mesh))
    places = vertex_places(finer.mesh, finer.along(surface.parameters))
    return deviation_of(finer.mesh, surface.at(places), mesh)


def deviation_of(mesh: PolygonMesh, points: Floats, before: PolygonMesh | None = None) -> Deviation:
    """The distances between a mesh and its vertices moved to `points` (n, 3).

    `before` is the mesh that was split to become `mesh`; without it, `mesh` itself. The points may
    be of any precision, such as those of a preview.
    """
    whole = mesh if before is None else before
    corners, used = mesh.triangulation.triangles.astype(np.intp), mesh.used
    moved = np.asarray(points, dtype=np.float64)
    own = np.flatnonzero(used)
    from_mesh, from_surface = np.zeros((2, mesh.vertex_count))
    from_mesh[own] = _distances(mesh.vertices, moved, corners, own)
    from_surface[own] = _distances(moved, mesh.vertices, corners, own)
    used = used[: whole.vertex_count]
    return Deviation(fixed(from_mesh), fixed(from_surface), used, whole.diagonal)


def times_for(mesh: PolygonMesh, fewest: int = FEWEST) -> int:
    """How often the faces of a mesh are split so that there are enough of them."""
    count, times = mesh.face_count, 0
    while count < fewest and times < MOST_TIMES:
        count, times = 4 * count, times + 1
    return times


def vertex_places(mesh: PolygonMesh, parameters: Floats) -> Floats:
    """(n, 2) parameters of vertices from those of corners (c, 2): each as in its first corner.

    A vertex of no face has those of the first corner of all.
    """
    places = np.tile(parameters[:1], (mesh.vertex_count, 1))
    # Written backwards, so that the first corner of each vertex is the one that stays.
    places[mesh.corners[::-1]] = parameters[::-1]
    return places


def _distances(points: Floats, vertices: Floats, corners: Indices, own: Indices) -> Floats:
    """(m,) of points[own] from the triangles whose `corners` (t, 3) are among the vertices."""
    from scipy.spatial import cKDTree

    triangles = _Triangles.of(vertices[corners])
    around = _around(corners, len(vertices), own)
    tree = cKDTree(triangles.middles)
    nearby = min(NEARBY, len(corners))
    found = np.empty(len(own))
    for first in range(0, len(own), SHARE):
        rows = slice(first, first + SHARE)
        at = points[own[rows]]
        _, close = tree.query(at, nearby)
        candidates = np.concatenate([around[rows], close.reshape(len(at), -1)], axis=1)
        best = triangles.squares(at, candidates).argmin(axis=1)
        found[rows] = triangles.distances(at, candidates[np.arange(len(at)), best])
    return found


def _around(corners: Indices, count: int, own: Indices) -> Indices:
    """(m, 8) triangles around vertices; where there are fewer, the last stands repeatedly."""
    by_vertex = np.argsort(corners.ravel(), kind="stable") // 3
    counts = np.bincount(corners.ravel(), minlength=count)
    starts = np.cumsum(counts) - counts
    steps = np.minimum(np.arange(AROUND), np.maximum(counts[own, None] - 1, 0))
    found: Indices = by_vertex[starts[own, None] + steps]
    return found


@dataclass(frozen=True, eq=False)
class _Triangles:
    """Triangles a, a + b, a + c with what distances from them take."""

    a: Floats
    b: Floats
    c: Floats
    middles: Floats
    bb: Floats
    """(t,) b . b, and so on"""
    bc: Floats
    cc: Floats
    thickness: Floats
    """(t,) 1 / (bb cc - bc^2), zero for triangles without area"""

    @classmethod
    def of(cls, at: Floats) -> "_Triangles":
        """Of corners (t, 3, 3)."""
        a, b, c = at[:, 0], at[:, 1] - at[:, 0], at[:, 2] - at[:, 0]
        bb, bc, cc = (np.einsum("td,td->t", x, y) for x, y in ((b, b), (b, c), (c, c)))
        area = bb * cc - bc**2
        flat = area <= 1e-24 * (bb + cc) ** 2
        thickness = np.where(flat, 0.0, 1.0 / np.where(flat, 1.0, area))
        return cls(a, b, c, at.mean(axis=1), bb, bc, cc, thickness)

    def squares(self, points: Floats, numbers: Indices) -> Floats:
        """(m, k) squared distances of points (m, 3) from k triangles each, to half the digits."""
        away = points[:, None] - self.a[numbers]
        along_b = np.einsum("mkd,mkd->mk", away, self.b[numbers])
        along_c = np.einsum("mkd,mkd->mk", away, self.c[numbers])
        square = np.einsum("mkd,mkd->mk", away, away)
        bb, bc, cc = self.bb[numbers], self.bc[numbers], self.cc[numbers]
        share_b = (cc * along_b - bc * along_c) * self.thickness[numbers]
        share_c = (bb * along_c - bc * along_b) * self.thickness[numbers]
        inside = (share_b > 0.0) & (share_c > 0.0) & (share_b + share_c < 1.0)
        flat = square - share_b * along_b - share_c * along_c
        sides = np.minimum(
            np.minimum(_to_side(square, along_b, bb), _to_side(square, along_c, cc)),
            _to_side(square - 2.0 * along_b + bb, along_c - along_b + bb - bc, bb + cc - 2.0 * bc),
        )
        found: Floats = np.where(inside, flat, sides)
        return found

    def distances(self, points: Floats, numbers: Indices) -> Floats:
        """(m,) distances of points (m, 3) from one triangle each, to all digits."""
        a, b, c = self.a[numbers], self.b[numbers], self.c[numbers]
        away = points - a
        zero = np.zeros_like(away)
        sides = [(zero, b), (zero, c), (b, c - b)]
        found = np.minimum.reduce([_from_side(away - start, side) for start, side in sides])
        along_b, along_c = (np.einsum("md,md->m", away, side) for side in (b, c))
        bb, bc, cc = self.bb[numbers], self.bc[numbers], self.cc[numbers]
        share_b = (cc * along_b - bc * along_c) * self.thickness[numbers]
        share_c = (bb * along_c - bc * along_b) * self.thickness[numbers]
        inside = (share_b > 0.0) & (share_c > 0.0) & (share_b + share_c < 1.0)
        across = np.cross(b, c)
        length = np.linalg.norm(across, axis=1)
        height = np.abs(np.einsum("md,md->m", away, across)) / np.where(length > 0.0, length, 1.0)
        closest: Floats = np.where(inside, np.minimum(height, found), found)
        return closest


def _to_side(square: Floats, along: Floats, length: Floats) -> Floats:
    """Squared distances from segments, by those from their starts and the products with them."""
    share = np.clip(along / np.where(length > 0.0, length, 1.0), 0.0, 1.0)
    found: Floats = square - share * (2.0 * along - share * length)
    return found


def _from_side(away: Floats, side: Floats) -> Floats:
    """(m,) distances from segments of points `away` (m, 3) from their starts."""
    length = np.einsum("md,md->m", side, side)
    along = np.einsum("md,md->m", away, side)
    share = np.clip(along / np.where(length > 0.0, length, 1.0), 0.0, 1.0)
    found: Floats = np.linalg.norm(away - share[:, None] * side, axis=1)
    return found
