"""The drag under way."""

from dataclasses import dataclass, replace

import numpy as np

from plusedit.commands.base import Command
from plusedit.document.selection import Selection
from plusedit.interaction.places import seen_axes
from plusedit.interaction.snapping import AXES
from plusedit.interaction.tool import Drag, Held, Pointer, Shown, Stage
from plusedit.interaction.typed import NOTHING_TYPED, Typed
from plusedit.scene.camera import Camera, PlaneCamera

LOCKS = ("X", "Y", "Z")
SOFT = "O"  # takes neighbors along, or leaves them
NARROWER, WIDER = "[", "]"  # of how far that reaches
PACE = 1.2  # by which it grows
USUAL_REACH = 120.0  # pixels
SHORTEST, LONGEST = 5.0, 5000.0  # pixels


@dataclass(eq=False)
class Running:
    """A drag, what it began with, and what has been said to it so far."""

    drag: Drag
    stage: Stage
    modal: bool
    """begun by a key: it follows the pointer without a button, and a press accepts it"""
    pointer: Pointer
    selection: Selection
    """what was selected before"""
    reach: float = USUAL_REACH
    """of a soft move, in pixels"""
    command: Command | None = None
    """the last one that could be shown"""
    typed: Typed = NOTHING_TYPED
    axis: str | None = None
    soft: bool = False
    pans: bool = False
    """whether it is the drag itself that moves the view"""

    def __post_init__(self) -> None:
        self._count_fields()

    def answer(self, to: Pointer, camera: Camera) -> Shown:
        """What the drag says to a pointer, seen by the camera there is now."""
        self.pointer = to
        reach = self.reach if self.soft else None
        said = replace(to, typed=self.typed.values, axis=self.axis, reach=reach)
        return self.drag.send(self._as_at_start(said, camera))

    def takes(self, key: str, held: Held = Held.NONE) -> bool:
        """Lock or free axes, take neighbors along, or go on with a number; false for other keys."""
        if key in LOCKS:
            self._lock(key.lower(), across=Held.SHIFT in held)
            return True
        if key == SOFT:
            self.soft = not self.soft
            self._count_fields()
            return True
        if key in (NARROWER, WIDER):
            return self.widen(-1.0 if key == NARROWER else 1.0)
        typed = self.typed.after(key)
        if typed is not None:
            self.typed = typed
        return typed is not None

    def widen(self, steps: float) -> bool:
        """Let a soft move reach farther, or less far; false if it is none."""
        if self.soft:
            self.reach = float(np.clip(self.reach * PACE**steps, SHORTEST, LONGEST))
        return self.soft

    def _lock(self, axis: str, *, across: bool) -> None:
        axes = "".join(name for name in AXES if name != axis) if across else axis
        self.axis = None if self.axis == axes else axes

    def _count_fields(self) -> None:
        count = len(seen_axes(self.stage.camera)) + (1 if self.soft else 0)
        self.typed = self.typed.of_fields(count)

    def _as_at_start(self, to: Pointer, camera: Camera) -> Pointer:
        """The pointer over the same place of the world, as the camera saw it at the start.

        So that a drag may go on while the wheel zooms or the view is panned. In space no place of
        the world is meant: there the pointer stays where it is.
        """
        start = self.stage.camera
        if self.pans or camera == start or not isinstance(start, PlaneCamera):
            return to
        x, y = start.to_screen(camera.to_world(to.at, np.zeros(3))[None])[0]
        return replace(to, x=float(x), y=float(y))


def means_something(key: str) -> bool:
    """Whether a drag has a use for the key."""
    own = ("Enter", "Escape", SOFT, NARROWER, WIDER, *LOCKS)
    return key in own or NOTHING_TYPED.after(key) is not None
