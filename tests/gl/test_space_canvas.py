"""The 3D view on a real display with real events: it draws, forwards and finds its way."""

import gc
import weakref

import numpy as np
import pytest
from numpy.testing import assert_allclose
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QColor, QMouseEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMainWindow

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.interaction.gesture import Gestures
from plusedit.interaction.picking import under
from plusedit.scene.captions import boxes_of
from plusedit.scene.gizmo import gizmo_of
from plusedit.scene.options import ViewOptions
from plusedit.scene.plane_handles import plane_handles
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import space_items
from plusedit.scene.theme import DARK, LIGHT
from plusedit.views.opengl import opengl_problem
from plusedit.views.settings_strip import SettingsStrip
from tests.geometry.surfaces import a_surface

pytestmark = pytest.mark.gl

SAIL = ShapeId("sail")
SIZE = (800.0, 600.0)
CAMERA = SpaceCamera(SIZE, (1.5, 2.0, 0.0), 5.0)
LEFT, MIDDLE, RIGHT = (
    Qt.MouseButton.LeftButton,
    Qt.MouseButton.MiddleButton,
    Qt.MouseButton.RightButton,
)
NONE, SHIFT, CTRL, ALT = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
)


@pytest.fixture
def session():
    return Session(Design({SAIL: Shape(a_surface(4, 4), "Sail")}))


@pytest.fixture
def make_canvas(qtbot):
    """Makes 3D views of sessions, 800 by 600 pixels, shown, in perspective."""

    def make(session):
        assert opengl_problem() == ""
        from plusedit.views.space_canvas import SpaceCanvas

        canvas = SpaceCanvas(session, Gestures(session, SpaceCamera((1.0, 1.0))))
        canvas.is_animated = False
        canvas.resize(*map(int, SIZE))
        qtbot.addWidget(canvas)
        with qtbot.waitExposed(canvas):
            canvas.show()
        canvas.set_camera(CAMERA)
        return canvas

    return make


@pytest.fixture
def canvas(make_canvas, session):
    return make_canvas(session)


def at(canvas, point):
    """The pixel of a point of the world."""
    return QPointF(*canvas.camera.to_screen(np.array([point], dtype=float))[0]).toPoint()


def move(canvas, to, button=Qt.MouseButton.NoButton, held=NONE):
    place = QPointF(to)
    event = QMouseEvent(
        QEvent.Type.MouseMove,
        place,
        canvas.mapToGlobal(place),
        Qt.MouseButton.NoButton,
        button,
        held,
    )
    QApplication.sendEvent(canvas, event)


def drag(canvas, start, end, button=LEFT, held=NONE, count=20, *, release=True):
    move(canvas, start, held=held)
    QTest.mousePress(canvas, button, held, start)
    for share in np.linspace(0.0, 1.0, count):
        move(canvas, start + (end - start) * float(share), button, held)
    if release:
        QTest.mouseRelease(canvas, button, held, end)


