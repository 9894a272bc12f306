"""Contexts of OpenGL: the one that Qt has made current, and one for pictures."""

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtGui import QGuiApplication, QOffscreenSurface, QOpenGLContext

from plusedit.views.gl.egl import context_without_display
from plusedit.views.gl.functions import Functions, OpenGLError
from plusedit.views.opengl import VERSION, surface_format

SCREENLESS = ("offscreen", "minimal", "vnc", "linuxfb")  # Qt's platforms without OpenGL


def current_functions() -> Functions:
    """The functions of the context of Qt's that is current. OpenGLError if it won't do."""
    context = QOpenGLContext.currentContext()
    if context is None:
        raise OpenGLError("no context of OpenGL is current")
    version = context.format().version()
    if context.isOpenGLES() or tuple(version) < VERSION:
        major, minor = version
        kind = "OpenGL ES" if context.isOpenGLES() else "OpenGL"
        raise OpenGLError(f"OpenGL 3.3 is needed, there is {kind} {major}.{minor}")
    return Functions(lambda name: int(context.getProcAddress(name) or 0))


@contextmanager
def context_for_pictures() -> Iterator[Functions]:
    """OpenGL to draw pictures with, current for as long as the block lasts; then what was before.

    Beside windows it is one of their platform; without an application, or where its platform
    shows nothing, one that needs no display. OpenGLError where there is none.
    """
    running = QGuiApplication.instance() is not None
    if running and QGuiApplication.platformName() not in SCREENLESS:
        with _beside_windows() as gl:
            yield gl
    else:
        with context_without_display() as gl:
            yield gl


@contextmanager
def _beside_windows() -> Iterator[Functions]:
    """A context of the application's platform, without a window."""
    before = QOpenGLContext.currentContext()
    drawn_on = None if before is None else before.surface()
    context, surface = QOpenGLContext(), QOffscreenSurface()
    context.setFormat(surface_format())
    if not context.create():
        raise OpenGLError("OpenGL is missing here")
    surface.setFormat(context.format())
    surface.create()
    if not context.makeCurrent(surface):
        raise OpenGLError("OpenGL was found, but nothing can be drawn with it")
    try:
        yield current_functions()
    finally:
        context.doneCurrent()
        if before is not None and drawn_on is not None:
            before.makeCurrent(drawn_on)
