"""A shape of a design: geometry, and what the outliner says of it."""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import inf
from types import MappingProxyType
from typing import NewType, TypeAlias

from plusedit.geometry.constraints import Wish
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface

ShapeId = NewType("ShapeId", str)
Json: TypeAlias = "Mapping[str, Json] | list[Json] | str | float | int | bool | None"
Tree: TypeAlias = Mapping[str, Json]

NOTHING: Tree = MappingProxyType({})
COLOR = re.compile("#[0-9a-fA-F]{6}", re.ASCII)


PlusGeometry: TypeAlias = PlusCurve | PlusSurface
"""What is drawn from control lines or a grid of control planes alone."""

Geometry: TypeAlias = PlusCurve | PlusSurface | MeshSurface
"""What has a net of control elements that can be edited: lines, planes, planes of faces."""


@dataclass(frozen=True)
class Style:
    """How a curve is drawn; None leaves it to the theme."""

    color: str | None = None
    """"#rrggbb" """
    width: float | None = None
    """of the stroke, in logical pixels"""
    facets: bool = False
    """whether the 3D view shows a mesh itself, with flat faces, and not its surface"""

    def __post_init__(self) -> None:
        if self.color is not None and not COLOR.fullmatch(self.color):
            raise ValueError(f'color: expected "#rrggbb", got {json.dumps(self.color):.40}')
        if self.width is not None and not 0.0 <= self.width < inf:
            raise ValueError(f"width: expected a number of pixels, got {self.width}")


@dataclass(frozen=True, eq=False)
class Shape:
    """One shape of a design; an immutable value, compared by identity."""

    geometry: Geometry
    name: str
    visible: bool = True
    locked: bool = False
    style: Style = Style()
    extra: Tree = field(default_factory=lambda: NOTHING)
    """keys of the file that this program does not know; nested under "basis" and "style" too"""
    constraints: tuple[Wish, ...] = ()
    """what a curve or surface keeps while anything else about it is edited"""

    @property
    def curve(self) -> PlusCurve | None:
        """The curve, or None where the shape is of another kind."""
        return self.geometry if isinstance(self.geometry, PlusCurve) else None

    @property
    def surface(self) -> PlusSurface | None:
        """The surface, or None where the shape is of another kind."""
        return self.geometry if isinstance(self.geometry, PlusSurface) else None

    @property
    def mesh(self) -> MeshSurface | None:
        """The surface of a polygon mesh, or None where the shape is of another kind."""
        return self.geometry if isinstance(self.geometry, MeshSurface) else None

    @property
    def plus(self) -> PlusGeometry | None:
        """The curve or surface with a control net; None where the shape is a mesh."""
        return None if isinstance(self.geometry, MeshSurface) else self.geometry

    @property
    def element_count(self) -> int:
        """How many control lines, control planes or faces it has."""
        if isinstance(self.geometry, MeshSurface):
            # Its net has as many, but would have to be worked out.
            return self.geometry.mesh.face_count
        return len(self.geometry.net)

    @property
    def editable(self) -> bool:
        """Whether its geometry may be changed: it is seen and not locked."""
        return self.visible and not self.locked

    def with_curve(self, curve: PlusCurve) -> "Shape":
        """The same shape with another curve."""
        return replace(self, geometry=curve)

    def with_plus(self, geometry: PlusGeometry) -> "Shape":
        """The same shape with another curve or surface."""
        return replace(self, geometry=geometry)

    def with_mesh(self, mesh: MeshSurface) -> "Shape":
        """The same shape with another surface of a mesh."""
        return replace(self, geometry=mesh)
