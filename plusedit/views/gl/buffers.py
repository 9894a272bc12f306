"""Memory of the graphics card: buffers, and how vertices are read from them."""

from dataclasses import dataclass

from plusedit.views.gl.functions import (
    ARRAY_BUFFER,
    DYNAMIC_DRAW,
    ELEMENT_ARRAY_BUFFER,
    FLOAT,
    STATIC_DRAW,
    UNSIGNED_BYTE,
    Array,
    Functions,
    address,
)


class Buffer:
    """A buffer that keeps its memory while what is put into it has the same size."""

    def __init__(self, gl: Functions, kind: int = ARRAY_BUFFER) -> None:
        self._gl, self._kind = gl, kind
        self._capacity = -1
        self.name = gl.made("Buffers")

    def bind(self) -> None:
        """Make it the current one of its kind."""
        self._gl.BindBuffer(self._kind, self.name)

    def put(self, array: Array) -> None:
        """Fill it with an array, contiguous in memory."""
        self.bind()
        size = array.nbytes
        if size == self._capacity:
            self._gl.BufferSubData(self._kind, 0, size, address(array))
            return
        usage = STATIC_DRAW if self._kind == ELEMENT_ARRAY_BUFFER else DYNAMIC_DRAW
        self._gl.BufferData(self._kind, size, address(array), usage)
        self._capacity = size

    def put_part(self, array: Array, first: int) -> None:
        """Replace what it holds from byte `first` on."""
        self.bind()
        self._gl.BufferSubData(self._kind, first, array.nbytes, address(array))

    def release(self) -> None:
        """Free it."""
        self._gl.delete("Buffers", self.name)


@dataclass(frozen=True)
class Attribute:
    """Where one input of a vertex shader lies in a record of a buffer."""

    location: int
    count: int
    """of its components"""
    offset: int = 0
    """in bytes"""
    is_color: bool = False
    """four bytes from 0 to 255, read as 0 to 1; floats otherwise"""


class VertexArray:
    """Which buffers the inputs of a vertex shader come from."""

    def __init__(self, gl: Functions) -> None:
        self._gl = gl
        self.name = gl.made("VertexArrays")

    def bind(self) -> None:
        """Read vertices that way from now on."""
        self._gl.BindVertexArray(self.name)

    def read(
        self, buffer: Buffer, stride: int, *attributes: Attribute, each_instance: bool = False
    ) -> None:
        """Take attributes from records of `stride` bytes, one for a vertex or for an instance."""
        gl = self._gl
        self.bind()
        buffer.bind()
        for attribute in attributes:
            kind = UNSIGNED_BYTE if attribute.is_color else FLOAT
            at, count = attribute.location, attribute.count
            gl.EnableVertexAttribArray(at)
            gl.VertexAttribPointer(at, count, kind, attribute.is_color, stride, attribute.offset)
            if each_instance:
                gl.VertexAttribDivisor(at, 1)

    def release(self) -> None:
        """Free it."""
        self._gl.delete("VertexArrays", self.name)
