"""Lines, marks and areas, each kind drawn at once however many items there are."""

from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.items import Item, Markers, Polygon, Polyline, Segments
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.theme import Theme
from plusedit.views.gl.buffers import Attribute, Buffer, VertexArray
from plusedit.views.gl.colors import word_of
from plusedit.views.gl.functions import TRIANGLE_STRIP, TRIANGLES, Array, Functions
from plusedit.views.gl.programs import Program
from plusedit.views.gl.sight import Box, Sight, box_of
from plusedit.views.gl.strokes import RECORD, in_space, records_of, strokes_of
from plusedit.views.gl.triangles import triangulated

FAR_OFF = 1e3  # heights of the view from where places are counted, beyond which single
# precision would show: they are counted anew
MARKS = {"circle": 0.0, "square": 1.0, "diamond": 2.0, "ring": 3.0, "cross": 4.0}


class Batch:
    """Items of like kinds in one buffer, filled anew when they change."""

    def __init__(self, gl: Functions, program: Program) -> None:
        self._gl = gl
        self._program = program
        self._buffer, self._vertices = Buffer(gl), VertexArray(gl)
        self.items: Sequence[Item] = ()
        """what it holds"""
        self._theme: Theme | None = None
        self._camera: SpaceCamera | None = None
        self._count = 0
        self.origin: Floats = np.zeros(3)
        """where places are counted from"""
        self.box: Box | None = None
        """what lies in it; None if nothing does"""

    def show(self, items: Sequence[Item], theme: Theme, camera: SpaceCamera) -> None:
        """Hold those items; does nothing where they are the same as before."""
        if self._holds(items, theme, camera):
            return
        self.items, self._theme, self._camera = items, theme, camera
        points = [in_space(row) for item in items for row in _points(item)]
        self.box = box_of(np.concatenate(points)) if points else None
        self.origin = _origin(self.box, camera)
        records = self._records(items, theme, camera) if self.box is not None else np.zeros(0)
        self._count = len(records)
        if self._count:
            self._buffer.put(records)

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

    def _holds(self, items: Sequence[Item], theme: Theme, camera: SpaceCamera) -> bool:
        old = self.items
        if len(items) != len(old) or theme != self._theme or self._camera is None:
            return False
        if any(a is not b for a, b in zip(items, old, strict=True)):
            return False
        if camera is self._camera or camera == self._camera:
            return True
        off = np.abs(np.array(camera.target) - self.origin).max()
        return not self._depends_on_camera() and bool(off <= FAR_OFF * camera.height)

    def _depends_on_camera(self) -> bool:
        return False

    def _records(self, items: Sequence[Item], theme: Theme, camera: SpaceCamera) -> Array:
        raise NotImplementedError

    def _draw(self, count: int) -> None:
        raise NotImplementedError


class Lines(Batch):
    """Polylines, segments and outlines of polygons."""

    def __init__(self, gl: Functions, program: Program, dashed: Program | None = None) -> None:
        """With a program for lines of which some are dashed, where there may be such."""
        super().__init__(gl, program)
        self._plain, self._dashed = program, dashed or program
        step = RECORD.itemsize
        # Four records in a row, of which the middle two are the ends of the segment.
        places = [Attribute(k, 4, k * step) for k in range(4)]
        color, form = Attribute(4, 4, step + 16, is_color=True), Attribute(5, 2, step + 20)
        self._vertices.read(self._buffer, step, *places, color, form, each_instance=True)

    def _depends_on_camera(self) -> bool:
        return any(isinstance(i, Polyline | Segments) and i.dash != "solid" for i in self.items)

    def _records(self, items: Sequence[Item], theme: Theme, camera: SpaceCamera) -> Array:
        lines = [item for item in items if isinstance(item, Polyline | Segments | Polygon)]
        self._program = self._dashed if self._depends_on_camera() else self._plain
        return records_of(strokes_of(lines), theme, self.origin, camera)

    def _draw(self, count: int) -> None:
        if count > 3:
            self._gl.DrawArraysInstanced(TRIANGLE_STRIP, 0, 4, count - 3)


class Marks(Batch):
    """Markers."""

    RECORD: Final = np.dtype(
        [("at", "<f4", 3), ("fill", "<u4"), ("outline", "<u4"), ("form", "<f4", 3)]
    )

    def __init__(self, gl: Functions, program: Program) -> None:
        super().__init__(gl, program)
        self._vertices.read(
            self._buffer,
            self.RECORD.itemsize,
            Attribute(0, 3, 0),
            Attribute(1, 4, 12, is_color=True),
            Attribute(2, 4, 16, is_color=True),
            Attribute(3, 3, 20),
            each_instance=True,
        )

    def _records(self, items: Sequence[Item], theme: Theme, camera: SpaceCamera) -> Array:
        markers = [item for item in items if isinstance(item, Markers)]
        records = np.zeros(sum(len(item.points) for item in markers), dtype=self.RECORD)
        at = 0
        for item in markers:
            rows = records[at : at + len(item.points)]
            rows["at"] = in_space(item.points) - self.origin
            rows["fill"] = word_of(theme, "canvas" if item.fill is None else item.fill)
            rows["outline"] = word_of(theme, item.outline)
            rows["form"] = item.size, item.width, MARKS[item.mark]
            at += len(rows)
        return records

    def _draw(self, count: int) -> None:
        self._gl.DrawArraysInstanced(TRIANGLE_STRIP, 0, 4, count)


class Fills(Batch):
    """Insides of polygons."""

    RECORD: Final = np.dtype([("at", "<f4", 3), ("color", "<u4")])

    def __init__(self, gl: Functions, program: Program) -> None:
        super().__init__(gl, program)
        places = Attribute(0, 3, 0), Attribute(1, 4, 12, is_color=True)
        self._vertices.read(self._buffer, self.RECORD.itemsize, *places)

    def _records(self, items: Sequence[Item], theme: Theme, camera: SpaceCamera) -> Array:
        pieces: list[Any] = []
        for item in items:
            if isinstance(item, Polygon) and len(item.points) > 2:
                points = in_space(item.points) - self.origin
                rows = np.zeros(3 * (len(points) - 2), dtype=self.RECORD)
                corners = triangulated(points)
                rows = rows[: 3 * len(corners)]
                rows["at"] = points[corners.ravel()]
                rows["color"] = word_of(theme, item.fill)
                pieces.append(rows)
        return np.concatenate(pieces) if pieces else np.zeros(0, dtype=self.RECORD)

    def _draw(self, count: int) -> None:
        self._gl.DrawArrays(TRIANGLES, 0, count)


def _points(item: Item) -> Sequence[Floats]:
    match item:
        case Polyline(points) | Polygon(points) | Markers(points):
            rows: Sequence[Floats] = (points,)
        case Segments(starts, ends):
            rows = (starts, ends)
        case _:
            rows = ()
    return [row for row in rows if len(row)]


def _origin(box: Box | None, camera: SpaceCamera) -> Floats:
    """Where to count places from: what is seen, as far as that lies in the box."""
    if box is None:
        return np.zeros(3)
    low, high = box
    near: Floats = np.minimum(np.maximum(np.array(camera.target), low), high)
    return near
