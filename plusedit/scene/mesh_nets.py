"""Where surfaces of meshes are evaluated to be drawn: at the vertices, or between them as well."""

from dataclasses import dataclass
from threading import Lock
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.deviation import ROOM, splits_within
from plusedit.geometry.mesh.foundation import Foundation
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh, fixed
from plusedit.scene.mesh_drawing import DrawnNet, Pairs

WHOLE = 8 * ROOM  # corners of all meshes; each takes at most a quarter of what the others leave
LEAST = ROOM >> 5  # that a mesh may have, however many others there are


_NETS: "WeakKeyDictionary[Foundation, DrawnNet]" = WeakKeyDictionary()
_BARE: "WeakKeyDictionary[Foundation, DrawnNet]" = WeakKeyDictionary()
_LOCK = Lock()
"""For who looks through the nets, in whatever thread."""


def net_of(surface: MeshSurface) -> DrawnNet:
    """Where a surface is evaluated: the same for all surfaces of a mesh with those parameters."""
    net = known_net(surface)
    if net is None:
        net = _net(surface)
        with _LOCK:
            net = _NETS.setdefault(surface.foundation, net)
    return net


def known_net(surface: MeshSurface) -> DrawnNet | None:
    """The same if it has been made, of this surface or one that its mesh was moved to."""
    with _LOCK:
        net = _NETS.get(surface.foundation)
        if net is None:
            for other, found in _NETS.items():
                if _is_alike(surface, other):
                    net = _NETS[surface.foundation] = found
                    break
        return net


def bare_net(surface: MeshSurface) -> DrawnNet:
    """The faces as they are, without what takes time."""
    net, mesh = _BARE.get(surface.foundation), surface.mesh
    if net is None:
        none, parents = np.zeros((0, 2), np.intp), np.arange(mesh.face_count, dtype=np.int32)
        net = DrawnNet(mesh, np.zeros((mesh.vertex_count, 2)), none, none, parents)
        _BARE[surface.foundation] = net
    return net


def _is_alike(surface: MeshSurface, other: Foundation) -> bool:
    """Whether the other one has the same faces with the same parameters, wherever they are."""
    mesh, parts = surface.mesh, other.parts
    if parts.parameters is not surface.parameters:
        return False
    return mesh is parts.mesh or (
        mesh.vertex_count == parts.mesh.vertex_count
        and np.array_equal(mesh.corners, parts.mesh.corners)
        and np.array_equal(mesh.starts, parts.mesh.starts)
    )


def _room() -> int:
    """How many corners another mesh may be drawn with: of many, each is small in the view."""
    with _LOCK:
        nets = {id(net): net for net in _NETS.values()}
    drawn = sum(len(net.mesh.corners) for net in nets.values())
    return max(LEAST, min(ROOM, (WHOLE - drawn) // 4))


def _net(surface: MeshSurface) -> DrawnNet:
    mesh = surface.mesh
    times = splits_within(mesh, _room())
    edges, counts = polygon_edges(mesh)
    boundary = edges[counts == 1]
    if not times:
        parents = np.arange(mesh.face_count, dtype=np.int32)
        sides = _sides(mesh, surface.parameters)
        return DrawnNet(mesh, surface.vertex_places, edges, boundary, parents, sides)
    split = mesh.subdivided(times)
    parameters = split.along(surface.parameters)
    places = np.zeros((split.mesh.vertex_count, 2))
    # Written backwards, so that the first corner of each vertex is the one that stays.
    places[split.mesh.corners[::-1]] = parameters[::-1]
    for step in split.rounds:
        middles = _middles(step.before.corners, step.before.following, step.places, step.mesh)
        edges, boundary = (middles.halved(pairs) for pairs in (edges, boundary))
    sides = _sides(split.mesh, parameters)
    return DrawnNet(split.mesh, fixed(places), edges, boundary, split.parents, sides)


def _sides(mesh: PolygonMesh, parameters: Floats) -> Floats | None:
    """What `DrawnNet.sides` are to be, by the sense of the triangles around in (u, v)."""
    triangles, _, corners = mesh.triangulation
    (au, av), (bu, bv) = ((parameters[corners[:, k]] - parameters[corners[:, 0]]).T for k in (1, 2))
    senses = np.repeat(np.sign(au * bv - av * bu), 3)
    turns = np.bincount(triangles.ravel(), senses, mesh.vertex_count)
    return np.where(turns < 0.0, -1.0, 1.0) if (turns < 0.0).any() else None


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
