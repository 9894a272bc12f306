"""How the faces of a mesh hang together: half-edges, borders, parts and handles.

Every corner c of a face stands also for the *half-edge* that leaves it: the directed side from
the vertex of c to that of the next corner, `following[c]`, with the face on its left. Where two
faces lie on both sides of an edge, it is made of two half-edges of opposite directions, and
`opposite` leads from each to the other:

    opposite[opposite[c]] = c,      vertex of opposite[c] = vertex of following[c].

A half-edge without opposite (-1) is part of the *border*. Two steps lead everywhere: `following`
runs around a face, and following[opposite[c]], again and again, visits the half-edges that leave
one vertex, clockwise. All half-edges of a vertex that are reached from each other this way are an
*umbrella*; a vertex of a proper surface has one, a bow tie has two.

Gluing faces along all pairs of half-edges gives a surface, orientable since each pair has opposite
directions. A connected part with V umbrellas, E edges and F faces has the *Euler characteristic*

    chi = V - E + F = 2 - 2 g - b,

where b counts the rings into which its border falls (holes and rims alike) and g its handles: a
ball has g = b = 0, a disk b = 1, a tube b = 2, a torus g = 1. Both numbers together say what the
part is, whatever its shape (classification of compact surfaces; e.g. Armstrong, Basic Topology,
chapter 7). An edge with three faces, or with two that run along it in the same direction, is not
glued: it counts as border of all of them. `repair` makes meshes in which there is no such edge.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import Numbers, PolygonMesh, fixed

Indices = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class BoundaryLoop:
    """One ring of the border: around a hole, or the rim of a sheet."""

    vertices: Numbers
    """(k,) in the order of the half-edges, faces on the left"""
    corners: Numbers
    """(k,) the half-edges of the ring; the first is the one of the lowest number"""
    length: float
    """in the unit of the vertices"""
    component: int
    """the part that it bounds"""


@dataclass(frozen=True)
class Component:
    """A connected part: faces that are joined across edges."""

    faces: int
    edges: int
    vertices: int
    """umbrellas; in a repaired mesh just vertices"""
    boundaries: int
    """b, the rings of its border"""

    @property
    def euler(self) -> int:
        """The Euler characteristic V - E + F."""
        return self.vertices - self.edges + self.faces

    @property
    def handles(self) -> int:
        """g: how many closed cuts it takes at most without falling apart."""
        return (2 - self.boundaries - self.euler) // 2

    @property
    def closed(self) -> bool:
        return self.boundaries == 0


class SharedEdges(NamedTuple):
    """The half-edges sorted by the two vertices that they join, whichever way they run."""

    corners: Indices
    """(c,) half-edges, those of one edge together"""
    firsts: Indices
    """(e,) where each edge begins in that row"""
    counts: Indices
    """(e,) how many half-edges it has"""


@dataclass(frozen=True, eq=False)
class Topology:
    """What of a mesh does not change when vertices move; worked out when first asked for."""

    mesh: PolygonMesh

    @classmethod
    def of(cls, mesh: PolygonMesh) -> "Topology":
        """That of `mesh`; the same object every time."""
        return mesh.topology

    @cached_property
    def opposite(self) -> Numbers:
        """(c,) the half-edge on the other side of every half-edge's edge, -1 at the border."""
        mesh = self.mesh
        first, second = pairs(shared_edges(mesh.corners, mesh.following, mesh.vertex_count))
        glued = (mesh.corners[first] != mesh.corners[second]) & (
            mesh.owners[first] != mesh.owners[second]
        )
        return opposites(len(mesh.corners), first[glued], second[glued])

    @cached_property
    def border(self) -> Numbers:
        """(k,) the half-edges without opposite, ascending."""
        return fixed(np.flatnonzero(self.opposite < 0).astype(np.int32))

    @cached_property
    def leading(self) -> Numbers:
        """(e,) the half-edge with the lower number of every edge, ascending."""
        numbers = np.arange(len(self.opposite), dtype=np.int32)
        return fixed(numbers[(self.opposite < 0) | (numbers < self.opposite)])

    @cached_property
    def edges(self) -> Numbers:
        """(e, 2) the vertices that every edge joins, in the direction of its leading half-edge."""
        corners = self.mesh.corners
        ends = [corners[self.leading], corners[self.mesh.following[self.leading]]]
        return fixed(np.stack(ends, axis=1))

    @cached_property
    def edge_of(self) -> Numbers:
        """(c,) the edge to which every half-edge belongs."""
        numbers = np.empty(len(self.opposite), dtype=np.int32)
        numbers[self.leading] = np.arange(len(self.leading), dtype=np.int32)
        inner = self.leading[self.opposite[self.leading] >= 0]
        numbers[self.opposite[inner]] = numbers[inner]
        return fixed(numbers)

    @cached_property
    def edge_lengths(self) -> Floats:
        """(e,) in the unit of the vertices."""
        starts, ends = self.mesh.vertices[self.edges].transpose(1, 0, 2)
        return fixed(np.linalg.norm(ends - starts, axis=1))

    @cached_property
    def neighbors(self) -> Numbers:
        """(c,) the face across every half-edge, -1 at the border."""
        across = self.mesh.owners[self.opposite]
        return fixed(np.where(self.opposite >= 0, across, np.int32(-1)))

    @cached_property
    def umbrella_of(self) -> Numbers:
        """(c,) the umbrella to which every corner belongs, numbered by their lowest corners."""
        return fixed(umbrellas(self.mesh.following, self.opposite))

    @cached_property
    def component_of(self) -> Numbers:
        """(f,) the connected part of every face, numbered by their lowest faces."""
        lead = self.leading[self.opposite[self.leading] >= 0]
        owners = self.mesh.owners
        joined = connected(self.mesh.face_count, owners[lead], owners[self.opposite[lead]])
        return fixed(joined)

    @cached_property
    def components(self) -> tuple[Component, ...]:
        """The connected parts by their numbers."""
        faces = np.bincount(self.component_of)
        of_corner = self.component_of[self.mesh.owners]
        edges = np.bincount(of_corner[self.leading], minlength=len(faces))
        vertices = np.bincount(of_corner[first_of_each(self.umbrella_of)], minlength=len(faces))
        rings = np.bincount([loop.component for loop in self.loops], minlength=len(faces))
        columns = (faces, edges, vertices, rings)
        return tuple(
            Component(*row) for row in zip(*(column.tolist() for column in columns), strict=True)
        )

    @cached_property
    def loops(self) -> tuple[BoundaryLoop, ...]:
        """The rings of the border: part by part, the longest of each part first."""
        after = dict(zip(self.border.tolist(), self._border_following().tolist(), strict=True))
        found = []
        while after:
            ring = [next(iter(after))]
            while (step := after.pop(ring[-1])) != ring[0]:
                ring.append(step)
            found.append(self._loop(np.array(ring, dtype=np.int32)))
        return tuple(sorted(found, key=lambda loop: (loop.component, -loop.length)))

    def loops_of(self, component: int) -> tuple[BoundaryLoop, ...]:
        """The rings that bound one part, the longest first."""
        return tuple(loop for loop in self.loops if loop.component == component)

    def _border_following(self) -> Numbers:
        """(k,) the half-edge of the border that leaves where each arrives, on the same umbrella."""
        following, opposite = self.mesh.following, self.opposite
        after = following[self.border]
        turning = np.flatnonzero(opposite[after] >= 0)
        while len(turning):
            after[turning] = following[opposite[after[turning]]]
            turning = turning[opposite[after[turning]] >= 0]
        return after

    def _loop(self, ring: Numbers) -> BoundaryLoop:
        vertices = self.mesh.corners[ring]
        points = self.mesh.vertices[vertices]
        steps = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
        component = int(self.component_of[self.mesh.owners[ring[0]]])
        return BoundaryLoop(fixed(vertices), fixed(ring), float(steps.sum()), component)

    @cached_property
    def _by_vertex(self) -> tuple[Indices, Indices]:
        """Corners sorted by vertex, and (n + 1,) where each vertex begins among them."""
        counts = np.bincount(self.mesh.corners, minlength=self.mesh.vertex_count)
        starts = np.concatenate([[0], np.cumsum(counts)])
        return np.argsort(self.mesh.corners, kind="stable"), starts

    @property
    def corners_by_vertex(self) -> tuple[Indices, Indices]:
        """(c,) corners sorted by vertex, and (n + 1,) where those of each vertex begin."""
        return self._by_vertex

    def faces_at(self, vertex: int) -> Numbers:
        """The faces that have a corner at the vertex, ascending."""
        corners, starts = self._by_vertex
        return np.unique(self.mesh.owners[corners[starts[vertex] : starts[vertex + 1]]])


