"""A design as items to draw, in layers: overlays, curves, control lines.

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
from plusedit.document.shape import NotDrawn, Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.arrows import direction_arrow
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.control_lines import control_line_items
from plusedit.scene.drawn import drawn
from plusedit.scene.handles import handle_shapes
from plusedit.scene.items import Item, Label, Patch, Polyline, Segments
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import in_order

WIDTH = 2.0  # of a curve whose style says nothing
THINNEST = 1.0  # pixels
HALO = 6.0  # pixels by which the glow of a selected curve is wider than the curve
DIM = "@45"  # locked shapes


@dataclass(frozen=True, eq=False)
class Layers:
    """What to draw, the first layer and the first item of each farthest back."""

    overlays: tuple[Item, ...]
    curves: tuple[Item, ...]
    handles: tuple[Item, ...]

    def __iter__(self) -> Iterator[Item]:
        return chain(self.overlays, self.curves, self.handles)


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

    `glow` is the halo of selected curves, which takes longer than all else of a curve. What is
    too large to be calculated with is left out.
    """
    shown = [
        (shape_id, shape, curve)
        for shape_id, shape in design.shapes.items()
        if shape.visible
        and (curve := shape.curve) is not None
        and (only is None or shape_id in only)
    ]
    with_handles = [
        shape_id
        for shape_id in handle_shapes(design, selection, options)
        if only is None or shape_id in only
    ]
    overlays = (
        item
        for entry in in_order()
        if entry.name in options.overlays
        for _, shape, curve in shown
        for item in entry.draw(shape, curve, camera)
    )
    curves = (
        item
        for shape_id, shape, curve in shown
        for item in _curve(shape, curve, camera, shape_id in selection.shapes, glow)
    )
    handles = _handles(design, camera, selection, with_handles)
    with np.errstate(all="ignore"):
        return Layers(*(tuple(filter(_is_finite, layer)) for layer in (overlays, curves, handles)))


def _is_finite(item: Item) -> bool:
    match item:
        case Segments(starts, ends):
            return bool(np.isfinite(starts).all() and np.isfinite(ends).all())
        case Label(at):
            return bool(np.isfinite(at).all())
        case Patch():
            return True
        case _:
            return bool(np.isfinite(item.points).all())


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


def _curve(
    shape: Shape, curve: PlusCurve, camera: PlaneCamera, selected: bool, glow: bool
) -> Iterator[Item]:
    points = drawn(curve, camera).points
    # Thinner than a pixel, a curve would be fainter than its ghost and its polygon.
    width = WIDTH if shape.style.width is None else max(shape.style.width, THINNEST)
    if selected and glow:
        yield Polyline(points, "selected@28", width + HALO)
    color = shape.style.color or "plus"
    yield Polyline(points, color + DIM if shape.locked else color, width)
    if selected:
        yield from direction_arrow(curve, camera)


def _handles(
    design: Design, camera: PlaneCamera, selection: Selection, shapes: list[ShapeId]
) -> Iterator[Item]:
    lines = selection.by_shape()
    active = selection.active
    # Those of selected shapes come last: they lie in front, as they are what a click takes.
    for shape_id in sorted(shapes, key=lambda i: i in selection.shapes):
        curve = design[shape_id].curve
        if curve is None:
            continue
        yield from control_line_items(
            curve,
            camera,
            selected=lines.get(shape_id, ()),
            active=active.number if active is not None and active.shape == shape_id else None,
            quiet=bool(selection) and shape_id not in selection.shapes,
        )
