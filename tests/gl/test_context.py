"""What the views may rely on where there is a display: OpenGL 3.3 core, and windows that show."""

import subprocess
import sys

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QColor, QGuiApplication, QOffscreenSurface, QOpenGLContext, QSurfaceFormat
from PySide6.QtOpenGL import QOpenGLFramebufferObject
from PySide6.QtWidgets import QWidget

pytestmark = pytest.mark.gl

COLOR_BUFFER = 0x4000  # GL_COLOR_BUFFER_BIT


@pytest.fixture
def context(qapp):
    """A current context of OpenGL 3.3 core."""
    wanted = QSurfaceFormat()
    wanted.setVersion(3, 3)
    wanted.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    surface = QOffscreenSurface()
    surface.setFormat(wanted)
    surface.create()
    made = QOpenGLContext()
    made.setFormat(wanted)
    assert made.create()
    assert made.makeCurrent(surface)
    yield made
    made.doneCurrent()


def test_the_display_is_a_real_one(qapp):
    assert QGuiApplication.platformName() in ("xcb", "wayland", "cocoa", "windows")


def test_opengl_is_at_least_3_3_core(context):
    got = context.format()
    assert got.version() >= (3, 3)
    assert got.profile() == QSurfaceFormat.OpenGLContextProfile.CoreProfile


def test_what_is_drawn_can_be_read_back(context):
    buffer = QOpenGLFramebufferObject(QSize(8, 8))
    buffer.bind()
    functions = context.functions()
    functions.glClearColor(0.0, 0.4, 1.0, 1.0)
    functions.glClear(COLOR_BUFFER)
    assert buffer.toImage().pixelColor(4, 4) == QColor(0, 102, 255)
    buffer.release()


def test_a_window_is_seen(qtbot):
    window = QWidget()
    window.setStyleSheet("background: #0066ff")
    window.resize(200, 100)
    qtbot.addWidget(window)
    with qtbot.waitExposed(window):
        window.show()
    assert window.grab().toImage().pixelColor(100, 50) == QColor("#0066ff")


def test_the_doctor_finds_all_well():
    command = [sys.executable, "-m", "plusedit", "doctor"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "OpenGL" in done.stdout