def shared_edges(tails: Numbers, following: Numbers, vertex_count: int) -> SharedEdges:
    """The half-edges from the vertices `tails` (c,) to those of the corners that follow."""
    heads = tails[following]
    keys = np.minimum(tails, heads).astype(np.int64)
    keys *= vertex_count
    keys += np.maximum(tails, heads)
    corners = np.argsort(keys)
    keys = keys[corners]
    begins = np.ones(len(keys), dtype=np.bool_)
    np.not_equal(keys[1:], keys[:-1], out=begins[1:])
    firsts = np.flatnonzero(begins)
    return SharedEdges(corners, firsts, np.diff(firsts, append=len(keys)))


def pairs(shared: SharedEdges) -> tuple[Indices, Indices]:
    """Both half-edges of every edge that has just two, in either direction."""
    firsts = shared.firsts[shared.counts == 2]
    return shared.corners[firsts], shared.corners[firsts + 1]


def opposites(count: int, first: Indices, second: Indices) -> Numbers:
    opposite = np.full(count, -1, dtype=np.int32)
    opposite[first], opposite[second] = second, first
    return fixed(opposite)


def umbrellas(following: Numbers, opposite: Numbers) -> Numbers:
    """(c,) the umbrella of every corner, numbered in the order of their lowest corners."""
    inner = np.flatnonzero(opposite >= 0)
    return connected(len(opposite), following[inner], opposite[inner])


def connected(count: int, first: NDArray[np.integer], second: NDArray[np.integer]) -> Numbers:
    """(count,) groups of what is linked, directly or through others, by pairs first - second.

    Groups are numbered in the order of their lowest members.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    links = coo_array((np.ones(len(first), dtype=np.int8), (first, second)), shape=(count, count))
    labels = connected_components(links, directed=False)[1]
    lowest = first_of_each(labels)
    ranks = np.empty(len(lowest), dtype=np.int32)
    ranks[np.argsort(lowest)] = np.arange(len(lowest), dtype=np.int32)
    numbered: Numbers = ranks[labels]
    return numbered


def first_of_each(labels: Numbers) -> Indices:
    """(k,) where each of the labels 0 to k - 1 stands first in a row in which all occur."""
    firsts = np.empty(int(labels.max(initial=-1)) + 1, dtype=np.intp)
    # Of several values for one place the last stays.
    firsts[labels[::-1]] = np.arange(len(labels) - 1, -1, -1)
    return firsts
