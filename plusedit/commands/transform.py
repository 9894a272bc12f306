"""Affine maps of control lines, exact for whole curves."""

from dataclasses import dataclass, replace

import numpy as np

from plusedit.commands.base import Command, Targets, counted, edit_curves, fitted, fitted_matrix
from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve


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
            matrix = fitted_matrix(self.matrix, curve.dimension)
            offset = fitted(self.offset, curve.dimension)
            if (matrix == np.eye(len(matrix))).all() and not offset.any():
                return curve
            return image(curve, rows, matrix, offset)

        return edit_curves(design, self.targets, mapped)


def image(curve: PlusCurve, rows: list[int], matrix: Floats, offset: Floats) -> PlusCurve:
    """The curve with some of its lines mapped, as `Transform` says."""
    lines, whole = curve.lines, len(rows) == len(curve.lines)
    points, given = lines.points.copy(), lines.given.copy()
    points[rows] = points[rows] @ matrix.T + offset
    factor = similarity(matrix) if whole else None
    if factor is not None:
        given = given @ matrix.T / factor
        return replace(curve, lines=replace(lines, points=points, given=given), s=curve.s * factor)
    if whole:
        directions = curve.directions @ matrix.T
        return replace(curve, lines=lines.with_points(points).with_directions(directions))
    given[rows] = given[rows] @ matrix.T
    return replace(curve, lines=replace(lines, points=points, given=given))


def similarity(matrix: Floats) -> float | None:
    """The factor by which all lengths are multiplied; None if it depends on the direction, or 0."""
    gram = matrix.T @ matrix
    square = float(np.trace(gram)) / len(matrix)
    if square <= 0.0 or np.abs(gram - square * np.eye(len(matrix))).max() > 1e-12 * square:
        return None
    return float(np.sqrt(square))
