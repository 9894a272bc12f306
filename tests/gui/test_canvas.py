"""The 2D view with real events: it draws, forwards and finds its way, and decides nothing."""

import gc
import weakref

import numpy as np
import pytest
from numpy.testing import assert_allclose
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QColor, QContextMenuEvent, QMouseEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.interaction.gesture import Gestures
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.handles import handles
from plusedit.scene.options import ViewOptions
from plusedit.scene.theme import DARK, LIGHT
from plusedit.views.canvas import PlaneCanvas
from plusedit.views.strata import Strata
from tests.designs import BOW, WING

pytestmark = pytest.mark.gui

LEFT, MIDDLE, RIGHT = (
    Qt.MouseButton.LeftButton,
    Qt.MouseButton.MiddleButton,
    Qt.MouseButton.RightButton,
)
MOVES = 200


@pytest.fixture
def canvas(qtbot, session):
    """The 2D view of the known design, 800 by 600 pixels, shown."""
    made = canvas_of(session)
    qtbot.addWidget(made)
    made.show()
    qtbot.waitExposed(made)
    made.set_camera(PlaneCamera((800.0, 600.0), (2.0, 1.0), 100.0))
    return made


def canvas_of(session):
    made = PlaneCanvas(session, Gestures(session, PlaneCamera((1.0, 1.0))))
    made.resize(800, 600)
    return made


def pixel(canvas, place):
    """Where a point of the world is on the screen."""
    x, y = canvas.camera.to_screen(np.array([place], dtype=float))[0]
    return QPoint(round(x), round(y))


def drag(canvas, start, end, count=10, button=LEFT, *, release=True):
    """Press, many moves along a curved way, and let go, unless that is left to the test."""
    QTest.mouseMove(canvas, start)
    QTest.mousePress(canvas, button, Qt.KeyboardModifier.NoModifier, start)
    for share in np.linspace(0.0, 1.0, count):
        bow = QPoint(0, round(40.0 * np.sin(np.pi * share)))
        move(canvas, start + (end - start) * float(share) + bow, button)
    if release:
        QTest.mouseRelease(canvas, button, Qt.KeyboardModifier.NoModifier, end)


def move(canvas, to, button):
    """QTest's own moves tell of no buttons that are down."""
    event = QMouseEvent(
        QEvent.Type.MouseMove,
        QPointF(to),
        canvas.mapToGlobal(QPointF(to)),
        Qt.MouseButton.NoButton,
        button,
        Qt.KeyboardModifier.NoModifier,
    )
    QApplication.sendEvent(canvas, event)


def wheel(canvas, at, notches, modifiers=Qt.KeyboardModifier.NoModifier, **touch):
    phase = touch.get("phase", Qt.ScrollPhase.NoScrollPhase)
    event = QWheelEvent(
        QPointF(at),
        canvas.mapToGlobal(QPointF(at)),
        touch.get("pixels", QPoint()),
        QPoint(0, round(120 * notches)),
        Qt.MouseButton.NoButton,
        modifiers,
        phase,
        False,
    )
    QApplication.sendEvent(canvas, event)


def color_at(canvas, place):
    return QColor(canvas.grab().toImage().pixel(pixel(canvas, place)))


# Edits


def test_a_drag_of_a_dot_with_200_moves_is_one_step_and_leaves_no_rounding(canvas, session):
    before = session.design
    start = pixel(canvas, (2.0, 3.0))
    drag(canvas, start, start + QPoint(100, 100), MOVES)
    assert session.undo_label == "Move control line"
    assert_allclose(session.design.curve(BOW).lines.points[1], (3.0, 2.0), atol=1e-9)
    session.undo()
    assert session.design is before
    assert session.undo_label is None


def test_a_drag_of_a_grip_with_200_moves_is_one_step(canvas, session):
    before = session.design
    curve = session.design.curve(WING)
    at = handles(curve, canvas.camera)
    start = QPointF(*at.tips[0, 1]).toPoint()
    end = QPointF(*at.points[1]).toPoint() + QPoint(0, -120)
    drag(canvas, start, end, MOVES)
    turned = session.design.curve(WING).directions[1]
    assert_allclose(turned, (0.0, np.hypot(0.6, 0.8)), atol=0.02)
    session.undo()
    assert session.design is before
    assert session.undo_label is None


