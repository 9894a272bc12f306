"""The session: one design being worked on. The only mutable object below the views."""

from collections.abc import Callable
from typing import Protocol

from plusedit.document.constraining import OldNumbers, enforced
from plusedit.document.design import Design
from plusedit.document.history import History
from plusedit.document.selection import NOTHING_SELECTED, Selection
from plusedit.events import Event


class Edit(Protocol):
    """What a session takes in: a pure function from design to design, with a name."""

    def label_in(self, design: Design) -> str:
        """What the Undo menu says of the edit of that design, such as "Move control plane"."""
        ...

    def apply(self, design: Design) -> Design:
        """The edited design. EditError if it can't be done."""
        ...

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        """The old numbers of control lines and planes, where they got others."""
        ...

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        """What is selected once the edit is committed."""
        ...


class Session:
    """Takes edits in and tells whoever listens.

    `changed` is emitted with the old and the new design after every preview, commit, abort,
    undo, redo and open that leads to another design; `selected` with the old and new selection;
    `stepped` after whatever may have changed the names of undo and redo or the saved mark.
    """

    def __init__(self, design: Design | None = None) -> None:
        self.changed: Event[Design, Design] = Event()
        self.selected: Event[Selection, Selection] = Event()
        self.stepped: Event[()] = Event()
        self._history = History(design if design is not None else Design())
        self._preview: Design | None = None
        self._selection = NOTHING_SELECTED
        self._chosen = NOTHING_SELECTED

    @property
    def design(self) -> Design:
        """What is on screen: the preview while there is one, else the current step."""
        return self.committed if self._preview is None else self._preview

    @property
    def committed(self) -> Design:
        """The current step without any preview: what edits are applied to."""
        return self._history.design

    @property
    def selection(self) -> Selection:
        """What is selected; never more than the design has."""
        return self._selection

    @property
    def is_previewing(self) -> bool:
        """Whether a drag or a slider is under way."""
        return self._preview is not None

    @property
    def undo_label(self) -> str | None:
        """What undo would take back, or None."""
        return self._history.undo_label

    @property
    def redo_label(self) -> str | None:
        """What redo would do again, or None."""
        return self._history.redo_label

    @property
    def is_saved(self) -> bool:
        """Whether the current step is the one that was saved last."""
        return self._history.is_saved

    def preview(self, edit: Edit) -> None:
        """Show `edit` on top of the committed design, in place of any other preview.

        EditError if it can't be done; the preview before stays.
        """
        self._show(self._edited(edit))

    def commit(self, edit: Edit) -> None:
        """Make `edit` a step of the history, in place of any preview. EditError as above."""
        before = self.committed
        design = self._edited(edit)
        if design is not before:
            self._chosen = edit.reselect(self._chosen, before, design)
        self._settle(lambda: self._history.push(edit.label_in(before), design))

    def abort(self) -> None:
        """Drop the preview: the committed design, the very same object, is on screen again."""
        self._show(None)

    def undo(self) -> None:
        """Go one step back; any preview is dropped."""
        self._settle(self._history.undo)

    def redo(self) -> None:
        """Go one step on again; any preview is dropped."""
        self._settle(self._history.redo)

    def open(self, design: Design, *, saved: bool = True) -> None:
        """Start over with `design`; its history begins here, nothing is selected."""
        old, self._history, self._preview = self.design, History(design), None
        if not saved:
            self._history.mark_unsaved()
        self.select(NOTHING_SELECTED)
        if old is not design:
            self.changed.emit(old, design)
        self.stepped.emit()

    def mark_saved(self) -> None:
        """The current step is on disk."""
        self._history.mark_saved()
        self.stepped.emit()

    def select(self, selection: Selection) -> None:
        """Select what the design has of `selection`."""
        self._chosen = selection.cut_to(self.design)
        self._cut()

    def _edited(self, edit: Edit) -> Design:
        """The committed design edited, its shapes keeping their constraints."""
        before = self.committed
        design = edit.apply(before)
        if design is before:
            return before
        return enforced(before, design, lambda: edit.old_numbers(before, design))

    def _show(self, preview: Design | None) -> None:
        old, self._preview = self.design, preview
        self._tell(old)

    def _settle(self, step: Callable[[], object]) -> None:
        old, self._preview = self.design, None
        step()
        # For good: what undo brings back is not selected again.
        self._chosen = self._chosen.cut_to(self.design)
        self._tell(old)
        self.stepped.emit()

    def _tell(self, old: Design) -> None:
        self._cut()
        if old is not self.design:
            self.changed.emit(old, self.design)

    def _cut(self) -> None:
        """Show as selected what was chosen and is there; a preview may lack some of it."""
        old, self._selection = self._selection, self._chosen.cut_to(self.design)
        if self._selection != old:
            self.selected.emit(old, self._selection)
