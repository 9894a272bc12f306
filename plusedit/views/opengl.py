"""OpenGL as this program needs it: a core profile of version 3.3, tried once."""

import os
from contextlib import suppress
from functools import lru_cache
from importlib import import_module

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QGuiApplication, QOffscreenSurface, QOpenGLContext, QSurfaceFormat

VERSION = (3, 3)
SOFTWARE = ("llvmpipe", "softpipe", "swrast", "software", "gdi generic")


def surface_format(*, samples: int = 0) -> QSurfaceFormat:
    """What contexts are asked for: a core profile, with a depth buffer."""
    wanted = QSurfaceFormat()
    wanted.setRenderableType(QSurfaceFormat.RenderableType.OpenGL)
    wanted.setVersion(*VERSION)
    wanted.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    wanted.setDepthBufferSize(24)
    wanted.setAlphaBufferSize(8)
    wanted.setSamples(samples)
    return wanted


def prepare_opengl() -> None:
    """To be called before the application is made: views may share what they have uploaded."""
    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_ShareOpenGLContexts)


@lru_cache(maxsize=1)
def opengl_problem() -> str:
    """Why the 3D view can't be shown, in a sentence; empty where it can."""
    if QGuiApplication.platformName() == "offscreen":
        return "There is no display here, and so no OpenGL."
    # pyqtgraph is to be imported next, maybe while a thread imports numba. Both import parts of
    # colorama; where neither has begun with its whole, one of them fails.
    with suppress(ImportError):
        import_module("colorama")
    if QGuiApplication.platformName().startswith("wayland"):
        # Read by PyOpenGL at its first import: it would look for the X11 library else.
        os.environ.setdefault("PYOPENGL_PLATFORM", "egl")
    context = QOpenGLContext()
    context.setFormat(surface_format())
    if not context.create():
        return "OpenGL is missing here; plusedit doctor says what to install."
    surface = QOffscreenSurface()
    surface.setFormat(context.format())
    surface.create()
    if not context.makeCurrent(surface):
        return "OpenGL was found, but nothing can be drawn with it."
    found = context.format().version()
    context.doneCurrent()
    if found < VERSION:
        has, needs = (".".join(map(str, version)) for version in (found, VERSION))
        return f"The 3D view needs OpenGL {needs}, and this machine has {has}."
    return ""


@lru_cache(maxsize=1)
def is_software() -> bool:
    """Whether OpenGL is drawn by the processor: then every sample of a pixel costs its time."""
    if opengl_problem():
        return True
    context, surface = QOpenGLContext(), QOffscreenSurface()
    context.setFormat(surface_format())
    context.create()
    surface.setFormat(context.format())
    surface.create()
    context.makeCurrent(surface)
    name = renderer_name(context).lower()
    context.doneCurrent()
    return any(word in name for word in SOFTWARE)


def renderer_name(context: QOpenGLContext) -> str:
    """What a context that is current says it draws with."""
    renderer = 0x1F01  # GL_RENDERER
    name: object = context.functions().glGetString(renderer)
    return name.decode(errors="replace") if isinstance(name, bytes) else str(name or "")
