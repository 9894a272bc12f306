"""Surfaces of meshes as they cover the view: the triangles that they are drawn with, in pixels."""

from dataclasses import dataclass
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.interaction.mesh_depths import DepthMap, depth_map
from plusedit.scene.camera import Camera
from plusedit.scene.drawn_mesh import MeshDrawing, drawing_of

BEHIND = 2e-3  # of the usual length of a pixel: smaller ones are behind the eye, or all but


@dataclass(frozen=True, eq=False)
class MeshFacets:
    """The triangles of one drawing in one view."""

    drawing: MeshDrawing
    corners: Floats
    """(t, 3, 2) pixels; not finite where a corner is behind the eye"""
    depths: Floats
    """(t, 3)"""
    low: Floats
    """(2, t) of the box around each"""
    high: Floats
    size: tuple[float, float]
    """of the view in pixels"""

    @cached_property
    def middles(self) -> Floats:
        """(f, 2) where the faces of the mesh are in the view."""
        return np.stack([self._mean(self.corners[..., k].mean(axis=1)) for k in (0, 1)], axis=1)

    @cached_property
    def deep(self) -> Floats:
        """(f,) how deep those are."""
        return self._mean(self.depths.mean(axis=1))

    @cached_property
    def map(self) -> DepthMap:
        """What it hides."""
        return depth_map(self.corners, self.depths, self.size)

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


_KEPT: "WeakKeyDictionary[MeshDrawing, tuple[Camera, MeshFacets]]" = WeakKeyDictionary()


def mesh_crossings(at: Floats, surface: MeshSurface, camera: Camera) -> list[Crossing]:
    """Every layer of a surface, as it is drawn by now, under a pixel (2,); the nearest first."""
    facets = facets_of_mesh(surface, camera)
    (x, y), (left, top), (right, bottom) = at, facets.low, facets.high
    rows = np.flatnonzero((left <= x) & (right >= x) & (top <= y) & (bottom >= y))
    shares = _shares(at, facets.corners[rows])
    hit = (shares >= 0.0).all(axis=1)
    rows, shares = rows[hit], shares[hit]
    net = facets.drawing.net
    depths = np.einsum("kc,kc->k", shares, facets.depths[rows])
    places = np.einsum("kc,kcd->kd", shares, net.places[net.triangles[rows]])
    return [
        Crossing(float(depths[k]), int(net.faces[rows[k]]), *places[k].tolist())
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
    points, triangles = drawing.points, drawing.net.triangles
    screen = camera.to_screen(points)
    screen = np.where(np.isfinite(screen), screen, np.nan)
    screen[~(camera.pixel_at(points) > BEHIND * camera.pixel)] = np.nan
    corners = screen[triangles]
    # A minimum along so short an axis would take several times as long as these.
    a, b, c = np.moveaxis(corners, 1, 0)
    low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
    low, high = np.ascontiguousarray(low.T), np.ascontiguousarray(high.T)
    depths = camera.depths(points)[triangles]
    return MeshFacets(drawing, corners, depths, low, high, camera.size)


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
