"""Edits of whole curves: the family and its parameters, tangency, closing; s of surfaces too."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace

from plusedit.commands.base import Command, edit_curves, edit_shapes, kind_of, many, of_curves
from plusedit.commands.meshes import edit_meshes
from plusedit.document.design import Design
from plusedit.document.shape import PlusGeometry, ShapeId, Tree
from plusedit.geometry.bases import Basis
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.passing import passing_through
from plusedit.geometry.sizes import closed_basis, ordered_basis, with_family
from plusedit.geometry.tangency import closed_smoothly, tangent_at_ends

Ids = tuple[ShapeId, ...]


def rebased(design: Design, ids: Ids, change: Callable[[Basis], Basis]) -> Design:
    """The design with other bases under the same control lines."""

    def edited(_: ShapeId, curve: PlusCurve) -> PlusCurve:
        basis = change(curve.basis)
        return curve if basis == curve.basis else replace(curve, basis=basis)

    return edit_curves(design, ids, edited)


@dataclass(frozen=True, eq=False)
class SetMagnitude(Command):
    """Give curves and surfaces, those of meshes too, their magnitude s."""

    values: Mapping[ShapeId, float]

    @property
    def label(self) -> str:
        return self._of("curve")

    def label_in(self, design: Design) -> str:
        return self._of(kind_of(design, self.values))

    def _of(self, noun: str) -> str:
        return "Set s" if len(self.values) == 1 else f"Set s of {many({noun: len(self.values)})}"

    def apply(self, design: Design) -> Design:
        def strong(shape_id: ShapeId, geometry: PlusGeometry) -> PlusGeometry:
            s = float(self.values[shape_id])
            return geometry if s == geometry.s else replace(geometry, s=s)

        def of_mesh(shape_id: ShapeId, surface: MeshSurface) -> MeshSurface:
            s = float(self.values[shape_id])
            return surface if s == surface.s else surface.with_s(s)

        meshes = [i for i in self.values if design[i].mesh is not None]
        design = edit_meshes(design, meshes, of_mesh)
        return edit_shapes(design, [i for i in self.values if i not in meshes], strong)


@dataclass(frozen=True, eq=False)
class ChangeFamily(Command):
    """Blend the same control lines by functions of another family."""

    ids: Ids
    family: str

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Change family of")

    def apply(self, design: Design) -> Design:
        return rebased(design, self.ids, lambda basis: with_family(basis, self.family))


@dataclass(frozen=True, eq=False)
class ChangeOrder(Command):
    """Give B-splines another order; an open one takes at most the number of its lines.

    Knots given before become uniform, since they are as many as the order says.
    """

    ids: Ids
    order: int

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Change order of")

    def apply(self, design: Design) -> Design:
        return rebased(design, self.ids, lambda basis: ordered_basis(basis, self.order))


@dataclass(frozen=True, eq=False)
class SetClosed(Command):
    """Close or open B-spline and RaG curves; knots given before become uniform."""

    ids: Ids
    closed: bool

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Close" if self.closed else "Open")

    def apply(self, design: Design) -> Design:
        return rebased(design, self.ids, lambda basis: closed_basis(basis, self.closed))


@dataclass(frozen=True, eq=False)
class SetBasisField(Command):
    """Set one parameter of a basis by the name of its field, such as "sigma" or "knots"."""

    ids: Ids
    field_name: str
    value: object
    """a number, True or False, a list of numbers, or None for the usual one"""

    @property
    def label(self) -> str:
        return of_curves(self.ids, f"Set {self.field_name.replace('_', ' ')} of")

    def apply(self, design: Design) -> Design:
        value = tuple(self.value) if isinstance(self.value, list) else self.value

        def changed(basis: Basis) -> Basis:
            names = {field.name for field in fields(basis)}  # type: ignore[arg-type]
            if self.field_name not in names - {"size"}:
                raise ValueError(f"a curve of this family has no {self.field_name}")
            return replace(basis, **{self.field_name: value})  # type: ignore[type-var]

        return rebased(design, self.ids, changed)


@dataclass(frozen=True, eq=False)
class CloseSmoothly(Command):
    """Close curves so that the ends run into each other in one direction."""

    ids: Ids

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Smoothly close")

    def apply(self, design: Design) -> Design:
        return edit_curves(design, self.ids, lambda _, curve: closed_smoothly(curve))


@dataclass(frozen=True, eq=False)
class MakeTangent(Command):
    """Let open curves leave and reach their end points along the end lines."""

    ids: Ids
    start: bool = True
    end: bool = True

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Make ends tangent of")

    def apply(self, design: Design) -> Design:
        return edit_curves(
            design,
            self.ids,
            lambda _, curve: tangent_at_ends(curve, start=self.start, end=self.end),
        )


@dataclass(frozen=True, eq=False)
class PassThrough(Command):
    """Change directions as little as makes curves pass through their control points."""

    ids: Ids

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Pass through the points of")

    def apply(self, design: Design) -> Design:
        return edit_curves(design, self.ids, lambda _, curve: passing_through(curve))


@dataclass(frozen=True, eq=False)
class SetView(Command):
    """Keep cameras and overlays with the design."""

    tree: Tree

    @property
    def label(self) -> str:
        return "Change view"

    def apply(self, design: Design) -> Design:
        return design if self.tree == design.view else replace(design, view=self.tree)
