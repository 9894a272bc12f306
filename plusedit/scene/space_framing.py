"""Where to look in space so that everything is seen."""

from collections.abc import Iterable, Iterator

import numpy as np

from plusedit.document.design import Design
from plusedit.document.selection import NOTHING_SELECTED
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_surface import coarse_points
from plusedit.scene.extremes import telling
from plusedit.scene.items import (
    Caption,
    Item,
    Label,
    Legend,
    Markers,
    Mesh,
    Patch,
    Polygon,
    Polyline,
    Segments,
)
from plusedit.scene.options import ViewOptions
from plusedit.scene.shapes import handle_items, overlay_items, shown_meshes, shown_shapes
from plusedit.scene.space_camera import SpaceCamera

MARGIN = 32.0  # pixels around what is framed
ROUNDS = 3  # handles keep their size in pixels: zooming in needs room for them again
SETTLED = 0.01  # change of the height for which another round is not worth its time


def framed_in_space(
    design: Design,
    camera: SpaceCamera,
    options: ViewOptions,
    *,
    only: Iterable[ShapeId] | None = None,
    margin: float = MARGIN,
) -> SpaceCamera:
    """The camera moved and zoomed so that all that is drawn of the shapes is seen.

    It looks the same way as before. Itself if nothing is drawn.
    """
    chosen = None if only is None else frozenset(only)
    shown = shown_shapes(design, chosen)
    points = [in_space(geometry.net.control_points) for _, _, geometry in shown]
    points += [telling(surface.mesh.vertices) for _, _, surface in shown_meshes(design, chosen)]
    if not points:
        return camera
    camera = camera.framing(np.concatenate(points), margin)
    for _, _, geometry in shown:
        if isinstance(geometry, PlusCurve):
            points.append(in_space(drawn(geometry, camera).points))
        else:
            points.append(coarse_points(geometry))
    for _ in range(ROUNDS):
        items = [
            *overlay_items(design, shown, camera, options),
            *handle_items(design, camera, options, NOTHING_SELECTED, chosen),
        ]
        extent = np.concatenate(
            [*points, *(telling(in_space(p)) for i in items for p in _places(i))]
        )
        before, camera = camera, camera.framing(extent[np.isfinite(extent).all(axis=1)], margin)
        if abs(camera.height - before.height) <= SETTLED * before.height:
            break
    return camera


def in_space(points: Floats) -> Floats:
    """(m, 3) points (m, 2) or (m, 3); a plane curve lies in z = 0."""
    if points.shape[1] == 3:
        return points
    return np.column_stack([points, np.zeros(len(points))])


def _places(item: Item) -> Iterator[Floats]:
    match item:
        case Polyline(points) | Polygon(points) | Markers(points) | Mesh(points):
            yield points
        case Segments(starts, ends):
            yield starts
            yield ends
        case Label(at):
            yield at[None]
        case Patch() | Legend() | Caption():
            pass
