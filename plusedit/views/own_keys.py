"""Keys that a widget keeps for itself while it has the focus, whatever they are shortcuts of."""

from collections.abc import Collection

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QWidget

ALONE = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.KeypadModifier,
)
OF_NUMBERS = frozenset(Qt.Key(ord(sign)) for sign in "0123456789+-.(")
"""keys that a number begins with, which is typed over another"""


class OwnKeys(QObject):
    """Lets those keys, alone or with Shift, come to `widget` as keys."""

    def __init__(self, widget: QWidget, keys: Collection[int]) -> None:
        super().__init__(widget)
        self._keys = frozenset(keys)
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        is_asking = event.type() == QEvent.Type.ShortcutOverride
        if not is_asking or not isinstance(event, QKeyEvent):
            return False
        if event.key() in self._keys and event.modifiers() in ALONE:
            event.accept()
            return True
        return False
