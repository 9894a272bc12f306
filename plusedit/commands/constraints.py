"""Edits of what shapes keep while anything else about them is edited."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from plusedit.commands.base import Command, kind_of, many, unlocked, with_shapes
from plusedit.document.design import Design, EditError
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.constraints import Wish, constraints
from plusedit.geometry.keeping import kept

Wishes = Mapping[ShapeId, Wish]


@dataclass(frozen=True, eq=False)
class Constrain(Command):
    """Let shapes keep a constraint from now on, in place of one of the same kind.

    EditError, with what would make it possible, where a shape can't keep it.
    """

    wishes: Wishes

    @property
    def label(self) -> str:
        return self._of("shape")

    def label_in(self, design: Design) -> str:
        return self._of(kind_of(design, self.wishes))

    def _of(self, noun: str) -> str:
        titles = {constraints[wish.kind].title for wish in self.wishes.values()}
        what = titles.pop() if len(titles) == 1 else "Constraints"
        return f"{what}: {many({noun: len(self.wishes)})}"

    def apply(self, design: Design) -> Design:
        found: dict[ShapeId, Shape] = {}
        for shape_id, wish in self.wishes.items():
            shape = unlocked(design, shape_id)
            geometry = shape.plus
            if geometry is None or not constraints[wish.kind].takes(geometry):
                raise EditError(f"{shape.name}: {constraints[wish.kind].title} is not for it")
            wishes = (*(w for w in shape.constraints if w.kind != wish.kind), wish)
            keeping = kept(geometry, wishes)
            if wish in keeping.problems:
                raise EditError(f"{shape.name}: {keeping.problems[wish]}")
            if wish not in shape.constraints:
                found[shape_id] = replace(shape, constraints=wishes)
        return with_shapes(design, found)


@dataclass(frozen=True, eq=False)
class Release(Command):
    """Let shapes no longer keep constraints of one kind; they stay as they are now."""

    ids: tuple[ShapeId, ...]
    kind: str

    @property
    def label(self) -> str:
        return f"Release: {constraints[self.kind].title}"

    def apply(self, design: Design) -> Design:
        found: dict[ShapeId, Shape] = {}
        for shape_id in self.ids:
            shape = unlocked(design, shape_id)
            left = tuple(wish for wish in shape.constraints if wish.kind != self.kind)
            if left != shape.constraints:
                found[shape_id] = replace(shape, constraints=left)
        return with_shapes(design, found)
