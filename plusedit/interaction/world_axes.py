"""Which axes of the world run to the right, upwards and out of a view."""

import numpy as np

from plusedit.scene.camera import Camera, PlaneCamera

Z = 2


def world_axes(camera: Camera) -> tuple[tuple[int, float], ...]:
    """The axes nearest to the right, to upwards and to out of the view: number and sign of each.

    Three different axes; no sign is 0. In the plane views they are those of the view itself.
    """
    rows = camera.axes_of_view
    right = int(np.abs(rows[0]).argmax())
    others = [axis for axis in range(3) if axis != right]
    up = max(others, key=lambda axis: abs(rows[1, axis]))
    out = 3 - right - up
    return tuple(
        (axis, -1.0 if row[axis] < 0.0 else 1.0)
        for axis, row in zip((right, up, out), rows, strict=True)
    )


def lifting_axis(camera: Camera) -> tuple[int, float]:
    """What PageUp moves along: out of a plane view, and in space along z."""
    return world_axes(camera)[2] if isinstance(camera, PlaneCamera) else (Z, 1.0)
