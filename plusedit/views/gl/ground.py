"""The grid on the ground: lines in z = 0 around what is looked at, gone in the distance."""

from dataclasses import dataclass
from functools import lru_cache
from math import pi

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.graduation import graduation
from plusedit.scene.items import Item, Segments
from plusedit.scene.space_camera import SpaceCamera

APART = 3.0  # times as far as the lines of the grid of a plane view
FARTHEST = 1.0  # of the longer side of the view, from its middle
LOWEST = (0.02, 0.2)  # slope of the view: seen flatter the grid is gone, steeper it is clear
ALIGNED = 1e-9  # radians


@dataclass(frozen=True, eq=False)
class Ground:
    """What to draw, and how it fades."""

    items: tuple[Item, ...]
    middle: Floats
    """(3,)"""
    reach: float
    """the distance from the middle at which nothing is left"""


@lru_cache(maxsize=4)
def ground_of(camera: SpaceCamera) -> Ground | None:
    """The ground of that view; None where it would be seen edge-on.

    The same for the same view. In the parallel front, back and side views the grid stands
    upright, in the plane that is seen.
    """
    across = _across(camera)
    slope = abs(float(camera.toward[across]))
    strength = np.clip((slope - LOWEST[0]) / (LOWEST[1] - LOWEST[0]), 0.0, 1.0)
    if strength <= 0.0:
        return None
    middle = np.array(camera.target)
    middle[across] = 0.0
    reach = FARTHEST * camera.height * max(1.0, camera.size[0] / max(camera.size[1], 1.0))
    marks = graduation(APART * camera.pixel)
    items: list[Item] = []
    for axis in (a for a in range(3) if a != across):
        along = 3 - across - axis
        low, high = float(middle[axis]) - reach, float(middle[axis]) + reach
        majors, minors = (at[np.abs(at - middle[axis]) < reach] for at in marks.between(low, high))
        is_axis = np.abs(majors) < marks.minor / 2.0
        for at, color in (
            (minors, f"minor@{round(100 * strength * marks.strength)}"),
            (majors[~is_axis], f"major@{round(100 * strength)}"),
            (majors[is_axis], f"{'xyz'[along]}@{round(60 * strength)}"),
        ):
            if len(at):
                items.append(_lines(at, axis, along, middle, reach, color))
    return Ground(tuple(items), middle, reach)


def _across(camera: SpaceCamera) -> int:
    """The axis that is normal to the ground."""
    if not camera.perspective and abs(camera.pitch) < ALIGNED:
        turns = camera.yaw / (pi / 2.0)
        if abs(turns - round(turns)) < ALIGNED:
            return 1 if round(turns) % 2 == 0 else 0
    return 2


def _lines(at: Floats, axis: int, along: int, middle: Floats, reach: float, color: str) -> Segments:
    """Chords of the circle about the middle where one coordinate is `at`."""
    half = np.sqrt(reach**2 - (at - middle[axis]) ** 2)
    starts = np.tile(middle, (len(at), 1))
    starts[:, axis] = at
    ends = starts.copy()
    starts[:, along] -= half
    ends[:, along] += half
    return Segments(starts, ends, color)
