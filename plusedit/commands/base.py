"""What every command is made of."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass

from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import ShapeId

Targets = Mapping[ShapeId, tuple[int, ...]]
"""Indices of control lines by shape, as `Selection.targets` gives them."""


class Command(ABC):
    """An edit that knows its name, and what is selected after it. It has no undo: history does."""

    @property
    @abstractmethod
    def label(self) -> str:
        """What the Undo menu says, such as "Rotate 3 control lines"."""

    @abstractmethod
    def apply(self, design: Design) -> Design:
        """The edited design. EditError if it can't be done."""

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        """What is selected once the edit is committed: what was, as far as it is still there."""
        return selection.cut_to(new)


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

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        for command in self.commands:
            selection = command.reselect(selection, old, new)
        return selection.cut_to(new)


def counted(targets: Targets, verb: str, noun: str = "control line") -> str:
    """Such as "Move control line" or "Move 3 control lines"."""
    count = sum(len(indices) for indices in targets.values())
    return f"{verb} {noun}" if count == 1 else f"{verb} {count} {noun}s"
