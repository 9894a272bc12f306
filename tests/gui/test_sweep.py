"""Playing s."""

import pytest
from PySide6.QtCore import QPoint, Qt

from plusedit.app.sweep import PERIOD
from plusedit.document.selection import Selection
from plusedit.geometry.magnitude import polygon_length
from tests.designs import BOW, WING, a_design

pytestmark = pytest.mark.gui


@pytest.fixture
def playing(window):
    """The window while the wing plays s."""
    window.files.show(a_design(), None)
    window.session.select(Selection.of_shapes([WING]))
    window.sweep.toggle()
    yield window
    window.sweep.stop()


def s(window, shape_id=WING):
    return window.session.design.curve(shape_id).s


def test_s_goes_from_zero_to_the_end_of_the_family_and_back(playing):
    length = polygon_length(a_design().curve(WING))
    for seconds, ratio in ((0.0, 0.0), (PERIOD / 2.0, 1.0), (PERIOD, 0.0)):
        playing.sweep.show_at(seconds)
        assert s(playing) == pytest.approx(ratio * length)
    assert s(playing, BOW) == a_design().curve(BOW).s


def test_the_end_of_the_family_is_that_of_the_overlay(playing):
    playing.sweep.stop()
    options = playing.panes.options.with_setting("s_family.reach", 2.0)
    playing.panes.set_options(options)
    playing.sweep.toggle()
    playing.sweep.show_at(PERIOD / 2.0)
    assert s(playing) == pytest.approx(2.0 * polygon_length(a_design().curve(WING)))


def test_neither_history_nor_file_take_notice(playing):
    committed = playing.session.committed
    playing.sweep.show_at(1.0)
    assert playing.session.undo_label is None
    assert playing.session.is_saved
    playing.sweep.stop()
    assert playing.session.design is committed


@pytest.mark.parametrize("key", [Qt.Key.Key_Escape, Qt.Key.Key_Delete, Qt.Key.Key_A])
def test_any_key_ends_it_and_does_nothing_else(qtbot, playing, key):
    committed, selection = playing.session.committed, playing.session.selection
    playing.sweep.show_at(1.0)
    qtbot.keyClick(playing.panes.plane, key)
    assert not playing.sweep.is_running
    assert playing.session.design is committed
    assert playing.session.selection == selection


def test_a_click_ends_it_and_does_nothing_else(qtbot, playing):
    committed, selection = playing.session.committed, playing.session.selection
    playing.sweep.show_at(1.0)
    qtbot.mouseClick(playing.panes.plane, Qt.MouseButton.LeftButton, pos=QPoint(40, 40))
    assert not playing.sweep.is_running
    assert playing.session.design is committed
    assert playing.session.selection == selection


def test_what_else_changes_the_design_ends_it(playing):
    playing.session.open(a_design())
    playing.sweep._step()
    assert not playing.sweep.is_running


def test_with_nothing_to_play_it_says_so(window):
    window.sweep.toggle()
    assert not window.sweep.is_running
    assert "no shape" in window.status.text.text()
