"""What is selected: shapes, and control lines or planes of them. Not a part of the design.

The faces of a mesh are control planes here as those of a surface are. There may be many thousands.
"""

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design
from plusedit.document.shape import ShapeId


class LineId(NamedTuple):
    """A control line, or a control plane, by the id of its shape and its number there."""

    shape: ShapeId
    number: int
    """counted from 0; plane (i, j) of a surface has the number i * n_v + j, that of a mesh the
    number of its face"""


@dataclass(frozen=True)
class Selection:
    """Selected control lines, and the shapes that are selected with or without lines of theirs."""

    lines: frozenset[LineId] = frozenset()
    shapes: frozenset[ShapeId] = frozenset()
    """those of `lines` always among them"""
    active: LineId | None = None
    """the line that was selected last, one of `lines`; numbers typed in speak of it"""

    def __post_init__(self) -> None:
        # Taken apart and not asked for by name, which for many thousands of faces takes its time.
        shapes = self.shapes | {shape_id for shape_id, _ in self.lines}
        object.__setattr__(self, "shapes", frozenset(shapes))
        if self.active not in self.lines:
            object.__setattr__(self, "active", None)

    @classmethod
    def of_lines(cls, lines: Iterable[LineId], active: LineId | None = None) -> "Selection":
        """Those control lines; a single one is active."""
        chosen = frozenset(lines)
        if len(chosen) == 1:
            active = next(iter(chosen))
        return cls(chosen, active=active)

    @classmethod
    def of_shapes(cls, shapes: Iterable[ShapeId]) -> "Selection":
        """Those shapes as wholes, none of their control lines."""
        return cls(shapes=frozenset(shapes))

    def __bool__(self) -> bool:
        return bool(self.shapes)

    def __or__(self, other: "Selection") -> "Selection":
        return Selection(self.lines | other.lines, self.shapes | other.shapes, other.active)

    def toggled(self, line: LineId) -> "Selection":
        """With `line` added, or taken out if it was in."""
        if line in self.lines:
            return Selection(self.lines - {line}, self.shapes)
        return Selection(self.lines | {line}, self.shapes, line)

    def toggled_shape(self, shape_id: ShapeId) -> "Selection":
        """With a shape added as a whole, or taken out with all lines of it."""
        if shape_id not in self.shapes:
            return Selection(self.lines, self.shapes | {shape_id}, self.active)
        lines = frozenset(line for line in self.lines if line.shape != shape_id)
        return Selection(lines, self.shapes - {shape_id}, self.active)

    def by_shape(self) -> Mapping[ShapeId, tuple[int, ...]]:
        """The indices of the selected lines, rising, for each shape that has some."""
        return self._by_shape

    @cached_property
    def _by_shape(self) -> Mapping[ShapeId, tuple[int, ...]]:
        found: dict[ShapeId, list[int]] = defaultdict(list)
        for shape_id, number in self.lines:
            found[shape_id].append(number)
        return MappingProxyType(
            {shape_id: tuple(sorted(indices)) for shape_id, indices in sorted(found.items())}
        )

    @cached_property
    def leading(self) -> LineId | None:
        """The active line, else the first of all selected ones; None where there is none."""
        return self.active or min(self.lines, default=None)

    def targets(self, design: Design) -> Mapping[ShapeId, tuple[int, ...]]:
        """What an edit of control lines acts on, by shape, in editable shapes only.

        The selected lines; where a shape is selected without any line, all lines of it, but of a
        mesh none: it is meant as a whole.
        """
        lines = self.by_shape()
        found: dict[ShapeId, tuple[int, ...]] = {}
        for shape_id in design:
            if shape_id in self.shapes and design[shape_id].editable:
                shape = design[shape_id]
                count = 0 if shape.mesh is not None else shape.element_count
                found[shape_id] = lines.get(shape_id, tuple(range(count)))
        return found

    def renumbered(self, old_numbers: Mapping[ShapeId, NDArray[np.intp]]) -> "Selection":
        """The same lines under other numbers; those that are no longer there are left out.

        For every shape whose lines were renumbered, the old number of each line that it has now.
        """
        there = {
            LineId(shape_id, old): LineId(shape_id, new)
            for shape_id, numbers in old_numbers.items()
            for new, old in enumerate(numbers.tolist())
        }
        lines = frozenset(
            there.get(line, line)
            for line in self.lines
            if line in there or line.shape not in old_numbers
        )
        active = self.active
        if active is not None and active.shape in old_numbers:
            active = there.get(active)
        return Selection(lines, self.shapes, active)

    def cut_to(self, design: Design) -> "Selection":
        """Without what the design does not have; itself if nothing goes."""
        counts = {i: design[i].element_count for i in self.shapes if i in design}
        if len(counts) == len(self.shapes) and all(
            numbers[-1] < counts[shape_id] for shape_id, numbers in self._by_shape.items()
        ):
            return self
        lines = frozenset(line for line in self.lines if line.number < counts.get(line.shape, 0))
        shapes = frozenset(counts)
        return Selection(lines, shapes, self.active)


NOTHING_SELECTED = Selection()
