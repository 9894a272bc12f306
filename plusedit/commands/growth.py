"""Edits of how many control lines a curve has, and deleting lines and planes alike."""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from plusedit.commands.base import Command, NetCommand, edit_curves, unlocked
from plusedit.commands.planes import DeletePlanes, kept_planes, split
from plusedit.document.constraining import OldNumbers
from plusedit.document.design import Design, EditError
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.insertion import insert_line
from plusedit.geometry.keeping import holds
from plusedit.geometry.magnitude import polygon_length
from plusedit.geometry.sizes import with_end_line, without_lines


@dataclass(frozen=True, eq=False)
class DeleteLines(NetCommand):
    """Take control lines away, and whole rows and columns of control planes.

    A curve that would keep fewer than 2 lines goes as a whole, and so does a surface that would
    keep fewer than 2 x 2 planes. EditError where planes make up no whole rows or columns.
    """

    @property
    def verb(self) -> str:
        return "Delete"

    def label_in(self, design: Design) -> str:
        lines, planes = split(design, self.targets)
        return super().label_in(design) if lines else DeletePlanes(planes).label_in(design)

    def apply(self, design: Design) -> Design:
        lines, planes = split(design, self.targets)
        gone = [
            shape_id
            for shape_id, rows in lines.items()
            if rows and len(design.curve(shape_id).lines) - len(set(rows)) < 2
        ]
        left = {i: rows for i, rows in lines.items() if rows and i not in gone}
        design = edit_curves(design, left, lambda i, curve: without_lines(curve, left[i]))
        for shape_id in gone:
            unlocked(design, shape_id)
        design = DeletePlanes(planes).apply(design)
        return design.without(*gone) if gone else design

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        lines, planes = split(old, self.targets)
        numbers = {
            shape_id: np.setdiff1d(np.arange(len(old.curve(shape_id).lines)), rows)
            for shape_id, rows in lines.items()
            if shape_id in new
        }
        return numbers | kept_planes(old, new, planes)

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        """What stays keeps being selected; else the neighbor, so that Delete can go on."""
        lines, planes = split(old, self.targets)
        if not lines:
            return DeletePlanes(planes).reselect(selection, old, new)
        kept = selection.renumbered(self.old_numbers(old, new)).cut_to(new)
        if kept.lines or len(self.targets) != 1:
            return kept
        (shape_id, rows), *_ = lines.items()
        if shape_id not in new or not rows:
            return kept
        last = len(new.curve(shape_id).lines) - 1
        return Selection.of_lines([LineId(shape_id, min(max(min(rows) - 1, 0), last))])


@dataclass(frozen=True, eq=False)
class InsertLine(Command):
    """Put a control line on a curve; the shape changes as little as the family allows.

    What the curve keeps passing through moves along it, so that it changes little then, too.
    """

    shape_id: ShapeId
    u: float

    @property
    def label(self) -> str:
        return "Insert control line"

    def apply(self, design: Design) -> Design:
        return edit_curves(design, [self.shape_id], lambda _, curve: self._longer(design, curve))

    def _longer(self, design: Design, curve: PlusCurve) -> PlusCurve:
        """With the points that the curve keeps passing through where it runs already.

        Elsewhere they would draw it away as soon as it passes through them again.
        """
        longer, new = inserted(curve, self.u)
        kept = [
            number + (number >= new)
            for wish in design[self.shape_id].constraints
            if wish.kind == "passing" and holds(curve, wish)
            for number in wish.numbers
        ]
        if not kept:
            return longer
        points = longer.lines.points.copy()
        points[kept] = curve.at(longer.basis.nodes[kept])
        return replace(longer, lines=longer.lines.with_points(points))

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        curve = old.curve(self.shape_id)
        rows = np.arange(len(curve.lines))
        return {self.shape_id: np.insert(rows, inserted(curve, self.u)[1], -1)}

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        number = inserted(old.curve(self.shape_id), self.u)[1]
        return Selection.of_lines([LineId(self.shape_id, number)])


@lru_cache(maxsize=4)
def inserted(curve: PlusCurve, u: float) -> tuple[PlusCurve, int]:
    """The curve with one more line, and its number; the same objects while a drag asks again."""
    return insert_line(curve, u)


@dataclass(frozen=True, eq=False)
class AppendLine(Command):
    """Draw an open curve on by one control line, which is selected then.

    While s is half the length of the control polygon, as on a new curve, it goes on being so.
    """

    shape_id: ShapeId
    at_end: bool
    """after the last line, or before the first"""
    point: Floats
    direction: Floats | None = None
    order: int | None = None
    """what a B-spline shall have once it has lines enough; None: what it has"""

    @property
    def label(self) -> str:
        return "Add control line"

    def apply(self, design: Design) -> Design:
        def longer(_: ShapeId, curve: PlusCurve) -> PlusCurve:
            if curve.closed:
                raise EditError("a closed curve has no end to draw on from")
            added = with_end_line(
                curve, self.point, self.direction, at_end=self.at_end, order=self.order
            )
            return replace(added, s=usual_s(added)) if is_usual(curve) else added

        return edit_curves(design, [self.shape_id], longer)

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        rows = np.arange(len(old.curve(self.shape_id).lines))
        return {self.shape_id: np.insert(rows, len(rows) if self.at_end else 0, -1)}

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        number = len(new.curve(self.shape_id).lines) - 1 if self.at_end else 0
        return Selection.of_lines([LineId(self.shape_id, number)])


def usual_s(curve: PlusCurve) -> float:
    """Half the length of the control polygon, what a new curve gets."""
    return polygon_length(curve) / 2.0


def is_usual(curve: PlusCurve) -> bool:
    """Whether s is half the length of the control polygon, but for rounding."""
    half = usual_s(curve)
    return abs(curve.s - half) <= 1e-9 * half
