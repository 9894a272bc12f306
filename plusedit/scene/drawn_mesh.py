"""Surfaces of meshes as triangles to draw: the surface at the vertices, or between them as well.

A surface of a large mesh takes a while to evaluate. Windows never wait for that: they draw the best
there is, have the rest evaluated beside, and hand in what came of it. What was evaluated is kept
with its surface, for as long as that lives.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.foundation import Foundation
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh

MOST = 1 << 17  # corners of the faces that are drawn, unless the mesh has more
FINEST = 4  # times that edges are halved
KEPT = 24  # drawings
LOOKED_AT = 64  # vertices that tell by which map a mesh was moved
SLACK = 1e-9  # of the diagonal, within which a map is the one

Pairs: TypeAlias = NDArray[np.intp]
Singles: TypeAlias = NDArray[np.float32]
Evaluate: TypeAlias = Callable[[MeshSurface, Floats], Floats]


@dataclass(frozen=True, eq=False)
class DrawnNet:
    """Where surfaces of a mesh are evaluated, and how those places are joined."""

    mesh: PolygonMesh
    """the faces that are drawn: those of the mesh, or parts of them"""
    places: Floats
    """(n, 2) parameters of their vertices"""
    edges: Pairs
    """(k, 2) vertices joined by the edges of the faces before they were split"""
    boundary: Pairs
    """(b, 2) those of edges that have a face on one side only"""
    parents: NDArray[np.int32]
    """(f,) the face of the mesh in which each face lies"""

    @property
    def triangles(self) -> NDArray[np.int32]:
        """(t, 3) vertices."""
        return self.mesh.triangulation.triangles

    @cached_property
    def faces(self) -> NDArray[np.int32]:
        """(t,) the face of the mesh before in which each triangle lies."""
        return self.parents[self.mesh.triangulation.owners]


@dataclass(frozen=True, eq=False)
class MeshDrawing:
    """A surface at the vertices of a net."""

    net: DrawnNet
    points: Floats
    """(n, 3)"""
    is_exact: bool = True
    """whether they are to full accuracy; else they are near enough for a moment"""

    @cached_property
    def normals(self) -> Floats:
        """(n, 3) unit vectors to the front, the mean of the triangles around; zero without any."""
        return vertex_normals(self.points, self.net.triangles)

    def lines(self, pairs: Pairs) -> tuple[Floats, Floats]:
        """(k, 3) starts and ends of the segments that join vertices."""
        return self.points[pairs[:, 0]], self.points[pairs[:, 1]]


_NETS: "WeakKeyDictionary[PolygonMesh, list[tuple[Floats, DrawnNet]]]" = WeakKeyDictionary()
_DRAWINGS: "WeakKeyDictionary[MeshSurface, MeshDrawing]" = WeakKeyDictionary()
_LATEST: "WeakKeyDictionary[Foundation, MeshDrawing]" = WeakKeyDictionary()
"""The last one of all surfaces that differ in S, s and edits only, which may be gone by now."""


def drawing_of(surface: MeshSurface, *, wait: bool = True) -> MeshDrawing:
    """The surface as it is drawn.

    Without `wait` only what is known by now: the surface before the last change, or the mesh
    itself, where it has not been evaluated.
    """
    known = known_drawing(surface)
    if known is not None and (known.is_exact or not wait):
        return known
    if wait:
        return keep(surface, evaluated(surface))
    return _stand_in(surface)


def known_drawing(surface: MeshSurface) -> MeshDrawing | None:
    """What has been evaluated of the surface, or of one that was moved to it as a whole."""
    found = _DRAWINGS.get(surface)
    if found is None:
        found = _moved(surface)
        if found is not None:
            keep(surface, found)
    return found


def keep(surface: MeshSurface, drawing: MeshDrawing) -> MeshDrawing:
    """Draw a surface like that from now on; to be called from the thread that draws."""
    _DRAWINGS.pop(surface, None)
    _DRAWINGS[surface] = _LATEST[surface.foundation] = drawing
    while len(_DRAWINGS) > KEPT:
        del _DRAWINGS[next(iter(_DRAWINGS))]
    return drawing


def evaluated(surface: MeshSurface, quick: Evaluate | None = None) -> MeshDrawing:
    """The surface at its vertices and between them, to full accuracy unless evaluated by `quick`.

    Takes its time, in whatever thread.
    """
    net = net_of(surface)
    if quick is not None:
        return MeshDrawing(net, quick(surface, net.places), is_exact=False)
    return MeshDrawing(net, surface.at(net.places))


def net_of(surface: MeshSurface) -> DrawnNet:
    """Where a surface is evaluated: the same for all surfaces of a mesh with those parameters."""
    nets = _NETS.setdefault(surface.mesh, [])
    for parameters, net in nets:
        if parameters is surface.parameters:
            return net
    net = _net(surface)
    nets.append((surface.parameters, net))
    return net


def vertex_normals(points: Floats, triangles: NDArray[np.int32]) -> Floats:
    """(n, 3) unit normals of points by the triangles around them, large ones counting for more."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    flat, count = triangles.ravel(), len(points)
    sums = [np.bincount(flat, np.repeat(across[:, k], 3), count) for k in range(3)]
    normals = np.stack(sums, axis=1)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    unit: Floats = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0.0)
    return unit


