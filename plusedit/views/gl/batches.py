"""Lines, marks and areas, each kind drawn at once however many items there are."""

from collections.abc import Sequence
from typing import Final

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.items import (
    Caption,
    Item,
    Label,
    Legend,
    Markers,
    Mesh,
    Patch,
    Polygon,
    Polyline,
    Segments,
)
from plusedit.scene.space_camera import SpaceCamera
from plusedit.views.gl.buffers import Attribute, Buffer, VertexArray
from plusedit.views.gl.colors import Palette
from plusedit.views.gl.functions import TRIANGLE_STRIP, TRIANGLES, Functions
from plusedit.views.gl.programs import Program
from plusedit.views.gl.sight import Box, Sight
from plusedit.views.gl.strokes import A_GAP, STEP, Records, in_space, records_of
from plusedit.views.gl.triangles import triangulated

FAR_OFF = 1e3  # heights of the view from where places are counted, beyond which single
# precision would show: they are counted anew
MARKS = {"circle": 0.0, "square": 1.0, "diamond": 2.0, "ring": 3.0, "cross": 4.0}


class Batch:
    """Items of like kinds in one buffer, filled anew when they change.

    The records of items that stay are kept: while one shape is dragged all others are only copied.
    """

    def __init__(self, gl: Functions, program: Program) -> None:
        self._gl = gl
        self._program = program
        self._buffer, self._vertices = Buffer(gl), VertexArray(gl)
        self.items: Sequence[Item] = ()
        """what it holds"""
        self._records: dict[Item, Records] = {}
        self._palette: Palette | None = None
        self._camera: SpaceCamera | None = None
        self._count = 0
        self.origin: Floats = np.zeros(3)
        """where places are counted from"""
        self.box: Box | None = None
        """what lies in it; None if nothing does"""

    def show(self, items: Sequence[Item], palette: Palette, camera: SpaceCamera) -> None:
        """Hold those items; does nothing where they are the same as before."""
        if self._holds(items, palette, camera):
            return
        kept = self._records
        if palette is not self._palette or not self._sees_well(camera):
            kept = {}
            self.origin = _origin(items, camera)
        self.items, self._palette, self._camera = items, palette, camera
        self._records = {
            item: found if (found := kept.get(item)) is not None else self._made(item)
            for item in items
        }
        parts = [part for part in self._records.values() if len(part)]
        self.box, self._count = None, 0
        if parts:
            self._put(np.concatenate([*self._leading(), *parts]))

    def _put(self, records: Records) -> None:
        at = records[len(self._leading()) :, :3]
        self.box = at.min(axis=0) + self.origin, at.max(axis=0) + self.origin
        self._count = len(records)
        self._buffer.put(records)

    def _made(self, item: Item) -> Records:
        """The records of one item."""
        raise NotImplementedError

    def _leading(self) -> tuple[Records, ...]:
        """Records before those of the first item."""
        return ()

    def draw(self, sight: Sight, opacity: float = 1.0) -> None:
        """Draw them all."""
        if not self._count:
            return
        self._program.use()
        sight.show(self._program, self.origin)
        self._program.set("opacity", opacity)
        self._vertices.bind()
        self._draw(self._count)

    def release(self) -> None:
        """Free what it holds on the card."""
        self._buffer.release()
        self._vertices.release()

    def _holds(self, items: Sequence[Item], palette: Palette, camera: SpaceCamera) -> bool:
        old = self.items
        if len(items) != len(old) or palette is not self._palette:
            return False
        if any(a is not b for a, b in zip(items, old, strict=True)):
            return False
        return camera == self._camera or self._sees_well(camera)

    def _sees_well(self, camera: SpaceCamera) -> bool:
        """Whether the records do for that view, too."""
        off = np.abs(np.array(camera.target) - self.origin).max()
        return bool(off <= FAR_OFF * camera.height)

    def _draw(self, count: int) -> None:
        raise NotImplementedError


