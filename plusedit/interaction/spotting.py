"""What overlays draw at the point of a shape that is under the pointer, or nearest to it.

The shape is the one that lies under the pointer; while a drag is under way, that which did before;
else the selected curve that is nearest, however far away it is.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.interaction.facets import hidden, surfaces_under
from plusedit.interaction.hits import Hit, nearest_on_segments
from plusedit.interaction.picking import curves_under
from plusedit.interaction.places import in_space
from plusedit.interaction.tool import REACH, Stage
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.drawn import drawn
from plusedit.scene.items import Item, Markers
from plusedit.scene.overlays import Seen, in_order
from plusedit.scene.shapes import is_finite

NEAR = 24.0  # pixels within which a curve counts as under the pointer
MARK = 10.0  # pixels, of what is pointed at from elsewhere


@dataclass(frozen=True)
class Spot:
    """A point of a shape."""

    shape: ShapeId
    place: tuple[float, ...]
    """(u,) of a curve, (u, v) of a surface"""


def spot_items(spot: Spot, stage: Stage) -> Iterator[Item]:
    """What the overlays that are switched on draw at a spot."""
    shape, options = stage.design[spot.shape], stage.options
    lines = stage.selection.by_shape().get(spot.shape, ())
    with np.errstate(all="ignore"):
        for entry in in_order():
            if entry.follows_pointer and entry.name in options.overlays:
                numbers = entry.numbers(options.settings)
                seen = Seen(stage.camera, lines, numbers, stage.design)
                items = entry.draw_place(shape, shape.geometry, spot.place, seen)
                yield from filter(is_finite, items)


def mark_items(spot: Spot, stage: Stage) -> Iterator[Item]:
    """A mark at a spot that is pointed at from elsewhere."""
    geometry = stage.design[spot.shape].plus if spot.shape in stage.design else None
    if isinstance(geometry, PlusCurve):
        yield Markers(geometry.at(spot.place), "circle", MARK, "hover", "canvas", 1.5)
    elif geometry is not None:
        points = geometry.derivatives_at([spot.place], highest=0)[0]
        yield Markers(points, "circle", MARK, "hover", "canvas", 1.5)


def is_followed(stage: Stage) -> bool:
    """Whether an overlay that is switched on draws anything under the pointer."""
    names = stage.options.overlays
    return any(entry.follows_pointer and entry.name in names for entry in in_order())


def spot_under(at: Floats, stage: Stage, held: ShapeId | None = None) -> Spot | None:
    """The spot under a pixel (2,), or nearest to it; of the shape `held` alone, if there is one."""
    if held is not None:
        geometry = stage.design[held].geometry if held in stage.design else None
        return None if geometry is None else _spot_of(held, geometry, at, stage)
    surfaces = surfaces_under(at, stage)
    for curve in curves_under(at, stage, REACH if surfaces else NEAR):
        if not surfaces or _is_seen(curve, stage):
            return Spot(curve.shape, (curve.u,))
    if not surfaces:
        return _nearest_selected(at, stage)
    first = surfaces[0]
    found = _spot_of(first.shape, stage.design[first.shape].geometry, at, stage)
    return found or Spot(first.shape, (first.u, first.v))


def _is_seen(hit: Hit, stage: Stage) -> bool:
    """Whether no surface hides a curve; in a plane they are seen through."""
    if isinstance(stage.camera, PlaneCamera):
        return True
    point = in_space(stage.design.curve(hit.shape).at([hit.u]))
    return not hidden(point, stage.design, stage.camera)[0]


def _nearest_selected(at: Floats, stage: Stage) -> Spot | None:
    found = [
        (*nearest_on_curve(curve, at, stage.camera), shape_id)
        for shape_id, curve in stage.design.curves()
        if shape_id in stage.selection.shapes and stage.design[shape_id].visible
    ]
    if not found:
        return None
    _, u, shape_id = min(found)
    return Spot(shape_id, (u,))


def _spot_of(shape_id: ShapeId, geometry: Geometry, at: Floats, stage: Stage) -> Spot | None:
    if isinstance(geometry, PlusCurve):
        return Spot(shape_id, (nearest_on_curve(geometry, at, stage.camera)[1],))
    if isinstance(geometry, MeshSurface):
        own = (hit for hit in surfaces_under(at, stage) if hit.shape == shape_id)
        return next((Spot(shape_id, (hit.u, hit.v)) for hit in own), None)
    place = place_under(geometry, at, stage.camera)
    return None if place is None else Spot(shape_id, place)


def nearest_on_curve(curve: PlusCurve, at: Floats, camera: Camera) -> tuple[float, float]:
    """How far a curve, as it is drawn, is from a pixel (2,) in pixels, and at what parameter."""
    shown = drawn(curve, camera)
    along, distances = nearest_on_segments(at, shown.screen[:-1], shown.screen[1:])
    row = int(np.argmin(np.where(np.isfinite(distances), distances, np.inf)))
    first, last = shown.grid.parameters[row : row + 2]
    return float(distances[row]), float(first + along[row] * (last - first))


def place_under(surface: PlusSurface, at: Floats, camera: Camera) -> tuple[float, float] | None:
    """(u, v) of the first point of a surface under a pixel (2,); None where it is not."""
    from plusedit.geometry.surface_nearest import hit_by_ray

    origin, way = camera.ray(at)
    if isinstance(camera, PlaneCamera):
        # A parallel view begins outside of all there is.
        reach = 2.0 * float(np.abs(surface.planes.control_points).max())
        origin = origin - way * (reach + float(np.abs(surface.gradients).max()))
    hit = hit_by_ray(surface, origin, way)
    return None if hit is None else (hit.u, hit.v)
