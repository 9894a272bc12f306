"""Edits of surfaces of meshes."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from math import isfinite

import numpy as np

from plusedit.commands.base import (
    Command,
    Targets,
    edit_geometries,
    fitted,
    fitted_matrix,
    unlocked,
    with_shapes,
)
from plusedit.document.design import Design, EditError
from plusedit.document.map_record import MapRecord, map_of, with_map
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Domain
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.remapping import remapped

LEAST, MOST = 1e-3, 1e3  # smoothness that anyone has a use for


def edit_meshes(
    design: Design, ids: Iterable[ShapeId], edit: Callable[[ShapeId, MeshSurface], MeshSurface]
) -> Design:
    """`edit_geometries` of meshes: EditError where a shape is of another kind."""
    return edit_geometries(design, ids, design.mesh, edit)


@dataclass(frozen=True, eq=False)
class SetSmoothness(Command):
    """Give surfaces of meshes their smoothness S."""

    values: Mapping[ShapeId, float]

    @property
    def label(self) -> str:
        return "Set S" if len(self.values) == 1 else f"Set S of {len(self.values)} meshes"

    def apply(self, design: Design) -> Design:
        def smoothed(shape_id: ShapeId, surface: MeshSurface) -> MeshSurface:
            value = float(self.values[shape_id])
            if not (isfinite(value) and LEAST <= value <= MOST):
                raise EditError(f"S lies between {LEAST:g} and {MOST:g}")
            return surface if value == surface.smoothness else surface.with_smoothness(value)

        return edit_meshes(design, self.values, smoothed)


@dataclass(frozen=True, eq=False)
class SetAreaWeights(Command):
    """Let faces of meshes count by their area over their squared radius, or all alike."""

    ids: tuple[ShapeId, ...]
    are_on: bool

    @property
    def label(self) -> str:
        return "Weigh faces by area" if self.are_on else "Weigh faces alike"

    def apply(self, design: Design) -> Design:
        def weighted(_: ShapeId, surface: MeshSurface) -> MeshSurface:
            if surface.area_weights == self.are_on:
                return surface
            return replace(surface, area_weights=self.are_on)

        return edit_meshes(design, self.ids, weighted)


@dataclass(frozen=True, eq=False)
class Remap(Command):
    """Give a mesh the parameters of another map; edited planes stay where they are in space."""

    shape_id: ShapeId
    domain: Domain
    parameters: Floats
    """(c, 2) as of a mapped mesh"""
    name: str
    """of the map, as on the shelf"""
    cone_points: tuple[int, ...] = ()
    """the vertices at the corners of a pillow, if a person chose them"""
    made: tuple[MeshSurface, MeshSurface] | None = None
    """a surface and what becomes of it, where that has been worked out already"""

    @property
    def label(self) -> str:
        return "Choose cone points" if self.cone_points else "Change map"

    def apply(self, design: Design) -> Design:
        shape, surface = unlocked(design, self.shape_id), design.mesh(self.shape_id)
        record = MapRecord(self.name, self.cone_points)
        is_same = surface.domain == self.domain and np.array_equal(
            surface.parameters, self.parameters
        )
        if is_same and map_of(shape) == record:
            return design
        found = surface
        if self.made is not None and self.made[0] is surface:
            found = self.made[1]
        elif not is_same:
            try:
                found = remapped(surface, self.domain, self.parameters)
            except ValueError as error:
                raise EditError(f"{shape.name}: {error}") from error
        extra = with_map(shape.extra, record)
        return with_shapes(design, {self.shape_id: replace(shape, geometry=found, extra=extra)})


def transformed_meshes(
    design: Design, targets: Targets, matrix: Floats, offset: Floats
) -> tuple[Design, Targets]:
    """The design with x -> matrix x + offset done to the meshes that are meant as wholes.

    Such a mesh is mapped, and its surface follows it. What is left of the targets comes second.
    """
    turn, shift = fitted_matrix(matrix, 3), fitted(offset, 3)
    meshes = [
        i
        for i, rows in targets.items()
        if design[i].mesh is not None and (not rows or len(set(rows)) == design[i].element_count)
    ]

    def mapped(_: ShapeId, surface: MeshSurface) -> MeshSurface:
        if (turn == np.eye(3)).all() and not shift.any():
            return surface
        return surface.transformed(turn, shift)

    others = {i: rows for i, rows in targets.items() if i not in meshes}
    return edit_meshes(design, meshes, mapped), others
