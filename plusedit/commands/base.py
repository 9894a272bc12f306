"""What every command is made of."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from plusedit.document.constraining import OldNumbers
from plusedit.document.design import Design, EditError
from plusedit.document.selection import Selection
from plusedit.document.shape import Geometry, PlusGeometry, Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.net import ControlNet
from plusedit.geometry.surface import PlusSurface, Way

Kind = TypeVar("Kind", bound=Geometry)

Targets = Mapping[ShapeId, tuple[int, ...]]
"""Numbers of control lines and planes by shape, as `Selection.targets` gives them.

A mesh without any number is meant as a whole; with numbers the planes of those faces are.
"""

Side: TypeAlias = Literal["both", "u", "v"]
"""Which directions of a control plane are meant; a control line has only one, always meant."""


@dataclass(frozen=True, eq=False)
class Landing:
    """Where one of the points or directions that are edited comes to stand, free of rounding."""

    shape_id: ShapeId
    number: int
    vector: Floats
    """(dim,) the control point or direction then"""
    way: Way = "u"
    """of a control plane: which of its two directions"""


class Command(ABC):
    """An edit that knows its name, and what is selected after it. It has no undo: history does."""

    @property
    @abstractmethod
    def label(self) -> str:
        """What the Undo menu says, such as "Rotate 3 control lines"."""

    def label_in(self, design: Design) -> str:
        """The label in the words that fit the shapes of the design before the edit."""
        return self.label

    @abstractmethod
    def apply(self, design: Design) -> Design:
        """The edited design, or the very same one where nothing changes.

        EditError if it can't be done.
        """

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        """For shapes whose control lines or planes got other numbers, the old number of each."""
        return {}

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        """What is selected once the edit is committed: what was, as far as it is still there."""
        return selection.cut_to(new)


@dataclass(frozen=True, eq=False)
class NetCommand(Command):
    """An edit of some control lines and control planes."""

    targets: Targets

    @property
    @abstractmethod
    def verb(self) -> str:
        """What is done, such as "Rotate"."""

    @property
    def label(self) -> str:
        return counted(self.targets, self.verb)

    def label_in(self, design: Design) -> str:
        return f"{self.verb} {named(design, self.targets)}"


@dataclass(frozen=True)
class Together(Command):
    """Several edits as one step, done in order."""

    name: str
    commands: tuple[Command, ...]

    @property
    def label(self) -> str:
        return self.name

    def apply(self, design: Design) -> Design:
        for command in self.commands:
            design = command.apply(design)
        return design

    def old_numbers(self, old: Design, new: Design) -> OldNumbers:
        found: dict[ShapeId, NDArray[np.intp]] = {}
        for command in self.commands:
            between = command.apply(old)
            for shape_id, numbers in command.old_numbers(old, between).items():
                first = found.get(shape_id)
                through = numbers if first is None else np.append(first, -1)[numbers]
                found[shape_id] = through
            old = between
        return found

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        for command in self.commands:
            between = command.apply(old)
            selection = command.reselect(selection, old, between)
            old = between
        return selection.cut_to(new)


def counted(targets: Targets, verb: str, noun: str = "control line") -> str:
    """Such as "Move control line" or "Move 3 control lines"."""
    count = sum(len(rows) for rows in targets.values())
    return f"{verb} {many({noun: count})}"


def named(design: Design, targets: Targets) -> str:
    """Such as "3 control planes", or "control line and 2 control planes"."""
    counts = {"control line": 0, "control plane": 0, "mesh": 0}
    for shape_id, rows in targets.items():
        shape = design.shapes.get(shape_id)
        if shape is not None and shape.mesh is not None and not rows:
            counts["mesh"] += 1
        else:
            has_planes = shape is not None and shape.curve is None
            counts["control plane" if has_planes else "control line"] += len(rows)
    return many(counts)


def many(counts: Mapping[str, int]) -> str:
    """How many of each, by their names in the singular, such as "row and 2 columns"."""
    parts = [
        noun if count == 1 else f"{count} {noun}{'es' if noun.endswith('sh') else 's'}"
        for noun, count in counts.items()
        if count
    ]
    return " and ".join(parts) or f"0 {next(iter(counts))}s"


def of_curves(ids: Iterable[ShapeId], verb: str, noun: str = "curve") -> str:
    """Such as "Reverse curve" or "Reverse 3 curves"."""
    return f"{verb} {many({noun: len(tuple(ids))})}"


def kind_of(design: Design, ids: Iterable[ShapeId]) -> str:
    """What those shapes are: "curve", "surface", "mesh", or "shape" where they differ."""
    kinds = {
        kind_of_shape(shape)
        for shape_id in ids
        if (shape := design.shapes.get(shape_id)) is not None
    }
    return kinds.pop() if len(kinds) == 1 else "shape"


def kind_of_shape(shape: Shape) -> str:
    """ "curve", "surface" or "mesh"."""
    return "curve" if shape.curve is not None else "mesh" if shape.mesh is not None else "surface"


def edit_shapes(
    design: Design, ids: Iterable[ShapeId], edit: Callable[[ShapeId, PlusGeometry], PlusGeometry]
) -> Design:
    """`edit_geometries` of curves and surfaces: EditError where a shape is of another kind."""
    return edit_geometries(design, ids, design.plus, edit)


def edit_geometries(
    design: Design,
    ids: Iterable[ShapeId],
    geometry_of: Callable[[ShapeId], Kind],
    edit: Callable[[ShapeId, Kind], Kind],
) -> Design:
    """The design with `edit` done to every shape named; the same design if it changes none.

    All or nothing. EditError where a shape is locked, hidden or missing, and what `geometry_of`
    raises where it is of another kind; a ValueError of `edit` becomes an EditError that names the
    shape.
    """
    found: dict[ShapeId, Shape] = {}
    for shape_id in ids:
        shape, geometry = unlocked(design, shape_id), geometry_of(shape_id)
        try:
            edited = edit(shape_id, geometry)
        except EditError:
            raise
        except ValueError as error:
            raise EditError(f"{shape.name}: {error}") from error
        if edited is not geometry:
            found[shape_id] = replace(shape, geometry=edited)
    return with_shapes(design, found)


def edit_curves(
    design: Design, ids: Iterable[ShapeId], edit: Callable[[ShapeId, PlusCurve], PlusCurve]
) -> Design:
    """`edit_shapes` of curves only: EditError where a shape is of another kind."""
    return edit_shapes(design, ids, lambda shape_id, _: edit(shape_id, design.curve(shape_id)))


def edit_surfaces(
    design: Design, ids: Iterable[ShapeId], edit: Callable[[ShapeId, PlusSurface], PlusSurface]
) -> Design:
    """`edit_shapes` of surfaces only: EditError where a shape is of another kind."""
    return edit_shapes(design, ids, lambda shape_id, _: edit(shape_id, design.surface(shape_id)))


def with_shapes(design: Design, shapes: Mapping[ShapeId, Shape]) -> Design:
    """The design with those shapes in place of theirs, or in front; itself if there are none."""
    return replace(design, shapes={**design.shapes, **shapes}) if shapes else design


def unlocked(design: Design, shape_id: ShapeId) -> Shape:
    """The shape of that id. EditError if there is none, or it is locked or hidden."""
    shape = design[shape_id]
    if shape.locked:
        raise EditError(f"{shape.name} is locked")
    if not shape.visible:
        raise EditError(f"{shape.name} is hidden")
    return shape


def edit_nets(
    design: Design,
    targets: Targets,
    edit: Callable[[ShapeId, Geometry, list[int]], ControlNet],
) -> Design:
    """The design with `edit` done to the named control lines and planes.

    `edit` gets the geometry and the numbers meant, all faces of a mesh that is meant as a whole,
    and gives its new net, or the very net it has where nothing changes. EditError as in
    `edit_shapes`, and where a number is missing.
    """

    def edited(shape_id: ShapeId, geometry: Geometry) -> Geometry:
        rows = rows_meant(design, shape_id, targets[shape_id])
        if not rows:
            return geometry
        before = geometry.net
        net = edit(shape_id, geometry, rows)
        return geometry if net is before else geometry.with_net(net)

    return edit_geometries(design, targets, lambda i: design[i].geometry, edited)


def rows_meant(design: Design, shape_id: ShapeId, rows: Collection[int]) -> list[int]:
    """The numbers given; for none of a mesh those of all its faces. EditError if one is missing."""
    shape = design[shape_id]
    count = shape.element_count
    if not rows and shape.mesh is not None:
        return list(range(count))
    if rows and (min(rows) < 0 or max(rows) >= count):
        missing = next(row for row in rows if not 0 <= row < count)
        noun = "plane" if shape.curve is None else "line"
        raise EditError(f"{shape.name} has no control {noun} {missing + 1}")
    return list(rows)


def ways_of(geometry: Geometry, side: Side) -> Iterator[int]:
    """The indices k of the directions `vectors[k]` that are meant."""
    if isinstance(geometry, PlusCurve):
        yield 0
        return
    if side != "v":
        yield 0
    if side != "u":
        yield 1


def fitted(vector: Floats, dimension: int) -> Floats:
    """`vector` with as many numbers as `dimension` says: zeros added, or the last left out."""
    result = np.zeros(dimension)
    count = min(dimension, len(vector))
    result[:count] = vector[:count]
    return result


def fitted_matrix(matrix: Floats, dimension: int) -> Floats:
    """`matrix` with as many rows and columns as `dimension` says: of the identity, or left out."""
    result = np.eye(dimension)
    count = min(dimension, len(matrix))
    result[:count, :count] = matrix[:count, :count]
    return result
