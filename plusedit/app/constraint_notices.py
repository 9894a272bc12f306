"""What is told and shown of constraints once they are set, and once an edit can't keep them."""

from collections.abc import Iterator

from plusedit.app.view_state import ViewState
from plusedit.document.constraining import problems_of
from plusedit.document.design import Design, changed
from plusedit.views.desk import Desk

BADGES = "constraints"  # the overlay that shows them


class ConstraintNotices:
    """Says in the status bar why shapes no longer keep something; shows badges of the first."""

    def __init__(self, desk: Desk, view: ViewState) -> None:
        self._desk, self._view = desk, view
        self._settled = desk.session.design
        desk.session.changed.listen(self._look)

    def _look(self, old: Design, new: Design) -> None:
        if self._desk.session.is_previewing:
            self._tell(old, new)
            return
        # A step is told of once more: what its drag said may be gone by then.
        old, self._settled = self._settled, new
        self._tell(old, new)
        # Badges that a person switched off stay off, and so do those of a design just opened.
        is_step = self._desk.session.undo_label is not None
        is_first = _is_constrained(new) and not _is_constrained(old)
        if is_step and is_first and BADGES not in self._view.options.overlays:
            self._view.toggle_overlay(BADGES)

    def _tell(self, old: Design, new: Design) -> None:
        gained = dict.fromkeys(_gained(old, new))
        if gained:
            self._desk.say(" ".join(gained))


def _gained(old: Design, new: Design) -> Iterator[str]:
    """Why shapes can't keep what they could keep, or did not have to, before."""
    for shape_id in changed(old, new):
        shape, before = new.shapes.get(shape_id), old.shapes.get(shape_id)
        if shape is None or not shape.constraints:
            continue
        known = set(problems_of(before).values()) if before is not None else set()
        for words in problems_of(shape).values():
            if words not in known:
                yield f"{shape.name}: {words}"


def _is_constrained(design: Design) -> bool:
    return any(shape.constraints for shape in design.shapes.values())
