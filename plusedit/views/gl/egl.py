"""A context of OpenGL that no window system knows of, for pictures where there is no display."""

import ctypes
import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from plusedit.views.gl.functions import Functions, OpenGLError

SURFACELESS, DEVICE = 0x31DD, 0x313F  # platforms
OPENGL_API, OPENGL_BIT, RENDERABLE_TYPE, SURFACE_TYPE, NONE = 0x30A2, 0x8, 0x3040, 0x3033, 0x3038
VERSION_3_3_CORE = (0x3098, 3, 0x30FB, 3, 0x30FD, 1, NONE)
MOST_DEVICES = 16

_Pointer = ctypes.c_void_p


@contextmanager
def context_without_display() -> Iterator[Functions]:
    """OpenGL 3.3 core, current in this thread for as long as the block lasts.

    Draw into targets of your own: it has no surface. OpenGLError where EGL can't give one.
    """
    egl = _library()
    why = "EGL knows no platform without a display"
    for display in _displays(egl):
        try:
            context = _context(egl, display)
        except OpenGLError as error:
            why = str(error)
            continue
        try:
            yield Functions(lambda name: egl.eglGetProcAddress(name))
        finally:
            egl.eglMakeCurrent(display, None, None, None)
            egl.eglDestroyContext(display, context)
            egl.eglTerminate(display)
        return
    raise OpenGLError(why)


def _library() -> Any:
    # Where there is no graphics card Mesa warns of it, and then draws all the same.
    os.environ.setdefault("EGL_LOG_LEVEL", "fatal")
    try:
        egl = ctypes.CDLL("libEGL.so.1")
    except OSError as error:
        raise OpenGLError(f"EGL can't be loaded ({error})") from error
    for name, result, arguments in (
        ("eglGetProcAddress", _Pointer, [ctypes.c_char_p]),
        ("eglInitialize", ctypes.c_uint, [_Pointer] * 3),
        ("eglBindAPI", ctypes.c_uint, [ctypes.c_uint]),
        ("eglChooseConfig", ctypes.c_uint, [_Pointer] * 3 + [ctypes.c_int, _Pointer]),
        ("eglCreateContext", _Pointer, [_Pointer] * 4),
        ("eglDestroyContext", ctypes.c_uint, [_Pointer] * 2),
        ("eglMakeCurrent", ctypes.c_uint, [_Pointer] * 4),
        ("eglTerminate", ctypes.c_uint, [_Pointer]),
    ):
        function = getattr(egl, name)
        function.restype, function.argtypes = result, arguments
    return egl


def _displays(egl: Any) -> Iterator[int]:
    """What EGL can draw with: the usual card or the processor, then each card by itself."""
    found = egl.eglGetProcAddress(b"eglGetPlatformDisplayEXT")
    if not found:
        return
    display_of = ctypes.CFUNCTYPE(_Pointer, ctypes.c_uint, _Pointer, _Pointer)(found)
    if display := display_of(SURFACELESS, None, None):
        yield display
    query = egl.eglGetProcAddress(b"eglQueryDevicesEXT")
    if not query:
        return
    devices, count = (_Pointer * MOST_DEVICES)(), ctypes.c_int()
    ask = ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_int, _Pointer, _Pointer)(query)
    if ask(MOST_DEVICES, devices, ctypes.byref(count)):
        for device in devices[: count.value]:
            if display := display_of(DEVICE, device, None):
                yield display


def _context(egl: Any, display: int) -> int:
    if not egl.eglInitialize(display, None, None):
        raise OpenGLError("EGL finds no driver; Mesa's is in libegl-mesa0 and libgl1-mesa-dri")
    try:
        if not egl.eglBindAPI(OPENGL_API):
            raise OpenGLError("the EGL driver has no OpenGL")
        wanted = (ctypes.c_int * 5)(RENDERABLE_TYPE, OPENGL_BIT, SURFACE_TYPE, 0, NONE)
        config, count = _Pointer(), ctypes.c_int()
        egl.eglChooseConfig(display, wanted, ctypes.byref(config), 1, ctypes.byref(count))
        version = (ctypes.c_int * len(VERSION_3_3_CORE))(*VERSION_3_3_CORE)
        context = egl.eglCreateContext(display, config, None, version)
        if not context:
            raise OpenGLError("the EGL driver has no OpenGL 3.3")
        if not egl.eglMakeCurrent(display, None, None, context):
            egl.eglDestroyContext(display, context)
            raise OpenGLError("the EGL driver draws only on surfaces")
    except OpenGLError:
        egl.eglTerminate(display)
        raise
    return int(context)
