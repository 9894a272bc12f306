"""Qt's events as plain values."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent, QSinglePointEvent

from plusedit.interaction.tool import Held, Pointer

HELD = {
    Qt.KeyboardModifier.ShiftModifier: Held.SHIFT,
    Qt.KeyboardModifier.ControlModifier: Held.CTRL,
    Qt.KeyboardModifier.AltModifier: Held.ALT,
}

KEYS = {
    Qt.Key.Key_Tab: "Tab",
    Qt.Key.Key_Backspace: "Backspace",
    Qt.Key.Key_Return: "Enter",
    Qt.Key.Key_Enter: "Enter",
    Qt.Key.Key_Escape: "Escape",
    Qt.Key.Key_Comma: ".",  # on the number pad of half of the world
}

MODIFIERS = {
    Qt.Key.Key_Shift: Held.SHIFT,
    Qt.Key.Key_Control: Held.CTRL,
    Qt.Key.Key_Alt: Held.ALT,
}
"""By the keys themselves."""


def held_of(modifiers: Qt.KeyboardModifier) -> Held:
    """The modifier keys that a gesture knows."""
    held = Held.NONE
    for key, flag in HELD.items():
        if modifiers & key:
            held |= flag
    return held


def held_after(event: QKeyEvent, *, pressed: bool) -> Held:
    """What is held once that key is down, or up; some platforms tell what was held before."""
    held, own = held_of(event.modifiers()), MODIFIERS.get(Qt.Key(event.key()), Held.NONE)
    return held | own if pressed else held & ~own


def pointer_of(event: QSinglePointEvent) -> Pointer:
    """Where a mouse event happened, in logical pixels of the widget, and what was held."""
    at = event.position()
    return Pointer(at.x(), at.y(), held_of(event.modifiers()))


def key_of(event: QKeyEvent) -> str | None:
    """The key by the name that gestures know it by: "Enter", "X", "7"; None if it has none."""
    named = KEYS.get(Qt.Key(event.key()))
    if named is not None:
        return named
    # Qt numbers the keys of the alphabet, digits and signs as ASCII does.
    return chr(event.key()) if 32 < event.key() < 127 else None
