"""A design as items to draw in a plane, in layers: overlays, shapes, control lines and planes.

This is the one place that says how a design looks; windows, pictures and SVG files draw what
comes from here.
"""

from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from itertools import chain

import numpy as np

from plusedit.document.design import Design
from plusedit.document.selection import NOTHING_SELECTED, Selection
from plusedit.document.shape import NotDrawn, PlusGeometry, Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.arrows import direction_arrow
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.items import Item
from plusedit.scene.options import ViewOptions
from plusedit.scene.shapes import (
    curve_items,
    handle_items,
    is_finite,
    overlay_items,
    shown_shapes,
    surface_line_items,
)


@dataclass(frozen=True, eq=False)
class Layers:
    """What to draw, the first layer and the first item of each farthest back."""

    overlays: tuple[Item, ...]
    shapes: tuple[Item, ...]
    handles: tuple[Item, ...]

    def __iter__(self) -> Iterator[Item]:
        return chain(self.overlays, self.shapes, self.handles)


def scene_items(
    design: Design,
    camera: PlaneCamera,
    options: ViewOptions,
    selection: Selection = NOTHING_SELECTED,
    *,
    only: Collection[ShapeId] | None = None,
    glow: bool = True,
) -> Layers:
    """How `design` looks; with `only`, how those shapes of it do.

    `glow` is the halo of selected shapes, which takes longer than all else of a curve. What is
    too large to be calculated with is left out.
    """
    shown = shown_shapes(design, only)
    overlays = overlay_items(shown, camera, options)
    shapes = (
        item
        for shape_id, shape, geometry in shown
        for item in _shape(shape, geometry, camera, options, shape_id in selection.shapes, glow)
    )
    handles = handle_items(design, camera, options, selection, only)
    with np.errstate(all="ignore"):
        return Layers(*(tuple(filter(is_finite, layer)) for layer in (overlays, shapes, handles)))


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


def left_out(design: Design) -> str:
    """What the design has that can't be drawn yet, in a sentence; empty if nothing."""
    kinds = Counter(
        shape.geometry.kind
        for shape in design.shapes.values()
        if isinstance(shape.geometry, NotDrawn)
    )
    if not kinds:
        return ""
    counted = [f"{n} {_plural(kind) if n > 1 else kind}" for kind, n in sorted(kinds.items())]
    verb = "is" if sum(kinds.values()) == 1 else "are"
    return f"{' and '.join(counted)} {verb} kept but not drawn yet"


def _plural(kind: str) -> str:
    return f"{kind}es" if kind.endswith("sh") else f"{kind}s"
