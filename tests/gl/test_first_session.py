"""What a new user does first, on a real display: draw, turn, set s, save, quit, open again."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

from plusedit.io.files import load
from plusedit.scene.handles import handles
from tests.gui.conftest import Answers
from tests.gui.finding import type_into

pytestmark = pytest.mark.gl

LEFT = Qt.MouseButton.LeftButton
LINES = 8


@pytest.fixture
def make_window(qtbot, qapp, tmp_path):
    """The main window as it starts; settings and autosaves are kept between windows."""
    from plusedit.app.settings import Settings
    from plusedit.app.window import MainWindow

    def make():
        window = MainWindow(Settings(tmp_path / "settings.ini"), tmp_path / "autosave")
        window.files.dialogs = Answers()
        qtbot.addWidget(window, before_close_func=lambda w: w.session.mark_saved())
        window.show()
        qtbot.waitExposed(window)
        # Without a window manager nobody else makes it the active one, and shortcuts need that.
        window.activateWindow()
        qtbot.waitUntil(window.isActiveWindow)
        return window

    yield make
    qapp.setStyleSheet("")


def click(canvas, x, y):
    QTest.mouseMove(canvas, QPoint(round(x), round(y)))
    QTest.mouseClick(canvas, LEFT, pos=QPoint(round(x), round(y)))


def drag(canvas, start, end, moves=30):
    start, end = np.array(start), np.array(end)
    QTest.mousePress(canvas, LEFT, pos=QPoint(*np.round(start).astype(int)))
    for share in np.linspace(0.0, 1.0, moves):
        QTest.mouseMove(canvas, QPoint(*np.round(start + share * (end - start)).astype(int)))
    QTest.mouseRelease(canvas, LEFT, pos=QPoint(*np.round(end).astype(int)))


def the_curve(window):
    ((shape_id, curve),) = window.session.design.curves()
    return shape_id, curve


def on_a_ring(canvas, number):
    angle = 2.0 * np.pi * number / LINES
    middle = np.array([canvas.width(), canvas.height()]) / 2.0
    return middle + 0.33 * canvas.height() * np.array([np.cos(angle), np.sin(angle)])


def test_a_first_session_ends_with_the_very_same_curve(qtbot, make_window, tmp_path):
    window = make_window()
    start = next(b for b in window.findChildren(QPushButton) if b.text() == "New curve")
    QTest.mouseClick(start, LEFT)
    canvas = window.canvas
    qtbot.waitUntil(canvas.isVisible)

    for number in range(LINES):
        click(canvas, *on_a_ring(canvas, number))
    click(canvas, *on_a_ring(canvas, 0))
    shape_id, curve = the_curve(window)
    assert curve.closed
    assert len(curve.lines) == LINES
    assert curve.basis.order == 4

    QTest.keyClick(canvas, Qt.Key.Key_Escape)
    QTest.keyClick(canvas, Qt.Key.Key_V)
    for number in (1, 4):
        before = the_curve(window)[1].directions[number]
        stand = handles(the_curve(window)[1], canvas.camera)
        grip = stand.tips[0][number]
        drag(canvas, grip, grip + np.array([-40.0, 30.0]))
        after = the_curve(window)[1].directions[number]
        assert np.linalg.norm(after) == pytest.approx(np.linalg.norm(before), rel=1e-12)
        assert abs(before @ after) < 0.999
        assert window.session.undo_label == "Rotate control line"

    type_into(qtbot, window.magnitude.ratio_field, "0.65")
    path = tmp_path / "ring.plus.json"
    window.files.dialogs.save = path
    QTest.keyClick(window, Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(path.exists)
    drawn = the_curve(window)[1]
    assert window.close()

    again = make_window()
    assert again.files.open(path)
    read = the_curve(again)[1]
    assert read.basis == drawn.basis
    assert read.s == drawn.s
    for name in ("points", "given", "automatic"):
        kept, was = getattr(read.lines, name), getattr(drawn.lines, name)
        assert kept.tobytes() == was.tobytes()
    assert load(path).design[shape_id].name == again.session.design[shape_id].name
