"""Affine maps of control lines, exact for whole curves."""

from dataclasses import dataclass, replace

import numpy as np

from plusedit.commands.base import Command, Targets, counted, edit_curves, fitted, fitted_matrix
from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.transforms import transformed


@dataclass(frozen=True, eq=False)
class Transform(Command):
    """Map points by x -> matrix x + offset, and the directions given by the user as vectors.

    Where every line of a curve is meant the curve becomes its exact image: under a similarity s
    takes the factor and automatic directions stay so, under any other map they become given.
    Where only some lines are meant, automatic directions go on following their neighbours.
    """

    targets: Targets
    matrix: Floats
    """(2, 2) or (3, 3); in a dimension that it has not, nothing changes"""
    offset: Floats
    """(2,) or (3,)"""
    name: str = "Transform"
    """the verb of the label"""

    @property
    def label(self) -> str:
        return counted(self.targets, self.name)

    def apply(self, design: Design) -> Design:
        def mapped(shape_id: ShapeId, curve: PlusCurve) -> PlusCurve:
            rows = list(self.targets[shape_id])
            if curve.dimension == 2 and len(self.matrix) == 3 and self._leaves_the_plane:
                raise ValueError("a plane curve can be turned in the top view only")
            matrix = fitted_matrix(self.matrix, curve.dimension)
            offset = fitted(self.offset, curve.dimension)
            if (matrix == np.eye(len(matrix))).all() and not offset.any():
                return curve
            return image(curve, rows, matrix, offset)

        return edit_curves(design, self.targets, mapped)

    @property
    def _leaves_the_plane(self) -> bool:
        return bool(self.matrix[2, :2].any() or self.matrix[:2, 2].any())


def image(curve: PlusCurve, rows: list[int], matrix: Floats, offset: Floats) -> PlusCurve:
    """The curve with some of its lines mapped, as `Transform` says."""
    lines = curve.lines
    if len(set(rows)) == len(lines):
        return transformed(curve, matrix, offset)
    points, given = lines.points.copy(), lines.given.copy()
    points[rows] = points[rows] @ matrix.T + offset
    given[rows] = given[rows] @ matrix.T
    return replace(curve, lines=replace(lines, points=points, given=given))
