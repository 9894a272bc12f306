"""Contexts of OpenGL made by Qt."""

from PySide6.QtGui import QOpenGLContext, QSurfaceFormat

from plusedit.views.gl.functions import Functions, OpenGLError

NEEDED = (3, 3)
DEPTH, STENCIL = 24, 8  # bits


def wanted_format(samples: int = 0) -> QSurfaceFormat:
    """What to ask for: OpenGL 3.3 core, which is the oldest that does and the newest of macOS's."""
    wanted = QSurfaceFormat()
    wanted.setRenderableType(QSurfaceFormat.RenderableType.OpenGL)
    wanted.setVersion(*NEEDED)
    wanted.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    wanted.setDepthBufferSize(DEPTH)
    wanted.setStencilBufferSize(STENCIL)
    wanted.setSamples(samples)
    return wanted


def current_functions() -> Functions:
    """The functions of the context of Qt's that is current. OpenGLError if it won't do."""
    context = QOpenGLContext.currentContext()
    if context is None:
        raise OpenGLError("no context of OpenGL is current")
    version = context.format().version()
    if context.isOpenGLES() or tuple(version) < NEEDED:
        major, minor = version
        kind = "OpenGL ES" if context.isOpenGLES() else "OpenGL"
        raise OpenGLError(f"OpenGL 3.3 is needed, there is {kind} {major}.{minor}")
    return Functions(lambda name: int(context.getProcAddress(name) or 0))
