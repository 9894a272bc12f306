"""Edits of control points and weights, on any number of control lines and planes of any shapes.

Edits of directions and affine maps have modules of their own; their names are here too.
"""

from dataclasses import dataclass

import numpy as np

from plusedit.commands.base import Landing, NetCommand, edit_nets, fitted
from plusedit.commands.directions import (
    ResetDirections,
    ReverseDirections,
    ScaleDirections,
    SetAngle,
    SetDirection,
    SetLength,
    Turn,
)
from plusedit.commands.meshes import transformed_meshes
from plusedit.commands.rotation import Rotate
from plusedit.commands.soft_move import SoftMove
from plusedit.commands.transform import Transform
from plusedit.document.design import Design
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.net import ControlNet

__all__ = [
    "Landing",
    "MovePoints",
    "ResetDirections",
    "ReverseDirections",
    "Rotate",
    "ScaleDirections",
    "SetAngle",
    "SetCoordinate",
    "SetDirection",
    "SetLength",
    "SetWeight",
    "SoftMove",
    "Transform",
    "Turn",
]


@dataclass(frozen=True, eq=False)
class MovePoints(NetCommand):
    """Shift control points, all by the same vector."""

    by: Floats
    """(dim,); what it has not for a space curve is zero, what is too much is left out"""
    landing: Landing | None = None
    """of one of the points: P + (Q - P) need not be Q to the last bit"""

    @property
    def verb(self) -> str:
        return "Move"

    def apply(self, design: Design) -> Design:
        def moved(shape_id: ShapeId, geometry: Geometry, rows: list[int]) -> ControlNet:
            net, by = geometry.net, fitted(self.by, geometry.dimension)
            if not by.any():
                return net
            points = net.control_points.copy()
            points[rows] += by
            if self.landing is not None and self.landing.shape_id == shape_id:
                points[self.landing.number] = fitted(self.landing.vector, geometry.dimension)
            return net.with_control_points(points)

        design, others = transformed_meshes(design, self.targets, np.eye(3), self.by)
        return edit_nets(design, others, moved)


@dataclass(frozen=True, eq=False)
class SetCoordinate(NetCommand):
    """Give control points the same x, y or z."""

    axis: int
    value: float

    @property
    def verb(self) -> str:
        return f"Set {'xyz'[self.axis]} of"

    def apply(self, design: Design) -> Design:
        def placed(_: ShapeId, geometry: Geometry, rows: list[int]) -> ControlNet:
            if self.axis >= geometry.dimension:
                raise ValueError(f"a plane curve has no {'xyz'[self.axis]}")
            points = geometry.net.control_points.copy()
            points[rows, self.axis] = self.value
            return geometry.net.with_control_points(points)

        return edit_nets(design, self.targets, placed)


@dataclass(frozen=True, eq=False)
class SetWeight(NetCommand):
    """Give control lines and planes the same weight; a shape whose weights are all 1 keeps none."""

    weight: float

    @property
    def verb(self) -> str:
        return "Set weight of"

    def apply(self, design: Design) -> Design:
        def weighted(_: ShapeId, geometry: Geometry, rows: list[int]) -> ControlNet:
            net = geometry.net
            old = net.weight_row
            weights = np.ones(len(net)) if old is None else old.copy()
            weights[rows] = self.weight
            return net.with_weight_row(None if (weights == 1.0).all() else weights)

        return edit_nets(design, self.targets, weighted)
