"""Places of the world where views of it see them."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.space_camera import SpaceCamera

FLATTEST = 0.2  # sine of the angle between the ground and the eye's ray, to be drawn on
FARTHEST = 10.0  # heights of the view from its target: there the ground ends
HALVINGS = 30  # of the way to where it ends


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


def sheet_of(camera: Camera) -> Floats:
    """A point of what new curves are drawn on: (2,) of the plane z = 0, or (3,) across the view.

    Where the ground is seen too flat to draw on, it is the plane through the origin that faces
    the eye; in a view of a plane it is the one that is seen.
    """
    if isinstance(camera, PlaneCamera):
        return np.zeros(max(camera.axes) + 1)
    return np.zeros(2 if abs(camera.axes_of_view[2, 2]) >= FLATTEST else 3)


def on_sheet(pixel: Floats, like: Floats, camera: Camera) -> Floats:
    """(dim,) the point under a pixel (2,), in z = 0 or as deep in the view as `like` (dim,).

    Of the ground no more than is near: a pixel beyond stands for the last place on its way there.
    """
    if len(like) == 3 or not isinstance(camera, SpaceCamera):
        return camera.to_world(pixel, like)
    target = np.array(camera.target)
    middle = camera.to_screen(target[None, :2])[0]
    low, high = 0.0, 1.0
    found = _on_ground(pixel, camera)
    if found is None:
        found = _on_ground(middle, camera)
        for _ in range(HALVINGS if found is not None else 0):
            share = (low + high) / 2.0
            nearer = _on_ground(middle + share * (pixel - middle), camera)
            low, high = (low, share) if nearer is None else (share, high)
            found = found if nearer is None else nearer
    return like.copy() if found is None else found[:2]


def _on_ground(pixel: Floats, camera: SpaceCamera) -> Floats | None:
    """(3,) what is seen of the plane z = 0 at a pixel; None where that is far away."""
    found = camera.on_plane(pixel, np.zeros(3), np.array([0.0, 0.0, 1.0]))
    if found is None:
        return None
    far = np.linalg.norm(found - np.array(camera.target)) > FARTHEST * camera.height
    return None if far else found


def in_space(points: Floats) -> Floats:
    """(m, 3) points (m, 2) of the plane z = 0, or those of space as they are."""
    return points if points.shape[1] == 3 else np.column_stack([points, np.zeros(len(points))])
