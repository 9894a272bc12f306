"""Pulling a point of the shape itself."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from plusedit.commands.base import Command, edit_geometries, fitted, kind_of
from plusedit.document.design import Design
from plusedit.document.shape import Geometry, Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.influence import Place
from plusedit.geometry.keeping import kept
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.pulling import Change, pulled


def keeper(shape: Shape) -> Callable[[Geometry], Geometry]:
    """What brings other geometry of a shape back to what the shape keeps."""
    before = shape.plus

    def keep(geometry: Geometry) -> Geometry:
        if isinstance(geometry, MeshSurface):
            return geometry
        return kept(geometry, shape.constraints, before).geometry

    return keep


@dataclass(frozen=True, eq=False)
class Pull(Command):
    """Bring a point of a curve or surface to another place by the least change of its data.

    Of a mesh the control planes of the faces around change. What a shape keeps stays kept.
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
        def moved(shape_id: ShapeId, geometry: Geometry) -> Geometry:
            target = fitted(np.asarray(self.to), geometry.dimension)
            shape = design[shape_id]
            keep = keeper(shape) if shape.constraints else None
            return pulled(geometry, self.place, target, self.change, keep)

        return edit_geometries(design, [self.shape_id], lambda i: design[i].geometry, moved)
