"""Edits of the faces of meshes that other control planes don't have: smoothness, taking back."""

from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite

import numpy as np

from plusedit.commands.base import Command, NetCommand, Targets, named, rows_meant
from plusedit.commands.meshes import LEAST, MOST, edit_meshes
from plusedit.document.design import Design, EditError
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface


def edit_faces(
    design: Design, targets: Targets, edit: Callable[[MeshSurface, list[int]], MeshSurface]
) -> Design:
    """The design with `edit` done to the faces meant, all of a mesh that is meant as a whole.

    EditError where a shape is no mesh, is locked or hidden, or has no such face.
    """

    def edited(shape_id: ShapeId, surface: MeshSurface) -> MeshSurface:
        return edit(surface, rows_meant(design, shape_id, targets[shape_id]))

    return edit_meshes(design, targets, edited)


@dataclass(frozen=True, eq=False)
class SetFactor(Command):
    """Let S be larger or smaller at some faces: sigma_i = S r_i times a factor of their own."""

    targets: Targets
    factor: float
    relative: bool = False
    """whether the factors that faces have are multiplied by it, or replaced"""

    @property
    def label(self) -> str:
        return "Set local S"

    def label_in(self, design: Design) -> str:
        what = named(design, self.targets)
        if self.relative:
            return f"Make {what} {'sharper' if self.factor < 1.0 else 'smoother'}"
        return f"{'Reset' if self.factor == 1.0 else 'Set'} local S of {what}"

    def apply(self, design: Design) -> Design:
        def scaled(surface: MeshSurface, rows: list[int]) -> MeshSurface:
            before = factors_of(surface)
            factors = before.copy()
            factors[rows] = before[rows] * self.factor if self.relative else self.factor
            chosen = factors[rows]
            if not (np.isfinite(chosen).all() and LEAST <= chosen.min() <= chosen.max() <= MOST):
                raise EditError(f"a factor of S lies between {LEAST:g} and {MOST:g}")
            if np.array_equal(factors, before):
                return surface
            return surface.with_factors(None if (factors == 1.0).all() else factors)

        if not isfinite(self.factor):
            raise EditError(f"a factor of S can't be {self.factor}")
        return edit_faces(design, self.targets, scaled)


def factors_of(surface: MeshSurface) -> Floats:
    """(f,) by what S is multiplied at each face; not to be written to."""
    return np.ones(surface.mesh.face_count) if surface.factors is None else surface.factors


@dataclass(frozen=True, eq=False)
class ResetPlanes(NetCommand):
    """Give faces their own control planes back: points and gradients as the mesh says."""

    @property
    def verb(self) -> str:
        return "Reset"

    def apply(self, design: Design) -> Design:
        def reset(surface: MeshSurface, rows: list[int]) -> MeshSurface:
            left = surface.net.without_edits(rows)
            return surface if left is surface.net else surface.with_net(left)

        return edit_faces(design, self.targets, reset)
