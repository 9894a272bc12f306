"""The functions of OpenGL 3.3 core that the program calls, and their constants.

They are asked of the context itself and called directly: so the same code draws in a window of Qt
on any platform and in a context that no window system knows of, and a call takes a microsecond.
"""

import ctypes
from collections.abc import Callable
from typing import Any

from numpy.typing import NDArray

Array = NDArray[Any]

_KINDS: dict[str, Any] = {
    "e": ctypes.c_uint,  # enumerations, names of objects, bit fields
    "i": ctypes.c_int,
    "f": ctypes.c_float,
    "d": ctypes.c_double,
    "b": ctypes.c_ubyte,
    "n": ctypes.c_ssize_t,  # sizes and offsets in buffers
    "p": ctypes.c_void_p,
    "c": ctypes.c_char_p,
}

# What they take; after a colon, what they give back.
_SIGNATURES = {
    "ActiveTexture": "e",
    "AttachShader": "ee",
    "BindBuffer": "ee",
    "BindFramebuffer": "ee",
    "BindRenderbuffer": "ee",
    "BindVertexArray": "e",
    "BlendFunc": "ee",
    "BlitFramebuffer": "iiiiiiiiee",
    "BufferData": "enpe",
    "BufferSubData": "ennp",
    "CheckFramebufferStatus": "e:e",
    "Clear": "e",
    "ClearColor": "ffff",
    "ClearDepth": "d",
    "ColorMask": "bbbb",
    "CompileShader": "e",
    "CreateProgram": ":e",
    "CreateShader": "e:e",
    "CullFace": "e",
    "DeleteBuffers": "ip",
    "DeleteFramebuffers": "ip",
    "DeleteProgram": "e",
    "DeleteRenderbuffers": "ip",
    "DeleteShader": "e",
    "DeleteVertexArrays": "ip",
    "DepthFunc": "e",
    "DepthMask": "b",
    "Disable": "e",
    "DrawArrays": "eii",
    "DrawArraysInstanced": "eiii",
    "DrawElements": "eiep",
    "Enable": "e",
    "EnableVertexAttribArray": "e",
    "Finish": "",
    "FramebufferRenderbuffer": "eeee",
    "FrontFace": "e",
    "GenBuffers": "ip",
    "GenFramebuffers": "ip",
    "GenRenderbuffers": "ip",
    "GenVertexArrays": "ip",
    "GetError": ":e",
    "GetIntegerv": "ep",
    "GetProgramInfoLog": "eipp",
    "GetProgramiv": "eep",
    "GetShaderInfoLog": "eipp",
    "GetShaderiv": "eep",
    "GetString": "e:c",
    "GetUniformLocation": "ec:i",
    "LinkProgram": "e",
    "PixelStorei": "ei",
    "PolygonOffset": "ff",
    "ReadBuffer": "e",
    "ReadPixels": "iiiieep",
    "RenderbufferStorageMultisample": "eieii",
    "ShaderSource": "eipp",
    "Uniform1f": "if",
    "Uniform2f": "iff",
    "Uniform3f": "ifff",
    "Uniform4f": "iffff",
    "UniformMatrix3fv": "iibp",
    "UniformMatrix4fv": "iibp",
    "UseProgram": "e",
    "VertexAttribDivisor": "ee",
    "VertexAttribPointer": "eiebip",
    "Viewport": "iiii",
}

TRIANGLES, TRIANGLE_STRIP = 0x4, 0x5
LESS, EQUAL, LEQUAL, GREATER = 0x201, 0x202, 0x203, 0x204
ONE, ONE_MINUS_SRC_ALPHA = 1, 0x303
FRONT, BACK = 0x404, 0x405
CULL_FACE, DEPTH_TEST, BLEND, MULTISAMPLE = 0xB44, 0xB71, 0xBE2, 0x809D
STENCIL_TEST, SCISSOR_TEST, POLYGON_OFFSET_FILL = 0xB90, 0xC11, 0x8037
COUNTERCLOCKWISE = 0x901
DEPTH_BUFFER_BIT, COLOR_BUFFER_BIT = 0x100, 0x4000
UNSIGNED_BYTE, UNSIGNED_INT, FLOAT = 0x1401, 0x1405, 0x1406
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 0x8892, 0x8893
STATIC_DRAW, DYNAMIC_DRAW = 0x88E4, 0x88E8
FRAGMENT_SHADER, VERTEX_SHADER = 0x8B30, 0x8B31
COMPILE_STATUS, LINK_STATUS, INFO_LOG_LENGTH = 0x8B81, 0x8B82, 0x8B84
VENDOR, RENDERER, VERSION = 0x1F00, 0x1F01, 0x1F02
RGBA, RGBA8, DEPTH24_STENCIL8, DEPTH_COMPONENT = 0x1908, 0x8058, 0x88F0, 0x1902
FRAMEBUFFER, READ_FRAMEBUFFER, DRAW_FRAMEBUFFER = 0x8D40, 0x8CA8, 0x8CA9
RENDERBUFFER, COLOR_ATTACHMENT0, DEPTH_STENCIL_ATTACHMENT = 0x8D41, 0x8CE0, 0x821A
FRAMEBUFFER_COMPLETE, FRAMEBUFFER_BINDING = 0x8CD5, 0x8CA6
NEAREST, LINEAR, PACK_ALIGNMENT = 0x2600, 0x2601, 0xD05
MAX_SAMPLES, MAX_RENDERBUFFER_SIZE = 0x8D57, 0x84E8


class OpenGLError(RuntimeError):
    """OpenGL is missing, too old, or refused something; says what in a sentence."""


class Functions:
    """The functions of one context; `Enable` is glEnable. Call them while it is current."""

    def __init__(self, address_of: Callable[[bytes], int | None]) -> None:
        """`address_of` gives the address of a function of that name, such as b"glEnable"."""
        for name, signature in _SIGNATURES.items():
            takes, _, gives = signature.partition(":")
            address = address_of(f"gl{name}".encode())
            if not address:
                raise OpenGLError(f"this OpenGL has no function gl{name}; 3.3 is needed")
            prototype = ctypes.CFUNCTYPE(_KINDS.get(gives), *(_KINDS[kind] for kind in takes))
            setattr(self, name, prototype(address))

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"gl{name} is not among the functions that are looked up")

    def made(self, kind: str) -> int:
        """A new object: kind is "Buffers", "VertexArrays", "Framebuffers" or "Renderbuffers"."""
        name = ctypes.c_uint()
        getattr(self, f"Gen{kind}")(1, ctypes.byref(name))
        return name.value

    def delete(self, kind: str, name: int) -> None:
        """Free an object that `made` gave."""
        getattr(self, f"Delete{kind}")(1, ctypes.byref(ctypes.c_uint(name)))

    def integer(self, what: int) -> int:
        """A number that the context knows."""
        value = ctypes.c_int()
        self.GetIntegerv(what, ctypes.byref(value))
        return value.value

    def text(self, what: int) -> str:
        """VENDOR, RENDERER or VERSION in words."""
        return (self.GetString(what) or b"").decode("utf-8", "replace")

    def errors(self) -> list[int]:
        """What went wrong since the last call; empty if nothing did."""
        found: list[int] = []
        while (code := self.GetError()) and len(found) < 16:
            found.append(code)
        return found


def address(array: Array) -> int:
    """Where the first entry of an array lies in memory."""
    return int(array.__array_interface__["data"][0])
