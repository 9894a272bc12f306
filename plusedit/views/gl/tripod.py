"""The axes in a corner of the view: they show how it is turned, and clicks turn it."""

from dataclasses import replace
from functools import lru_cache
from typing import Final

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.items import Item, Markers, Segments
from plusedit.scene.space_camera import SpaceCamera

CORNER = 52.0  # pixels from the right and upper edges to the middle
ARM = 32.0  # pixels
DISC, BALL = 18.0, 12.0  # diameters at the ends that have letters, and at the others
REACH = 10.0  # pixels around the middle of an end that count as on it
LETTER = 3.6  # half the height of a letter
RAISED = 14.0  # pixels that letters stand before their discs

ENDS: Final = (
    ("right", "x", (1.0, 0.0, 0.0)),
    ("left", "x", (-1.0, 0.0, 0.0)),
    ("back", "y", (0.0, 1.0, 0.0)),
    ("front", "y", (0.0, -1.0, 0.0)),
    ("top", "z", (0.0, 0.0, 1.0)),
    ("bottom", "z", (0.0, 0.0, -1.0)),
)
"""The view that looks along each end, from outside; its axis; its direction."""

_STROKES: Final = {
    "x": [((-0.8, -1.0), (0.8, 1.0)), ((-0.8, 1.0), (0.8, -1.0))],
    "y": [((-0.8, 1.0), (0.0, 0.0)), ((0.8, 1.0), (0.0, 0.0)), ((0.0, 0.0), (0.0, -1.0))],
    "z": [((-0.8, 1.0), (0.8, 1.0)), ((0.8, 1.0), (-0.8, -1.0)), ((-0.8, -1.0), (0.8, -1.0))],
}


def tripod_camera(camera: SpaceCamera) -> SpaceCamera:
    """A parallel view of the same directions, a unit to a pixel, the origin in the corner."""
    width, height = camera.size
    to_right, upwards = width / 2.0 - CORNER, height / 2.0 - CORNER
    x, y, z = (-to_right * camera.right - upwards * camera.up).tolist()
    return replace(camera, target=(x, y, z), height=max(height, 1.0), perspective=False)


def axis_under(pixel: Floats, camera: SpaceCamera) -> str | None:
    """The name of the view that a click at a pixel (2,) asks for; None beside the axes."""
    small = tripod_camera(camera)
    ends = ARM * np.array([way for _, _, way in ENDS])
    off = np.linalg.norm(small.to_screen(ends) - pixel, axis=1)
    near = np.flatnonzero(off <= REACH)
    if not len(near):
        return None
    nearest = near[np.argmin(small.depths(ends[near]))]
    return ENDS[int(nearest)][0]


@lru_cache(maxsize=4)
def tripod_items(camera: SpaceCamera, hovered: str | None = None) -> tuple[list[Item], ...]:
    """What to draw with `tripod_camera`: arms, discs, letters, each before the one before.

    `hovered` is the view whose end is under the pointer. The same items for the same view.
    """
    arms: list[Item] = []
    discs: list[Item] = []
    letters: list[Item] = []
    for view, axis, way in ENDS:
        end = ARM * np.array([way])
        color = "hover" if view == hovered else axis
        if min(way) < 0.0:
            discs.append(
                Markers(end, "circle", BALL, "canvas" if view != hovered else color, color)
            )
            continue
        arms.append(Segments(np.zeros((1, 3)), end, color, 2.5))
        discs.append(Markers(end, "circle", DISC, color, color))
        strokes = LETTER * np.array(_STROKES[axis])
        lifted = end[0] + RAISED * camera.toward
        strokes = strokes @ np.stack([camera.right, camera.up]) + lifted
        letters.append(Segments(strokes[:, 0], strokes[:, 1], "canvas", 1.6))
    return arms, discs, letters
