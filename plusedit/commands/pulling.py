"""Pulling a point of the shape itself."""

from dataclasses import dataclass

import numpy as np

from plusedit.commands.base import Command, edit_geometries, fitted, kind_of
from plusedit.document.design import Design
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.influence import Place
from plusedit.geometry.pulling import Change, pulled


@dataclass(frozen=True, eq=False)
class Pull(Command):
    """Bring a point of a curve or surface to another place by the least change of its data.

    Of a mesh the control planes of the faces around change.
    """

    shape_id: ShapeId
    place: Place
    """(u,) of a curve, (u, v) of a surface"""
    to: Floats
    """(3,) of the world; the last is left out of plane curves"""
    change: Change = "points"

    @property
    def label(self) -> str:
        return "Pull curve" if len(self.place) == 1 else "Pull surface"

    def label_in(self, design: Design) -> str:
        return f"Pull {kind_of(design, [self.shape_id])}"

    def apply(self, design: Design) -> Design:
        def moved(_: ShapeId, geometry: Geometry) -> Geometry:
            target = fitted(np.asarray(self.to), geometry.dimension)
            return pulled(geometry, self.place, target, self.change)

        return edit_geometries(design, [self.shape_id], lambda i: design[i].geometry, moved)