class Lines(Batch):
    """Polylines, segments and outlines of polygons."""

    def __init__(self, gl: Functions, program: Program, dashed: Program | None = None) -> None:
        """With a program for lines of which some are dashed, where there may be such."""
        super().__init__(gl, program)
        self._plain, self._dashed = program, dashed or program
        # Four records in a row, of which the middle two are the ends of the segment.
        places = [Attribute(k, 4, k * STEP) for k in range(4)]
        color, form = Attribute(4, 4, STEP + 16, is_color=True), Attribute(5, 2, STEP + 20)
        self._vertices.read(self._buffer, STEP, *places, color, form, each_instance=True)

    def show(self, items: Sequence[Item], palette: Palette, camera: SpaceCamera) -> None:
        """Hold those items; dashed lines are measured anew in every view."""
        dashed = [item for item in items if _is_dashed(item)]
        if dashed and camera != self._camera:
            self.items = ()
            for item in dashed:
                self._records.pop(item, None)
        super().show(items, palette, camera)
        self._program = self._dashed if dashed else self._plain

    def _made(self, item: Item) -> Records:
        assert self._palette is not None
        assert self._camera is not None
        return records_of(item, self._palette, self.origin, self._camera)

    def _leading(self) -> tuple[Records, ...]:
        return (A_GAP,)

    def _draw(self, count: int) -> None:
        if count > 3:
            self._gl.DrawArraysInstanced(TRIANGLE_STRIP, 0, 4, count - 3)


class Marks(Batch):
    """Markers."""

    STEP: Final = 32
    """Bytes of a record: a place, two colors of four bytes, size, width and kind"""

    def __init__(self, gl: Functions, program: Program) -> None:
        super().__init__(gl, program)
        self._vertices.read(
            self._buffer,
            self.STEP,
            Attribute(0, 3, 0),
            Attribute(1, 4, 12, is_color=True),
            Attribute(2, 4, 16, is_color=True),
            Attribute(3, 3, 20),
            each_instance=True,
        )

    def _made(self, item: Item) -> Records:
        assert self._palette is not None
        count = len(item.points) if isinstance(item, Markers) else 0
        records = np.empty((count, self.STEP // 4), dtype=np.float32)
        if isinstance(item, Markers):
            fill = self._palette.word("canvas" if item.fill is None else item.fill)
            records[:, :3] = in_space(item.points) - self.origin
            records[:, 3:5].view(np.uint32)[:] = fill, self._palette.word(item.outline)
            records[:, 5:] = item.size, item.width, MARKS[item.mark]
        return records

    def _draw(self, count: int) -> None:
        self._gl.DrawArraysInstanced(TRIANGLE_STRIP, 0, 4, count)


class Fills(Batch):
    """Insides of polygons."""

    STEP: Final = 16
    """Bytes of a record: a place and a color of four bytes"""

    def __init__(self, gl: Functions, program: Program) -> None:
        super().__init__(gl, program)
        places = Attribute(0, 3, 0), Attribute(1, 4, 12, is_color=True)
        self._vertices.read(self._buffer, self.STEP, *places)

    def _made(self, item: Item) -> Records:
        assert self._palette is not None
        if not isinstance(item, Polygon) or len(item.points) < 3:
            return np.empty((0, self.STEP // 4), dtype=np.float32)
        points = in_space(item.points) - self.origin
        corners = triangulated(points)
        records = np.empty((corners.size, self.STEP // 4), dtype=np.float32)
        records[:, :3] = points[corners.ravel()]
        records[:, 3].view(np.uint32)[:] = self._palette.word(item.fill)
        return records

    def _draw(self, count: int) -> None:
        self._gl.DrawArrays(TRIANGLES, 0, count)


def _is_dashed(item: Item) -> bool:
    return isinstance(item, Polyline | Segments) and item.dash != "solid"


def _origin(items: Sequence[Item], camera: SpaceCamera) -> Floats:
    """Where to count places from: what is seen, as far as that lies among the items."""
    rows = [row for item in items for row in _places(item) if len(row)]
    if not rows:
        return np.zeros(3)
    points = np.concatenate([in_space(row) for row in rows])
    near: Floats = np.clip(np.array(camera.target), points.min(axis=0), points.max(axis=0))
    return near


def _places(item: Item) -> tuple[Floats, ...]:
    match item:
        case Segments(starts, ends):
            return starts, ends
        case Label() | Legend() | Caption() | Patch() | Mesh():
            return ()
        case _:
            return (item.points,)
