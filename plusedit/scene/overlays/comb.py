"""Curvature combs of curves, and of lines of constant u and of constant v on surfaces.

Of a surface those at the nodes of the selected control planes, or else five each way. A caption
says which curvature a tooth of length one stands for.
"""

from collections.abc import Iterator

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.combs import Measure, comb_items
from plusedit.scene.extents import USUAL, extent_of
from plusedit.scene.iso_lines import iso_lines
from plusedit.scene.items import Caption, Item, Row
from plusedit.scene.overlays import Seen, Setting, overlay

FEWER = 0.3  # of the teeth of a curve, for each of many lines on a surface

comb = overlay(
    "comb",
    title="Curvature comb",
    order=110,
    shortcut="Shift+K",
    group="Curve analysis",
    settings=(
        Setting("scale", "Comb scale", 1.0, 0.001, 1000.0),
        Setting("density", "Comb density", 1.0, 0.1, 10.0),
    ),
)


@comb.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """Teeth, the line along their tips, and what the longest stands for."""
    yield from comb_items(curve, _measure(seen), seen.camera)


@comb.of_surfaces
def of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """The lines, and the comb of each."""
    measure = _measure(seen, FEWER)
    for line in iso_lines(surface, seen.lines):
        yield line.drawn(seen.camera)
        yield from comb_items(line.curve, measure, seen.camera)


@comb.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """How long the teeth are."""
    if any(shape.visible and shape.plus is not None for shape in design.shapes.values()):
        factor = _measure(seen).factor
        value = Row("a tooth 1 unit long", f"κ {1.0 / factor:.3g} / unit", "v")
        yield Caption("Curvature comb", (value,))


def _measure(seen: Seen, share: float = 1.0) -> Measure:
    extent = USUAL if seen.design is None else extent_of(seen.design)
    return Measure.of(seen.settings["scale"], share * seen.settings["density"], extent)
