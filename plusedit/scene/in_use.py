"""Which of the overlays that are on have anything to draw of a design."""

from collections.abc import Iterable

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.scene.overlays import Overlay, Taken


def in_use(entries: Iterable[Overlay], design: Design) -> list[Overlay]:
    """Those that take a shape that is seen."""
    entries = list(entries)
    if not entries:
        return []
    shown = [shape for shape in design.shapes.values() if shape.visible]
    kinds = {_kind(shape) for shape in shown}

    def is_used(entry: Overlay) -> bool:
        # What takes no shape by itself takes a pair.
        if not entry.takes:
            return len(shown) > 1
        return bool(kinds & entry.takes)

    return [entry for entry in entries if is_used(entry)]


def _kind(shape: Shape) -> Taken:
    if shape.curve is not None:
        return "curve"
    return "mesh" if shape.mesh is not None else "surface"
