"""Edits of whole surfaces: bases by u and by v, the order of their planes, tangency, balance.

Edits of how many rows and columns a surface has lie in `plusedit.commands.planes`, curves taken
from surfaces in `plusedit.commands.extraction`; their names are here too.
"""

from dataclasses import dataclass

import numpy as np

from plusedit.commands.base import Command, edit_surfaces, of_curves
from plusedit.commands.extraction import ExtractBoundary, ExtractCurve
from plusedit.commands.planes import DeletePlanes, InsertRow
from plusedit.document.constraining import OldNumbers
from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.surface import PlusSurface, Way
from plusedit.geometry.surface_magnitude import balanced
from plusedit.geometry.surface_passing import passing_through_surface
from plusedit.geometry.surface_sizes import with_closed, with_family, with_field, with_order
from plusedit.geometry.surface_tangency import CORNERS, tangent_at_corners, tangent_to_planes
from plusedit.geometry.surface_transforms import (
    reversed_numbers,
    reversed_surface,
    transposed,
    transposed_numbers,
)

__all__ = [
    "Balance",
    "ChangeFamilyOf",
    "ChangeOrderOf",
    "DeletePlanes",
    "ExtractBoundary",
    "ExtractCurve",
    "InsertRow",
    "PassThroughSurface",
    "ReverseWay",
    "SetBasisFieldOf",
    "SetClosedOf",
    "TangentCorners",
    "TangentToCornerPlanes",
    "Transpose",
]

Ids = tuple[ShapeId, ...]

ROUNDING = 1e-12  # of the longest direction: what changes by less has not changed


def of_surfaces(ids: Ids, verb: str) -> str:
    """Such as "Transpose surface" or "Transpose 3 surfaces"."""
    return of_curves(ids, verb, "surface")


@dataclass(frozen=True, eq=False)
class Transpose(Command):
    """Swap u and v; the shape stays, its normals turn round, the selected planes stay selected."""

    ids: Ids

    @property
    def label(self) -> str:
        return of_surfaces(self.ids, "Transpose")

    def apply(self, design: Design) -> Design:
        return edit_surfaces(design, self.ids, lambda _, surface: transposed(surface))

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        return {i: transposed_numbers(old.surface(i)) for i in self.ids}

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return selection.renumbered(self.old_numbers(old, new))


@dataclass(frozen=True, eq=False)
class ReverseWay(Command):
    """Let u or v run the other way; the shape stays, the selected planes stay selected."""

    ids: Ids
    way: Way

    @property
    def label(self) -> str:
        return of_surfaces(self.ids, f"Reverse {self.way} of")

    def apply(self, design: Design) -> Design:
        def backwards(_: ShapeId, surface: PlusSurface) -> PlusSurface:
            return reversed_surface(surface, self.way)

        return edit_surfaces(design, self.ids, backwards)

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        return {i: reversed_numbers(old.surface(i), self.way) for i in self.ids}

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return selection.renumbered(self.old_numbers(old, new))


@dataclass(frozen=True, eq=False)
class ChangeFamilyOf(Command):
    """Blend the same control planes by functions of another family along u or v."""

    ids: Ids
    way: Way
    family: str

    @property
    def label(self) -> str:
        return of_surfaces(self.ids, f"Change family along {self.way} of")

    def apply(self, design: Design) -> Design:
        return edit_surfaces(
            design, self.ids, lambda _, surface: with_family(surface, self.way, self.family)
        )


@dataclass(frozen=True, eq=False)
class ChangeOrderOf(Command):
    """Give B-splines along u or v another order; open ones take at most the number of planes.

    Knots given before become uniform, since they are as many as the order says.
    """

    ids: Ids
    way: Way
    order: int

    @property
    def label(self) -> str:
        return of_surfaces(self.ids, f"Change order along {self.way} of")

    def apply(self, design: Design) -> Design:
        return edit_surfaces(
            design, self.ids, lambda _, surface: with_order(surface, self.way, self.order)
        )


@dataclass(frozen=True, eq=False)
class SetClosedOf(Command):
    """Close or open surfaces along u or v; knots given before become uniform."""

    ids: Ids
    way: Way
    closed: bool

    @property
    def label(self) -> str:
        verb = "Close" if self.closed else "Open"
        return f"{of_surfaces(self.ids, verb)} along {self.way}"

    def apply(self, design: Design) -> Design:
        return edit_surfaces(
            design, self.ids, lambda _, surface: with_closed(surface, self.way, self.closed)
        )


@dataclass(frozen=True, eq=False)
class SetBasisFieldOf(Command):
    """Set one parameter of the basis along u or v, such as "sigma" or "knots"."""

    ids: Ids
    way: Way
    field_name: str
    value: object
    """a number, True or False, a list of numbers, or None for the usual one"""

    @property
    def label(self) -> str:
        name = self.field_name.replace("_", " ")
        return of_surfaces(self.ids, f"Set {name} along {self.way} of")

    def apply(self, design: Design) -> Design:
        def changed(_: ShapeId, surface: PlusSurface) -> PlusSurface:
            return with_field(surface, self.way, self.field_name, self.value)

        return edit_surfaces(design, self.ids, changed)


@dataclass(frozen=True, eq=False)
class TangentCorners(Command):
    """Let surfaces leave their corners along the edges of the control net."""

    ids: Ids

    @property
    def label(self) -> str:
        return of_surfaces(self.ids, "Make corners tangent of")

    def apply(self, design: Design) -> Design:
        return edit_surfaces(design, self.ids, lambda _, surface: tangent_at_corners(surface))


@dataclass(frozen=True, eq=False)
class TangentToCornerPlanes(Command):
    """Let surfaces touch the control planes at their corners."""

    ids: Ids

    @property
    def label(self) -> str:
        return of_surfaces(self.ids, "Touch corner planes of")

    def apply(self, design: Design) -> Design:
        own = dict.fromkeys(CORNERS)
        return edit_surfaces(design, self.ids, lambda _, surface: tangent_to_planes(surface, own))


@dataclass(frozen=True, eq=False)
class PassThroughSurface(Command):
    """Change directions as little as makes surfaces pass through their control points."""

    ids: Ids

    @property
    def label(self) -> str:
        return of_surfaces(self.ids, "Pass through the points of")

    def apply(self, design: Design) -> Design:
        return edit_surfaces(design, self.ids, lambda _, surface: passing_through_surface(surface))


@dataclass(frozen=True, eq=False)
class Balance(Command):
    """Stretch the directions by u and by v so that one s suits both; the middle length stays."""

    ids: Ids

    @property
    def label(self) -> str:
        return of_surfaces(self.ids, "Balance u and v of")

    def apply(self, design: Design) -> Design:
        def even(_: ShapeId, surface: PlusSurface) -> PlusSurface:
            after = balanced(surface)
            change = np.abs(after.directions - surface.directions).max()
            tiny = change <= ROUNDING * np.abs(surface.directions).max()
            return surface if tiny else after

        return edit_surfaces(design, self.ids, even)
