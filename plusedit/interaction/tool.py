"""What a tool is, and what it gets to see."""

from collections.abc import Generator
from dataclasses import dataclass, field
from enum import Flag, auto
from typing import ClassVar, Protocol, TypeAlias

import numpy as np

from plusedit.commands.base import Command
from plusedit.document.design import Design
from plusedit.document.selection import NOTHING_SELECTED, Selection
from plusedit.geometry.arrays import Floats
from plusedit.registry import Registry
from plusedit.scene.camera import Camera
from plusedit.scene.items import Item
from plusedit.scene.options import ViewOptions

REACH = 10.0  # pixels around a dot or grip within which a click takes it


class Held(Flag):
    """Modifier keys."""

    NONE = 0
    SHIFT = auto()
    CTRL = auto()
    ALT = auto()


@dataclass(frozen=True)
class Pointer:
    """Where the mouse is, in pixels to the right and downwards, and what is held or typed."""

    x: float
    y: float
    held: Held = Held.NONE
    typed: tuple[float | None, ...] = ()
    """numbers typed during a drag, by field; None for a field that was left empty. There is one for
    each axis that is seen, and one more, a radius, where `reach` is given"""
    axis: str | None = None
    """"x", "y" or "z" while a drag is locked to that axis, two of them to the plane they span"""
    reach: float | None = None
    """pixels around what is moved within which its neighbors follow; None: they stay"""

    @property
    def at(self) -> Floats:
        """(2,)"""
        return np.array([self.x, self.y])


@dataclass(frozen=True)
class NewCurves:
    """What kind of curve the pen draws."""

    family: str = "bspline"
    order: int = 4
    closed: bool = False


@dataclass(frozen=True)
class Stage:
    """All that a tool may know when a gesture begins."""

    design: Design
    camera: Camera
    selection: Selection = NOTHING_SELECTED
    options: ViewOptions = field(default_factory=ViewOptions)
    new_curves: NewCurves = NewCurves()
    grid_step: float = 1.0
    """what points snap to and arrow keys move by, in units of the design"""


Outcome: TypeAlias = Command | Selection | None
"""What a tool answers with: an edit, another selection, or nothing (yet)."""


@dataclass(frozen=True, eq=False)
class Feedback:
    """What a view shows on top of the design while a tool is at work."""

    items: tuple[Item, ...] = ()
    hint: str = ""
    """what can be done here, and which keys change it: for the status bar"""
    readout: str = ""
    """beside the pointer: numbers of the drag under way, or what one would change"""
    cursor: str = "arrow"
    """"arrow", "cross", "move", "turn", "hand" or "grab" """
    error: str = ""


@dataclass(frozen=True, eq=False)
class Shown:
    """What a drag answers with: an outcome, and what to show with it."""

    outcome: Outcome = None
    feedback: Feedback = Feedback()
    pan: tuple[float, float] = (0.0, 0.0)
    """pixels to the right and downwards by which the view is to shift from where it is"""
    at_end: Command | None = None
    """what is done once the drag is over, if it takes too long to be shown before"""


Drag: TypeAlias = Generator[Shown, Pointer, None]
"""Each command stands for the whole drag so far and replaces the one before; a selection takes
effect at once. A drag that returns before it yields takes nothing and changes nothing."""


class Tool(Protocol):
    """One entry of the shelf `tools`. It reads the stage and answers; it never calls a session.

    Every view makes its own: what a tool remembers between gestures is the view's affair.
    """

    title: ClassVar[str]
    shortcut: ClassVar[str]
    order: ClassVar[int]
    """its place in the tool bar"""

    def drag(self, start: Pointer, stage: Stage) -> Drag:
        """A drag from `start`: first advanced with next(), then sent every further pointer."""
        ...

    def click(self, at: Pointer, stage: Stage) -> Outcome:
        """A press and release in one place."""
        ...

    def double_click(self, at: Pointer, stage: Stage) -> Outcome:
        """The second of two quick clicks; the first was a `click`.

        None: this is a press like any other, of a click or a drag.
        """
        ...

    def hover(self, at: Pointer, stage: Stage) -> Feedback:
        """What a press here would take, shown and said."""
        ...

    def keys(self, stage: Stage) -> frozenset[str]:
        """The keys that mean something to this tool alone now, such as "Enter" to the pen."""
        ...

    def key(self, key: str, stage: Stage) -> Outcome:
        """One of `keys` was pressed."""
        ...

    def reset(self) -> None:
        """A drag was given up, or another tool was chosen: forget what was begun."""
        ...


tools: Registry[type[Tool]] = Registry("plusedit.tools")
"""The tools by name: the classes, whose title, shortcut and order menus and tool bars read."""

register = tools.register
