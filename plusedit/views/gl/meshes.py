"""Triangles with light on them."""

from collections.abc import Iterable
from math import sqrt

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.items import Mesh
from plusedit.views.gl.buffers import Attribute, Buffer, VertexArray
from plusedit.views.gl.colors import Shade
from plusedit.views.gl.functions import (
    ELEMENT_ARRAY_BUFFER,
    TRIANGLES,
    UNSIGNED_INT,
    Functions,
)
from plusedit.views.gl.programs import Programs
from plusedit.views.gl.sight import Box, Sight


class MeshBuffers:
    """One mesh on the card, or after it another one of the same triangles."""

    def __init__(self, gl: Functions, mesh: Mesh) -> None:
        self._gl = gl
        self._mesh = mesh
        self._buffer, self._triangles = Buffer(gl), Buffer(gl, ELEMENT_ARRAY_BUFFER)
        self.put(mesh)
        self._vertices = VertexArray(gl)
        width = _width(mesh)
        parts = [Attribute(0, 3), Attribute(1, 3, 12), Attribute(2, 3, 24)]
        self._vertices.read(self._buffer, 4 * width, *parts[: width // 3])
        self._triangles.put(np.ascontiguousarray(mesh.triangles, np.uint32))
        self._count = mesh.triangles.size

    def fits(self, mesh: Mesh) -> bool:
        """Whether nothing but the vertices has to be sent for that mesh."""
        return mesh.triangles is self._mesh.triangles and _width(mesh) == _width(self._mesh)

    def put(self, mesh: Mesh) -> None:
        """Hold the vertices of that mesh."""
        self._mesh = mesh
        self.box: Box = mesh.points.min(axis=0), mesh.points.max(axis=0)
        self.origin: Floats = (self.box[0] + self.box[1]) / 2.0
        vertices = np.zeros((len(mesh.points), _width(mesh)), np.float32)
        vertices[:, :3] = mesh.points - self.origin
        if mesh.normals is not None:
            vertices[:, 3:6] = mesh.normals
        if mesh.colors is not None:
            vertices[:, 6:] = mesh.colors
        self._buffer.put(vertices)

    def draw(self) -> None:
        """Draw all triangles."""
        self._vertices.bind()
        self._gl.DrawElements(TRIANGLES, self._count, UNSIGNED_INT, None)

    def release(self) -> None:
        """Free it."""
        self._buffer.release()
        self._triangles.release()
        self._vertices.release()


class Meshes:
    """All meshes that a frame shows."""

    def __init__(self, gl: Functions, programs: Programs) -> None:
        self._gl, self._programs = gl, programs
        self._held: dict[Mesh, MeshBuffers] = {}

    def show(self, meshes: Iterable[Mesh]) -> None:
        """Send to the card what it does not have yet; free what is no longer drawn."""
        wanted = set(meshes)
        free = [self._held.pop(mesh) for mesh in list(self._held) if mesh not in wanted]
        for mesh in wanted - self._held.keys():
            held = next((held for held in free if held.fits(mesh)), None)
            if held is None:
                held = MeshBuffers(self._gl, mesh)
            else:
                free.remove(held)
                held.put(mesh)
            self._held[mesh] = held
        for held in free:
            held.release()

    def box(self, mesh: Mesh) -> Box:
        """What one of those that were shown lies in."""
        return self._held[mesh].box

    def draw(self, mesh: Mesh, sight: Sight) -> None:
        """Draw one of those that were shown, both of its sides or what is not culled."""
        held = self._held[mesh]
        front, back = (_of_two(sight.palette.albedo(color)) for color in (mesh.front, mesh.back))
        glass = ("GLASS",) if min(front[3], back[3]) < 1.0 else ()
        tinted = () if mesh.colors is None else ("TINTED",)
        program = self._programs.named("mesh", "shade", *sight.styles, *glass, *tinted)
        program.use()
        sight.show(program, held.origin)
        sight.show_light(program, held.origin, front, back)
        held.draw()

    def release(self) -> None:
        """Free everything."""
        for held in self._held.values():
            held.release()
        self._held = {}


def _width(mesh: Mesh) -> int:
    """How many numbers a vertex has: a place, a normal and perhaps a color."""
    return 6 if mesh.colors is None else 9


def _of_two(shade: Shade) -> Shade:
    """The color of each of two faces of a body, so that both together have that opacity."""
    red, green, blue, opacity = shade
    return red, green, blue, 1.0 - sqrt(1.0 - opacity)
