"""Two shapes of the design against each other, by the nearest points of the one to the other.

The two that are selected; a single one, or none, is completed by the first that fit. Curves have
hairs from the one to the other; of surfaces and meshes the first is colored by its distance.
"""

from collections.abc import Iterator, Mapping

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.apart import Gap
from plusedit.geometry.arrays import Floats
from plusedit.scene.items import Caption, Item, Markers, Row, Segments
from plusedit.scene.overlays import Coloring, DrawnSurfaces, Seen, Setting, overlay
from plusedit.scene.shape_pairs import comparison, pair_of, values_at

TITLE = "Two shapes"
HAIR, LOUD, BACK = "hover@70", "hover", "v"

two_shapes = overlay(
    "two_shapes",
    title="Two shapes against each other",
    order=57,
    shortcut="Shift+Y",
    group="Comparison",
    coloring=Coloring("Distance", "units", least=1e-12),
    settings=(Setting("density", "Hairs", 120.0, 10.0, 2000.0),),
)


@two_shapes.of_designs
def against_each_other(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """Hairs, the farthest places, and the distances both ways in words."""
    pair = pair_of(design, chosen)
    if pair is None:
        if len(design):
            yield Caption(TITLE, (Row("select two curves, or two surfaces or meshes"),))
        return
    found = comparison(design, pair, wait=seen.waits)
    first, second = (design[shape_id].name for shape_id in pair)
    if found is None:
        yield Caption(f"{first} and {second}", (Row("being measured …"),))
        return
    if found.there.feet is not None and design[pair.first].curve is not None:
        count = len(found.there.points)
        shown = np.unique(np.linspace(0, count - 1, round(seen.settings["density"])).astype(int))
        yield Segments(found.there.points[shown], found.there.feet[shown], HAIR)
    for gap, color in ((found.back, BACK), (found.there, LOUD)):
        yield from _farthest(gap, color)
    yield Caption(
        f"{first} and {second}",
        (
            Row(f"largest, from {first}", f"{found.there.largest:.4g} units", LOUD),
            Row("rms", f"{found.there.rms:.4g} units"),
            Row(f"largest, from {second}", f"{found.back.largest:.4g} units", BACK),
            Row("rms", f"{found.back.rms:.4g} units"),
            Row("Hausdorff distance, about", f"{found.hausdorff:.4g} units"),
        ),
    )


@two_shapes.coloring_of_designs
def of_first(
    design: Design, chosen: frozenset[ShapeId], drawn: DrawnSurfaces, wait: bool
) -> Mapping[ShapeId, Floats]:
    """The distances of the first surface or mesh from the second, where that is known."""
    pair = pair_of(design, chosen)
    if pair is None or pair.first not in drawn:
        return {}
    found = comparison(design, pair, wait=wait)
    values = None if found is None else values_at(found, drawn[pair.first])
    return {} if values is None else {pair.first: values}


def _farthest(gap: Gap, color: str) -> Iterator[Item]:
    at = gap.points[gap.worst]
    if gap.largest == 0.0:
        return
    if gap.feet is not None:
        yield Segments(at[None], gap.feet[[gap.worst]], color, 2.0)
    yield Markers(at[None], "ring", 10.0, None, color)
