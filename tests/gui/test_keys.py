"""Single keys act in the whole window, but not where they are typed or mean something else."""

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractItemView, QApplication, QLineEdit

from tests.designs import WING, a_design
from tests.gui.conftest import select_lines
from tests.gui.finding import named

pytestmark = pytest.mark.gui

SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def filled(qtbot, window):
    window.files.show(a_design(), None)
    select_lines(window, WING, 1)
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    for panel in ("outliner", "lines_table", "inspector"):
        window.docks.widget(panel).refresh()
    return window


def shape_list(window):
    return window.docks.widget("outliner").list


def table(window):
    return window.docks.widget("lines_table").table


def slider(window):
    return window.magnitude.slider


OUTSIDE_THE_VIEWS = pytest.mark.parametrize("place", [shape_list, table, slider])


OVERLAYS = [
    (Qt.Key.Key_K, SHIFT, "comb"),
    (Qt.Key.Key_X, SHIFT, "extrema"),
    (Qt.Key.Key_O, Qt.KeyboardModifier.NoModifier, "circle"),
    (Qt.Key.Key_J, Qt.KeyboardModifier.NoModifier, "continuity"),
    (Qt.Key.Key_N, Qt.KeyboardModifier.NoModifier, "numbers"),
]


@OUTSIDE_THE_VIEWS
def test_letters_switch_overlays_wherever_the_focus_is(qtbot, filled, place):
    widget = place(filled)
    widget.setFocus()
    for key, held, overlay in OVERLAYS:
        was_on = overlay in filled.view.options.overlays
        qtbot.keyClick(widget, key, held)
        assert (overlay in filled.view.options.overlays) is not was_on
        assert filled.focusWidget() is widget


@OUTSIDE_THE_VIEWS
def test_g_lets_the_keys_that_follow_go_to_the_drag(qtbot, filled, place):
    widget = place(filled)
    widget.setFocus()
    qtbot.keyClick(widget, Qt.Key.Key_G)
    assert filled.gestures.is_busy
    assert filled.focusWidget() is filled.canvas


def test_f2_renames_the_shape_that_is_current_in_the_list(qtbot, filled):
    shapes = shape_list(filled)
    shapes.setFocus()
    shapes.setCurrentIndex(shapes.model().index(0, 0))
    qtbot.keyClick(shapes, Qt.Key.Key_F2)
    assert shapes.state() == QAbstractItemView.State.EditingState
    assert "gaussian" not in filled.view.options.overlays


@pytest.mark.parametrize("sign", ["-", "+", "5", "."])
def test_a_number_is_typed_over_a_cell_of_the_table(qtbot, filled, sign):
    lines, before = table(filled), filled.session.design
    lines.setFocus()
    lines.setCurrentIndex(lines.model().index(0, 1))
    qtbot.keyClick(lines, sign)
    editor = lines.findChild(QLineEdit)
    assert editor is not None
    assert editor.text() == sign
    assert filled.session.design is before


def test_plus_and_minus_move_the_slider_that_has_the_focus(qtbot, filled):
    slider(filled).setFocus()
    before = slider(filled).ratio
    qtbot.keyClick(slider(filled), Qt.Key.Key_Minus)
    slider(filled).finish()
    assert slider(filled).ratio < before


def test_a_letter_that_is_typed_switches_nothing(qtbot, filled):
    name = named(filled.docks.widget("inspector"), "name", QLineEdit)
    name.setFocus()
    name.selectAll()
    before = filled.view.options.overlays
    qtbot.keyClick(name, Qt.Key.Key_K, SHIFT)
    qtbot.keyClick(name, Qt.Key.Key_J)
    assert name.text().lower() == "kj"
    assert filled.view.options.overlays == before


def test_letters_do_nothing_on_the_start_page(qtbot, filled):
    filled.show_start_page()
    filled.start_page.setFocus()
    before = filled.view.options.overlays
    qtbot.keyClick(filled.start_page, Qt.Key.Key_K, SHIFT)
    qtbot.keyClick(filled.start_page, Qt.Key.Key_R, SHIFT)
    assert filled.view.options.overlays == before
    assert filled.session.undo_label is None


def test_the_number_pad_turns_the_view_while_the_list_has_the_focus(filled):
    filled.view.set_projection("front")
    shapes = shape_list(filled)
    shapes.setFocus()
    for kind in (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress):
        event = QKeyEvent(kind, Qt.Key.Key_7, Qt.KeyboardModifier.KeypadModifier, "7")
        event.ignore()
        QApplication.sendEvent(shapes, event)
        assert event.isAccepted()
    assert filled.view.projection == "top"
