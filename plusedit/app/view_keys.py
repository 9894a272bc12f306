"""Keys that come to the window since no widget in it took them, and need more than a shortcut."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QWidget

from plusedit.app.actions import COMMANDING, is_sign

ASKS, PRESSES = QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress


class ViewKeys(QObject):
    """Sets off what the number pad stands for; keeps letters from a view that is not seen."""

    def __init__(self, window: QWidget, view: QWidget) -> None:
        super().__init__(window)
        self._window, self._view = window, view
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() not in (ASKS, PRESSES) or not isinstance(event, QKeyEvent):
            return False
        # On X11 Qt takes "Num+7" for "7" when it looks for shortcuts, and Ctrl with a digit of the
        # pad would show other panes.
        action = self._of_number_pad(event)
        if action is not None and event.type() == PRESSES:
            action.trigger()
        is_blind = event.type() == ASKS and not self._view.isVisible() and _is_plain(event)
        if action is not None or is_blind:
            event.accept()
            return True
        return False

    def _of_number_pad(self, event: QKeyEvent) -> QAction | None:
        """What a key of the number pad stands for, if for anything."""
        if not event.modifiers() & Qt.KeyboardModifier.KeypadModifier:
            return None
        keys = QKeySequence(event.keyCombination())
        actions = (*self._view.actions(), *self._window.actions())
        return next((a for a in actions if a.isEnabled() and keys in a.shortcuts()), None)


def _is_plain(event: QKeyEvent) -> bool:
    return is_sign(event.key()) and not event.modifiers() & COMMANDING
