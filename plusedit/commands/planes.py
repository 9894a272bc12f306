"""Edits of how many control planes a surface has: rows and columns come and go as wholes.

Row i is the planes (i, j) of one node by u, column j those of one node by v.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from plusedit.commands.base import (
    Command,
    NetCommand,
    Targets,
    counted,
    edit_surfaces,
    many,
    unlocked,
)
from plusedit.document.constraining import OldNumbers
from plusedit.document.design import Design, EditError
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.surface import WAYS, PlusSurface, Way
from plusedit.geometry.surface_insertion import (
    insert_column,
    insert_row,
    without_columns,
    without_rows,
)


@dataclass(frozen=True, eq=False)
class InsertRow(Command):
    """Put a row of control planes on a surface; the shape changes as little as the family allows.

    The new planes are selected then.
    """

    shape_id: ShapeId
    way: Way
    """"u": a new row at that u, "v": a new column at that v"""
    value: float

    @property
    def label(self) -> str:
        return "Insert row" if self.way == "u" else "Insert column"

    def apply(self, design: Design) -> Design:
        def larger(_: ShapeId, surface: PlusSurface) -> PlusSurface:
            return inserted(surface, self.way, self.value)[0]

        return edit_surfaces(design, [self.shape_id], larger)

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        surface = old.surface(self.shape_id)
        place = inserted(surface, self.way, self.value)[1]
        count = surface.planes.shape[0] * surface.planes.shape[1]
        grid = np.arange(count).reshape(surface.planes.shape)
        return {self.shape_id: np.insert(grid, place, -1, axis=WAYS.index(self.way)).ravel()}

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        place = inserted(old.surface(self.shape_id), self.way, self.value)[1]
        return row_selected(new, self.shape_id, self.way, place)


@lru_cache(maxsize=4)
def inserted(surface: PlusSurface, way: Way, value: float) -> tuple[PlusSurface, int]:
    """The surface with one more row or column, and which; the same objects when asked again."""
    return insert_row(surface, value) if way == "u" else insert_column(surface, value)


def row_selected(design: Design, shape_id: ShapeId, way: Way, place: int) -> Selection:
    """Row `place` selected, or that column where the way is "v"; its middle plane is active."""
    numbers = row_numbers(design.surface(shape_id).planes.shape, way, place)
    lines = [LineId(shape_id, number) for number in numbers.tolist()]
    return Selection.of_lines(lines, lines[len(lines) // 2])


def row_numbers(shape: tuple[int, int], way: Way, place: int) -> NDArray[np.intp]:
    """The numbers of the planes in a row, or in a column where the way is "v"."""
    numbers = np.arange(shape[0] * shape[1]).reshape(shape)
    return numbers[place] if way == "u" else numbers[:, place]


@dataclass(frozen=True, eq=False)
class DeletePlanes(NetCommand):
    """Take whole rows and columns of control planes away.

    A surface that would keep fewer than 2 x 2 planes goes as a whole. EditError where planes are
    meant that make up no whole rows or columns.
    """

    @property
    def verb(self) -> str:
        return "Delete"

    @property
    def label(self) -> str:
        return counted(self.targets, self.verb, "control plane")

    def label_in(self, design: Design) -> str:
        found = [(design.surface(i), rows) for i, rows in self.targets.items() if rows]
        if not found or any(goes_whole(surface, rows) for surface, rows in found):
            return self.label
        pairs = [whole_rows(surface.planes.shape, numbers) for surface, numbers in found]
        counts = {"row": sum(len(rows) for rows, _ in pairs)}
        counts["column"] = sum(len(columns) for _, columns in pairs)
        return f"{self.verb} {many(counts)}"

    def apply(self, design: Design) -> Design:
        left = {shape_id: numbers for shape_id, numbers in self.targets.items() if numbers}
        for shape_id in left:
            unlocked(design, shape_id)
        gone = [i for i, numbers in left.items() if goes_whole(design.surface(i), numbers)]
        kept = [shape_id for shape_id in left if shape_id not in gone]
        design = edit_surfaces(design, kept, lambda i, surface: without(surface, left[i]))
        return design.without(*gone) if gone else design

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        return kept_planes(old, new, self.targets)

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        """Planes that stay keep being selected; else the row before, so that Delete can go on."""
        numbers = kept_planes(old, new, self.targets)
        kept = selection.renumbered(numbers).cut_to(new)
        if kept.lines or len(numbers) != 1 or len(self.targets) != 1:
            return kept
        (shape_id,) = numbers
        rows, columns = whole_rows(old.surface(shape_id).planes.shape, self.targets[shape_id])
        if rows and columns:
            return kept
        way: Way = "u" if rows else "v"
        return row_selected(new, shape_id, way, max(min(rows or columns) - 1, 0))


def whole_rows(shape: tuple[int, int], numbers: tuple[int, ...]) -> tuple[list[int], list[int]]:
    """The rows and columns that those planes of a surface of (n_u, n_v) make up.

    EditError where some of the planes belong to none of them, or are not there.
    """
    count = shape[0] * shape[1]
    missing = [number for number in numbers if not 0 <= number < count]
    if missing:
        raise EditError(f"there is no control plane {missing[0] + 1}")
    meant = np.zeros(shape, dtype=bool)
    meant.flat[list(numbers)] = True
    rows, columns = np.all(meant, axis=1), np.all(meant, axis=0)
    if not np.array_equal(meant, rows[:, None] | columns):
        raise EditError("Select whole rows or columns (double-click a net edge) to delete them.")
    return np.flatnonzero(rows).tolist(), np.flatnonzero(columns).tolist()


def goes_whole(surface: PlusSurface, numbers: tuple[int, ...]) -> bool:
    """Whether fewer than 2 x 2 planes would stay."""
    rows, columns = whole_rows(surface.planes.shape, numbers)
    n_u, n_v = surface.planes.shape
    return n_u - len(rows) < 2 or n_v - len(columns) < 2


def without(surface: PlusSurface, numbers: tuple[int, ...]) -> PlusSurface:
    """The surface of the rows and columns that stay."""
    rows, columns = whole_rows(surface.planes.shape, numbers)
    if rows:
        surface = without_rows(surface, rows)
    return without_columns(surface, columns) if columns else surface


def kept_planes(old: Design, new: Design, targets: Targets) -> dict[ShapeId, NDArray[np.intp]]:
    """The old number of each plane that stays, for the surfaces that lose some and stay."""
    found = {}
    for shape_id, numbers in targets.items():
        if shape_id in new:
            shape = old.surface(shape_id).planes.shape
            rows, columns = whole_rows(shape, numbers)
            grid = np.arange(shape[0] * shape[1]).reshape(shape)
            found[shape_id] = np.delete(np.delete(grid, rows, axis=0), columns, axis=1).ravel()
    return found


def split(design: Design, targets: Targets) -> tuple[Targets, Targets]:
    """The targets in curves, and those in surfaces."""
    planes = {i: rows for i, rows in targets.items() if design[i].surface is not None}
    return {i: rows for i, rows in targets.items() if i not in planes}, planes