@pytest.mark.parametrize("way", ["Escape", "right button"])
def test_a_drag_given_up_restores_the_very_same_design(canvas, session, way):
    before = session.design
    start = pixel(canvas, (2.0, 3.0))
    drag(canvas, start, start + QPoint(80, 10), MOVES, release=False)
    assert session.design is not before
    if way == "Escape":
        QTest.keyClick(canvas, Qt.Key.Key_Escape)
    else:
        QTest.mouseClick(canvas, RIGHT, Qt.KeyboardModifier.NoModifier, start)
    assert session.design is before
    QTest.mouseRelease(canvas, LEFT, Qt.KeyboardModifier.NoModifier, start)
    assert session.design is before
    assert session.undo_label is None


def test_a_drag_goes_on_beyond_the_edge_of_the_view(canvas, session):
    start = pixel(canvas, (2.0, 3.0))
    drag(canvas, start, QPoint(-300, 900))
    assert session.design.curve(BOW).lines.points[1][0] < -4.0


def test_a_number_typed_during_a_drag_is_taken_exactly(canvas, session):
    start = pixel(canvas, (2.0, 3.0))
    drag(canvas, start, start + QPoint(50, 0), release=False)
    QTest.keyClicks(canvas, "0.5")
    QTest.keyClick(canvas, Qt.Key.Key_Tab)
    QTest.keyClicks(canvas, "-1")
    QTest.keyClick(canvas, Qt.Key.Key_Return)
    QTest.mouseRelease(canvas, LEFT, Qt.KeyboardModifier.NoModifier, start)
    assert session.design.curve(BOW).lines.points[1].tolist() == [2.5, 2.0]


def test_a_click_selects(canvas, session):
    QTest.mouseClick(canvas, LEFT, Qt.KeyboardModifier.NoModifier, pixel(canvas, (2.0, 3.0)))
    assert session.selection.active == LineId(BOW, 1)


def test_a_double_click_on_a_grip_makes_the_direction_automatic(canvas, session):
    at = handles(session.design.curve(WING), canvas.camera)
    grip = QPointF(*at.tips[0, 1]).toPoint()
    QTest.mouseClick(canvas, LEFT, Qt.KeyboardModifier.NoModifier, grip)
    QTest.mouseDClick(canvas, LEFT, Qt.KeyboardModifier.NoModifier, grip)
    assert session.design.curve(WING).lines.automatic.all()


# Finding one's way


@pytest.mark.parametrize("notches", [1, -3, 0.25])
def test_the_wheel_zooms_and_keeps_the_point_under_the_pointer(canvas, notches):
    at = QPoint(123, 456)
    held = canvas.camera.in_plane(np.array([[123.0, 456.0]]))
    scale = canvas.camera.scale
    wheel(canvas, at, notches)
    assert (canvas.camera.scale > scale) == (notches > 0)
    assert_allclose(canvas.camera.to_screen(held)[0], (123.0, 456.0), atol=1e-6)


def test_two_fingers_pan_and_with_ctrl_they_zoom(canvas):
    before = canvas.camera
    touch = {"phase": Qt.ScrollPhase.ScrollUpdate, "pixels": QPoint(7, -9)}
    wheel(canvas, QPoint(100, 100), 0.5, **touch)
    assert canvas.camera == before.panned((7.0, -9.0))
    wheel(canvas, QPoint(100, 100), 0.5, Qt.KeyboardModifier.ControlModifier, **touch)
    assert canvas.camera.scale > before.scale


def test_the_middle_button_pans(canvas, session):
    before, design = canvas.camera, session.design
    drag(canvas, QPoint(400, 300), QPoint(450, 280), button=MIDDLE)
    move(canvas, QPoint(500, 500), Qt.MouseButton.NoButton)
    assert_allclose(canvas.camera.center, before.panned((50.0, -20.0)).center)
    assert session.design is design


