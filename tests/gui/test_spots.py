"""What overlays show under the pointer is drawn in front, and the layers below stay as they are."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from plusedit.document.selection import Selection
from plusedit.scene.items import Polyline
from plusedit.scene.options import ViewOptions
from plusedit.scene.theme import LIGHT
from plusedit.views import strata
from tests.designs import BOW
from tests.gui.test_canvas import LEFT, canvas, canvas_of, drag, move, pixel  # noqa: F401

pytestmark = pytest.mark.gui


@pytest.fixture
def view(canvas):  # noqa: F811
    canvas.set_options(ViewOptions(overlays=frozenset({"circle"})))
    canvas.grab()
    return canvas


def on_the_bow(view, u):
    point = view._session.design.curve(BOW).at([u])[0]
    x, y = view.camera.to_screen(point[None])[0]
    return QPoint(round(x), round(y))


def circles(view):
    return [item for item in view._spotted() if isinstance(item, Polyline)]


def test_it_follows_the_pointer_without_drawing_the_shapes_again(view, monkeypatch):
    move(view, on_the_bow(view, 0.3), Qt.MouseButton.NoButton)
    (first,) = circles(view)
    view.grab()
    with monkeypatch.context() as watched:
        watched.setattr(strata, "scene_items", None)
        move(view, on_the_bow(view, 0.6), Qt.MouseButton.NoButton)
        picture = view.grab().toImage()
    (second,) = circles(view)
    assert not np.array_equal(first.points, second.points)
    amber = LIGHT.color("hover").lower()
    colors = {
        picture.pixelColor(x, y).name()
        for x in range(0, picture.width(), 1)
        for y in range(0, picture.height(), 3)
    }
    assert amber in colors


def test_it_is_worked_out_once_for_each_place(view):
    move(view, on_the_bow(view, 0.3), Qt.MouseButton.NoButton)
    assert view._spotted() is view._spotted()


def test_it_goes_with_the_pointer(view):
    move(view, on_the_bow(view, 0.3), Qt.MouseButton.NoButton)
    assert circles(view)
    QApplication.sendEvent(view, QEvent(QEvent.Type.Leave))
    assert not view._spotted()


def test_it_is_live_during_drags(view):
    start = on_the_bow(view, 0.0)
    move(view, start, Qt.MouseButton.NoButton)
    (before,) = circles(view)
    drag(view, start, start + QPoint(40, 30), release=False)
    assert view._session.is_previewing
    (after,) = circles(view)
    assert not np.array_equal(before.points, after.points)
    QTest.keyClick(view, Qt.Key.Key_Escape)
    QTest.mouseRelease(view, LEFT, pos=start)


def test_far_from_all_shapes_it_shows_the_selected_curve(view, session):
    corner = QPoint(view.width() - 3, view.height() - 3)
    move(view, corner, Qt.MouseButton.NoButton)
    assert not view._spotted()
    session.select(Selection(frozenset(), frozenset([BOW])))
    assert view._spotted()
