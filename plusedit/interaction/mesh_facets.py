"""Surfaces of meshes as they cover the view: the triangles that they are drawn with, in pixels."""

from dataclasses import dataclass
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.interaction.mesh_depths import DepthMap, depth_map
from plusedit.scene.camera import Camera
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.mesh_drawing import MeshDrawing

BEHIND_EYE = np.uint8(16)  # beside four bits for the sides of a pixel
BEHIND = 2e-3  # of the usual length of a pixel: smaller ones are behind the eye, or all but


@dataclass(frozen=True, eq=False)
class MeshFacets:
    """The triangles of one drawing in one view."""

    drawing: MeshDrawing
    screen: Floats
    """(n, 2) pixels of the vertices; not finite behind the eye"""
    depths: Floats
    """(n,)"""
    behind: NDArray[np.uint8]
    """(n,) BEHIND_EYE where a vertex is, else 0"""
    size: tuple[float, float]
    """of the view in pixels"""

    @cached_property
    def corners(self) -> Floats:
        """(t, 3, 2) pixels of the triangles."""
        found: Floats = self.screen[self.drawing.net.triangles]
        return found

    @cached_property
    def middles(self) -> Floats:
        """(f, 2) where the faces of the mesh are in the view."""
        return np.stack([self._mean(self.corners[..., k].mean(axis=1)) for k in (0, 1)], axis=1)

    @cached_property
    def deep(self) -> Floats:
        """(f,) how deep those are."""
        return self._mean(self.depths[self.drawing.net.triangles].mean(axis=1))

    @cached_property
    def map(self) -> DepthMap:
        """What it hides."""
        return depth_map(self.corners, self.depths[self.drawing.net.triangles], self.size)

    def around(self, at: Floats) -> NDArray[np.intp]:
        """The triangles that have a pixel (2,) in the boxes around them."""
        x, y = self.screen.T
        sides = self.behind.copy()
        for bit, is_beyond in enumerate((x < at[0], x > at[0], y < at[1], y > at[1])):
            sides |= is_beyond.view(np.uint8) << np.uint8(bit)
        # No boxes are made: most views are looked at but once, and this takes less time.
        first, second, third = (sides[corners] for corners in self.drawing.net.corners)
        is_apart = (first & second & third) | ((first | second | third) & BEHIND_EYE)
        return np.flatnonzero(is_apart == 0)

    def _mean(self, values: Floats) -> Floats:
        """(f,) the means of numbers of triangles (t,) over each face."""
        faces, count = self.drawing.net.faces, int(self.drawing.net.parents.max()) + 1
        with np.errstate(invalid="ignore"):
            means: Floats = np.bincount(faces, values, count) / np.bincount(faces, minlength=count)
        return means


@dataclass(frozen=True)
class Crossing:
    """Where a surface lies under a pixel."""

    depth: float
    face: int
    """of the mesh"""
    u: float
    v: float
    triangle: int
    """of the drawing"""
    shares: tuple[float, float, float]
    """what each of its corners has in the point"""


_KEPT: "WeakKeyDictionary[MeshDrawing, tuple[Camera, MeshFacets]]" = WeakKeyDictionary()


def mesh_crossings(at: Floats, surface: MeshSurface, camera: Camera) -> list[Crossing]:
    """Every layer of a surface, as it is drawn by now, under a pixel (2,); the nearest first."""
    facets = facets_of_mesh(surface, camera)
    net, rows = facets.drawing.net, facets.around(at)
    shares = _shares(at, facets.screen[net.triangles[rows]])
    hit = (shares >= 0.0).all(axis=1)
    rows, shares = rows[hit], shares[hit]
    depths = np.einsum("kc,kc->k", shares, facets.depths[net.triangles[rows]])
    corners = net.places[net.triangles[rows]]
    for corner in (1, 2):
        # Across a seam the corners have parameters on either side of it.
        corners[:, corner] = surface.domain.nearest(corners[:, corner], corners[:, 0])
    places = np.einsum("kc,kcd->kd", shares, corners)
    return [
        Crossing(
            depth=float(depths[k]),
            face=int(net.faces[rows[k]]),
            u=float(places[k, 0]),
            v=float(places[k, 1]),
            triangle=int(rows[k]),
            shares=(float(shares[k, 0]), float(shares[k, 1]), float(shares[k, 2])),
        )
        for k in np.argsort(depths, kind="stable")
    ]


def facets_of_mesh(surface: MeshSurface, camera: Camera) -> MeshFacets:
    """The triangles of a surface as it is drawn by now; those of the last view are kept."""
    drawing = drawing_of(surface, wait=False)
    kept = _KEPT.get(drawing)
    if kept is None or kept[0] != camera:
        kept = _KEPT[drawing] = camera, _facets(drawing, camera)
    return kept[1]


def _facets(drawing: MeshDrawing, camera: Camera) -> MeshFacets:
    points = drawing.points
    screen = camera.to_screen(points)
    is_seen = np.isfinite(screen).all(axis=1) & (camera.pixel_at(points) > BEHIND * camera.pixel)
    screen = np.where(is_seen[:, None], screen, np.nan)
    behind = np.where(is_seen, np.uint8(0), BEHIND_EYE)
    return MeshFacets(drawing, screen, camera.depths(points), behind, camera.size)


def _shares(at: Floats, corners: Floats) -> Floats:
    """(k, 3) what each corner of triangles (k, 3, 2) has in a point; negative in thin ones."""
    one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    off = at - corners[:, 0]
    twice = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        second = (off[:, 0] * other[:, 1] - off[:, 1] * other[:, 0]) / twice
        third = (one[:, 0] * off[:, 1] - one[:, 1] * off[:, 0]) / twice
    shares = np.stack([1.0 - second - third, second, third], axis=1)
    return np.where(np.isfinite(shares), shares, -1.0)
