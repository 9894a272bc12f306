"""Areas, lines and marks that are drawn after each other, each kind at once."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TypeAlias

from plusedit.scene.items import Item, Mesh, Patch, Polygon, Polyline, Segments, Words
from plusedit.scene.space_camera import SpaceCamera
from plusedit.views.gl.batches import Batch, Fills, Lines, Marks
from plusedit.views.gl.colors import Palette
from plusedit.views.gl.sight import Box, Sight

Kinds: TypeAlias = tuple[list[Item], list[Item], list[Item]]
"""Areas; lines, with the outlines of areas; marks"""


@dataclass(eq=False)
class Group:
    """Areas, lines and marks that are drawn after each other, each kind at once."""

    fills: Fills
    lines: Lines
    marks: Marks

    @property
    def batches(self) -> tuple[Batch, Batch, Batch]:
        """In the order in which they are drawn."""
        return self.fills, self.lines, self.marks

    def show(self, items: Kinds, palette: Palette, camera: SpaceCamera) -> None:
        """Hold those areas, lines and marks."""
        for batch, kind in zip(self.batches, items, strict=True):
            batch.show(kind, palette, camera)

    def boxes(self) -> Iterator[Box]:
        """What the batches lie in."""
        for batch in self.batches:
            if batch.box is not None:
                yield batch.box

    def draw(self, sight: Sight, opacity: float = 1.0) -> None:
        """Draw all of it."""
        for batch in self.batches:
            batch.draw(sight, opacity)

    def release(self) -> None:
        """Free it."""
        for batch in self.batches:
            batch.release()


def _rank(item: Item) -> int:
    match item:
        case Polygon():
            return 0
        case Polyline() | Segments():
            return 1
        case _:
            return 2


def by_kind(items: Iterable[Item]) -> Kinds:
    """Areas; lines, with the outlines of areas; marks."""
    kinds: Kinds = ([], [], [])
    for item in items:
        kinds[_rank(item)].append(item)
    kinds[1][:0] = kinds[0]
    return kinds


def runs_of(items: Iterable[Item]) -> Iterator[Kinds]:
    """Groups of items whose order allows areas, lines and marks to be drawn at once each."""
    run: list[Item] = []
    for item in items:
        if isinstance(item, Patch | Mesh | Words):
            continue
        if run and _rank(item) < _rank(run[-1]):
            yield by_kind(run)
            run = []
        run.append(item)
    if run:
        yield by_kind(run)
