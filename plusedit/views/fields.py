"""Fields in which values are typed: what can't be taken says why and goes back to what it was."""

from collections.abc import Callable
from typing import Generic, TypeVar

from PySide6.QtCore import QEvent, QPoint, QSignalBlocker, Qt
from PySide6.QtGui import QFocusEvent, QKeyEvent, QKeySequence, QWheelEvent
from PySide6.QtWidgets import QComboBox, QLineEdit, QToolTip, QWidget

from plusedit.views.arithmetic import calculated, true_minus, written
from plusedit.views.look import tabular

T = TypeVar("T")

MIXED = "mixed"  # shown where the selected things differ
STEPPING = (QKeySequence.StandardKey.Undo, QKeySequence.StandardKey.Redo)
STEPS = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1}


class Field(QLineEdit, Generic[T]):
    """A line of text that stands for a value.

    `read` makes a value of what was typed, or raises ValueError with the reason; `apply` does
    the edit and answers with the reason why not, or with nothing.
    """

    def __init__(
        self,
        name: str,
        read: Callable[[str], T],
        write: Callable[[T], str],
        apply: Callable[[T], str],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self._read, self._write, self._apply = read, write, apply
        self._shown = ""
        self.value: T | None = None
        self.is_done = False
        """whether Enter took what was typed, and nothing has been typed since"""
        self.returnPressed.connect(self._enter)
        self.textEdited.connect(lambda _: self._begin())

    def show_value(self, value: T | None, *, mixed: str = MIXED) -> None:
        """Show `value`, or the placeholder `mixed` for None; what is being typed stays."""
        self.value = value
        shown = "" if value is None else self._write(value)
        self.setPlaceholderText(mixed if value is None else "")
        is_typing = self.hasFocus() and self.isModified()
        if shown == self._shown and (is_typing or self.text() == self._dressed()):
            return
        self._shown = shown
        if not is_typing:
            self._revert()

    def event(self, event: QEvent) -> bool:
        # With nothing being typed, undo and redo mean the design.
        if (
            isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.ShortcutOverride
            and not self.isModified()
            and any(event.matches(keys) for keys in STEPPING)
        ):
            event.ignore()
            return False
        return super().event(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        self._begin()
        self._dress()
        super().focusInEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        if event.reason() != Qt.FocusReason.PopupFocusReason:
            self._finish()
            self._dress()
        super().focusOutEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self.isModified():
            self._revert()
            self.selectAll()
            return
        super().keyPressEvent(event)

    def _begin(self) -> None:
        self.is_done = False

    def _enter(self) -> None:
        self._finish()
        self.is_done = True

    def _finish(self) -> None:
        """Take what was typed, if anything was."""
        if not self.isModified():
            return
        # Unmodified from here on: a message box that takes the focus must not come back here.
        self.setModified(False)
        try:
            value = self._read(self.text())
        except ValueError as error:
            self.refuse(str(error))
            return
        if reason := self._apply(value):
            self.refuse(reason)
            return
        if self.hasFocus():
            self.selectAll()

    def refuse(self, reason: str) -> None:
        """Say why what was typed can't be taken, and go back to what was shown."""
        self._revert()
        if self.hasFocus():
            self.selectAll()
        QToolTip.showText(self.mapToGlobal(QPoint(0, self.height())), reason, self)

    def _dressed(self) -> str:
        """What is shown, as it is to look now."""
        return self._shown

    def _dress(self) -> None:
        if not self.isModified() and self.text() != self._dressed():
            self._revert()

    def _revert(self) -> None:
        # What is selected as a whole stays so: the next number typed replaces this one.
        is_chosen = self.hasSelectedText() and self.selectedText() == self.text()
        with QSignalBlocker(self):
            self.setText(self._dressed())
            self.setCursorPosition(0)
            if is_chosen:
                self.selectAll()
        self.setModified(False)


class TextField(Field[str]):
    """A line of text."""

    def __init__(self, name: str, apply: Callable[[str], str]) -> None:
        super().__init__(name, lambda text: text, lambda text: text, apply)


class NumberField(Field[float]):
    """A number, or a sum that comes to one. Up, Down and the wheel change it by `step`."""

    def __init__(
        self,
        name: str,
        apply: Callable[[float], str],
        *,
        step: float = 1.0,
        digits: int = 6,
        whole: bool = False,
    ) -> None:
        self._whole = whole
        super().__init__(name, self._number, lambda value: written(value, digits), apply)
        self.step = step
        self.setFont(tabular(self.font()))
        self.setToolTip("A number or a sum such as 2*3+1; ↑ ↓ and the wheel change it")

    def keyPressEvent(self, event: QKeyEvent) -> None:
        direction = STEPS.get(Qt.Key(event.key()))
        if direction is not None:
            self._change_by(direction * self.step * _pace(event.modifiers()))
            return
        super().keyPressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        # A field that does not have the focus lets the pane scroll.
        if not self.hasFocus() or not event.angleDelta().y():
            event.ignore()
            return
        direction = 1 if event.angleDelta().y() > 0 else -1
        self._change_by(direction * self.step * _pace(event.modifiers()))
        event.accept()

    def _dressed(self) -> str:
        # What is copied or edited has the sign that programs read.
        return self._shown if self.hasFocus() else true_minus(self._shown)

    def _number(self, text: str) -> float:
        value = calculated(text)
        if self._whole and value != round(value):
            raise ValueError("a whole number is needed")
        return value

    def _change_by(self, amount: float) -> None:
        self._finish()
        if self.value is None:
            return
        if self._whole:
            amount = max(1, round(abs(amount))) * (1 if amount > 0 else -1)
        if reason := self._apply(self.value + amount):
            self.refuse(reason)
        elif self.hasFocus():
            self.selectAll()


def _pace(held: Qt.KeyboardModifier) -> float:
    if held & Qt.KeyboardModifier.ShiftModifier:
        return 10.0
    return 0.1 if held & Qt.KeyboardModifier.ControlModifier else 1.0


class Choice(QComboBox):
    """One of a few names; `apply` answers with the reason why not, or with nothing."""

    def __init__(self, name: str, options: dict[str, str], apply: Callable[[str], str]) -> None:
        super().__init__()
        self.setAccessibleName(name)
        self._apply = apply
        for key, title in options.items():
            self.addItem(title, key)
        self.setPlaceholderText(MIXED)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.activated.connect(self._chosen)

    def show_value(self, key: str | None) -> None:
        """Show the option of that key; None: mixed."""
        self._key = key
        with QSignalBlocker(self):
            self.setCurrentIndex(-1 if key is None else self.findData(key))

    def wheelEvent(self, event: QWheelEvent) -> None:
        # A wheel that was meant to scroll the pane must not change the design.
        event.ignore()

    def _chosen(self, index: int) -> None:
        if reason := self._apply(str(self.itemData(index))):
            QToolTip.showText(self.mapToGlobal(QPoint(0, self.height())), reason, self)
            self.show_value(self._key)
