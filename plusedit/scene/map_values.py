"""The values of the overlay that colors surfaces, of all shapes that are shown."""

from collections.abc import Collection

from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.camera import Camera
from plusedit.scene.coloring import known_values, mesh_values, surface_values
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.drawn_surface import Grids, surface_grids
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import Overlay
from plusedit.scene.shapes import shown_meshes, shown_shapes


def values_of(
    entry: Overlay,
    design: Design,
    camera: Camera,
    options: ViewOptions,
    *,
    draft: bool = False,
    wait: bool = True,
    only: Collection[ShapeId] | None = None,
    chosen: frozenset[ShapeId] = frozenset(),
) -> dict[ShapeId, Floats]:
    """What each shape is colored by at the points that are drawn, as far as that is known.

    With `wait` all is found first. The `chosen` shapes are selected.
    """
    if entry.compares:
        drawn = _drawn(design, camera, options, draft=draft, wait=wait)
        return dict(entry.design_values(design, chosen, drawn, wait))
    numbers = entry.numbers(options.settings)
    values: dict[ShapeId, Floats | None] = {}
    for shape_id, _, geometry in shown_shapes(design, only):
        if isinstance(geometry, PlusSurface):
            grids = surface_grids(geometry, camera, draft=draft)
            values[shape_id] = surface_values(entry, geometry, grids, numbers)
    for shape_id, shape, surface in shown_meshes(design, only):
        if options.facets or shape.style.facets:
            continue
        drawing = drawing_of(surface, wait=wait)
        find = mesh_values if wait else known_values
        values[shape_id] = find(entry, surface, drawing, numbers)
    return {shape_id: found for shape_id, found in values.items() if found is not None}


def _drawn(
    design: Design, camera: Camera, options: ViewOptions, *, draft: bool, wait: bool
) -> dict[ShapeId, Grids | MeshDrawing]:
    """How all surfaces are drawn, but for meshes that are shown as they are."""
    found: dict[ShapeId, Grids | MeshDrawing] = {
        shape_id: surface_grids(geometry, camera, draft=draft)
        for shape_id, _, geometry in shown_shapes(design)
        if isinstance(geometry, PlusSurface)
    }
    if not options.facets:
        for shape_id, _, surface in shown_meshes(design):
            found[shape_id] = drawing_of(surface, wait=wait)
    return found
