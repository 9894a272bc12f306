"""Edits of control points and weights, on any number of lines of any shapes.

Edits of directions and affine maps have modules of their own; their names are here too.
"""

from dataclasses import dataclass

import numpy as np

from plusedit.commands.base import Command, Landing, Targets, counted, edit_lines, fitted
from plusedit.commands.directions import (
    ResetDirections,
    ReverseDirections,
    ScaleDirections,
    SetAngle,
    SetDirection,
    SetLength,
    Turn,
)
from plusedit.commands.transform import Transform
from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines

__all__ = [
    "Landing",
    "MovePoints",
    "ResetDirections",
    "ReverseDirections",
    "ScaleDirections",
    "SetAngle",
    "SetCoordinate",
    "SetDirection",
    "SetLength",
    "SetWeight",
    "Transform",
    "Turn",
]


@dataclass(frozen=True, eq=False)
class MovePoints(Command):
    """Shift control points, all by the same vector."""

    targets: Targets
    by: Floats
    """(dim,); what it has not for a space curve is zero, what is too much is left out"""
    landing: Landing | None = None
    """of one of the points: P + (Q - P) need not be Q to the last bit"""

    @property
    def label(self) -> str:
        return counted(self.targets, "Move")

    def apply(self, design: Design) -> Design:
        def moved(shape_id: ShapeId, curve: PlusCurve, rows: list[int]) -> ControlLines:
            by = fitted(self.by, curve.dimension)
            if not by.any():
                return curve.lines
            points = curve.lines.points.copy()
            points[rows] += by
            if self.landing is not None and self.landing.shape_id == shape_id:
                points[self.landing.number] = fitted(self.landing.vector, curve.dimension)
            return curve.lines.with_points(points)

        return edit_lines(design, self.targets, moved)


@dataclass(frozen=True, eq=False)
class SetCoordinate(Command):
    """Give control points the same x, y or z."""

    targets: Targets
    axis: int
    value: float

    @property
    def label(self) -> str:
        return counted(self.targets, f"Set {'xyz'[self.axis]} of")

    def apply(self, design: Design) -> Design:
        def placed(_: ShapeId, curve: PlusCurve, rows: list[int]) -> ControlLines:
            if self.axis >= curve.dimension:
                raise ValueError(f"a plane curve has no {'xyz'[self.axis]}")
            points = curve.lines.points.copy()
            points[rows, self.axis] = self.value
            return curve.lines.with_points(points)

        return edit_lines(design, self.targets, placed)


@dataclass(frozen=True, eq=False)
class SetWeight(Command):
    """Give control lines the same weight; where all weights of a curve become 1 it keeps none."""

    targets: Targets
    weight: float

    @property
    def label(self) -> str:
        return counted(self.targets, "Set weight of")

    def apply(self, design: Design) -> Design:
        def weighted(_: ShapeId, curve: PlusCurve, rows: list[int]) -> ControlLines:
            old = curve.lines.weights
            weights = np.ones(len(curve.lines)) if old is None else old.copy()
            weights[rows] = self.weight
            return curve.lines.with_weights(None if (weights == 1.0).all() else weights)

        return edit_lines(design, self.targets, weighted)
