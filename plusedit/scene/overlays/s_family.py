"""The shapes of one net for many values of s at once, as skins of an onion.

From s = 0, the classical shape, in even steps to a multiple of L, the length of the control
polygon; colored by s. All are sums of the same two terms.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.curve import terms as curve_terms
from plusedit.geometry.natural import natural_length_of
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface import terms as surface_terms
from plusedit.scene.color_scale import ColorScale
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.items import Caption, Item, Polyline, Row
from plusedit.scene.overlays import Seen, Setting, overlay
from plusedit.scene.shapes import shown_shapes

RAMP = ColorScale(("#2C74B3", "#7D6BB0", "#B4587F", "#C8622A"))
"""As light all along as is seen on both canvases; blue to orange is told apart by everyone."""
WIDTH = 1.25
MOST_OF_SURFACES = 7  # each with several lines
MOST_ROWS = 9  # of the caption
LINES_OPEN, LINES_CLOSED = (0.0, 0.25, 0.5, 0.75, 1.0), (0.0, 0.25, 0.5, 0.75)

s_family = overlay(
    "s_family",
    title="Family by s",
    order=44,
    shortcut="Shift+O",
    group="Constructions",
    settings=(
        Setting("count", "Shapes", 9.0, 2.0, 33.0),
        Setting("reach", "Up to s / L", 1.0, 0.1, 4.0),
    ),
)


@s_family.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """A thin curve for each value of s; nothing where the control polygon has no length."""
    values = _values(curve, round(seen.settings["count"]), seen.settings["reach"])
    if not len(values):
        return
    last = replace(curve, s=float(values[-1]))
    # What strays little at both ends of the family does so between: it is affine in s.
    ends = [drawn(each, seen.camera).grid.parameters for each in (curve.classical, last)]
    base, plus = curve_terms(curve.basis, curve.lines, Grid(np.union1d(*ends)))
    for s, color in zip(values.tolist(), RAMP.hexadecimal(len(values)), strict=True):
        yield Polyline(base + s * plus, color, WIDTH)


@s_family.of_surfaces
def of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """The edges and a few lines across for each value of s, fewer values than of curves."""
    count = min(round(seen.settings["count"]), MOST_OF_SURFACES)
    values = _values(surface, count, seen.settings["reach"])
    if not len(values):
        return
    colors = RAMP.hexadecimal(len(values))
    grids = surface_grids(surface, seen.camera)
    few = [Grid(np.array(LINES_CLOSED if closed else LINES_OPEN)) for closed in surface.closed]
    for is_along_u in (True, False):
        pair = (grids[0], few[1]) if is_along_u else (few[0], grids[1])
        base, plus = surface_terms(*surface.bases, surface.planes, *pair)
        for s, color in zip(values.tolist(), colors, strict=True):
            lines = base + s * plus
            for points in lines.swapaxes(0, 1) if is_along_u else lines:
                yield Polyline(np.ascontiguousarray(points), color, WIDTH)


@s_family.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """Which color stands for which s."""
    shown = [geometry for _, _, geometry in shown_shapes(design)]
    if not shown:
        return
    count, reach = round(seen.settings["count"]), seen.settings["reach"]
    if not any(isinstance(geometry, PlusCurve) for geometry in shown):
        count = min(count, MOST_OF_SURFACES)
    every = -(-(count - 1) // (MOST_ROWS - 1))
    colors = RAMP.hexadecimal(count)
    rows = [
        Row(f"{reach * number / (count - 1):.3g}", color=colors[number])
        for number in range(0, count, every)
    ]
    yield Caption("s / L", tuple(rows))


def _values(geometry: PlusCurve | PlusSurface, count: int, reach: float) -> Floats:
    """(count,) the values of s; none where there is no length that they could be measured by."""
    length = natural_length_of(geometry)
    return np.linspace(0.0, reach * length, count) if length > 0.0 else np.zeros(0)
