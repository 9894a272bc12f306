"""Designs: ordered, immutable collections of shapes.

An edit makes a new design that shares every shape it did not touch, so `old[id] is new[id]`
means "unchanged": no flags, no signals for single properties.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from plusedit.document.shape import NOTHING, PlusGeometry, Shape, ShapeId, Tree
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface


class EditError(ValueError):
    """An edit that can't be done, in words fit for the person who asked for it."""


@dataclass(frozen=True, eq=False)
class Design:
    """Shapes by id, in the order of drawing: back to front."""

    shapes: Mapping[ShapeId, Shape] = field(default_factory=dict)
    view: Tree = field(default_factory=lambda: NOTHING)
    """what the file keeps of cameras and overlays; never needed to understand the shapes"""
    extra: Tree = field(default_factory=lambda: NOTHING)
    """keys of the file that this program does not know"""

    def __post_init__(self) -> None:
        object.__setattr__(self, "shapes", MappingProxyType(dict(self.shapes)))

    def __getitem__(self, shape_id: ShapeId) -> Shape:
        """The shape of that id. EditError if there is none."""
        try:
            return self.shapes[shape_id]
        except KeyError:
            raise EditError(f"there is no shape {shape_id!r}") from None

    def __contains__(self, shape_id: object) -> bool:
        return shape_id in self.shapes

    def __iter__(self) -> Iterator[ShapeId]:
        return iter(self.shapes)

    def __len__(self) -> int:
        return len(self.shapes)

    def curve(self, shape_id: ShapeId) -> PlusCurve:
        """The curve of that shape. EditError if there is none."""
        curve = self[shape_id].curve
        if curve is None:
            raise EditError(f"{self[shape_id].name} is not a curve")
        return curve

    def surface(self, shape_id: ShapeId) -> PlusSurface:
        """The surface of that shape. EditError if there is none."""
        surface = self[shape_id].surface
        if surface is None:
            raise EditError(f"{self[shape_id].name} is not a surface")
        return surface

    def mesh(self, shape_id: ShapeId) -> MeshSurface:
        """The surface of the mesh of that shape. EditError if there is none."""
        mesh = self[shape_id].mesh
        if mesh is None:
            raise EditError(f"{self[shape_id].name} is not a mesh")
        return mesh

    def plus(self, shape_id: ShapeId) -> PlusGeometry:
        """The curve or surface with a control net of that shape. EditError if there is none."""
        geometry = self[shape_id].plus
        if geometry is None:
            raise EditError(f"{self[shape_id].name} is a mesh: it has no control net")
        return geometry

    def curves(self) -> Iterator[tuple[ShapeId, PlusCurve]]:
        """Every curve with its id, back to front."""
        for shape_id, shape in self.shapes.items():
            if shape.curve is not None:
                yield shape_id, shape.curve

    def surfaces(self) -> Iterator[tuple[ShapeId, PlusSurface]]:
        """Every surface with its id, back to front."""
        for shape_id, shape in self.shapes.items():
            if shape.surface is not None:
                yield shape_id, shape.surface

    def meshes(self) -> Iterator[tuple[ShapeId, MeshSurface]]:
        """Every surface of a mesh with its id, back to front."""
        for shape_id, shape in self.shapes.items():
            if shape.mesh is not None:
                yield shape_id, shape.mesh

    def drawn(self) -> Iterator[tuple[ShapeId, PlusGeometry]]:
        """Every curve and surface with a control net with its id, back to front."""
        for shape_id, shape in self.shapes.items():
            if shape.plus is not None:
                yield shape_id, shape.plus

    @property
    def is_spatial(self) -> bool:
        """Whether it has surfaces, meshes, or curves of space."""
        return any(
            shape.plus is None or shape.plus.dimension == 3 for shape in self.shapes.values()
        )

    def with_shape(self, shape_id: ShapeId, shape: Shape) -> "Design":
        """The design with that shape in place of the one of that id, or in front of all."""
        return replace(self, shapes={**self.shapes, shape_id: shape})

    def with_curve(self, shape_id: ShapeId, curve: PlusCurve) -> "Design":
        """The design with other geometry for one shape. EditError if it is locked or hidden."""
        shape = self[shape_id]
        if not shape.editable:
            state = "locked" if shape.locked else "hidden"
            raise EditError(f"{shape.name} is {state}")
        return self.with_shape(shape_id, shape.with_curve(curve))

    def edited(self, shape_id: ShapeId, edit: Callable[[PlusCurve], PlusCurve]) -> "Design":
        """The design with `edit` done to one curve; its ValueError becomes an EditError."""
        try:
            return self.with_curve(shape_id, edit(self.curve(shape_id)))
        except EditError:
            raise
        except ValueError as error:
            raise EditError(f"{self[shape_id].name}: {error}") from error

    def without(self, *shape_ids: ShapeId) -> "Design":
        """The design without those shapes."""
        gone = set(shape_ids)
        return replace(self, shapes={i: s for i, s in self.shapes.items() if i not in gone})

    def ordered(self, shape_ids: list[ShapeId]) -> "Design":
        """The same shapes in that order. EditError if it names others, or not all."""
        if set(shape_ids) != set(self.shapes) or len(shape_ids) != len(self.shapes):
            raise EditError("an order has to name every shape once")
        return replace(self, shapes={i: self.shapes[i] for i in shape_ids})

    def unused_id(self, stem: str) -> ShapeId:
        """`stem`, or `stem-2`, `stem-3`, ... : the first that no shape has."""
        if stem not in self.shapes:
            return ShapeId(stem)
        number = 2
        while f"{stem}-{number}" in self.shapes:
            number += 1
        return ShapeId(f"{stem}-{number}")


def changed(old: Design, new: Design) -> set[ShapeId]:
    """The ids of the shapes that came, went or are another object; order is not looked at."""
    return {i for i in {*old, *new} if old.shapes.get(i) is not new.shapes.get(i)}
