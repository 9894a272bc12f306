"""Places of the world where views of it see them."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.space_camera import SpaceCamera


def seen_plane(camera: Camera) -> tuple[int, int]:
    """The two axes that run to the right and upwards; in a view of space x and y."""
    return camera.axes if isinstance(camera, PlaneCamera) else (0, 1)


def seen_axes(camera: Camera) -> tuple[int, ...]:
    """The axes that a drag can move along: two in a view of a plane, else all."""
    return camera.axes if isinstance(camera, PlaneCamera) else (0, 1, 2)


def in_world(pixels: Floats, camera: Camera) -> Floats:
    """(m, 3) points of the world that are seen at pixels (m, 2).

    They are level with the origin, or as deep as the target of a view of space.
    """
    middle = np.array(camera.target) if isinstance(camera, SpaceCamera) else np.zeros(3)
    return np.array([camera.to_world(pixel, middle) for pixel in np.asarray(pixels)])


def in_space(points: Floats) -> Floats:
    """(m, 3) points (m, 2) of the plane z = 0, or those of space as they are."""
    return points if points.shape[1] == 3 else np.column_stack([points, np.zeros(len(points))])
