"""The 2D view on a real display: what the person sees, taken from the screen itself."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest

from plusedit.document.session import Session
from plusedit.interaction.gesture import Gestures
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.options import ViewOptions
from plusedit.scene.theme import DARK, THEMES
from plusedit.views.canvas import PlaneCanvas
from tests.designs import BOW, a_design

pytestmark = pytest.mark.gl


@pytest.fixture
def canvas(qtbot):
    session = Session(a_design())
    made = PlaneCanvas(session, Gestures(session, PlaneCamera((1.0, 1.0))))
    made.set_options(ViewOptions(frozenset(), grid=False, rulers=False))
    made.resize(600, 400)
    qtbot.addWidget(made)
    with qtbot.waitExposed(made):
        made.show()
    return made


def seen(canvas):
    """(400, 600, 3) the colors on the screen, not those that the widget would paint."""
    image = canvas.screen().grabWindow(canvas.winId()).toImage()
    bits = np.frombuffer(image.constBits(), np.uint8)
    return bits.reshape(image.height(), image.width(), 4)[..., 2::-1].astype(int)


def has(pixels, color):
    wanted = QColor(color)
    rgb = [wanted.red(), wanted.green(), wanted.blue()]
    return bool((np.abs(pixels - rgb).max(axis=2) <= 6).any())


@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
def test_curves_and_control_lines_stand_on_the_screen(qtbot, canvas, theme):
    canvas.set_theme(theme)
    for role in ("canvas", "plus", "line"):
        qtbot.waitUntil(lambda role=role: has(seen(canvas), theme.color(role)))


def test_a_drag_is_seen_while_it_goes_on(qtbot, canvas):
    canvas.set_theme(DARK)
    x, y = canvas.camera.to_screen(a_design().curve(BOW).lines.points[1:2])[0]
    start = QPoint(round(x), round(y))
    qtbot.waitUntil(lambda: has(seen(canvas), DARK.color("plus")))
    before = seen(canvas)
    QTest.mouseMove(canvas, start)
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, start)
    QTest.mouseMove(canvas, start + QPoint(0, 40))
    QTest.mouseMove(canvas, start + QPoint(0, 60))
    qtbot.waitUntil(lambda: (seen(canvas) != before).any(axis=2).sum() > 500)
    QTest.keyClick(canvas, Qt.Key.Key_Escape)
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, start)
