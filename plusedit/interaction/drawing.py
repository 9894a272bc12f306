"""Drawing a curve line by line: which edit the next point makes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from plusedit.commands.base import Command, Together
from plusedit.commands.curves import ChangeOrder, CloseSmoothly, SetClosed, SetMagnitude
from plusedit.commands.growth import is_usual, usual_s
from plusedit.commands.naming import free_name
from plusedit.commands.shapes import AddShapes, AppendLine, DeleteLines
from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.sizes import basis_of
from plusedit.interaction.tool import NewCurves

FEWEST_CLOSED = 3  # control lines of a curve that the pen closes


@dataclass(frozen=True, eq=False)
class Placed:
    """A control line to be: its point, and its direction if one was drawn."""

    point: Floats
    direction: Floats | None = None


@dataclass(frozen=True)
class Stroke:
    """The open curve that is being drawn, and at which end."""

    shape: ShapeId
    at_end: bool

    def end(self, curve: PlusCurve) -> int:
        """The number of the line placed last."""
        return len(curve.lines) - 1 if self.at_end else 0

    def start(self, curve: PlusCurve) -> int:
        """The number of the line at the other end: the first that was placed."""
        return 0 if self.at_end else len(curve.lines) - 1


def begun(first: Placed, second: Placed, design: Design, new: NewCurves) -> AddShapes:
    """A new curve of two lines, whose second is selected then."""
    points = np.array([first.point, second.point])
    directions: list[ArrayLike | None] = [first.direction, second.direction]
    lines = ControlLines.of(points, directions)
    curve = PlusCurve(basis_of(new.family, 2, order=new.order), lines)
    curve = PlusCurve(curve.basis, lines, usual_s(curve))
    shape_id = design.unused_id("curve")
    shape = Shape(curve, free_name(design, "Curve"))
    selected = Selection.of_lines([LineId(shape_id, 1)])
    return AddShapes(((shape_id, shape),), "Draw curve", selected)


def continued(stroke: Stroke, placed: Placed, design: Design, new: NewCurves) -> AppendLine:
    """The curve with one line more at the end that is drawn."""
    order = new.order if is_growing(design.curve(stroke.shape)) else None
    return AppendLine(stroke.shape, stroke.at_end, placed.point, placed.direction, order)


def is_growing(curve: PlusCurve) -> bool:
    """Whether a B-spline is too short yet for the order it is to get."""
    return isinstance(curve.basis, BSpline) and curve.basis.order == curve.basis.size


def shortened(stroke: Stroke, design: Design) -> Command:
    """The curve without the line placed last."""
    curve = design.curve(stroke.shape)
    delete = DeleteLines({stroke.shape: (stroke.end(curve),)})
    after = delete.apply(design)
    if stroke.shape not in after or not is_usual(curve):
        return delete
    s = usual_s(after.curve(stroke.shape))
    return Together("Remove last control line", (delete, SetMagnitude({stroke.shape: s})))


def closed(stroke: Stroke, design: Design, new: NewCurves) -> Command:
    """The curve run back into its start."""
    shape_id, curve = stroke.shape, design.curve(stroke.shape)
    if isinstance(curve.basis, Bernstein):
        first = curve.lines.points[stroke.start(curve)]
        back = AppendLine(shape_id, stroke.at_end, first)
        return WholeAfter("Close curve", (back, CloseSmoothly((shape_id,))))
    steps: tuple[Command, ...] = (SetClosed((shape_id,), True),)
    if is_growing(curve):
        steps += (ChangeOrder((shape_id,), max(new.order, 2)),)
    if is_usual(curve):
        after = steps[0].apply(design).curve(shape_id)
        steps += (SetMagnitude({shape_id: usual_s(after)}),)
    return WholeAfter("Close curve", steps)


def can_close(stroke: Stroke, design: Design) -> bool:
    """Whether there are lines enough."""
    return len(design.curve(stroke.shape).lines) >= FEWEST_CLOSED


class WholeAfter(Together):
    """Several edits as one step, after which the shape is selected as a whole."""

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return Selection.of_shapes(selection.shapes).cut_to(new)
