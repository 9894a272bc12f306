"""Directions that follow the pointer over a ball, and their angles."""

from math import acos, asin, atan2, cos, pi, radians, sin

import numpy as np

from plusedit.commands.directions import quarter_exact
from plusedit.geometry.arrays import Floats, unit
from plusedit.scene.camera import Camera

FASTEST = radians(5.0)  # by which a pixel may turn the grip
LEAST = 26.0  # pixels, the smallest radius: a ball no larger than a mark could not be steered


class Ball:
    """A ball about a point, and the grip on it that the pointer has taken.

    Seen from the eye the grip stays under the pointer, on the half of the ball where it was. Near
    the rim, where a pixel would be a large angle, the ball is laid flat like a cone: the grip comes
    to the rim a little later than the pointer, and no small step ever turns it far.
    """

    def __init__(self, camera: Camera, center: Floats, grip: Floats) -> None:
        self._frame = frame_at(camera, center)
        pixel = float(camera.pixel_at(center[None])[0])
        arm = grip - center
        self._radius = max(float(np.linalg.norm(arm)) / pixel, LEAST)
        x, y, toward = self._frame @ unit(arm)
        self._steepest = acos(1.0 / (self._radius * FASTEST))
        self._half = 1.0 if toward >= 0.0 else -1.0
        polar = atan2(float(np.hypot(x, y)), abs(toward))
        self._start = self._seen(polar) * unit(np.array([x, y]))

    @property
    def toward(self) -> Floats:
        """(3,) unit vector from the center to the eye."""
        toward: Floats = self._frame[2]
        return toward

    def to(self, moved: Floats) -> Floats | None:
        """(3,) the unit vector to where the pointer has drawn the grip; None at the start."""
        if not moved.any():
            return None
        x, y = self._start + moved * (1.0, -1.0) / self._radius
        off = float(np.hypot(x, y))
        polar = min(self._polar(off), pi / 2.0)
        across = np.array([x, y]) / off if off > 0.0 else np.zeros(2)
        local = np.array([*(sin(polar) * across), self._half * cos(polar)])
        return unit(local @ self._frame)

    def _seen(self, polar: float) -> float:
        """How far from the middle, in radii, what is at an angle from head on is seen."""
        steepest = self._steepest
        if polar <= steepest:
            return sin(polar)
        return sin(steepest) + (polar - steepest) * cos(steepest)

    def _polar(self, seen: float) -> float:
        steepest = self._steepest
        if seen <= sin(steepest):
            return asin(seen)
        return steepest + (seen - sin(steepest)) / cos(steepest)


def frame_at(camera: Camera, point: Floats) -> Floats:
    """(3, 3) unit vectors in rows: right, up and toward the eye, as seen at a point (3,)."""
    toward = -camera.ray(camera.to_screen(point[None])[0])[1]
    right = camera.axes_of_view[0]
    right = unit(right - (right @ toward) * toward)
    return np.stack([right, np.cross(toward, right), toward])


def turn_between(before: Floats, after: Floats) -> Floats:
    """(3, 3) the smallest turn that takes one unit vector to another."""
    along = float(before @ after)
    if along < -1.0 + 1e-12:
        least = np.eye(3)[int(np.abs(before).argmin())]
        axis = unit(np.cross(before, least))
        return 2.0 * np.outer(axis, axis) - np.eye(3)
    x, y, z = np.cross(before, after)
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    matrix: Floats = np.eye(3) + cross + cross @ cross / (1.0 + along)
    return matrix


def azimuth(way: Floats) -> float:
    """In radians, of a vector (3,) in the plane z = 0, from x towards y."""
    return atan2(float(way[1]), float(way[0]))


def elevation(way: Floats) -> float:
    """In radians, of a vector (3,) above the plane z = 0."""
    return atan2(float(way[2]), float(np.hypot(way[0], way[1])))


def from_angles(azimuth: float, elevation: float) -> Floats:
    """(3,) the unit vector of an azimuth and an elevation; exact where they are quarter turns."""
    x, y = quarter_exact(azimuth)
    flat, z = quarter_exact(elevation)
    return np.array([flat * x, flat * y, z])
