"""Edits of whole shapes.

Edits of how many control lines a curve has lie in `plusedit.commands.growth`; their names are
here too.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from plusedit.commands.base import (
    Command,
    Targets,
    edit_curves,
    fitted,
    of_curves,
    unlocked,
    with_shapes,
)
from plusedit.commands.growth import AppendLine, DeleteLines, InsertLine
from plusedit.commands.lines import MovePoints
from plusedit.commands.naming import free_name, stem_of
from plusedit.document.constraining import OldNumbers
from plusedit.document.design import Design, EditError
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId, Style
from plusedit.geometry.arrays import Floats
from plusedit.geometry.transforms import reversed_curve, reversed_rows

__all__ = [
    "AddShapes",
    "AppendLine",
    "DeleteLines",
    "DeleteShapes",
    "Duplicate",
    "InsertLine",
    "Rename",
    "Reorder",
    "ReverseCurves",
    "SetLocked",
    "SetStyle",
    "SetVisible",
]

Ids = tuple[ShapeId, ...]


@dataclass(frozen=True, eq=False)
class AddShapes(Command):
    """Put shapes in front of all others; they are selected then."""

    shapes: tuple[tuple[ShapeId, Shape], ...]
    name: str = "Add"
    """the label, or its verb where it is a single word"""
    selected: Selection | None = None
    """what is selected then; None: the shapes as wholes"""

    @property
    def label(self) -> str:
        if " " in self.name:
            return self.name
        return of_curves((i for i, _ in self.shapes), self.name, "shape")

    def apply(self, design: Design) -> Design:
        taken = [shape_id for shape_id, _ in self.shapes if shape_id in design]
        if taken:
            raise EditError(f"there is a shape {taken[0]!r} already")
        return with_shapes(design, dict(self.shapes))

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        if self.selected is not None:
            return self.selected.cut_to(new)
        return Selection.of_shapes(shape_id for shape_id, _ in self.shapes)


@dataclass(frozen=True, eq=False)
class DeleteShapes(Command):
    """Take shapes away. Locked and hidden ones can't be."""

    ids: Ids

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Delete", "shape")

    def apply(self, design: Design) -> Design:
        for shape_id in self.ids:
            unlocked(design, shape_id)
        return design.without(*self.ids) if self.ids else design


@dataclass(frozen=True, eq=False)
class Duplicate(Command):
    """Copy shapes, shifted, in front of all others; the copies are selected then."""

    ids: Targets | Iterable[ShapeId]
    """the shapes to copy; of targets, the shapes they are in"""
    offset: Floats

    @property
    def label(self) -> str:
        return of_curves(tuple(self.ids), "Duplicate", "shape")

    def apply(self, design: Design) -> Design:
        for shape_id in tuple(self.ids):
            shape = unlocked(design, shape_id)
            copy_id = design.unused_id(stem_of(shape_id))
            design = design.with_shape(copy_id, replace(shape, name=free_name(design, shape.name)))
            if shape.plus is not None:
                rows = tuple(range(len(shape.plus.net)))
                design = MovePoints({copy_id: rows}, self.offset).apply(design)
            elif shape.mesh is not None:
                moved = shape.mesh.transformed(np.eye(3), fitted(self.offset, 3))
                design = design.with_shape(copy_id, design[copy_id].with_mesh(moved))
        return design

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return Selection.of_shapes(shape_id for shape_id in new if shape_id not in old)


@dataclass(frozen=True, eq=False)
class Rename(Command):
    """Call a shape something else; locked and hidden ones too."""

    shape_id: ShapeId
    name: str

    @property
    def label(self) -> str:
        return f"Rename to {self.name}"

    def apply(self, design: Design) -> Design:
        name = self.name.strip()
        if not name:
            raise EditError("a shape needs a name")
        shape = design[self.shape_id]
        return with_shapes(
            design, {} if name == shape.name else {self.shape_id: replace(shape, name=name)}
        )


@dataclass(frozen=True, eq=False)
class SetVisible(Command):
    """Show or hide shapes; what is hidden is no longer selected."""

    ids: Ids
    visible: bool

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Show" if self.visible else "Hide", "shape")

    def apply(self, design: Design) -> Design:
        return marked(design, self.ids, lambda shape: replace(shape, visible=self.visible))

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return selection if self.visible else deselected(selection, self.ids)


@dataclass(frozen=True, eq=False)
class SetLocked(Command):
    """Lock shapes against all editing, or unlock them; what is locked is no longer selected."""

    ids: Ids
    locked: bool

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Lock" if self.locked else "Unlock", "shape")

    def apply(self, design: Design) -> Design:
        return marked(design, self.ids, lambda shape: replace(shape, locked=self.locked))

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return deselected(selection, self.ids) if self.locked else selection


def marked(design: Design, ids: Ids, mark: Callable[[Shape], Shape]) -> Design:
    """The design with `mark` done to the shapes named; itself if that changes none."""
    found: dict[ShapeId, Shape] = {}
    for shape_id in ids:
        shape = design[shape_id]
        new = mark(shape)
        if (new.visible, new.locked) != (shape.visible, shape.locked):
            found[shape_id] = new
    return with_shapes(design, found)


def deselected(selection: Selection, ids: Ids) -> Selection:
    """The selection without those shapes and their lines."""
    gone = frozenset(ids)
    lines = frozenset(line for line in selection.lines if line.shape not in gone)
    return Selection(lines, selection.shapes - gone, selection.active)


@dataclass(frozen=True, eq=False)
class SetStyle(Command):
    """Draw shapes in another color or width."""

    ids: Ids
    style: Style

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Set style of", "shape")

    def apply(self, design: Design) -> Design:
        found = {i: replace(unlocked(design, i), style=self.style) for i in self.ids}
        changed = {i: shape for i, shape in found.items() if design[i].style != self.style}
        return with_shapes(design, changed)


@dataclass(frozen=True, eq=False)
class Reorder(Command):
    """Put all shapes in another order, back to front."""

    order: Ids

    @property
    def label(self) -> str:
        return "Reorder shapes"

    def apply(self, design: Design) -> Design:
        if sorted(self.order) != sorted(design):
            raise EditError("an order must name every shape once")
        return design if list(self.order) == list(design) else design.ordered(list(self.order))


@dataclass(frozen=True, eq=False)
class ReverseCurves(Command):
    """Run curves the other way; their shapes stay, the numbers of selected lines follow."""

    ids: Ids

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Reverse")

    def apply(self, design: Design) -> Design:
        return edit_curves(design, self.ids, lambda _, curve: reversed_curve(curve))

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        return {i: reversed_rows(old.curve(i).basis) for i in self.ids}

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return selection.renumbered(self.old_numbers(old, new))