def test_space_and_drag_pans_even_on_a_control_point(canvas, session):
    before, design = canvas.camera, session.design
    start = pixel(canvas, (2.0, 3.0))
    QTest.keyPress(canvas, Qt.Key.Key_Space)
    assert canvas.cursor().shape() == Qt.CursorShape.OpenHandCursor
    drag(canvas, start, start + QPoint(30, 40), release=False)
    assert canvas.cursor().shape() == Qt.CursorShape.ClosedHandCursor
    QTest.mouseRelease(canvas, LEFT, Qt.KeyboardModifier.NoModifier, start + QPoint(30, 40))
    QTest.keyRelease(canvas, Qt.Key.Key_Space)
    assert_allclose(canvas.camera.center, before.panned((30.0, 40.0)).center)
    assert session.design is design
    assert canvas.cursor().shape() != Qt.CursorShape.OpenHandCursor


def test_the_view_stands_still_during_a_drag(canvas):
    start = pixel(canvas, (2.0, 3.0))
    before = canvas.camera
    drag(canvas, start, start + QPoint(30, 40), release=False)
    wheel(canvas, start, 3)
    assert canvas.camera == before
    QTest.keyClick(canvas, Qt.Key.Key_Escape)


def test_a_view_that_is_not_yet_shown_frames_the_design_when_it_is(qtbot, session):
    canvas = canvas_of(session)
    qtbot.addWidget(canvas)
    canvas.frame_all()
    canvas.show()
    points = np.concatenate([curve.lines.points[:, :2] for _, curve in session.design.curves()])

    def is_all_seen():
        screen = canvas.camera.to_screen(points)
        return (screen > 22.0).all() and (screen < (800.0, 600.0)).all()

    qtbot.waitUntil(is_all_seen)


def test_framing_glides_to_where_the_selection_fills_the_view(qtbot, canvas, session):
    session.select(Selection.of_shapes([BOW]))
    with qtbot.waitSignal(canvas.camera_changed):
        canvas.frame_selected()
    points = session.design.curve(BOW).lines.points
    qtbot.waitUntil(lambda: np.ptp(canvas.camera.to_screen(points)[:, 0]) > 400.0)


def test_gestures_know_the_camera_and_the_grid(canvas):
    wheel(canvas, QPoint(100, 100), 5)
    assert canvas.gestures.camera == canvas.camera
    assert canvas.gestures.grid_step == canvas.grid_step


def test_another_projection_looks_along_another_axis(canvas):
    canvas.set_projection("front")
    assert canvas.camera.projection == "front"
    assert canvas.camera.center == (2.0, 0.0)
    assert canvas.camera.size == (800.0, 600.0)


# What is told


def test_the_pointer_is_told_in_coordinates_of_the_plane(qtbot, canvas):
    with qtbot.waitSignal(canvas.pointer_moved) as told:
        move(canvas, QPoint(400, 200), Qt.MouseButton.NoButton)
    assert_allclose(told.args, (2.0, 2.0))


def test_a_right_click_asks_for_the_menu_of_that_place(qtbot, canvas):
    with qtbot.waitSignal(canvas.context_menu_requested) as told:
        QTest.mouseClick(canvas, RIGHT, Qt.KeyboardModifier.NoModifier, QPoint(40, 50))
    assert told.args == [QPoint(40, 50)]


def test_the_menu_key_asks_for_the_menu_where_the_pointer_is(qtbot, canvas):
    move(canvas, QPoint(70, 80), Qt.MouseButton.NoButton)
    event = QContextMenuEvent(QContextMenuEvent.Reason.Keyboard, QPoint(), QPoint())
    with qtbot.waitSignal(canvas.context_menu_requested) as told:
        QApplication.sendEvent(canvas, event)
    assert told.args == [QPoint(70, 80)]


def test_a_closed_view_can_go_and_is_told_nothing_more(qtbot, session):
    canvas = canvas_of(session)
    canvas.show()
    qtbot.waitExposed(canvas)
    canvas.close()
    gone = weakref.ref(canvas)
    canvas.deleteLater()
    del canvas
    qtbot.waitUntil(lambda: gc.collect() is not None and gone() is None)
    session.select(Selection.of_shapes([BOW]))


