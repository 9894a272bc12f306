"""Surfaces of meshes as they cover the view: the triangles that they are drawn with, in pixels."""

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
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
    """(t, 2) of the box around each"""
    high: Floats


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
    facets = _facets_of(drawing_of(surface, wait=False), camera)
    inside = ((facets.low <= at) & (facets.high >= at)).all(axis=1)
    rows = np.flatnonzero(inside)
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


def _facets_of(drawing: MeshDrawing, camera: Camera) -> MeshFacets:
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
    return MeshFacets(
        drawing, corners, camera.depths(points)[triangles], corners.min(axis=1), corners.max(axis=1)
    )


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
