"""Copies of shapes side by side that differ in s alone, as figure 1 of the paper shows them."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from math import ceil, inf, isfinite

import numpy as np

from plusedit.commands.base import Command, fitted, of_curves, unlocked
from plusedit.commands.naming import stem_of
from plusedit.commands.transform import image
from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.natural import natural_length_of

MOST_NAMED = 4  # shapes: of more only the one in front bears the s of a copy
ROOM = 1.18  # times their size: from one copy to the next
AT = np.linspace(0.0, 1.0, 33)  # where shapes are looked at for their size
RIGHT: Floats = np.array([1.0, 0.0, 0.0])
DOWN: Floats = np.array([0.0, -1.0, 0.0])


@dataclass(frozen=True)
class Magnitude:
    """A value of s, by itself or in units of L, the length of a control polygon."""

    value: float
    is_of_length: bool = True

    @classmethod
    def read(cls, word: str) -> "Magnitude":
        """A number, or a multiple of L such as "0.5L". ValueError for anything else."""
        is_of_length = word.upper().endswith("L")
        number = word[:-1] if is_of_length else word
        try:
            value = float(number) if number or not is_of_length else 1.0
        except ValueError:
            value = inf
        if not isfinite(value):
            raise ValueError(f"expected a number, or a multiple of L such as 0.5L, got {word!r}")
        return cls(value, is_of_length)

    def of(self, geometry: Geometry) -> float:
        """The s that a shape gets; L of a mesh is 1."""
        if self.is_of_length and not isinstance(geometry, MeshSurface):
            return self.value * natural_length_of(geometry)
        return self.value

    @property
    def text(self) -> str:
        """Such as "s = 0.5 L"."""
        value = f"{self.value:g}".replace("-", "\N{MINUS SIGN}")
        if not self.is_of_length or self.value == 0.0:
            return f"s = {value}"
        return "s = L" if self.value == 1.0 else f"s = {value} L"


FIGURE_1 = tuple(Magnitude(share) for share in (0.0, 0.5, 1.0, 1.5))


@dataclass(frozen=True, eq=False)
class Multiply(Command):
    """Put a copy of shapes for each value of s beside them, in rows; the copies are selected."""

    ids: tuple[ShapeId, ...]
    magnitudes: tuple[Magnitude, ...] = FIGURE_1
    aspect: float = inf
    """how many times as wide as high the room for them is; endless: one row"""
    across: Floats = field(default_factory=lambda: RIGHT)
    """(3,) the unit vector from one copy to the next in a row"""
    down: Floats = field(default_factory=lambda: DOWN)
    """(3,) that from one row to the next"""
    in_place: bool = False
    """whether the copies take the place of the shapes"""

    @property
    def label(self) -> str:
        return of_curves(self.ids, "Small multiples of", "shape")

    def apply(self, design: Design) -> Design:
        shapes = {i: unlocked(design, i) for i in self.ids}
        copies = [
            {i: with_s(shape.geometry, magnitude.of(shape.geometry)) for i, shape in shapes.items()}
            for magnitude in self.magnitudes
        ]
        ways = self._ways([geometry for copy in copies for geometry in copy.values()])
        steps = [ROOM * length for length in self._sizes(copies, ways)]
        columns = best_columns(len(copies), self.aspect * steps[1] / steps[0])
        made = design.without(*self.ids) if self.in_place else design
        for place, (magnitude, copy) in enumerate(zip(self.magnitudes, copies, strict=True)):
            row, column = divmod(place, columns)
            column += not self.in_place
            offset = column * steps[0] * ways[0] + row * steps[1] * ways[1]
            for shape_id, geometry in copy.items():
                shape = shapes[shape_id]
                made = made.with_shape(
                    made.unused_id(stem_of(shape_id)),
                    replace(
                        shape,
                        name=self._named(shape_id, shape.name, magnitude),
                        geometry=shifted(geometry, offset),
                        constraints=(),
                    ),
                )
        return made

    def _named(self, shape_id: ShapeId, name: str, magnitude: Magnitude) -> str:
        if len(self.ids) == 1:
            return magnitude.text
        if self.in_place and len(self.ids) > MOST_NAMED:
            return magnitude.text if shape_id == self.ids[-1] else ""
        return f"{name}, {magnitude.text}"

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return Selection.of_shapes(shape_id for shape_id in new if shape_id not in old)

    def _ways(self, geometries: Iterable[Geometry]) -> tuple[Floats, Floats]:
        """Across and down, both in the plane where a shape can't leave it."""
        if any(geometry.dimension == 2 for geometry in geometries):
            return RIGHT, DOWN
        return self.across, self.down

    def _sizes(
        self, copies: Sequence[dict[ShapeId, Geometry]], ways: tuple[Floats, Floats]
    ) -> list[float]:
        """How wide and how high the largest copy is."""
        sizes = []
        for way in ways:
            along = [
                np.concatenate([points_of(geometry) @ way for geometry in copy.values()])
                for copy in copies
            ]
            sizes.append(max(float(np.ptp(each)) for each in along))
        largest = max(sizes)
        return [size or largest for size in sizes]


def best_columns(count: int, aspect: float) -> int:
    """In how many columns so many cells are largest, in room for so many times as many of them
    beside each other as below each other."""

    def size(columns: int) -> float:
        return min(aspect / columns, 1.0 / ceil(count / columns))

    return max(range(1, count + 1), key=lambda columns: (size(columns), columns))


def with_s(geometry: Geometry, s: float) -> Geometry:
    """The shape with another s."""
    if isinstance(geometry, MeshSurface):
        return geometry.with_s(s)
    return replace(geometry, s=s)


def shifted(geometry: Geometry, offset: Floats) -> Geometry:
    """The shape moved by a vector (3,)."""
    if isinstance(geometry, MeshSurface):
        return geometry.transformed(np.eye(3), offset)
    rows = list(range(len(geometry.net)))
    dimension = geometry.dimension
    return image(geometry, rows, np.eye(dimension), fitted(offset, dimension))


def points_of(geometry: Geometry) -> Floats:
    """(m, 3) control points and points of a shape, which tell its size."""
    if isinstance(geometry, MeshSurface):
        return geometry.mesh.vertices
    points = geometry.net.control_points
    if isinstance(geometry, PlusCurve):
        found = np.concatenate([points, geometry.at(AT)])
    else:
        found = np.concatenate([points, geometry.at(AT, AT).reshape(-1, 3)])
    if found.shape[1] == 2:
        found = np.column_stack([found, np.zeros(len(found))])
    return found
