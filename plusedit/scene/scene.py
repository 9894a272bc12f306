"""A design as items to draw in a plane, in layers: overlays, shapes, control lines and planes.

This is the one place that says how a design looks; windows, pictures and SVG files draw what
comes from here.
"""

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from itertools import chain

import numpy as np

from plusedit.document.design import Design
from plusedit.document.selection import NOTHING_SELECTED, Selection
from plusedit.document.shape import PlusGeometry, Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.arrows import direction_arrow
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.captions import in_corners
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.items import Caption, Item, Label, Legend, Markers, Words
from plusedit.scene.label_places import uncrowded
from plusedit.scene.map_lines import map_items
from plusedit.scene.mesh_shapes import mesh_items_in_plane
from plusedit.scene.options import ViewOptions
from plusedit.scene.shapes import (
    curve_items,
    design_overlay_items,
    handle_items,
    is_finite,
    overlay_items,
    shown_meshes,
    shown_shapes,
    surface_line_items,
)


@dataclass(frozen=True, eq=False)
class Layers:
    """What to draw, the first layer and the first item of each farthest back."""

    overlays: tuple[Item, ...]
    """lines and areas"""
    shapes: tuple[Item, ...]
    handles: tuple[Item, ...]
    marks: tuple[Item, ...] = ()
    """of overlays, and their words: in front of the shapes, behind handles"""
    legends: tuple[Legend, ...] = ()
    captions: tuple[Caption, ...] = ()
    """all in the same place: they are yet to be stacked"""

    def __iter__(self) -> Iterator[Item]:
        return chain(self.drawing(), in_corners((*self.legends, *self.captions)))

    def drawing(self) -> Iterator[Item]:
        """All but what is written into the corners."""
        return chain(self.overlays, self.shapes, self.marks, self.handles)


def scene_items(
    design: Design,
    camera: PlaneCamera,
    options: ViewOptions,
    selection: Selection = NOTHING_SELECTED,
    *,
    only: Collection[ShapeId] | None = None,
    glow: bool = True,
    wait: bool = True,
) -> Layers:
    """How `design` looks; with `only`, how those shapes of it do.

    What overlays draw about a design as a whole is left out then. `glow` is the halo of selected
    shapes, which takes longer than all else of a curve. Without `wait` surfaces of meshes are as
    they are known by now. What is too large to be calculated with is left out.
    """
    shown, meshes = shown_shapes(design, only), shown_meshes(design, only)
    overlays = chain(
        _of_design(design, camera, options, selection, wait=wait) if only is None else (),
        overlay_items(design, shown, camera, options, selection),
        overlay_items(design, meshes, camera, options, selection, wait=wait),
    )
    shapes = (
        item
        for shape_id, shape, geometry in shown
        for item in _shape(shape, geometry, camera, options, shape_id in selection.shapes, glow)
    )
    of_meshes = (
        item
        for shape_id, shape, surface in meshes
        for item in mesh_items_in_plane(
            shape, surface, camera, options, selected=shape_id in selection.shapes, wait=wait
        )
    )
    handles = handle_items(design, camera, options, selection, only)
    return _layers(camera, overlays, chain(of_meshes, shapes), handles)


def design_items(
    design: Design,
    camera: PlaneCamera,
    options: ViewOptions,
    selection: Selection,
    *,
    hurried: bool = False,
) -> Layers:
    """What overlays draw about a design as a whole, and nothing else; of meshes what is known.

    While an edit is going on (`hurried`) what takes its time is left for later.
    """
    overlays = _of_design(design, camera, options, selection, wait=False, hurried=hurried)
    return _layers(camera, overlays)


def _of_design(
    design: Design,
    camera: PlaneCamera,
    options: ViewOptions,
    selection: Selection,
    *,
    wait: bool,
    hurried: bool = False,
) -> Iterator[Item]:
    yield from map_items(design, camera, options, wait=wait, chosen=selection.shapes)
    yield from design_overlay_items(design, camera, options, selection, hurried=hurried, wait=wait)


def _layers(
    camera: PlaneCamera,
    overlays: Iterable[Item],
    shapes: Iterable[Item] = (),
    handles: Iterable[Item] = (),
) -> Layers:
    with np.errstate(all="ignore"):
        drawn = [item for item in overlays if is_finite(item)]
        return Layers(
            tuple(item for item in drawn if not isinstance(item, Markers | Words)),
            tuple(filter(is_finite, shapes)),
            tuple(filter(is_finite, handles)),
            uncrowded([item for item in drawn if isinstance(item, Markers | Label)], camera),
            tuple(item for item in drawn if isinstance(item, Legend)),
            tuple(item for item in drawn if isinstance(item, Caption)),
        )


def _shape(
    shape: Shape,
    geometry: PlusGeometry,
    camera: PlaneCamera,
    options: ViewOptions,
    selected: bool,
    glow: bool,
) -> Iterator[Item]:
    if isinstance(geometry, PlusCurve):
        yield from curve_items(shape, geometry, camera, selected=selected, glow=glow)
        if selected:
            yield from direction_arrow(geometry, camera)
        return
    yield from surface_line_items(
        shape,
        geometry,
        camera,
        surface_grids(geometry, camera),
        color=shape.style.color or "plus",
        selected=selected,
        inner=options.isolines,
        glow=glow,
    )
