"""What every command is made of."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from plusedit.document.design import Design, EditError
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines

Targets = Mapping[ShapeId, tuple[int, ...]]
"""Indices of control lines by shape, as `Selection.targets` gives them."""


@dataclass(frozen=True, eq=False)
class Landing:
    """Where one of the lines that are moved or turned comes to stand, free of rounding."""

    shape_id: ShapeId
    number: int
    vector: Floats
    """(dim,) its control point or direction then"""


class Command(ABC):
    """An edit that knows its name, and what is selected after it. It has no undo: history does."""

    @property
    @abstractmethod
    def label(self) -> str:
        """What the Undo menu says, such as "Rotate 3 control lines"."""

    @abstractmethod
    def apply(self, design: Design) -> Design:
        """The edited design, or the very same one where nothing changes.

        EditError if it can't be done.
        """

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        """What is selected once the edit is committed: what was, as far as it is still there."""
        return selection.cut_to(new)


@dataclass(frozen=True)
class Together(Command):
    """Several edits as one step, done in order."""

    name: str
    commands: tuple[Command, ...]

    @property
    def label(self) -> str:
        return self.name

    def apply(self, design: Design) -> Design:
        for command in self.commands:
            design = command.apply(design)
        return design

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        for command in self.commands:
            between = command.apply(old)
            selection = command.reselect(selection, old, between)
            old = between
        return selection.cut_to(new)


def counted(targets: Targets, verb: str, noun: str = "control line") -> str:
    """Such as "Move control line" or "Move 3 control lines"."""
    count = sum(len(indices) for indices in targets.values())
    return f"{verb} {noun}" if count == 1 else f"{verb} {count} {noun}s"


def of_curves(ids: Iterable[ShapeId], verb: str, noun: str = "curve") -> str:
    """Such as "Reverse curve" or "Reverse 3 curves"."""
    count = len(tuple(ids))
    return f"{verb} {noun}" if count == 1 else f"{verb} {count} {noun}s"


def edit_curves(
    design: Design, ids: Iterable[ShapeId], edit: Callable[[ShapeId, PlusCurve], PlusCurve]
) -> Design:
    """The design with `edit` done to every curve named; the same design if it changes none.

    All or nothing. EditError where a shape is locked, hidden, missing or no curve; a ValueError
    of `edit` becomes an EditError that names the shape.
    """
    found: dict[ShapeId, Shape] = {}
    for shape_id in ids:
        shape, curve = unlocked(design, shape_id), design.curve(shape_id)
        try:
            edited = edit(shape_id, curve)
        except EditError:
            raise
        except ValueError as error:
            raise EditError(f"{shape.name}: {error}") from error
        if edited is not curve:
            found[shape_id] = shape.with_curve(edited)
    return with_shapes(design, found)


def with_shapes(design: Design, shapes: Mapping[ShapeId, Shape]) -> Design:
    """The design with those shapes in place of theirs, or in front; itself if there are none."""
    return replace(design, shapes={**design.shapes, **shapes}) if shapes else design


def unlocked(design: Design, shape_id: ShapeId) -> Shape:
    """The shape of that id. EditError if there is none, or it is locked or hidden."""
    shape = design[shape_id]
    if shape.locked:
        raise EditError(f"{shape.name} is locked")
    if not shape.visible:
        raise EditError(f"{shape.name} is hidden")
    return shape


def edit_lines(
    design: Design,
    targets: Targets,
    edit: Callable[[ShapeId, PlusCurve, list[int]], ControlLines],
) -> Design:
    """The design with `edit` done to the named lines. EditError if one is missing."""

    def edited(shape_id: ShapeId, curve: PlusCurve) -> PlusCurve:
        rows = list(targets[shape_id])
        if not rows:
            return curve
        count = len(curve.lines)
        if min(rows) < 0 or max(rows) >= count:
            missing = next(row for row in rows if not 0 <= row < count)
            raise EditError(f"{design[shape_id].name} has no control line {missing + 1}")
        lines = edit(shape_id, curve, rows)
        return curve if lines is curve.lines else replace(curve, lines=lines)

    return edit_curves(design, targets, edited)


def fitted(vector: Floats, dimension: int) -> Floats:
    """`vector` with as many numbers as `dimension` says: zeros added, or the last left out."""
    result = np.zeros(dimension)
    count = min(dimension, len(vector))
    result[:count] = vector[:count]
    return result


def fitted_matrix(matrix: Floats, dimension: int) -> Floats:
    """`matrix` with as many rows and columns as `dimension` says: of the identity, or left out."""
    result = np.eye(dimension)
    count = min(dimension, len(matrix))
    result[:count, :count] = matrix[:count, :count]
    return result