def _net(surface: MeshSurface) -> DrawnNet:
    mesh, corners = surface.mesh, max(len(surface.mesh.corners), 1)
    times = 0
    while times < FINEST and corners * 4 ** (times + 1) <= MOST:
        times += 1
    edges, counts = polygon_edges(mesh)
    boundary = edges[counts == 1]
    if not times:
        parents = np.arange(mesh.face_count, dtype=np.int32)
        return DrawnNet(mesh, surface.vertex_places, edges, boundary, parents)
    split = mesh.subdivided(times)
    places = np.zeros((split.mesh.vertex_count, 2))
    # Written backwards, so that the first corner of each vertex is the one that stays.
    places[split.mesh.corners[::-1]] = split.along(surface.parameters)[::-1]
    for step in split.rounds:
        middles = _middles(step.before.corners, step.before.following, step.places, step.mesh)
        edges, boundary = (middles.halved(pairs) for pairs in (edges, boundary))
    return DrawnNet(split.mesh, places, edges, boundary, split.parents)


def polygon_edges(mesh: PolygonMesh) -> tuple[Pairs, NDArray[np.intp]]:
    """(k, 2) the vertices that edges join, each once, and (k,) of how many faces they are."""
    keys = _keys(mesh.corners, mesh.corners[mesh.following], mesh.vertex_count)
    found, counts = np.unique(keys, return_counts=True)
    return np.stack(np.divmod(found, max(mesh.vertex_count, 1)), axis=1), counts


def _keys(one: NDArray[np.integer], other: NDArray[np.integer], count: int) -> NDArray[np.int64]:
    low, high = np.minimum(one, other), np.maximum(one, other)
    keys: NDArray[np.int64] = low.astype(np.int64) * count + high
    return keys


@dataclass(frozen=True, eq=False)
class _Middles:
    """The vertices in the middles of edges."""

    keys: NDArray[np.int64]
    """ascending"""
    vertices: NDArray[np.int32]
    count: int

    def halved(self, pairs: Pairs) -> Pairs:
        """(2 k, 2) the halves of edges (k, 2)."""
        keys = _keys(pairs[:, 0], pairs[:, 1], self.count)
        middle = self.vertices[np.searchsorted(self.keys, keys)]
        first, last = np.stack([pairs[:, 0], middle], 1), np.stack([middle, pairs[:, 1]], 1)
        return np.concatenate([first, last])


def _middles(
    corners: NDArray[np.int32],
    following: NDArray[np.int32],
    places: NDArray[np.intp],
    split: PolygonMesh,
) -> _Middles:
    count = int(corners.max()) + 1
    at_place = np.zeros(places.max() + 1, dtype=np.int32)
    at_place[places] = split.corners
    keys = _keys(corners, corners[following], count)
    order = np.argsort(keys, kind="stable")
    vertices = at_place[len(corners) : 2 * len(corners)][order]
    return _Middles(keys[order], vertices, count)


def _stand_in(surface: MeshSurface) -> MeshDrawing:
    latest = _LATEST.get(surface.foundation)
    if latest is not None:
        return latest
    return MeshDrawing(_bare_net(surface.mesh), surface.mesh.vertices, is_exact=False)


_BARE: "WeakKeyDictionary[PolygonMesh, DrawnNet]" = WeakKeyDictionary()


def _bare_net(mesh: PolygonMesh) -> DrawnNet:
    """The faces as they are, without what takes time."""
    net = _BARE.get(mesh)
    if net is None:
        none, parents = np.zeros((0, 2), np.intp), np.arange(mesh.face_count, dtype=np.int32)
        net = _BARE[mesh] = DrawnNet(mesh, np.zeros((mesh.vertex_count, 2)), none, none, parents)
    return net


def _moved(surface: MeshSurface) -> MeshDrawing | None:
    """The drawing of a surface that this one is the image of, moved with its mesh.

    The surface follows an affine map of its mesh exactly, but for weights by area.
    """
    for other, drawing in reversed(list(_DRAWINGS.items())):
        if _has_same_numbers(surface, other):
            image = _affine_image(other.mesh, surface.mesh, drawing.points)
            if image is not None:
                is_exact = drawing.is_exact and not surface.area_weights
                return MeshDrawing(drawing.net, image, is_exact)
    return None


def _has_same_numbers(one: MeshSurface, other: MeshSurface) -> bool:
    return (
        one.parameters is other.parameters
        and one.mesh.vertices.shape == other.mesh.vertices.shape
        and one.domain == other.domain
        and (one.smoothness, one.s, one.area_weights)
        == (other.smoothness, other.s, other.area_weights)
        and one.factors is other.factors
        and not one.edited
        and not other.edited
    )


def _affine_image(old: PolygonMesh, new: PolygonMesh, points: Floats) -> Floats | None:
    """Points moved by the affine map from one mesh to the other; None where there is none."""
    looked_at = np.unique(np.linspace(0, old.vertex_count - 1, LOOKED_AT).astype(int))
    middle, image = old.vertices[looked_at].mean(axis=0), new.vertices[looked_at].mean(axis=0)
    way = np.linalg.lstsq(
        old.vertices[looked_at] - middle, new.vertices[looked_at] - image, rcond=None
    )[0]
    off = (old.vertices - middle) @ way + image - new.vertices
    if not np.isfinite(off).all() or np.abs(off).max(initial=0.0) > SLACK * new.diagonal:
        return None
    moved: Floats = (points - middle) @ way + image
    return moved