def wheel(canvas, place, notches, held=NONE):
    event = QWheelEvent(
        QPointF(place),
        canvas.mapToGlobal(QPointF(place)),
        QPoint(),
        QPoint(0, round(120 * notches)),
        Qt.MouseButton.NoButton,
        held,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(canvas, event)


def seen(canvas):
    """(600, 800, 3) the colors on the screen."""
    image = canvas.screen().grabWindow(canvas.winId()).toImage()
    bits = np.frombuffer(image.constBits(), np.uint8)
    return bits.reshape(image.height(), image.width(), 4)[..., 2::-1].astype(int)


def planes(session):
    return session.design.surface(SAIL).planes


def select_plane(session, number):
    session.select(Selection.of_lines([LineId(SAIL, number)]))


def ring_of(canvas, session, axis):
    """The pixels of a ring of the gizmo."""
    gizmo = gizmo_of(session.design, session.selection, canvas.camera)
    return [QPointF(*pixel).toPoint() for pixel in canvas.camera.to_screen(gizmo.ring(axis))]


def is_ring(canvas, place, axis):
    """Whether a press there would take that ring, and no handle that lies in front."""
    hit = under(np.array([place.x(), place.y()]), canvas.gestures.stage())
    return hit is not None and (hit.kind, hit.axis) == ("ring", axis)


# Edits


def test_a_click_picks_a_control_plane_of_a_surface_in_perspective(canvas, session):
    for number in (0, 5, 10, 15):
        point = planes(session).control_points[number]
        QTest.mouseClick(canvas, LEFT, NONE, at(canvas, point))
        assert session.selection.active == LineId(SAIL, number)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_ring_turns_a_control_plane_as_a_rigid_whole(canvas, session, axis):
    select_plane(session, 5)
    before = session.design
    ring = ring_of(canvas, session, axis)
    free = [k for k, place in enumerate(ring) if is_ring(canvas, place, axis)]
    start, end = ring[free[len(free) // 2]], ring[free[len(free) // 2] - 8]
    old = session.design.surface(SAIL).vectors[:, 5]
    drag(canvas, start, end)
    new = session.design.surface(SAIL).vectors[:, 5]
    assert_allclose(new @ new.T, old @ old.T, atol=1e-12)
    assert np.abs(new - old).max() > 0.05
    session.undo()
    assert session.design is before
    assert session.undo_label is None


def test_a_grip_turns_one_direction_alone(canvas, session):
    handles = plane_handles(session.design.surface(SAIL), canvas.camera)
    old = session.design.surface(SAIL).vectors[:, 6].copy()
    start = QPointF(*handles.tips[0, 6]).toPoint()
    drag(canvas, start, start + QPoint(30, -30))
    new = session.design.surface(SAIL).vectors[:, 6]
    assert_allclose(np.linalg.norm(new[0]), np.linalg.norm(old[0]), rtol=1e-12)
    assert np.abs(new[0] - old[0]).max() > 0.05
    assert_allclose(new[1], old[1])


def test_a_drag_with_z_pressed_moves_along_z_alone(canvas, session):
    before, old = session.design, planes(session).control_points[5].copy()
    start = at(canvas, old)
    drag(canvas, start, start + QPoint(40, -60), release=False)
    QTest.keyClick(canvas, Qt.Key.Key_Z)
    move(canvas, start + QPoint(45, -80), LEFT)
    QTest.mouseRelease(canvas, LEFT, NONE, start + QPoint(45, -80))
    new = planes(session).control_points[5]
    assert_allclose(new[:2], old[:2])
    assert new[2] > old[2] + 0.2
    session.undo()
    assert session.design is before


@pytest.mark.parametrize("way", ["Escape", "right button"])
def test_a_drag_given_up_restores_the_very_same_design(canvas, session, way):
    before = session.design
    start = at(canvas, planes(session).control_points[9])
    drag(canvas, start, start + QPoint(80, 10), release=False)
    assert session.design is not before
    if way == "Escape":
        QTest.keyClick(canvas, Qt.Key.Key_Escape)
    else:
        QTest.mouseClick(canvas, RIGHT, NONE, start)
    assert session.design is before
    QTest.mouseRelease(canvas, LEFT, NONE, start)
    assert session.undo_label is None


def test_a_plane_that_is_seen_edge_on_does_not_jump(canvas, session):
    canvas.look_from("front")
    select_plane(session, 5)
    for axis in range(3):
        before = session.design.surface(SAIL).vectors[:, 5].copy()
        ring = ring_of(canvas, session, axis)
        start = next(place for place in ring if is_ring(canvas, place, axis))
        drag(canvas, start, start + QPoint(3, 3), count=4)
        after = session.design.surface(SAIL).vectors[:, 5]
        assert np.abs(after - before).max() < 0.3
        session.undo()


def test_a_box_on_empty_ground_selects_what_lies_in_it(canvas, session):
    drag(canvas, QPoint(3, 597), QPoint(790, 60))
    assert len(session.selection.lines) >= 12


# Finding one's way


def test_the_middle_button_turns_and_the_target_stays(canvas, session):
    design = session.design
    drag(canvas, QPoint(400, 300), QPoint(500, 340), MIDDLE)
    assert canvas.camera.target == CAMERA.target
    assert canvas.camera.yaw < CAMERA.yaw
    assert canvas.camera.pitch > CAMERA.pitch
    move(canvas, QPoint(10, 10))
    assert canvas.gestures.camera == canvas.camera
    assert session.design is design


def test_shift_and_middle_button_pan_what_was_taken_hold_of(canvas, session):
    u, v = 0.4, 0.6
    point = session.design.surface(SAIL).at([u], [v])[0, 0]
    start = at(canvas, point)
    drag(canvas, start, start + QPoint(60, -35), MIDDLE, SHIFT)
    off = at(canvas, point) - start
    assert_allclose((off.x(), off.y()), (60, -35), atol=2)


def test_ctrl_and_middle_button_zoom(canvas):
    drag(canvas, QPoint(400, 300), QPoint(400, 200), MIDDLE, CTRL)
    assert canvas.camera.height < CAMERA.height
    assert canvas.camera.yaw == CAMERA.yaw


@pytest.mark.parametrize("notches", [1, -2, 0.25])
def test_the_wheel_keeps_the_point_of_the_surface_under_the_pointer(canvas, session, notches):
    point = session.design.surface(SAIL).at([0.3], [0.5])[0, 0]
    place = at(canvas, point)
    wheel(canvas, place, notches)
    assert (canvas.camera.height < CAMERA.height) == (notches > 0)
    off = at(canvas, point) - place
    assert off.manhattanLength() <= 3


def test_alt_drag_on_empty_ground_and_on_a_surface_turns_the_view(canvas, session):
    design = session.design
    on_surface = at(canvas, session.design.surface(SAIL).at([0.45], [0.45])[0, 0])
    for start in (QPoint(20, 580), on_surface):
        before = canvas.camera
        drag(canvas, start, start + QPoint(60, 0), LEFT, ALT)
        assert canvas.camera.yaw != before.yaw
        canvas.set_camera(CAMERA)
    assert session.design is design


def test_space_and_drag_pans(canvas, session):
    design = session.design
    QTest.keyPress(canvas, Qt.Key.Key_Space)
    drag(canvas, QPoint(400, 300), QPoint(430, 340))
    QTest.keyRelease(canvas, Qt.Key.Key_Space)
    assert canvas.camera.target != CAMERA.target
    assert canvas.camera.yaw == CAMERA.yaw
    assert session.design is design


def test_a_click_on_the_axes_looks_along_them(canvas):
    from plusedit.views.gl.tripod import ARM, tripod_camera

    for name, way in (("top", (0, 0, 1)), ("left", (-1, 0, 0))):
        canvas.set_camera(CAMERA)
        small = tripod_camera(canvas.camera)
        place = QPointF(*small.to_screen(ARM * np.array([way], dtype=float))[0]).toPoint()
        QTest.mouseClick(canvas, LEFT, NONE, place)
        wanted = CAMERA.looking(name)
        assert (canvas.camera.yaw, canvas.camera.pitch) == (wanted.yaw, wanted.pitch)


def test_a_view_along_an_axis_goes_back_to_perspective_when_it_is_turned(canvas):
    canvas.look_from("right")
    assert not canvas.camera.perspective
    drag(canvas, QPoint(400, 300), QPoint(430, 310), MIDDLE)
    assert canvas.camera.perspective
    canvas.toggle_perspective()
    drag(canvas, QPoint(400, 300), QPoint(430, 310), MIDDLE)
    assert not canvas.camera.perspective


def test_the_view_stands_still_during_a_drag(canvas, session):
    start = at(canvas, planes(session).control_points[5])
    drag(canvas, start, start + QPoint(30, 40), release=False)
    wheel(canvas, start, 3)
    assert canvas.camera == CAMERA
    QTest.keyClick(canvas, Qt.Key.Key_Escape)


def test_a_view_glides_unless_that_is_switched_off(qtbot, canvas):
    canvas.is_animated = True
    canvas.look_from("top")
    assert canvas.camera.pitch != pytest.approx(np.pi / 2.0)
    qtbot.waitUntil(lambda: canvas.camera.pitch == pytest.approx(np.pi / 2.0))


def test_framing_sees_all_control_points(canvas, session):
    canvas.set_camera(SpaceCamera(SIZE, (100.0, 0.0, 0.0), 0.01))
    canvas.frame_all()
    screen = canvas.camera.to_screen(planes(session).control_points)
    assert (screen > 0.0).all()
    assert (screen < SIZE).all()


# What is told and seen


def test_the_pointer_is_told_where_it_is_on_the_surface(qtbot, canvas, session):
    point = session.design.surface(SAIL).at([0.3], [0.5])[0, 0]
    with qtbot.waitSignal(canvas.pointer_moved) as told:
        move(canvas, at(canvas, point))
    assert_allclose(told.args, point, atol=0.03)


def test_a_right_click_asks_for_the_menu_of_that_place(qtbot, canvas):
    with qtbot.waitSignal(canvas.context_menu_requested) as told:
        QTest.mouseClick(canvas, RIGHT, NONE, QPoint(40, 50))
    assert told.args == [QPoint(40, 50)]


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
def test_the_surface_stands_on_the_screen(qtbot, canvas, session, theme):
    canvas.set_options(ViewOptions(frozenset(), "none", ground=False, isolines=False))
    canvas.set_theme(theme)
    place = at(canvas, session.design.surface(SAIL).at([0.5], [0.5])[0, 0])
    ground = QColor(theme.color("canvas"))

    def stands_out():
        pixels = seen(canvas)
        off = np.abs(pixels[place.y(), place.x()] - pixels[590, 10]).max()
        corner = pixels[590, 10]
        return off > 30 and abs(corner - [ground.red(), ground.green(), ground.blue()]).max() <= 3

    qtbot.waitUntil(stands_out)


def test_hovering_does_not_draw_the_design_again(qtbot, canvas, session, monkeypatch):
    QTest.qWait(200)
    drawn = []
    draw = canvas.draw
    monkeypatch.setattr(canvas, "draw", lambda: (drawn.append(1), draw()))
    pixels = seen(canvas)
    move(canvas, at(canvas, planes(session).control_points[5]))
    qtbot.waitUntil(lambda: (seen(canvas) != pixels).any())
    assert not drawn


def test_an_empty_view_says_what_to_do(qtbot, make_canvas):
    canvas = make_canvas(Session(Design()))
    canvas.set_options(ViewOptions(ground=False))
    qtbot.waitUntil(lambda: len(np.unique(seen(canvas)[280:320, 200:600].reshape(-1, 3))) > 10)


# Windows come and go


def test_it_is_resized_hidden_and_shown_again(qtbot, canvas):
    for size in ((300, 200), (160, 120), (900, 500)):
        canvas.resize(*size)
        qtbot.waitUntil(lambda size=size: canvas.camera.size == size)
    canvas.hide()
    with qtbot.waitExposed(canvas):
        canvas.show()
    qtbot.waitUntil(lambda: len(np.unique(seen(canvas))) > 20)


def test_it_moves_to_another_window(qtbot, canvas):
    window = QMainWindow()
    qtbot.addWidget(window)
    window.resize(700, 500)
    window.setCentralWidget(canvas)
    with qtbot.waitExposed(window):
        window.show()
    qtbot.waitUntil(lambda: len(np.unique(seen(canvas))) > 20)
    window.takeCentralWidget().setParent(None)


def test_two_views_show_the_same_session(qtbot, make_canvas, session):
    first, second = make_canvas(session), make_canvas(session)
    before = seen(second)
    start = at(first, planes(session).control_points[5])
    drag(first, start, start + QPoint(0, -80))
    qtbot.waitUntil(lambda: (seen(second) != before).any())


def test_a_closed_view_can_go_and_is_told_nothing_more(qtbot, session):
    from plusedit.views.space_canvas import SpaceCanvas

    canvas = SpaceCanvas(session, Gestures(session, SpaceCamera((1.0, 1.0))))
    canvas.show()
    qtbot.waitExposed(canvas)
    canvas.close()
    gone = weakref.ref(canvas)
    canvas.deleteLater()
    del canvas
    qtbot.waitUntil(lambda: gc.collect() is not None and gone() is None)
    select_plane(session, 3)


@pytest.mark.parametrize("height", [600, 380, 330, 280])
def test_numbers_of_overlays_leave_a_legend_its_place_in_a_low_view(qtbot, canvas, session, height):
    canvas.resize(500, height)
    canvas.set_options(ViewOptions(frozenset({"draft", "comb"})))
    strip = canvas.findChild(SettingsStrip)
    size = (500.0, float(height))

    def lies_beside():
        words = space_items(session.design, canvas.camera, canvas.options).words()
        boxes = [QRectF(*box) for box in boxes_of(words, size)]
        assert boxes
        assert not any(box.intersects(QRectF(strip.geometry())) for box in boxes)

    qtbot.waitUntil(lies_beside)
    assert strip.isVisible()
    assert not strip.geometry().intersects(QRect(canvas.width() - 104, 0, 104, 104))
