"""The menus: their groups, and what entries do besides their edit."""

from itertools import pairwise

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication

from plusedit.views.notices import EMPTY

pytestmark = pytest.mark.gui


def test_no_menu_begins_or_ends_with_a_line_or_has_two_in_a_row(window):
    for top in window.menuBar().actions():
        lines = [action.isSeparator() for action in top.menu().actions()]
        assert not lines[0] and not lines[-1], top.text()
        assert not any(a and b for a, b in pairwise(lines)), top.text()


def test_what_makes_surfaces_comes_first_in_their_menu(window):
    (menu,) = (a.menu() for a in window.menuBar().actions() if a.text() == "&Surface")
    assert [action.text() for action in menu.actions()[:2]] == ["New", "From curves"]


def test_a_new_surface_puts_the_pen_down(window):
    window.choose_tool("pen")
    window.actions_table["edit.new_sheet"].trigger()
    assert window.gestures.tool_name == "select"
    assert len(window.session.design) == 1


def test_the_pen_stays_in_hand_where_no_surface_was_made(window):
    window.choose_tool("pen")
    window.actions_table["edit.loft"].trigger()
    assert window.gestures.tool_name == "pen"


@pytest.mark.parametrize(
    ("key", "side"),
    [(Qt.Key.Key_7, "top"), (Qt.Key.Key_1, "front"), (Qt.Key.Key_3, "right")],
)
def test_the_number_pad_turns_the_view_where_the_desktop_takes_its_keys_for_digits(
    window, key, side
):
    window.view.set_projection("front" if side != "front" else "top")
    window.panes.focus()
    pad = Qt.KeyboardModifier.KeypadModifier
    for kind in (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress):
        event = QKeyEvent(kind, key, pad, chr(key))
        event.ignore()
        QApplication.sendEvent(window.canvas, event)
        assert event.isAccepted()
    assert window.view.projection == side


def test_ctrl_and_a_digit_of_the_number_pad_do_not_choose_panes(window):
    held = Qt.KeyboardModifier.KeypadModifier | Qt.KeyboardModifier.ControlModifier
    event = QKeyEvent(QEvent.Type.ShortcutOverride, Qt.Key.Key_1, held)
    event.ignore()
    QApplication.sendEvent(window.panes, event)
    assert event.isAccepted(), "else Qt would look for Ctrl+1"


def test_the_path_of_a_menu_is_not_broken_over_two_lines():
    assert "Surface\u00a0>\u00a0New" in EMPTY
