"""Length, bending energy and inflections of the selected curves, or of the first ones.

The inflections are told with how many a curve of that degree can have. While an edit is going on
what takes longer is told again once it rests.
"""

from collections.abc import Iterator
from math import isfinite

from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.curve_numbers import CurveNumbers, curve_numbers, known_numbers
from plusedit.scene.items import Caption, Item, Row
from plusedit.scene.overlays import Seen, overlay

FEW = 4  # curves that are told of
DIGITS = 6
LATER = "…"

numbers = overlay(
    "numbers",
    title="Length, bending energy, inflections",
    order=114,
    shortcut="N",
    group="Curve analysis",
)


@numbers.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """A caption for each curve that is selected, or for all while none is; for few at most."""
    curves = [(i, curve) for i, curve in design.curves() if design[i].visible]
    told = [pair for pair in curves if pair[0] in chosen] or curves
    for shape_id, curve in told[:FEW]:
        known = known_numbers(curve) if seen.is_hurried else curve_numbers(curve)
        yield Caption(design[shape_id].name or shape_id, tuple(rows_of(curve, known)))


def rows_of(curve: PlusCurve, known: CurveNumbers | None) -> Iterator[Row]:
    """What the caption says."""
    yield Row("length", LATER if known is None else f"{known.length:.{DIGITS}g} units")
    yield Row("bending energy", LATER if known is None else energy_text(known.energy))
    if curve.dimension == 2:
        yield Row("inflections", LATER if known is None else inflections_text(known))


def energy_text(energy: float) -> str:
    """Such as "6.28319 / unit"."""
    return f"{energy:.{DIGITS}g} / unit" if isfinite(energy) else "∞ (cusp)"


def inflections_text(known: CurveNumbers) -> str:
    """Such as "2 of at most 4"; empty of curves in space."""
    if known.inflections is None:
        return ""
    return str(known.inflections) + ("" if known.most is None else f" of at most {known.most}")
