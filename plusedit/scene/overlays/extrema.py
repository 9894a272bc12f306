"""Marks at the inflections of curves, and where their curvature is extremal.

A diamond where a plane curve changes from turning left to turning right, or back; a square where
the curvature is larger or smaller than all about, with its value while there are few of them. In
designs of many shapes those of the selected curves alone.
"""

from collections.abc import Iterator

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.items import Caption, Item, Markers, Row
from plusedit.scene.outward import outward_label
from plusedit.scene.overlays import Seen, overlay
from plusedit.scene.turning_points import turning_points

MANY = 200  # curves, of which only the selected are searched: each takes some milliseconds
FEW = 16  # extrema of a curve up to which values stand beside them
DIAMOND, SQUARE = 12.0, 9.0  # pixels
APART = 12.0  # pixels from a mark to its value, on the outer side of the curve

extrema = overlay(
    "extrema",
    title="Inflections and extremal curvature",
    order=111,
    shortcut="Shift+X",
    group="Curve analysis",
)


@extrema.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """A diamond at each inflection, a square at each extremum of curvature."""
    if _has_many(seen.design) and not seen.is_selected:
        return
    found = turning_points(curve)
    if len(found.extrema):
        yield Markers(found.extrema, "square", SQUARE, "v", "canvas", 1.0)
    if len(found.inflections):
        yield Markers(found.inflections, "diamond", DIAMOND, "hover", "canvas", 1.25)
    if len(found.extrema) <= FEW:
        values = found.curvatures.tolist()
        for point, way, value in zip(found.extrema, found.outward, values, strict=True):
            text = f"κ {value + 0.0:.3g}"
            yield outward_label(point, way, text, "v", seen.camera, apart=APART)


@extrema.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """How many there are, on all curves that are marked."""
    shown = {i: curve for i, curve in design.curves() if design[i].visible}
    is_for_selected = _has_many(design)
    curves = [curve for i, curve in shown.items() if i in chosen or not is_for_selected]
    if curves:
        found = [turning_points(curve) for curve in curves]
        turns = sum(len(each.inflections) for each in found)
        peaks = sum(len(each.extrema) for each in found)
        yield Caption(
            "Turning of curves",
            (
                Row("inflections (diamonds)", str(turns), "hover"),
                Row("extremal curvature (squares)", str(peaks), "v"),
            ),
        )


def _has_many(design: Design | None) -> bool:
    return design is not None and len(design) > MANY
