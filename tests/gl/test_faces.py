"""Faces of meshes in the 3D view, on a real display with real events."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.interaction.gesture import Gestures
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.plane_handles import handles_of_plane
from plusedit.scene.space_camera import SpaceCamera
from plusedit.views.opengl import opengl_problem
from tests.gl.test_space_canvas import CTRL, LEFT, NONE, SHIFT, at, drag, move, ring_of, seen
from tests.scene.meshes import HILL, a_hill, a_landscape

pytestmark = pytest.mark.gl

FACE = 7 * 15 + 7
CAMERA = SpaceCamera((800.0, 600.0), (0.5, 0.5, 0.2), 1.3, pitch=1.2)


@pytest.fixture
def session():
    surface = a_hill(15)
    drawing_of(surface)
    return Session(a_landscape(surface))


@pytest.fixture
def canvas(qtbot, session):
    """A 3D view of a hill of 225 faces."""
    assert opengl_problem() == ""
    from plusedit.views.space_canvas import SpaceCanvas

    canvas = SpaceCanvas(session, Gestures(session, CAMERA))
    canvas.is_animated = False
    canvas.resize(800, 600)
    qtbot.addWidget(canvas)
    with qtbot.waitExposed(canvas):
        canvas.show()
    canvas.set_camera(CAMERA)
    return canvas


def hill(session):
    return session.design.mesh(HILL)


def on_face(canvas, session, number):
    """The pixel of a place on a face, beside its middle."""
    center = hill(session).planes.centers[number] + 0.02
    return at(canvas, hill(session).at([center])[0])


def test_a_face_is_clicked_added_to_and_left_again(canvas, session):
    QTest.mouseClick(canvas, LEFT, NONE, on_face(canvas, session, FACE))
    assert session.selection == Selection.of_shapes([HILL])
    QTest.mouseClick(canvas, LEFT, NONE, on_face(canvas, session, FACE))
    assert session.selection.active == LineId(HILL, FACE)
    for number, held in ((40, SHIFT), (200, CTRL)):
        QTest.mouseClick(canvas, LEFT, held, on_face(canvas, session, number))
    assert session.selection.by_shape() == {HILL: (40, FACE, 200)}
    canvas.setFocus()
    QTest.keyClick(canvas, Qt.Key.Key_Escape)
    assert session.selection == Selection.of_shapes([HILL])


def test_a_face_is_dragged_by_its_dot_its_grip_and_a_ring(canvas, session):
    session.select(Selection.of_lines([LineId(HILL, FACE)]))
    before = session.design
    start = at(canvas, hill(session).planes.points[FACE])
    drag(canvas, start, start + QPoint(20, -10))
    assert session.undo_label == "Move control plane"
    handles, row = handles_of_plane(hill(session), FACE, canvas.camera)
    start = QPointF(*handles.tips[0, row]).toPoint()
    drag(canvas, start, start + QPoint(12, 12))
    assert session.undo_label == "Rotate control plane"
    assert list(hill(session).edited) == [FACE]
    old = hill(session).vectors[:, FACE]
    ring = ring_of(canvas, session, 2)
    drag(canvas, ring[10], ring[18])
    new = hill(session).vectors[:, FACE]
    assert_allclose(new @ new.T, old @ old.T, rtol=1e-9)
    while session.undo_label:
        session.undo()
    assert session.design is before


def test_escape_gives_a_drag_of_a_face_up(canvas, session):
    session.select(Selection.of_lines([LineId(HILL, FACE)]))
    before = session.design
    start = at(canvas, hill(session).planes.points[FACE])
    drag(canvas, start, start + QPoint(20, -10), release=False)
    assert session.is_previewing
    QTest.keyClick(canvas, Qt.Key.Key_Escape)
    QTest.mouseRelease(canvas, LEFT, NONE, start)
    assert session.design is before
    assert session.undo_label is None


def test_a_selected_face_and_the_one_pointed_at_are_seen(canvas, session, qtbot):
    session.select(Selection.of_shapes([HILL]))
    canvas.repaint()
    place = on_face(canvas, session, 40)
    plain = seen(canvas)
    move(canvas, place)
    canvas.repaint()
    hovered = seen(canvas)
    assert np.abs(hovered - plain).sum(axis=2).max() > 100
    QTest.mouseClick(canvas, LEFT, NONE, place)
    move(canvas, QPoint(5, 5))
    canvas.repaint()
    chosen = seen(canvas)
    box = (slice(place.y() - 6, place.y() + 6), slice(place.x() - 6, place.x() + 6))
    assert np.abs(chosen - plain)[box].sum(axis=2).max() > 100
