"""What the maps of a mesh are made on: its triangles, glued along half-edges.

Corner k of triangle t has the number 3 t + k, which is also that of the half-edge that leaves it
for the next corner. Gluing is by half-edge and not by vertices: two triangles that share all their
vertices but only one edge stay different neighbors along different edges. A sheet may have
triangles that the mesh has not, such as those that fill its holes for a while.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import Numbers, PolygonMesh
from plusedit.geometry.mesh.topology import BoundaryLoop

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Sheet:
    """Triangles of a connected part, those of the mesh first; never changed in place."""

    points: Floats
    """(n, 3)"""
    triangles: Indices
    """(t, 3) vertices, counter-clockwise from the front"""
    opposite: Indices
    """(3 t,) the half-edge on the other side, -1 at the border"""
    own: int
    """how many of the triangles are the mesh's"""

    @classmethod
    def of(cls, mesh: PolygonMesh) -> "Sheet":
        """The triangles of a mesh, in the order of `mesh.triangulation`."""
        cut = mesh.triangulation
        triangles = cut.triangles.astype(np.intp)
        glued = mesh.topology.opposite
        if (mesh.sizes == 3).all():
            return cls(mesh.vertices, triangles, glued.astype(np.intp), len(triangles))
        return cls(mesh.vertices, triangles, _glued(mesh, glued), len(triangles))

    @cached_property
    def tails(self) -> Indices:
        """(3 t,) the vertex of every corner, which its half-edge leaves."""
        return self.triangles.ravel()

    @cached_property
    def heads(self) -> Indices:
        """(3 t,) the vertex at which every half-edge arrives."""
        return np.roll(self.triangles, -1, axis=1).ravel()

    @cached_property
    def used(self) -> Flags:
        """(n,) true for vertices of some triangle."""
        marks = np.zeros(len(self.points), dtype=np.bool_)
        marks[self.tails] = True
        return marks

    @cached_property
    def lengths(self) -> Floats:
        """(t, 3) of the edge that leaves every corner."""
        around = self.points[self.triangles]
        steps = np.roll(around, -1, axis=1) - around
        lengths: Floats = np.sqrt(np.einsum("tcd,tcd->tc", steps, steps))
        return lengths

    @cached_property
    def doubled_areas(self) -> Floats:
        """(t,) twice the areas."""
        first, second, third = self.points[self.triangles].transpose(1, 0, 2)
        normals = np.cross(second - first, third - first)
        doubled: Floats = np.sqrt(np.einsum("td,td->t", normals, normals))
        return doubled

    @cached_property
    def chords(self) -> Indices:
        """The half-edges inside that join two vertices of the border."""
        border = np.zeros(len(self.points), dtype=np.bool_)
        border[self.tails[self.opposite < 0]] = True
        inside = (self.opposite >= 0) & border[self.tails] & border[self.heads]
        return np.flatnonzero(inside)

    def half_edge(self, tail: int, head: int) -> int:
        """A half-edge from one vertex to another; ValueError where there is none."""
        found = np.flatnonzero((self.tails == tail) & (self.heads == head))
        if not len(found):
            raise ValueError(f"no edge leads from vertex {tail} to {head}")
        return int(found[0])

    def ring(self, loop: BoundaryLoop) -> Indices:
        """(k,) the half-edges of a loop of the mesh's border, in its order.

        The loop is one of a proper surface: it passes every vertex once.
        """
        border = np.flatnonzero(self.opposite < 0)
        leaving = np.full(len(self.points), -1, dtype=np.intp)
        leaving[self.tails[border]] = border
        return leaving[loop.vertices]

    def filled(self, rings: Iterable[Indices]) -> "Sheet":
        """The sheet with a fan of triangles from its middle across every ring of border."""
        points, triangles, opposite = [self.points], [self.triangles], [self.opposite.copy()]
        vertex, corner = len(self.points), len(self.opposite)
        for ring in rings:
            tails, heads, k = self.tails[ring], self.heads[ring], len(ring)
            points.append(self.points[tails].mean(axis=0)[None])
            triangles.append(np.stack([heads, tails, np.full(k, vertex)], axis=1))
            firsts = corner + 3 * np.arange(k)
            opposite[0][ring] = firsts
            # From the tail to the middle beside the triangle before, back beside the next.
            fan = np.stack([ring, np.roll(firsts, 1) + 2, np.roll(firsts, -1) + 1], axis=1)
            opposite.append(fan.ravel())
            vertex, corner = vertex + 1, corner + 3 * k
        return Sheet(
            np.concatenate(points), np.concatenate(triangles), np.concatenate(opposite), self.own
        )

    def collared(self, ring: Indices) -> tuple["Sheet", Indices]:
        """The sheet with a strip of triangles outside of a ring of border, and the new ring.

        No edge inside of it joins two vertices of the new ring, so nothing collapses where that
        is laid along a straight line.
        """
        tails, k = self.tails[ring], len(ring)
        outer = len(self.points) + np.arange(k)
        points = np.concatenate([self.points, self._beyond(ring)])
        after, first = np.roll(np.arange(k), -1), len(self.opposite) + 6 * np.arange(k)
        # Two triangles for every edge a b of the ring with a' b' beyond: b a a' and b a' b'.
        inner = np.stack([tails[after], tails, outer], axis=1)
        beyond = np.stack([tails[after], outer, outer[after]], axis=1)
        opposite = np.full((k, 6), -1, dtype=np.intp)
        opposite[:, 0] = ring
        opposite[:, 1] = np.roll(first, 1) + 5
        opposite[:, 2], opposite[:, 3] = first + 3, first + 2
        opposite[:, 5] = np.roll(first, -1) + 1
        glued = self.opposite.copy()
        glued[ring] = first
        triangles = np.stack([inner, beyond], axis=1).reshape(-1, 3)
        collared = Sheet(
            points,
            np.concatenate([self.triangles, triangles]),
            np.concatenate([glued, opposite.ravel()]),
            self.own,
        )
        return collared, first + 4

    def _beyond(self, ring: Indices) -> Floats:
        """(k, 3) a point outside for each vertex of a ring, about an edge away from it."""
        tails, heads = self.tails[ring], self.heads[ring]
        count = len(self.points)
        ends = np.concatenate([self.tails, self.heads]), np.concatenate([self.heads, self.tails])
        chosen = np.isin(ends[0], tails)
        near = np.bincount(ends[0][chosen], minlength=count)[tails]
        sums = np.stack(
            [np.bincount(ends[0][chosen], axis[ends[1][chosen]], count) for axis in self.points.T],
            axis=1,
        )[tails]
        away = self.points[tails] - sums / near[:, None]
        lengths = np.linalg.norm(away, axis=1, keepdims=True)
        edge = np.linalg.norm(self.points[heads] - self.points[tails], axis=1).mean()
        unit = np.divide(away, lengths, out=np.zeros_like(away), where=lengths > 0.0)
        beyond: Floats = self.points[tails] + edge * unit
        return beyond

    def next_of(self, half_edge: int) -> int:
        """The half-edge after it in the same triangle."""
        return half_edge - 2 if half_edge % 3 == 2 else half_edge + 1

    def before(self, half_edge: int) -> int:
        """The half-edge before it in the same triangle."""
        return half_edge + 2 if half_edge % 3 == 0 else half_edge - 1


def _glued(mesh: PolygonMesh, across: Numbers) -> Indices:
    """(3 t,) the opposite half-edges of the triangles of polygons."""
    corners = mesh.triangulation.corners.astype(np.intp)
    tails, heads = corners.ravel(), np.roll(corners, -1, axis=1).ravel()
    opposite = np.full(len(tails), -1, dtype=np.intp)
    outer = np.flatnonzero(mesh.following[tails] == heads)
    place = np.full(len(mesh.corners), -1, dtype=np.intp)
    place[tails[outer]] = outer
    there = across[tails[outer]]
    opposite[outer] = np.where(there >= 0, place[there], -1)
    diagonals = np.flatnonzero(mesh.following[tails] != heads)
    # Corners belong to one polygon: a pair of them names one diagonal.
    low = np.minimum(tails[diagonals], heads[diagonals])
    high = np.maximum(tails[diagonals], heads[diagonals])
    twins = diagonals[np.lexsort((high, low))].reshape(-1, 2)
    opposite[twins[:, 0]], opposite[twins[:, 1]] = twins[:, 1], twins[:, 0]
    return opposite
