"""Plus surfaces: their terms in buffers, s a number that the shader weighs them by.

What a surface is made of goes to the card once. While s changes nothing is sent but s; while
planes are dragged the same buffers are filled again.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_kernels import changed_rows, surface_buffers
from plusedit.scene.items import Patch
from plusedit.views.gl.buffers import Attribute, Buffer, VertexArray
from plusedit.views.gl.functions import (
    ELEMENT_ARRAY_BUFFER,
    TRIANGLES,
    UNSIGNED_INT,
    Functions,
)
from plusedit.views.gl.programs import Programs
from plusedit.views.gl.sight import Box, Sight
from plusedit.views.gl.triangles import grid_triangles

TERMS = ("base", "plus", "base_u", "plus_u", "base_v", "plus_v")
FAR_OFF = 8.0  # sizes of a surface from the origin, beyond which its own middle becomes one
POINTLIKE = 1e-6  # of the size of a surface: shorter tangents have no direction
KEPT = 8  # lattices that no surface is drawn with

Key = tuple[ControlPlanes, Basis, Basis, Grid, Grid]
Single = NDArray[np.float32]


def key_of(patch: Patch) -> Key:
    """What the buffers of a patch depend on: all but s."""
    surface = patch.surface
    return surface.planes, surface.basis_u, surface.basis_v, patch.grid_u, patch.grid_v


@dataclass(frozen=True, eq=False)
class Frame:
    """Where a surface lies and how far its plus term may take it, whatever s is."""

    low: Floats
    high: Floats
    reach: float
    """of the plus term, at most, for s = 1"""

    @property
    def size(self) -> float:
        """The largest extent of the control points."""
        return float((self.high - self.low).max())

    def origin(self, before: Floats) -> Floats:
        """(3,) where coordinates are counted from: zero, or the middle of what is far off.

        The same as `before` while that is as good, so that what is dragged stays comparable.
        """
        middle = (self.low + self.high) / 2.0
        if np.abs(middle - before).max() <= FAR_OFF * self.size:
            return before
        return middle if np.abs(middle).max() > FAR_OFF * self.size else np.zeros(3)

    def box(self, s: float) -> Box:
        """What the surface stays inside of."""
        return self.low - abs(s) * self.reach, self.high + abs(s) * self.reach


_FRAMES: "WeakKeyDictionary[ControlPlanes, Frame]" = WeakKeyDictionary()


def frame_of(surface: PlusSurface) -> Frame:
    """The frame of a surface, from its control planes alone.

    All basis functions are positive: what they blend lies inside of what is blended.
    """
    frame = _FRAMES.get(surface.planes)
    if frame is None:
        points = surface.planes.control_points
        lengths = np.sqrt(np.square(surface.vectors).sum(axis=-1).max(axis=-1))
        frame = Frame(points.min(axis=0), points.max(axis=0), float(lengths.sum()))
        _FRAMES[surface.planes] = frame
    return frame


@lru_cache(maxsize=8)
def _wheres(rows: int, columns: int) -> Single:
    """(rows, columns, 2) the numbers of the samples, by u and by v."""
    numbers = np.indices((rows, columns), np.float32)
    return np.ascontiguousarray(numbers.transpose(1, 2, 0))


class Lattice:
    """What surfaces with as many samples share: how these are numbered and joined."""

    def __init__(self, gl: Functions, rows: int, columns: int) -> None:
        triangles = grid_triangles(rows, columns)
        self.count = triangles.size
        self.where = Buffer(gl)
        self.where.put(_wheres(rows, columns))
        self.triangles = Buffer(gl, ELEMENT_ARRAY_BUFFER)
        # The buffer of triangles belongs to the vertex array that is bound: let it be none.
        gl.BindVertexArray(0)
        self.triangles.put(triangles)

    def release(self) -> None:
        """Free it."""
        self.where.release()
        self.triangles.release()


class PatchBuffers:
    """The terms of one surface on the card."""

    def __init__(self, gl: Functions) -> None:
        self._gl = gl
        self._vertices = VertexArray(gl)
        self._buffers = [Buffer(gl) for _ in TERMS]
        for location, buffer in enumerate(self._buffers):
            self._vertices.read(buffer, 12, Attribute(location, 3))
        self._colors = Buffer(gl)
        self._colored: Single | None = None
        self._lattice: Lattice | None = None
        self._sent: Key | None = None
        self.origin: Floats = np.zeros(3)
        """(3,) where coordinates are counted from"""

    def fill(self, key: Key, lattice: Lattice, frame: Frame) -> None:
        """Put in another surface; of one that was dragged, what has moved."""
        origin = frame.origin(self.origin)
        planes, basis_u, basis_v, grid_u, grid_v = key
        if origin.any():
            planes = planes.with_points(planes.points - origin)
        sent = self._sent
        self._sent = (planes, basis_u, basis_v, grid_u, grid_v)
        if sent is not None and sent[1:] == key[1:] and origin is self.origin:
            self._change(self._sent, sent[0])
        else:
            terms = surface_buffers(basis_u, basis_v, planes, grid_u, grid_v)
            for buffer, name in zip(self._buffers, TERMS, strict=True):
                buffer.put(getattr(terms, name))
        self.origin = origin
        if lattice is not self._lattice:
            self._vertices.read(lattice.where, 8, Attribute(len(TERMS), 2))
            lattice.triangles.bind()
            self._lattice = lattice

    def color(self, colors: Single) -> None:
        """Draw it in these colors (m_u, m_v, 3) next; those it has already are not sent again."""
        if colors is not self._colored:
            self._vertices.read(self._colors, 12, Attribute(len(TERMS) + 1, 3))
            self._colors.put(np.ascontiguousarray(colors, np.float32))
            self._colored = colors

    def suits(self, key: Key) -> bool:
        """Whether it holds a surface on the same bases and grids."""
        return self._sent is not None and self._sent[1:] == key[1:]

    def _change(self, key: Key, before: ControlPlanes) -> None:
        planes, basis_u, basis_v, grid_u, grid_v = key
        changed = changed_rows(basis_u, basis_v, planes, before, grid_u, grid_v)
        if changed is None:
            return
        first = changed.rows.start * len(grid_v) * 12
        for buffer, name in zip(self._buffers, TERMS, strict=True):
            buffer.put_part(getattr(changed.buffers, name), first)

    def draw(self) -> None:
        """Draw all triangles."""
        if self._lattice is not None:
            self._vertices.bind()
            self._gl.DrawElements(TRIANGLES, self._lattice.count, UNSIGNED_INT, None)

    def release(self) -> None:
        """Free it."""
        for buffer in (*self._buffers, self._colors):
            buffer.release()
        self._vertices.release()


class Patches:
    """All surfaces that a frame shows, and the buffers of those of the frame before."""

    def __init__(self, gl: Functions, programs: Programs) -> None:
        self._gl, self._programs = gl, programs
        self._held: dict[Key, PatchBuffers] = {}
        self._lattices: dict[tuple[int, int], Lattice] = {}

    def show(self, patches: Iterable[Patch]) -> None:
        """Send to the card what it does not have yet, into buffers that are no longer needed."""
        wanted = {key_of(patch): patch for patch in patches}
        spare = [self._held.pop(key) for key in list(self._held) if key not in wanted]
        for key, patch in wanted.items():
            if key not in self._held:
                # Those that differ in control planes alone come first: a drag changes part of them.
                spare.sort(key=lambda buffers: buffers.suits(key))
                buffers = spare.pop() if spare else PatchBuffers(self._gl)
                buffers.fill(key, self._lattice(patch), frame_of(patch.surface))
                self._held[key] = buffers
        for buffers in spare:
            buffers.release()
        self._forget_lattices()

    def draw(self, patch: Patch, sight: Sight) -> None:
        """Draw one of those that were shown, both of its sides or what is not culled."""
        buffers = self._held[key_of(patch)]
        front, back = (sight.palette.albedo(color) for color in (patch.front, patch.back))
        styles = list(sight.styles)
        if patch.wire is not None:
            styles.append("WIRE")
        if min(front[3], back[3]) < 1.0:
            styles.append("GLASS")
        if patch.colors is not None:
            styles.append("TINTED")
            buffers.color(patch.colors)
        program = self._programs.named("patch", "shade", *styles)
        program.use()
        sight.show(program, buffers.origin)
        sight.show_light(program, buffers.origin, front, back)
        program.set("s", patch.surface.s)
        program.set("least", POINTLIKE * frame_of(patch.surface).size)
        if patch.wire is not None:
            program.set("wire", *sight.palette.shade(patch.wire))
        buffers.draw()

    def release(self) -> None:
        """Free everything."""
        for buffers in self._held.values():
            buffers.release()
        for lattice in self._lattices.values():
            lattice.release()
        self._held, self._lattices = {}, {}

    def _lattice(self, patch: Patch) -> Lattice:
        size = len(patch.grid_u), len(patch.grid_v)
        lattice = self._lattices.pop(size, None)
        if lattice is None:
            lattice = Lattice(self._gl, *size)
        self._lattices[size] = lattice
        return lattice

    def _forget_lattices(self) -> None:
        used = {(len(grid_u), len(grid_v)) for *_, grid_u, grid_v in self._held}
        for size in list(self._lattices):
            if len(self._lattices) <= KEPT + len(used):
                break
            if size not in used:
                self._lattices.pop(size).release()
