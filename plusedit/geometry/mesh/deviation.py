"""How far the surface of a mesh is from the mesh: from its points to the surface, and back.

Both are taken as triangles with the same corners: those of the mesh, and the same ones moved to the
surface. Faces of coarse meshes are split before, for a surface bends between far corners.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.nearest_triangles import distances
from plusedit.geometry.mesh.polygons import PolygonMesh, fixed

FEWEST = 4000  # faces: coarser meshes are split until they have as many
MOST_TIMES = 5  # that they are split
ROOM = 1 << 17  # corners of faces that are compared, unless the mesh has more
FINEST = 4  # times that faces are split for that


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
    finer = mesh.subdivided(splits_within(mesh))
    places = vertex_places(finer.mesh, finer.along(surface.parameters))
    return deviation_of(finer.mesh, surface.at(places), mesh)


def deviation_of(mesh: PolygonMesh, points: Floats, before: PolygonMesh | None = None) -> Deviation:
    """The distances between a mesh and its vertices moved to `points` (n, 3).

    `before` is the mesh that was split to become `mesh`; without it, `mesh` itself. The points may
    be of any precision, such as those of a preview. ValueError where one is not finite.
    """
    whole = mesh if before is None else before
    corners, used = mesh.triangulation.triangles.astype(np.intp), mesh.used
    moved = np.asarray(points, dtype=np.float64)
    if not np.isfinite(moved).all():
        raise ValueError("points: has a value that is not finite")
    own = np.flatnonzero(used)
    from_mesh, from_surface = np.zeros((2, mesh.vertex_count))
    from_mesh[own] = distances(mesh.vertices, moved, corners, own)
    from_surface[own] = distances(moved, mesh.vertices, corners, own)
    used = used[: whole.vertex_count]
    return Deviation(fixed(from_mesh), fixed(from_surface), used, whole.diagonal)


def times_for(mesh: PolygonMesh, fewest: int = FEWEST) -> int:
    """How often the faces of a mesh are split so that there are enough of them."""
    count, times = mesh.face_count, 0
    while count < fewest and times < MOST_TIMES:
        count, times = 4 * count, times + 1
    return times


def splits_within(mesh: PolygonMesh, room: int = ROOM) -> int:
    """How often the faces of a mesh can be split, to show and to measure what lies between its
    vertices, until they have more corners than there is room for."""
    corners, times = max(len(mesh.corners), 1), 0
    while times < FINEST and corners * 4 ** (times + 1) <= room:
        times += 1
    return times


def vertex_places(mesh: PolygonMesh, parameters: Floats) -> Floats:
    """(n, 2) parameters of vertices from those of corners (c, 2): each as in its first corner.

    A vertex of no face has those of the first corner of all.
    """
    places = np.tile(parameters[:1], (mesh.vertex_count, 1))
    # Written backwards, so that the first corner of each vertex is the one that stays.
    places[mesh.corners[::-1]] = parameters[::-1]
    return places
