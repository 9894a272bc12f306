"""Which of the overlays that are on have anything to draw of a design."""

from collections.abc import Iterable

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.scene.overlays import Overlay, Taken
from plusedit.scene.shape_pairs import pair_of


def in_use(entries: Iterable[Overlay], design: Design, chosen: frozenset[ShapeId]) -> list[Overlay]:
    """Those that take a shape that is seen, or compare two of which some are selected."""
    entries = list(entries)
    if not entries:
        return []
    kinds = {_kind(shape) for shape in design.shapes.values() if shape.visible}

    def is_used(entry: Overlay) -> bool:
        if entry.compares:
            pair = pair_of(design, chosen)
            return pair is not None and design[pair.first].curve is not None
        return bool(kinds & entry.takes)

    return [entry for entry in entries if is_used(entry)]


def _kind(shape: Shape) -> Taken:
    if shape.curve is not None:
        return "curve"
    return "mesh" if shape.mesh is not None else "surface"
