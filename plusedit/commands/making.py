"""Surfaces added in front of all shapes: simple bodies, and surfaces from curves.

The curves stay. A surface made from them does not follow them later: it has its own planes.
"""

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from plusedit.commands.base import Command, of_curves, unlocked
from plusedit.commands.naming import free_name
from plusedit.document.design import Design, EditError
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.making.aligning import aligned, loop
from plusedit.geometry.making.compatible import in_space
from plusedit.geometry.making.coons import coons
from plusedit.geometry.making.extrusion import extruded
from plusedit.geometry.making.lofting import lofted, section_parameters
from plusedit.geometry.making.revolution import WHOLE, revolved
from plusedit.geometry.making.ruled import ruled
from plusedit.geometry.surface import PlusSurface

STEM = "surface"
ALONG = np.linspace(0.0, 1.0, 129)  # where a surface is compared with its curves
EXACT = 1e-9  # of the extent: a surface that is nowhere farther from its curves meets them


@dataclass(frozen=True, eq=False)
class AddSurface(Command):
    """Put a surface in front of all shapes; it is selected then."""

    surface: PlusSurface
    name: str
    """such as "Tube": what it is called, and what undo says"""

    @property
    def label(self) -> str:
        return f"Add {self.name.lower()}"

    def apply(self, design: Design) -> Design:
        return with_surface(design, self.surface, self.name)

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return added(old, new)


@dataclass(frozen=True, eq=False)
class _FromCurves(Command):
    """Add surfaces made from curves; they are selected then."""

    ids: tuple[ShapeId, ...]

    def apply(self, design: Design) -> Design:
        shapes = [unlocked(design, shape_id) for shape_id in self.ids]
        curves = [design.curve(shape_id) for shape_id in self.ids]
        try:
            made = self.made(curves, [shape.name for shape in shapes])
        except EditError:
            raise
        except ValueError as error:
            raise EditError(str(error)) from error
        for name, surface in made:
            design = with_surface(design, surface, name)
        return design

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return added(old, new)

    @abstractmethod
    def made(
        self, curves: Sequence[PlusCurve], names: Sequence[str]
    ) -> list[tuple[str, PlusSurface]]:
        """The surfaces with their names. ValueError where the curves make none."""


@dataclass(frozen=True, eq=False)
class Extrude(_FromCurves):
    """Add, for every curve, the surface that it sweeps when it is moved straight on."""

    by: Floats
    """(3,)"""

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Extrude")

    def made(
        self, curves: Sequence[PlusCurve], names: Sequence[str]
    ) -> list[tuple[str, PlusSurface]]:
        return [
            (f"{name}, extruded", extruded(curve, self.by))
            for curve, name in zip(curves, names, strict=True)
        ]


@dataclass(frozen=True, eq=False)
class Revolve(_FromCurves):
    """Add, for every curve, the surface that it sweeps when it is turned about an axis."""

    point: Floats
    """(3,) of the axis"""
    axis: Floats
    """(3,) its direction"""
    angle: float = WHOLE
    """in radians"""

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Revolve")

    def made(
        self, curves: Sequence[PlusCurve], names: Sequence[str]
    ) -> list[tuple[str, PlusSurface]]:
        return [
            (f"{name}, revolved", revolved(curve, self.point, self.axis, self.angle))
            for curve, name in zip(curves, names, strict=True)
        ]


@dataclass(frozen=True, eq=False)
class Rule(_FromCurves):
    """Add the surface of straight lines between two curves, turned to run alike."""

    @property
    def label(self) -> str:
        return "Rule surface between 2 curves"

    def made(
        self, curves: Sequence[PlusCurve], names: Sequence[str]
    ) -> list[tuple[str, PlusSurface]]:
        if len(curves) != 2:
            raise EditError("A ruled surface needs two curves.")
        alike = aligned(curves)
        surface = ruled(*alike)
        return [(named("Ruled surface", surface.at(ALONG, [0.0, 1.0]), alike), surface)]


@dataclass(frozen=True, eq=False)
class Loft(_FromCurves):
    """Add a smooth surface through curves, in their order, each turned to run as the one before."""

    closed: bool = False
    """whether it goes on from the last curve to the first"""

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Loft" if not self.closed else "Loft round")

    def made(
        self, curves: Sequence[PlusCurve], names: Sequence[str]
    ) -> list[tuple[str, PlusSurface]]:
        alike = aligned(curves)
        surface = lofted(alike, closed=self.closed)
        at = section_parameters(alike, closed=self.closed)
        return [(named("Loft", surface.at(ALONG, at), alike), surface)]


@dataclass(frozen=True, eq=False)
class Fill(_FromCurves):
    """Add the Coons patch between four curves that meet at their ends, in any order."""

    @property
    def label(self) -> str:
        return "Fill between 4 curves"

    def made(
        self, curves: Sequence[PlusCurve], names: Sequence[str]
    ) -> list[tuple[str, PlusSurface]]:
        edges = loop(curves)
        surface = coons(*edges)
        along_u, along_v = surface.at(ALONG, [0.0, 1.0]), surface.at([0.0, 1.0], ALONG)
        found = np.concatenate([along_u, np.swapaxes(along_v, 0, 1)], axis=1)
        return [(named("Coons patch", found, edges), surface)]


def named(name: str, found: Floats, curves: Sequence[PlusCurve]) -> str:
    """The name of a surface, with how far it is from its curves where they had to be fitted.

    `found` (m, k, 3) is what the surface makes of the k curves, at the parameters `ALONG`.
    """
    wanted = np.stack([in_space(curve).at(ALONG) for curve in curves], axis=1)
    miss = float(np.linalg.norm(found - wanted, axis=-1).max())
    if miss <= EXACT * float(np.ptp(wanted)):
        return name
    return f"{name}, fitted within {miss:.2g}"


def with_surface(design: Design, surface: PlusSurface, name: str) -> Design:
    """The design with that surface in front of all, under a name and an id that are free."""
    shape = Shape(surface, free_name(design, name))
    return design.with_shape(design.unused_id(STEM), shape)


def added(old: Design, new: Design) -> Selection:
    """The shapes that the new design has and the old one has not."""
    return Selection.of_shapes(shape_id for shape_id in new if shape_id not in old)
