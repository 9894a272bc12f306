"""Where keys go: a field that was typed into keeps them, whatever changes around it."""

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QEnterEvent, QKeyEvent
from PySide6.QtWidgets import QApplication, QLineEdit

from plusedit.document.selection import LineId
from tests.designs import WING, a_design
from tests.gui.conftest import select_lines
from tests.gui.finding import named, type_into

pytestmark = pytest.mark.gui


@pytest.fixture
def filled(window):
    window.files.show(a_design(), None)
    select_lines(window, WING, 1)
    window.docks.widget("inspector").refresh()
    return window


def test_a_field_keeps_the_focus_after_its_number_was_taken(qtbot, filled):
    field = named(filled.docks.widget("inspector"), "x", QLineEdit)
    type_into(qtbot, field, "3.5")
    assert filled.session.undo_label is not None
    assert filled.focusWidget() is field


def test_tab_goes_to_the_next_field_after_a_number_was_taken(qtbot, filled):
    inspector = filled.docks.widget("inspector")
    field, following = named(inspector, "x", QLineEdit), named(inspector, "y", QLineEdit)
    type_into(qtbot, field, "3.5")
    qtbot.keyClick(field, Qt.Key.Key_Tab)
    assert filled.focusWidget() is following
    assert filled.session.selection.lines == {LineId(WING, 1)}


def test_the_slider_keeps_the_focus_while_keys_move_it(qtbot, filled):
    slider = filled.magnitude.slider
    slider.setFocus()
    qtbot.keyClick(slider, Qt.Key.Key_Right)
    slider.finish()
    assert filled.focusWidget() is slider


def overrides(field, key):
    """Whether the field keeps Ctrl and that key from the shortcuts of the window."""
    event = QKeyEvent(QEvent.Type.ShortcutOverride, key, Qt.KeyboardModifier.ControlModifier)
    event.ignore()
    QApplication.sendEvent(field, event)
    return event.isAccepted()


def test_undo_in_a_field_means_the_design_unless_something_is_being_typed(qtbot, filled):
    field = named(filled.docks.widget("inspector"), "x", QLineEdit)
    type_into(qtbot, field, "3.5")
    assert not overrides(field, Qt.Key.Key_Z)
    assert not overrides(field, Qt.Key.Key_Y)
    qtbot.keyClicks(field, "7")
    assert overrides(field, Qt.Key.Key_Z)
    assert overrides(field, Qt.Key.Key_A)


def test_the_next_number_replaces_the_one_just_taken(qtbot, filled):
    inspector = filled.docks.widget("inspector")
    field = named(inspector, "x", QLineEdit)
    type_into(qtbot, field, "3.50")
    inspector.refresh()
    qtbot.keyClicks(field, "8")
    assert field.text() == "8"


def enter(window):
    at = QPointF(20.0, 20.0)
    QApplication.sendEvent(window.canvas, QEnterEvent(at, at, at))


def test_the_pointer_takes_the_keys_from_a_field_once_its_number_was_taken(qtbot, filled):
    filled.activateWindow()
    qtbot.waitUntil(filled.isActiveWindow)
    field = named(filled.docks.widget("inspector"), "x", QLineEdit)
    field.setFocus()
    enter(filled)
    assert filled.focusWidget() is field, "about to be typed into"
    type_into(qtbot, field, "3.5")
    enter(filled)
    assert filled.focusWidget() is filled.canvas
