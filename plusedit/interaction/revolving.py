"""Angles about an axis in space that follow the pointer."""

from math import atan2, radians, sin

import numpy as np

from plusedit.commands.directions import quarter_exact
from plusedit.geometry.arrays import Floats
from plusedit.interaction.ball import frame_at
from plusedit.interaction.swing import DEAD, Swing
from plusedit.scene.camera import Camera
from plusedit.scene.gizmo import across

EDGE_ON = sin(radians(15.0))  # a ring seen flatter turns by the pointer's angle on the screen
DEAD_IN_SPACE = 2.0 * DEAD  # a ring at a slant is crossed faster than one that is seen as a circle


class Revolver:
    """The angle by which the pointer has gone round an axis.

    Where the plane across the axis is seen well enough, it is the angle in that plane of what lies
    under the pointer; where it is edge-on, the pointer's angle on the screen. Which of the two it
    is does not change during a drag, so that nothing jumps.
    """

    def __init__(self, camera: Camera, point: Floats, axis: Floats, start: Floats) -> None:
        frame = frame_at(camera, point)
        self._center = camera.to_screen(point[None])[0]
        slant = float(axis @ frame[2])
        self._sign = 1.0 if slant >= 0.0 else -1.0
        self._matrix = np.eye(2)
        first, second = across(axis)
        if abs(slant) >= EDGE_ON:
            # Pixels across the eye's ray belong to these vectors of the plane across the axis.
            seen = np.stack([first, second]) @ frame[:2].T * (1.0, -1.0)
            self._matrix = np.linalg.inv(seen.T) * [[1.0], [-1.0]]
            self._sign = 1.0
        dead = DEAD if abs(slant) < EDGE_ON else DEAD_IN_SPACE
        place = self._place(start)
        self._swing = Swing(np.zeros(2), place, dead)
        angle = atan2(-place[1], place[0])
        self.first: Floats = np.cos(angle) * first + np.sin(angle) * second
        """(3,) unit vector across the axis, where the pointer began"""

    def to(self, at: Floats) -> float:
        """The angle in radians, counter-clockwise about the axis, from the start to a pixel."""
        return self._sign * self._swing.to(self._place(at))

    def _place(self, at: Floats) -> Floats:
        """A pixel in the plane across the axis, as on a screen that faces it."""
        place: Floats = self._matrix @ (at - self._center)
        return place


def rotation(axis: Floats, angle: float) -> Floats:
    """(3, 3) the turn about a unit vector, counter-clockwise; exact about the axes of the world."""
    c, s = quarter_exact(angle)
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    matrix: Floats = c * np.eye(3) + s * cross + (1.0 - c) * np.outer(axis, axis)
    return matrix
