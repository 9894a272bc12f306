"""Hairs along the normals of surfaces: which side is the front, and how the normals turn."""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_frames import normals as unit_normals
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.items import Item, Markers, Segments
from plusedit.scene.overlays import Seen, Setting, overlay
from plusedit.scene.surface_spots import DENSITY, spots_on_surface, vertices_apart

COLOR = "accent"

normals = overlay(
    "normals",
    title="Normals",
    order=80,
    shortcut="F9",
    group="Surface analysis",
    settings=(DENSITY, Setting("length", "Length in pixels", 24.0, 4.0, 400.0)),
)


@normals.of_surfaces
def of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """A hair from a dot on the surface, toward its front."""
    spots = spots_on_surface(surface, seen.settings["density"], highest=1)
    points, by_u, by_v = spots.derivatives
    yield from _hairs(points, unit_normals(by_u, by_v), seen)


@normals.of_meshes
def of_mesh(shape: Shape, surface: MeshSurface, seen: Seen) -> Iterator[Item]:
    """The same of a mesh, at some of the points that are drawn."""
    drawing = drawing_of(surface, wait=False)
    chosen = vertices_apart(drawing, seen.settings["density"])
    yield from _hairs(drawing.points[chosen], drawing.normals[chosen], seen)


def _hairs(points: Floats, across: Floats, seen: Seen) -> Iterator[Item]:
    is_known = np.isfinite(across).all(axis=1) & across.any(axis=1)
    points, across = points[is_known], across[is_known]
    if len(points):
        pixel = np.broadcast_to(seen.camera.pixel_at(points), len(points))[:, None]
        yield Segments(points, points + seen.settings["length"] * pixel * across, COLOR, 1.25)
        yield Markers(points, "circle", 4.0, COLOR, COLOR, 0.0)
