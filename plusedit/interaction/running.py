"""The drag under way."""

from dataclasses import dataclass, replace

import numpy as np

from plusedit.commands.base import Command
from plusedit.document.selection import Selection
from plusedit.interaction.tool import Drag, Pointer, Shown, Stage
from plusedit.interaction.typed import NOTHING_TYPED, Typed
from plusedit.scene.camera import Camera

AXES = ("X", "Y", "Z")


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
    command: Command | None = None
    """the last one that could be shown"""
    typed: Typed = NOTHING_TYPED
    axis: str | None = None
    pans: bool = False
    """whether it is the drag itself that moves the view"""

    def answer(self, to: Pointer, camera: Camera) -> Shown:
        """What the drag says to a pointer, seen by the camera there is now."""
        self.pointer = to
        said = replace(to, typed=self.typed.values, axis=self.axis)
        return self.drag.send(self._as_at_start(said, camera))

    def takes(self, key: str) -> bool:
        """Lock or free an axis, or go on with a number; false for any other key."""
        if key in AXES:
            self.axis = None if self.axis == key.lower() else key.lower()
            return True
        typed = self.typed.after(key)
        if typed is not None:
            self.typed = typed
        return typed is not None

    def _as_at_start(self, to: Pointer, camera: Camera) -> Pointer:
        """The pointer over the same place of the world, as the camera saw it at the start.

        So that a drag may go on while the wheel zooms or the view is panned.
        """
        start = self.stage.camera
        if self.pans or camera == start:
            return to
        x, y = start.to_screen(camera.to_world(to.at, np.zeros(3))[None])[0]
        return replace(to, x=float(x), y=float(y))


def means_something(key: str) -> bool:
    """Whether a drag has a use for the key."""
    return key in ("Enter", "Escape", *AXES) or NOTHING_TYPED.after(key) is not None
