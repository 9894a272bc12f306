"""Curves taken from surfaces, as new shapes; the surfaces stay as they are."""

from dataclasses import dataclass

from plusedit.commands.base import Command, of_curves, unlocked
from plusedit.commands.naming import free_name, stem_of
from plusedit.document.design import Design, EditError
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.iso_curves import boundary_curves, iso_curve
from plusedit.geometry.surface import Way


@dataclass(frozen=True, eq=False)
class ExtractCurve(Command):
    """Add the curve of a surface along which u or v has a value; it is selected then."""

    shape_id: ShapeId
    way: Way
    """the parameter that is fixed"""
    value: float

    @property
    def label(self) -> str:
        return f"Extract curve of constant {self.way}"

    def apply(self, design: Design) -> Design:
        shape, surface = unlocked(design, self.shape_id), design.surface(self.shape_id)
        try:
            curve = iso_curve(surface, self.way, self.value)
        except ValueError as error:
            raise EditError(f"{shape.name}: {error}") from error
        return _with_curve(design, self.shape_id, curve, f"{self.way} = {self.value:.2f}")

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return _added(old, new)


@dataclass(frozen=True, eq=False)
class ExtractBoundary(Command):
    """Add the curves at the edges of surfaces; they are selected then."""

    ids: tuple[ShapeId, ...]

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Extract edges of", "surface")

    def apply(self, design: Design) -> Design:
        edges: list[tuple[ShapeId, PlusCurve]] = []
        for shape_id in self.ids:
            unlocked(design, shape_id)
            edges += [(shape_id, curve) for curve in boundary_curves(design.surface(shape_id))]
        if self.ids and not edges:
            raise EditError(f"{design[self.ids[0]].name} closes by u and by v: it has no edges")
        for shape_id, curve in edges:
            design = _with_curve(design, shape_id, curve, "edge")
        return design

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return _added(old, new)


def _with_curve(design: Design, source: ShapeId, curve: PlusCurve, what: str) -> Design:
    """The design with a curve of that surface in front of all."""
    name = free_name(design, f"{design[source].name}, {what}")
    curve_id = design.unused_id(f"{stem_of(source)}-curve")
    return design.with_shape(curve_id, Shape(curve, name))


def _added(old: Design, new: Design) -> Selection:
    return Selection.of_shapes(shape_id for shape_id in new if shape_id not in old)
