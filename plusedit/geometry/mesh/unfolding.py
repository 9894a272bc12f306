"""The faces of a mesh laid out in the domain of its parameters, to be looked at.

Every face is moved as a whole to the image whose center lies in the domain's cell. Those at the
rim of the cell reach beyond it, into the next image of the cell, where they cover what the faces
that were moved away from there leave open.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Domain, Images
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import Indices, PolygonMesh

Flags = NDArray[np.bool_]

SAME = 1e-7  # of the extent: parameters on both sides of an edge that differ by less are rounded
NONE = -1


@dataclass(frozen=True, eq=False)
class Unfolding:
    """Faces in the cell of a domain; never changed in place."""

    mesh: PolygonMesh
    domain: Domain
    centers: Floats
    """(f, 2) of the faces, in the cell"""
    corners: Floats
    """(c, 2) of the faces around these centers"""

    @classmethod
    def of(cls, surface: MeshSurface) -> "Unfolding":
        """The faces of a surface of a mesh at its parameters."""
        mesh, domain = surface.mesh, surface.domain
        centers = mesh.sums(surface.parameters) / mesh.sizes[:, None]
        reduced = domain.reduction(centers)
        away = surface.parameters - np.repeat(centers, mesh.sizes, axis=0)
        turned = away * np.repeat(reduced.signs, mesh.sizes)[:, None]
        corners = turned + np.repeat(reduced.places, mesh.sizes, axis=0)
        return cls(mesh, domain, reduced.places, corners)

    @cached_property
    def triangles(self) -> Floats:
        """(t, 3, 2) corners of the triangles of the mesh's triangulation."""
        return self.corners[self.mesh.triangulation.corners]

    @cached_property
    def boxes(self) -> tuple[Floats, Floats]:
        """Lowest and highest (u, v) of every triangle, (t, 2) each."""
        first, second, third = self.triangles.transpose(1, 0, 2)
        lows = np.minimum(np.minimum(first, second), third)
        return lows, np.maximum(np.maximum(first, second), third)

    @cached_property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lowest and highest (u, v) of the cell; of the faces where the domain is unbounded."""
        low, high = self.corners.min(axis=0), self.corners.max(axis=0)
        bounded = np.isfinite(self.domain.cell)
        return np.where(bounded, 0.0, low), np.where(bounded, self.domain.cell, high)

    @cached_property
    def rims(self) -> tuple[Floats, Floats]:
        """Starts and ends (k, 2) of the edges at the border of the mesh, and of edges at which the
        parameters of both faces are no images of each other: the map is torn there."""
        mesh, opposite = self.mesh, self.mesh.topology.opposite
        torn = opposite < 0
        inner = np.flatnonzero(~torn)
        across = opposite[inner]
        ends = (inner, mesh.following[across]), (mesh.following[inner], across)
        slack = SAME * float(np.ptp(self.corners, axis=0).max(initial=0.0))
        apart = np.zeros(len(inner), dtype=np.bool_)
        for mine, other in ends:
            there = self.domain.nearest(self.corners[other], self.corners[mine])
            apart |= np.abs(there - self.corners[mine]).max(axis=1, initial=0.0) > slack
        torn[inner[apart]] = True
        chosen = np.flatnonzero(torn)
        return self.corners[chosen], self.corners[mesh.following[chosen]]

    @cached_property
    def images(self) -> Images:
        """Those of the cell and of the cells around it; the first is the cell itself."""
        u, v = (period if np.isfinite(period) else 0.0 for period in self.domain.periods)
        return self.domain.images(u, v)

    def images_within(self, low: Floats, high: Floats) -> Images:
        """The images of the cell beside itself that reach into a box, those around the cell only.

        The first is the cell itself, whether or not it reaches there.
        """
        cell_low, cell_high = self.bounds
        images = self.images
        ends = images.signs[:, None, None] * np.stack([cell_low, cell_high])
        ends = ends + images.shifts[:, None, :]
        lows, highs = ends.min(axis=1), ends.max(axis=1)
        extent = cell_high - cell_low
        around = (lows < cell_high + extent / 2.0) & (highs > cell_low - extent / 2.0)
        seen = (around & (lows <= high) & (highs >= low)).all(axis=1)
        seen[0] = True
        return Images(images.shifts[seen], images.signs[seen])

    def face_at(self, place: Floats) -> int:
        """The face that covers a place (2,), or an image of it; -1 where none does.

        Of several, as where the map is folded, the last.
        """
        for near in self._images_of(place):
            around = self.triangles_within(near, near)
            found = around[_inside(self.triangles[around], near)]
            if len(found):
                return int(self.mesh.triangulation.owners[found[-1]])
        return NONE

    def triangles_within(self, low: Floats, high: Floats) -> Indices:
        """The triangles, at their own place only, whose boxes meet a box, rims included."""
        lows, highs = self.boxes
        seen = (lows[:, 0] <= high[0]) & (highs[:, 0] >= low[0])
        seen &= (lows[:, 1] <= high[1]) & (highs[:, 1] >= low[1])
        return np.flatnonzero(seen)

    def faces_within(self, low: Floats, high: Floats) -> Indices:
        """The faces of which some image has its center in a box."""
        marks = np.zeros(self.mesh.face_count, dtype=np.bool_)
        images = self.images_within(low, high)
        for shift, sign in zip(*images, strict=True):
            there = sign * self.centers + shift
            marks |= ((there >= low) & (there <= high)).all(axis=1)
        return np.flatnonzero(marks)

    def vertex_near(self, place: Floats) -> int:
        """The vertex of which some image is nearest to a place (2,)."""
        used = np.flatnonzero(self.mesh.used)
        squares = np.full(len(used), np.inf)
        for near in self._images_of(place):
            squares = np.minimum(squares, ((self.vertex_places[used] - near) ** 2).sum(axis=1))
        return int(used[squares.argmin()])

    def vertex_of_face(self, face: int, place: Floats) -> tuple[int, Floats]:
        """The vertex of a face nearest to a place (2,), and its image nearest to there (2,)."""
        mesh = self.mesh
        corners = slice(mesh.starts[face], mesh.starts[face + 1])
        around = self.corners[corners]
        near = self.domain.nearest(around, np.broadcast_to(place, around.shape))
        k = int(((near - place) ** 2).sum(axis=1).argmin())
        return int(mesh.corners[corners][k]), near[k]

    @cached_property
    def vertex_places(self) -> Floats:
        """(n, 2) of every vertex as some face has it; of no meaning for vertices of no face."""
        places = np.zeros((self.mesh.vertex_count, 2))
        places[self.mesh.corners] = self.corners
        return places

    def _images_of(self, place: Floats) -> Floats:
        """(k, 2) the image of a place in the cell, then those where faces of the cell may be."""
        reduced = self.domain.reduced(place[None])
        images = self.images
        near = images.signs[:, None] * reduced + images.shifts
        low, high = self.corners.min(axis=0), self.corners.max(axis=0)
        there = ((near >= low) & (near <= high)).all(axis=1)
        there[0] = True
        found: Floats = near[there]
        return found


def _inside(triangles: Floats, place: Floats) -> Flags:
    """(t,) true for triangles (t, 3, 2), either way around, that hold a place or pass through."""
    away = triangles - place
    after = np.roll(away, -1, axis=1)
    sides = away[..., 0] * after[..., 1] - away[..., 1] * after[..., 0]
    one_way: Flags = np.all(sides >= 0.0, axis=1) | np.all(sides <= 0.0, axis=1)
    has_area: Flags = sides.sum(axis=1) != 0.0
    return one_way & has_area
