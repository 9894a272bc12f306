"""Finding widgets as a person does: by what they are called."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget


def named(root, name, kind=QWidget):
    """The widget of that kind below `root` that is called so."""
    found = [w for w in root.findChildren(kind) if w.accessibleName() == name]
    assert len(found) == 1, f"{len(found)} widgets are called {name!r}"
    return found[0]


def type_into(qtbot, field, text):
    """Click into a field, replace what is there, press Enter."""
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, text)
    qtbot.keyClick(field, Qt.Key.Key_Return)
