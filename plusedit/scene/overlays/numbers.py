"""Length, bending energy and inflections of the selected curves, or of all together.

The inflections are told with how many a curve of that degree can have. While an edit is going on
what takes longer is told again once it rests.
"""

from collections.abc import Iterator, Sequence

from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.curve_numbers import curve_numbers, known_numbers, together
from plusedit.scene.curve_words import energy_text, inflections_text, length_text
from plusedit.scene.items import Caption, Item, Row
from plusedit.scene.overlays import Seen, overlay

MANY = 100  # curves, of which none are told of together: each takes some milliseconds
FEW = 3  # curves that are told of one by one
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
    """A caption for each curve that is selected, for few at most; else one for all together."""
    curves = {i: curve for i, curve in design.curves() if design[i].visible}
    told = {i: curve for i, curve in curves.items() if i in chosen} or curves
    if len(told) <= (FEW if told is not curves else 1):
        for shape_id, curve in told.items():
            yield Caption(design[shape_id].name or shape_id, tuple(_rows([curve], seen)))
    elif len(told) > MANY:
        yield Caption(f"{len(told)} curves", (Row("select some to be told of them"),))
    else:
        yield Caption(f"{len(told)} curves together", tuple(_rows(list(told.values()), seen)))


def _rows(curves: Sequence[PlusCurve], seen: Seen) -> Iterator[Row]:
    known = [known_numbers(curve) if seen.is_hurried else curve_numbers(curve) for curve in curves]
    found = together([each for each in known if each is not None])
    is_later = None in known
    yield Row("length", LATER if is_later else length_text(found))
    yield Row("bending energy", LATER if is_later else energy_text(found))
    if any(curve.dimension == 2 for curve in curves):
        yield Row("inflections", LATER if is_later else inflections_text(found))
