"""Shader programs, compiled from the files beside this module."""

import ctypes
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.views.gl.functions import (
    COMPILE_STATUS,
    FRAGMENT_SHADER,
    INFO_LOG_LENGTH,
    LINK_STATUS,
    VERTEX_SHADER,
    Functions,
    OpenGLError,
    address,
)

HEAD = "#version 330 core\n"
FOLDER = Path(__file__).parent / "shaders"


class Program:
    """A vertex and a fragment shader, linked; attributes have the locations they declare."""

    def __init__(self, gl: Functions, vertex: str, fragment: str, *defined: str) -> None:
        """The files shaders/`vertex`.vert and shaders/`fragment`.frag, with names defined."""
        self._gl = gl
        self._head = HEAD + "".join(f"#define {name}\n" for name in defined)
        self._places: dict[str, int] = {}
        self.told: object = None
        """what it was last told that holds for a whole frame"""
        self.name: int = gl.CreateProgram()
        kinds = ((VERTEX_SHADER, f"{vertex}.vert"), (FRAGMENT_SHADER, f"{fragment}.frag"))
        shaders = [self._compiled(kind, file) for kind, file in kinds]
        for shader in shaders:
            gl.AttachShader(self.name, shader)
        gl.LinkProgram(self.name)
        for shader in shaders:
            gl.DeleteShader(shader)
        if not self._status(gl.GetProgramiv, self.name, LINK_STATUS):
            raise OpenGLError(f"{vertex}, {fragment}: {self._log('Program', self.name)}")

    def use(self) -> None:
        """Draw with it from now on."""
        self._gl.UseProgram(self.name)

    def release(self) -> None:
        """Free it."""
        self._gl.DeleteProgram(self.name)

    def set(self, name: str, *values: float) -> None:
        """Give a uniform one to four numbers. The program must be in use."""
        place = self._place(name)
        match values:
            case (x,):
                self._gl.Uniform1f(place, x)
            case (x, y):
                self._gl.Uniform2f(place, x, y)
            case (x, y, z):
                self._gl.Uniform3f(place, x, y, z)
            case _:
                self._gl.Uniform4f(place, *values)

    def set_matrix(self, name: str, matrix: Floats) -> None:
        """Give a uniform a matrix (3, 3) or (4, 4), rows first."""
        rows = np.ascontiguousarray(matrix, dtype=np.float32)
        give = self._gl.UniformMatrix4fv if len(rows) == 4 else self._gl.UniformMatrix3fv
        give(self._place(name), 1, 1, address(rows))

    def _place(self, name: str) -> int:
        # A uniform that the compiler found no use for has the place -1, which OpenGL ignores.
        place = self._places.get(name)
        if place is None:
            place = self._places[name] = self._gl.GetUniformLocation(self.name, name.encode())
        return place

    def _compiled(self, kind: int, file: str) -> int:
        gl = self._gl
        shader: int = gl.CreateShader(kind)
        text = ctypes.c_char_p((self._head + _source(file)).encode())
        gl.ShaderSource(shader, 1, ctypes.byref(text), None)
        gl.CompileShader(shader)
        if not self._status(gl.GetShaderiv, shader, COMPILE_STATUS):
            raise OpenGLError(f"{file}: {self._log('Shader', shader)}")
        return shader

    def _status(self, ask: Callable[..., None], name: int, what: int) -> int:
        value = ctypes.c_int()
        ask(name, what, ctypes.byref(value))
        return value.value

    def _log(self, kind: str, name: int) -> str:
        gl = self._gl
        length = self._status(getattr(gl, f"Get{kind}iv"), name, INFO_LOG_LENGTH)
        text = ctypes.create_string_buffer(max(length, 1))
        getattr(gl, f"Get{kind}InfoLog")(name, len(text), None, text)
        return text.value.decode("utf-8", "replace").strip()


class Programs:
    """All programs of a context, compiled when they are first asked for."""

    def __init__(self, gl: Functions) -> None:
        self._gl = gl
        self._made: dict[tuple[str, ...], Program] = {}

    def named(self, vertex: str, fragment: str, *defined: str) -> Program:
        """The program of those shaders with those names defined; the same at every call."""
        key = (vertex, fragment, *defined)
        program = self._made.get(key)
        if program is None:
            program = self._made[key] = Program(self._gl, *key)
        return program

    def release(self) -> None:
        """Free all of them."""
        for program in self._made.values():
            program.release()
        self._made = {}


@cache
def _source(file: str) -> str:
    return (FOLDER / file).read_text(encoding="utf-8")
