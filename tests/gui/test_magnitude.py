"""The bar of s."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication

from plusedit.commands.curves import SetMagnitude
from plusedit.commands.lines import SetCoordinate
from plusedit.commands.shapes import AppendLine
from plusedit.document.selection import Selection
from plusedit.geometry.magnitude import best_s, polygon_length
from tests.designs import BOW, WING, a_design
from tests.gui.finding import named, type_into

pytestmark = pytest.mark.gui


@pytest.fixture
def bar(window):
    window.files.show(a_design(), None)
    window.session.select(Selection.of_shapes([WING]))
    window.magnitude.refresh()
    return window.magnitude


def at(slider, ratio):
    return QPoint(round(slider._x(ratio)), 15)


def drag(qtbot, slider, start, *stops):
    qtbot.mousePress(slider, Qt.MouseButton.LeftButton, pos=at(slider, start))
    for stop in stops:
        qtbot.mouseMove(slider, at(slider, stop))


def release(qtbot, slider, end):
    qtbot.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=at(slider, end))


def s(window, shape_id=WING):
    return window.session.design.curve(shape_id).s


def length(window, shape_id=WING):
    return polygon_length(window.session.design.curve(shape_id))


def test_a_drag_is_live_and_one_undo_step(qtbot, window, bar):
    before = s(window)
    drag(qtbot, bar.slider, bar.slider.ratio, 0.6, 0.9, 1.2)
    assert s(window) == pytest.approx(1.2 * length(window), rel=0.01)
    assert window.session.is_previewing
    release(qtbot, bar.slider, 1.2)
    assert not window.session.is_previewing
    assert window.session.undo_label == "Set s"
    window.session.undo()
    assert s(window) == before
    assert window.session.undo_label is None


def test_escape_restores_the_very_same_design(qtbot, window, bar):
    before = window.session.design
    drag(qtbot, bar.slider, bar.slider.ratio, 1.0)
    qtbot.keyClick(bar.slider, Qt.Key.Key_Escape)
    assert window.session.design is before
    release(qtbot, bar.slider, 1.0)
    assert window.session.design is before


def test_several_shapes_take_the_same_share_of_their_lengths(qtbot, window, bar):
    window.session.select(Selection.of_shapes([WING, BOW]))
    bar.refresh()
    type_into(qtbot, named(bar, "s / L", type(bar.ratio_field)), "0.75")
    for shape_id in (WING, BOW):
        assert s(window, shape_id) == pytest.approx(0.75 * length(window, shape_id))


def test_nothing_selected_means_all_visible_curves(qtbot, window, bar):
    window.session.select(Selection())
    bar.refresh()
    assert set(bar.targets()) == {WING, BOW}
    type_into(qtbot, bar.s_field, "2")
    assert s(window, WING) == s(window, BOW) == 2.0


def test_l_is_remembered_until_the_slider_is_reset(qtbot, window, bar):
    before = bar.slider.ratio
    window.session.commit(SetCoordinate({WING: (3,)}, 0, 50.0))
    bar.refresh()
    assert bar.slider.ratio == before
    qtbot.mouseDClick(bar.slider, Qt.MouseButton.LeftButton, pos=at(bar.slider, 1.5))
    assert s(window) == pytest.approx(0.5 * length(window))
    bar.refresh()
    assert bar.slider.ratio == pytest.approx(0.5)


def test_the_mark_stands_where_the_curve_is_closest_to_its_points(window, bar):
    curve = window.session.design.curve(WING)
    assert bar.slider.best == pytest.approx(best_s(curve) / polygon_length(curve))


def test_a_drag_snaps_to_zero_and_to_the_best(qtbot, window, bar):
    best = bar.slider.best
    drag(qtbot, bar.slider, bar.slider.ratio, best + 0.002)
    assert s(window) == pytest.approx(best_s(window.session.committed.curve(WING)))
    release(qtbot, bar.slider, best)


def test_notches_of_the_wheel_make_one_step(qtbot, window, bar):
    before = s(window)
    for _ in range(3):
        turn(bar.slider, 120)
    qtbot.waitUntil(lambda: window.session.undo_label == "Set s")
    assert s(window) == pytest.approx(before + 0.03 * length(window))
    window.undo()
    assert s(window) == before


def test_undo_takes_back_a_wheel_that_has_hardly_stopped(window, bar):
    before = s(window)
    turn(bar.slider, 120)
    window.undo()
    assert s(window) == before
    assert window.session.redo_label == "Set s"


def test_keys_step_by_a_hundredth(qtbot, window, bar):
    before = s(window)
    qtbot.keyClick(bar.slider, Qt.Key.Key_Minus)
    bar.slider.finish()
    assert s(window) == pytest.approx(before - 0.01 * length(window))


def test_s_beyond_the_slider_stands_at_its_end_and_in_the_field(qtbot, window, bar):
    type_into(qtbot, bar.ratio_field, "-3")
    bar.refresh()
    assert s(window) == pytest.approx(-3.0 * length(window))
    assert bar.ratio_field.text() == "-3"
    assert bar.slider._x(bar.slider.ratio) == bar.slider._x(0.0)


def test_without_a_curve_the_bar_rests(window):
    window.magnitude.refresh()
    assert not window.magnitude.slider.isEnabled()
    assert not window.magnitude.s_field.isEnabled()


def test_a_locked_curve_keeps_its_s(window, bar):
    from plusedit.commands.shapes import SetLocked

    window.session.commit(SetLocked((WING,), True))
    window.session.select(Selection.of_shapes([WING]))
    bar.refresh()
    assert not bar.targets()
    assert not bar.slider.isEnabled()


def test_points_stay_where_they_are(qtbot, window, bar):
    before = window.session.design.curve(WING).lines.points
    drag(qtbot, bar.slider, bar.slider.ratio, 1.0)
    release(qtbot, bar.slider, 1.0)
    assert_array_equal(window.session.design.curve(WING).lines.points, before)


def turn(widget, angle):
    place = QPointF(widget.rect().center())
    QApplication.sendEvent(
        widget,
        QWheelEvent(
            place,
            place,
            QPoint(),
            QPoint(0, angle),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        ),
    )


def test_the_length_is_measured_anew_when_a_curve_is_drawn_on(window, bar):
    curve = window.session.design.curve(WING)
    window.session.commit(SetMagnitude({WING: polygon_length(curve) / 2.0}))
    bar.reset()
    window.session.commit(AppendLine(WING, True, curve.lines.points[-1] + 1.0))
    bar.refresh()
    assert bar.slider.ratio == pytest.approx(0.5)


def test_l_is_measured_again_when_a_control_line_is_added(window, bar):
    from plusedit.commands.shapes import AppendLine

    old = window.desk.lengths.of(WING, window.session.design.curve(WING))
    window.session.commit(AppendLine(WING, True, np.array([9.0, 0.0])))
    new = window.desk.lengths.of(WING, window.session.design.curve(WING))
    assert new == pytest.approx(old + 5.0)


def test_one_s_over_l_is_set_on_several_curves_in_one_step(qtbot, window, bar):
    window.session.select(Selection.of_shapes([WING, BOW]))
    bar.reset()
    bar.refresh()
    type_into(qtbot, bar.ratio_field, "3/4")
    for shape_id in (WING, BOW):
        assert s(window, shape_id) == pytest.approx(0.75 * length(window, shape_id))
    window.session.undo()
    assert s(window) == pytest.approx(0.5 * length(window))
