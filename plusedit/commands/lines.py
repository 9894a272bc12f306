"""Edits of control points, directions and weights, on any number of lines of any shapes."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from plusedit.commands.base import Command, Targets, counted
from plusedit.document.design import Design, EditError
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines


def edit_lines(
    design: Design,
    targets: Targets,
    edit: Callable[[PlusCurve, list[int]], ControlLines],
) -> Design:
    """The design with `edit` done to the named lines. EditError if one is missing."""
    for shape_id, indices in targets.items():
        curve = design.curve(shape_id)
        for index in indices:
            if not 0 <= index < len(curve.lines):
                raise EditError(f"{design[shape_id].name} has no control line {index}")
        lines = edit(curve, list(indices))
        design = design.with_curve(shape_id, replace(curve, lines=lines))
    return design


@dataclass(frozen=True, eq=False)
class MovePoints(Command):
    """Shift control points, all by the same vector."""

    targets: Targets
    by: Floats
    """(dim,); what it has not for a space curve is zero, what is too much is left out"""

    @property
    def label(self) -> str:
        return counted(self.targets, "Move")

    def apply(self, design: Design) -> Design:
        def moved(curve: PlusCurve, rows: list[int]) -> ControlLines:
            points = curve.lines.points.copy()
            points[rows] += fitted(self.by, curve.dimension)
            return curve.lines.with_points(points)

        return edit_lines(design, self.targets, moved)


def fitted(vector: Floats, dimension: int) -> Floats:
    """`vector` with as many numbers as `dimension` says: zeros added, or the last left out."""
    result = np.zeros(dimension)
    count = min(dimension, len(vector))
    result[:count] = vector[:count]
    return result