# What is seen


def test_a_curve_is_seen_where_it_is_in_the_color_of_the_theme(canvas, session):
    canvas.set_options(ViewOptions(frozenset(), "none", grid=False))
    place = session.design.curve(WING).at([0.3])[0]
    for theme in (LIGHT, DARK):
        canvas.set_theme(theme)
        seen, wanted = color_at(canvas, place), QColor(theme.color("plus"))
        difference = [abs(seen.red() - wanted.red()), abs(seen.blue() - wanted.blue())]
        assert max(difference) < 110
        assert color_at(canvas, (2.0, -1.0)).name().upper() == theme.color("canvas")


def test_what_is_dragged_is_seen_as_if_all_were_drawn_anew(canvas, session):
    start = pixel(canvas, (2.0, 3.0))
    drag(canvas, start, start + QPoint(60, 30), release=False)
    kept = canvas.grab().toImage()
    canvas.set_theme(DARK)
    canvas.grab()
    canvas.set_theme(LIGHT)
    anew = canvas.grab().toImage()
    differs = np.frombuffer(kept.bits(), np.uint8) != np.frombuffer(anew.bits(), np.uint8)
    # The moving curve lies in front meanwhile: where curves cross a few pixels differ.
    assert differs.mean() < 1e-3
    QTest.keyClick(canvas, Qt.Key.Key_Escape)


def test_a_drag_draws_no_other_shape_again(canvas, session, monkeypatch):
    start = pixel(canvas, (2.0, 3.0))
    canvas.grab()
    drag(canvas, start, start + QPoint(20, 20), release=False)
    canvas.grab()
    drawn = []
    from plusedit.scene.scene import Layers
    from plusedit.views import strata

    def noting(design, camera, options, selection, *, only, glow, wait):
        drawn.extend(only)
        return Layers((), (), ())

    monkeypatch.setattr(strata, "scene_items", noting)
    move(canvas, start + QPoint(25, 25), LEFT)
    canvas.grab()
    assert set(drawn) == {BOW}
    QTest.keyClick(canvas, Qt.Key.Key_Escape)


def test_after_undo_the_view_is_what_it_was_before(qtbot, canvas, session):
    first = pixel(canvas, (2.0, 3.0))
    still = canvas.grab().toImage()
    drag(canvas, first, first + QPoint(50, 50))
    session.select(Selection())
    assert canvas.grab().toImage() != still
    session.undo()
    move(canvas, QPoint(1, 1), Qt.MouseButton.NoButton)
    canvas.leaveEvent(QEvent(QEvent.Type.Leave))
    qtbot.waitUntil(lambda: canvas.grab().toImage() == still)


def test_an_empty_view_says_what_to_do(qtbot):
    canvas = canvas_of(Session(Design()))
    qtbot.addWidget(canvas)
    canvas.set_options(ViewOptions(grid=False, rulers=False))
    image = canvas.grab().toImage().copy(200, 250, 400, 100)
    colors = {image.pixel(x, y) for x in range(400) for y in range(100)}
    assert len(colors) > 10


def test_the_view_has_a_name_for_who_can_not_see_it(canvas):
    assert canvas.accessibleName()


def test_while_a_slow_view_moves_its_last_picture_moves_along(qtbot, canvas, monkeypatch):
    monkeypatch.setattr("plusedit.views.strata.SLOW", 0.0)
    canvas.repaint()
    drawn = []
    monkeypatch.setattr(Strata, "_draw_still", lambda *arguments: drawn.append(arguments))
    before = canvas.grab().toImage()
    dot = canvas.camera.to_screen(np.array([[1.0, 2.0]]))[0]
    drawn.clear()
    canvas.pan(40.0, 20.0)
    after = canvas.grab().toImage()
    assert not drawn
    x, y = (round(value) for value in dot)
    assert after.pixelColor(x + 40, y + 20) == before.pixelColor(x, y)
    qtbot.waitUntil(lambda: bool(drawn))
