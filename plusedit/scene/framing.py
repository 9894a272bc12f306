"""Where to look so that everything is seen."""

from collections.abc import Iterable

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.extremes import telling
from plusedit.scene.items import Item, Label, Markers, Polygon, Polyline, Segments
from plusedit.scene.label_places import label_box
from plusedit.scene.options import ViewOptions
from plusedit.scene.scene import scene_items
from plusedit.scene.shapes import shown_meshes, shown_shapes

MARGIN = 32.0  # pixels around what is framed
ROUNDS = 3  # handles and names keep their size in pixels: zooming in needs room for them again
SETTLED = 0.01  # change of the scale for which another round is not worth its time


def framed(
    design: Design,
    camera: PlaneCamera,
    options: ViewOptions,
    *,
    only: Iterable[ShapeId] | None = None,
    margin: float = MARGIN,
    words: float = 1.0,
) -> PlaneCamera:
    """The camera moved and zoomed so that all that is drawn of the shapes is seen.

    Itself if nothing is drawn. Whatever keeps its size on the screen is given room for; labels are
    drawn `words` times as large.
    """
    chosen = None if only is None else frozenset(only)
    points = _control_points(design, camera, chosen)
    if not len(points):
        return camera
    camera = camera.framing(camera.placed(points), margin)
    for _ in range(ROUNDS):
        items = scene_items(design, camera, options, only=chosen, wait=False)
        extent = np.concatenate([points, extent_of(items, camera, words)])
        before, camera = camera, camera.framing(camera.placed(extent), margin)
        if abs(camera.scale - before.scale) <= SETTLED * before.scale:
            break
    return camera


def extent_of(items: Iterable[Item], camera: PlaneCamera, words: float = 1.0) -> Floats:
    """(m, 2) points of the plane that is seen, as far out as what the items draw."""
    rows = [telling(seen) for item in items for seen in _extent(item, camera, words)]
    return np.concatenate(rows) if rows else np.zeros((0, 2))


def _control_points(design: Design, camera: PlaneCamera, only: frozenset[ShapeId] | None) -> Floats:
    rows = [
        camera.plane(geometry.net.control_points) for _, _, geometry in shown_shapes(design, only)
    ]
    rows += [
        telling(camera.plane(surface.mesh.vertices)) for _, _, surface in shown_meshes(design, only)
    ]
    return np.concatenate(rows) if rows else np.zeros((0, 2))


def _extent(item: Item, camera: PlaneCamera, words: float) -> Iterable[Floats]:
    match item:
        case Polyline(points) | Polygon(points) | Markers(points):
            yield camera.plane(points)
        case Segments(starts, ends):
            yield camera.plane(starts)
            yield camera.plane(ends)
        case Label():
            yield camera.in_plane(camera.to_screen(item.at[None]) + words * label_box(item))
