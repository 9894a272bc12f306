"""Words beside a point, in the direction away from what they are about."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import Camera
from plusedit.scene.items import Anchor, Label

WORDS = 10.0  # pixels, the height of letters
SLOPE = 0.38  # of a direction across: less is up or down, with words in the middle
LOWER = 0.36  # of the height of letters, from their middle to the base line


def outward_label(
    at: Floats, way: Floats, text: str, color: str, camera: Camera, *, apart: float
) -> Label:
    """A text so many pixels from the point (dim,), on the side where the vector (dim,) leads.

    To the right and upwards where the vector is zero or leads into the screen.
    """
    length = float(np.linalg.norm(way))
    right, down = 0.6, -0.8
    if length > 0.0:
        pixel = float(camera.pixel_at(at[None])[0])
        start, end = camera.to_screen(np.stack([at, at + pixel / length * way]))
        leads = end - start
        size = float(np.hypot(*leads))
        if 0.1 < size < np.inf:
            right, down = (leads / size).tolist()
    anchor: Anchor = "left" if right > 0.0 else "right"
    if abs(right) < SLOPE:
        anchor = "center"
    offset = apart * right, apart * down + LOWER * WORDS
    return Label(at, text.replace("-", "\N{MINUS SIGN}"), color, offset, anchor, WORDS)
