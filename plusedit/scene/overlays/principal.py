"""Crosses along the directions in which surfaces bend most and least.

The orange arm lies along the largest curvature, the blue and thin one along the smallest, as the
maps color high and low values. Where a surface bends alike in all directions there is no cross.
"""

from collections.abc import Iterator, Mapping

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_frames import principal_curvatures
from plusedit.scene.items import Item, Segments
from plusedit.scene.overlays import Seen, Setting, overlay
from plusedit.scene.surface_spots import (
    DENSITY,
    Spots,
    in_front,
    spots_on_mesh,
    spots_on_surface,
)

LARGEST, SMALLEST = "#D9771F", "#3B7CC4"  # seen in both themes; not only by their hues
APART = 0.8  # of the distance from cross to cross: none touches another
ROUND = 1e-6  # of the largest curvature: curvatures that differ by less are alike

principal = overlay(
    "principal",
    title="Principal directions",
    order=81,
    shortcut="Shift+F9",
    group="Surface analysis",
    settings=(DENSITY, Setting("length", "Length in pixels", 20.0, 4.0, 400.0)),
)


@principal.of_surfaces
def of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """A cross in the middle of each of some cells."""
    yield from _crosses(spots_on_surface(surface, seen.settings["density"], highest=2), seen)


@principal.finding_of_meshes("density")
def spots_of_mesh(surface: MeshSurface, numbers: Mapping[str, float]) -> Spots:
    """The middles of some faces."""
    return spots_on_mesh(surface, numbers["density"], highest=2)


@principal.of_meshes
def of_mesh(shape: Shape, surface: MeshSurface, seen: Seen) -> Iterator[Item]:
    """The same of a mesh, once they are known."""
    if isinstance(seen.findings, Spots):
        yield from _crosses(seen.findings, seen)


def _crosses(spots: Spots, seen: Seen) -> Iterator[Item]:
    with np.errstate(all="ignore"):
        found = principal_curvatures(spots.derivatives)
        size = np.maximum(np.abs(found.largest), np.abs(found.smallest))
        differs = found.largest - found.smallest > ROUND * size
        is_known = differs & np.isfinite(size) & (size > 0.0)
    points = spots.derivatives[0][is_known]
    if not len(points):
        return
    pixel = np.broadcast_to(seen.camera.pixel_at(points), len(points))[:, None]
    half = 0.5 * np.minimum(seen.settings["length"] * pixel, APART * spots.step)
    points = in_front(points, seen.camera)
    # Seen from the other side, what was the largest curvature is the smallest.
    is_turned = (spots.sides < 0.0)[is_known, None]
    one, other = found.along_largest[is_known], found.along_smallest[is_known]
    large, small = half * np.where(is_turned, other, one), half * np.where(is_turned, one, other)
    yield Segments(points - small, points + small, SMALLEST, 1.25)
    yield Segments(points - large, points + large, LARGEST, 2.25)
