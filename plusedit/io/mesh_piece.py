"""Surfaces of meshes as files of triangles and polygons want them.

The faces are those of the mesh, or parts of them where it was split; their vertices lie on the
surface. What a file calls a point is a vertex together with its parameters: along a seam of the
map, where faces see a vertex at different parameters, it has as many points as there are.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.deviation import vertex_places
from plusedit.geometry.mesh.maps import Progress, silent
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.io.fields import of_number
from plusedit.io.mesh_faces import Faces, Numbers
from plusedit.io.surface_mesh import Points

BLOCK = 16_384  # points or faces that are worked on at once
STILL = 1e-6  # of the edges around: shorter tangents are rounding; or of the sine between two
PROBED = 512  # edges along which the error of a mesh is looked at
STEPS = 8  # half of the steps along each
MOST_TIMES = 6  # that faces are split
AT_ONCE = 65_536  # points that are evaluated before anybody may give up
MOST = 24_000_000  # corners: some gigabytes of memory


@dataclass(frozen=True, eq=False)
class MeshPiece:
    """A surface at the vertices of polygons."""

    name: str
    color: str | None
    mesh: PolygonMesh
    """its vertices are those before they were moved to the surface"""
    places: Points
    """(n, 3) vertices on the surface, in the kind of number that the file has"""
    directions: NDArray[np.float32]
    """(n, 3) unit normals of the vertices, to the front of the faces"""
    by_corner: Floats
    """(c, 2) parameters of the corners"""
    has_polygons: bool
    """whether faces are handed out as they are; else they are cut into triangles"""

    @cached_property
    def _points(self) -> tuple[Numbers, Numbers]:
        """(m,) a corner of every point, sorted by vertex, and (c,) the point of every corner."""
        bits = np.ascontiguousarray(self.by_corner + 0.0).view(np.int64)
        keys = np.column_stack([self.mesh.corners, bits])
        order = np.lexsort(keys.T[::-1])
        sorted_keys = keys[order]
        begins = np.ones(len(order), dtype=np.bool_)
        begins[1:] = (sorted_keys[1:] != sorted_keys[:-1]).any(axis=1)
        point_of = np.empty(len(order), dtype=np.int64)
        point_of[order] = np.cumsum(begins) - 1
        return order[begins].astype(np.int64), point_of

    @cached_property
    def _vertices(self) -> Numbers:
        """(m,) the vertex of every point."""
        return self.mesh.corners[self._points[0]].astype(np.int64)

    @cached_property
    def points(self) -> Points:
        """(m, 3)"""
        found: Points = self.places[self._vertices]
        return found

    @cached_property
    def normals(self) -> NDArray[np.float32]:
        """(m, 3) unit vectors, to the front."""
        return self.directions[self._vertices]

    def __len__(self) -> int:
        return len(self._points[0])

    def blocks(self) -> Iterator[slice]:
        """Slices of points, together all of them."""
        for first in range(0, len(self), BLOCK):
            yield slice(first, min(first + BLOCK, len(self)))

    def parameters(self, rows: slice) -> Floats:
        """(k, 2) u and v of those points."""
        found: Floats = self.by_corner[self._points[0][rows]]
        return found

    def faces(self) -> Iterator[Faces]:
        """All faces, block by block."""
        point_of, mesh = self._points[1], self.mesh
        sizes: list[int] = np.unique(mesh.sizes).tolist() if self.has_polygons else [3]
        for size in sizes:
            if self.has_polygons:
                chosen = np.flatnonzero(mesh.sizes == size)
                corners = mesh.starts[chosen, None] + np.arange(size)
            else:
                corners = mesh.triangulation.corners
            for first in range(0, len(corners), BLOCK):
                yield Faces.of_size(self.scaled, point_of[corners[first : first + BLOCK]])

    @cached_property
    def scaled(self) -> Floats:
        """(m, 3) the points, halved or doubled until they are no larger than one."""
        points = self.points.astype(np.float64)
        return np.ldexp(points, -int(np.frexp(np.abs(points).max())[1]))

    @property
    def face_count(self) -> int:
        """How many faces `faces` yields."""
        return self.mesh.face_count if self.has_polygons else self.triangle_count

    @property
    def triangle_count(self) -> int:
        """How many triangles there are once every face is cut."""
        return len(self.mesh.corners) - 2 * self.mesh.face_count

    @cached_property
    def welded(self) -> tuple[Numbers, Numbers]:
        """Points of the same vertex joined: which points (k,) are left, and what each has become.

        The second is (m,), places among the points that are left.
        """
        begins = np.ones(len(self), dtype=np.bool_)
        begins[1:] = self._vertices[1:] != self._vertices[:-1]
        return np.flatnonzero(begins), np.cumsum(begins) - 1


def pieced(
    surface: MeshSurface,
    times: int = 0,
    *,
    name: str = "",
    color: str | None = None,
    numbers: Any = np.float64,
    has_polygons: bool = True,
    tell: Progress = silent,
) -> MeshPiece:
    """The surface, to full accuracy, at the vertices of its mesh with faces split some `times`.

    `numbers` is the kind of number that points are rounded to. ValueError where the faces would be
    too many, or a point is beyond those numbers.
    """
    if len(surface.mesh.corners) * 4**times > MOST:
        faces = of_number(surface.mesh.face_count, "face")
        raise ValueError(f"{faces} split {times} times would have more than {MOST} corners")
    split = surface.mesh.subdivided(times)
    mesh, parameters = split.mesh, split.along(surface.parameters)
    with np.errstate(all="ignore"):
        points, by_u, by_v = _derivatives(surface, vertex_places(mesh, parameters), tell)
        rounded = points.astype(numbers)
    if not np.isfinite(points).all():
        raise ValueError("a point is beyond a double")
    if not np.isfinite(rounded).all():
        raise ValueError("a point is beyond the numbers that the file has")
    steep = _steepness(mesh.with_vertices(points), parameters)
    tangents = [np.where(_lengths(by) > STILL * steep, by, 0.0) for by in (by_u, by_v)]
    directions = _normals(mesh.with_vertices(points), *tangents).astype(np.float32)
    return MeshPiece(name, color, mesh, rounded, directions, parameters, has_polygons)


def _derivatives(
    surface: MeshSurface, places: Floats, tell: Progress
) -> tuple[Floats, Floats, Floats]:
    """Points and derivatives as the surface has them, with a word between times."""
    found = []
    for first in range(0, len(places), AT_ONCE):
        tell(first / len(places), "evaluating the surface")
        found.append(surface.derivatives(places[first : first + AT_ONCE]))
    points, by_u, by_v = (np.concatenate(rows) for rows in zip(*found, strict=True))
    return points, by_u, by_v


def times_within(surface: MeshSurface, tolerance: float, most: int) -> tuple[int, float]:
    """How often the faces are to be split so that edges stray no farther from the surface.

    Also the distance then reached, as far as some of the edges tell. There will be no more
    than `most` vertices, unless the mesh itself has more.
    """
    errors = _errors(surface)
    times, count = 0, surface.mesh.vertex_count
    while errors[times] > tolerance and times < MOST_TIMES and 4 * count <= most:
        times, count = times + 1, 4 * count
    return times, errors[times]


def _errors(surface: MeshSurface) -> list[float]:
    """How far the surface is from edges, by how often the faces are split.

    Looked at along some edges, and from some corners to the centers of their faces.
    """
    mesh, parameters = surface.mesh, surface.parameters
    chosen = np.arange(0, len(mesh.corners), max(1, len(mesh.corners) // PROBED))
    starts = parameters[chosen]
    centers = (mesh.sums(parameters) / mesh.sizes[:, None])[mesh.owners[chosen]]
    ends = np.concatenate([parameters[mesh.following[chosen]], centers])
    starts = np.concatenate([starts, starts])
    shares = np.linspace(0.0, 1.0, 2 * STEPS + 1)[:, None, None]
    places = (1.0 - shares) * starts + shares * ends
    with np.errstate(all="ignore"):
        points = surface.at(places.reshape(-1, 2)).reshape(*places.shape[:2], 3)
        found = []
        step = STEPS
        while step:
            chords = 0.5 * (points[: -step : 2 * step] + points[2 * step :: 2 * step])
            away = np.linalg.norm(points[step :: 2 * step] - chords, axis=2)
            found.append(float(np.nan_to_num(away, nan=0.0, posinf=0.0).max()))
            step //= 2
    # From then on half as long edges stray a quarter as far.
    return found + [found[-1] / 4.0**k for k in range(1, MOST_TIMES + 2 - len(found))]


def _normals(mesh: PolygonMesh, by_u: Floats, by_v: Floats) -> Floats:
    """(n, 3) unit normals of a surface at the vertices of a mesh that lies on it.

    They point to the front of the faces. Where the derivatives span no plane, as at the cone points
    of a pillow, the faces around tell.
    """
    sums = np.zeros((mesh.vertex_count, 3))
    weights = np.repeat(mesh.area_vectors, mesh.sizes, axis=0)
    for axis in range(3):
        sums[:, axis] = np.bincount(mesh.corners, weights[:, axis], minlength=mesh.vertex_count)
    around = _unit(sums)
    across = np.cross(_unit(by_u), _unit(by_v))
    spans = np.linalg.norm(across, axis=1, keepdims=True) > STILL
    facing = np.einsum("nd,nd->n", across, around)[:, None]
    normals = np.where(spans, np.where(facing < 0.0, -1.0, 1.0) * _unit(across), around)
    normals[~normals.any(axis=1)] = (0.0, 0.0, 1.0)
    return normals


def _steepness(mesh: PolygonMesh, parameters: Floats) -> Floats:
    """(n, 1) how long the edges at vertices are to what they are in the parameters, at most."""
    following = mesh.following
    long = _lengths(mesh.vertices[mesh.corners[following]] - mesh.vertices[mesh.corners])[:, 0]
    wide = _lengths(parameters[following] - parameters)[:, 0]
    ratios = np.divide(long, wide, out=np.zeros_like(long), where=wide > 0.0)
    found = np.zeros(mesh.vertex_count)
    np.maximum.at(found, mesh.corners, ratios)
    return found[:, None]


def _lengths(vectors: Floats) -> Floats:
    """(n, 1)"""
    found: Floats = np.linalg.norm(vectors, axis=1, keepdims=True)
    return found


def _unit(vectors: Floats) -> Floats:
    """(n, 3) of length one; zero where there is no direction."""
    largest = np.abs(vectors).max(axis=1, keepdims=True)
    scaled = np.divide(vectors, largest, out=np.zeros_like(vectors), where=largest > 0.0)
    length = np.linalg.norm(scaled, axis=1, keepdims=True)
    unit: Floats = np.divide(scaled, length, out=np.zeros_like(scaled), where=length > 0.0)
    return unit
