"""Shapes on the clipboard, as the JSON of a design: other windows and editors of text read it."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TypeVar

import numpy as np
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from plusedit.app.background import CancelledError, in_background
from plusedit.commands.base import fitted
from plusedit.commands.shapes import AddShapes, DeleteShapes
from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.io.formats import FormatError
from plusedit.views.desk import Desk

KIND = "application/x-plusedit-shapes+json"
SHIFT = 2.0  # grid steps to the right and downwards for every copy after the first
LARGEST = 64 * 2**20  # characters of plain text; more than that was not meant for us

T = TypeVar("T")


class Clipboard:
    """Copy, cut and paste of shapes."""

    def __init__(self, desk: Desk, parent: QWidget) -> None:
        self._desk, self._parent = desk, parent
        self._pasted = self._copied = ""
        self._times = 0

    def copy(self) -> bool:
        """Put the selected shapes on the clipboard; whether there were any."""
        design = self._desk.session.committed
        chosen = self._desk.session.selection.shapes
        shapes = {i: design[i] for i in design if i in chosen}
        if not shapes:
            self._desk.say("Nothing is selected, so nothing was copied.")
            return False
        text = self._made("Copying …", lambda: text_of(shapes))
        if text is None:
            return False
        data = QMimeData()
        data.setText(text)
        data.setData(KIND, text.encode())
        QGuiApplication.clipboard().setMimeData(data)
        self._pasted, self._times, self._copied = text, 1, text
        self._desk.say(f"Copied {counted(len(shapes))}.")
        return True

    def cut(self) -> None:
        """Copy the selected shapes and take them away."""
        chosen = self._desk.session.selection.shapes
        ids = tuple(i for i in self._desk.session.committed if i in chosen)
        if self.copy() and not self._desk.commit(DeleteShapes(ids)):
            self._times = 0  # nothing is left at that place, so the first copy may go there

    def paste(self) -> None:
        """Add the shapes on the clipboard, in front and selected."""
        text = self._text()
        try:
            shapes = self._made("Pasting …", lambda: shapes_in(text))
        except FormatError:
            self._desk.say("The clipboard holds no shapes.")
            return
        if shapes is None:
            return
        if text != self._pasted:
            self._pasted, self._times = text, 0
        step = SHIFT * self._desk.gestures.grid_step * self._times
        self._times += 1
        added = fresh(self._desk.session.committed, shapes, np.array([step, -step]))
        if not self._desk.commit(AddShapes(added, name="Paste")):
            self._desk.say(f"Pasted {counted(len(added))}.")

    def leave(self) -> None:
        """Leave what was copied as plain text: the program is about to end.

        Data made in Python would be taken down by Qt after Python itself, which ends in a crash.
        """
        if self._copied and self._text() == self._copied:
            QGuiApplication.clipboard().setText(self._copied)

    def _made(self, words: str, make: Callable[[], T]) -> T | None:
        """What `make` gives, without the window standing still; None if the person gave up."""
        try:
            return in_background(self._parent, words, make)
        except CancelledError:
            self._desk.say("That was cancelled.")
            return None

    def _text(self) -> str:
        # None while whoever owns the clipboard does not answer, whatever Qt's stubs say.
        data: QMimeData | None = QGuiApplication.clipboard().mimeData()
        if data is None:
            return ""
        if data.hasFormat(KIND):
            return bytes(data.data(KIND).data()).decode("utf-8", "replace")
        text = data.text() if data.hasText() else ""
        return text if len(text) <= LARGEST else ""


def text_of(shapes: "dict[ShapeId, Shape]") -> str:
    """Shapes as the text of a design."""
    from plusedit.io.formats.json_document import dumps

    return dumps(Design(shapes)).decode()


def shapes_in(text: str) -> list[tuple[ShapeId, Shape]]:
    """The shapes of a text. FormatError if it is not a design, or an empty one."""
    from plusedit.io.formats.json_document import loads

    if not text.strip():
        raise FormatError("the clipboard holds no shapes")
    shapes = list(loads(text.encode(), "clipboard").design.shapes.items())
    if not shapes:
        raise FormatError("the clipboard holds no shapes")
    return shapes


def fresh(
    design: Design, shapes: Iterable[tuple[ShapeId, Shape]], offset: Floats
) -> tuple[tuple[ShapeId, Shape], ...]:
    """The shapes shifted, under ids that no shape of the design has."""
    added: dict[ShapeId, Shape] = {}
    for shape_id, shape in shapes:
        taken = replace(design, shapes={**design.shapes, **added})
        added[taken.unused_id(shape_id)] = shifted(shape, offset)
    return tuple(added.items())


def shifted(shape: Shape, offset: Floats) -> Shape:
    """The shape moved by `offset`, visible and unlocked."""
    shape = replace(shape, visible=True, locked=False)
    geometry = shape.plus
    if not offset.any():
        return shape
    if shape.mesh is not None:
        return shape.with_mesh(shape.mesh.transformed(np.eye(3), fitted(offset, 3)))
    if geometry is None:
        return shape
    points = geometry.net.control_points + fitted(offset, geometry.dimension)
    return shape.with_plus(geometry.with_net(geometry.net.with_control_points(points)))


def counted(count: int) -> str:
    """Such as "1 shape" or "3 shapes"."""
    return "1 shape" if count == 1 else f"{count} shapes"
