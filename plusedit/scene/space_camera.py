"""The camera of the 3D view: a turntable about a target, in perspective or parallel projection.

At yaw and pitch zero it is the front view: x runs to the right, z upwards, the eye looks along y.
Yaw turns the eye about z, counter-clockwise seen from above; pitch lifts it. What lies as deep as
the target has the same size in both projections, so that switching between them keeps the scale.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import cos, exp, log, pi, radians, sin, tan
from types import MappingProxyType

import numpy as np

from plusedit.geometry.arrays import Floats

FIELD_OF_VIEW = radians(30.0)  # from the lower to the upper edge
NEAREST = 1e-3  # of the distance of the target: what is nearer to the eye is clipped
SMALLEST, LARGEST = 1e-9, 1e12  # of the world's height that is seen
ROUNDS = 12  # of framing in perspective; each leaves a small part of the error
SETTLED = 1e-3  # of the height: another round is not worth its time

STANDARD: Mapping[str, tuple[float, float]] = MappingProxyType(
    {
        "top": (0.0, pi / 2.0),
        "bottom": (0.0, -pi / 2.0),
        "front": (0.0, 0.0),
        "back": (pi, 0.0),
        "right": (pi / 2.0, 0.0),
        "left": (-pi / 2.0, 0.0),
        "iso": (radians(35.0), radians(30.0)),
    }
)
"""Yaw and pitch of the views that have names."""


@dataclass(frozen=True)
class SpaceCamera:
    """How the 3D view sees the world; an immutable value that can key a cache."""

    size: tuple[float, float]
    target: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """what the eye looks at, in the middle of the view"""
    height: float = 10.0
    """of the part of the world that is seen at the depth of the target"""
    yaw: float = STANDARD["iso"][0]
    pitch: float = STANDARD["iso"][1]
    """in radians, from -pi / 2 to pi / 2"""
    perspective: bool = True

    @classmethod
    def standard(cls, name: str, size: tuple[float, float]) -> "SpaceCamera":
        """The camera of a named view: parallel along an axis, in perspective for "iso"."""
        yaw, pitch = STANDARD[name]
        return cls(size, yaw=yaw, pitch=pitch, perspective=name == "iso")

    # Directions of the world, (3,) unit vectors

    @cached_property
    def right(self) -> Floats:
        """What runs to the right on the screen."""
        return np.array([cos(self.yaw), sin(self.yaw), 0.0])

    @cached_property
    def toward(self) -> Floats:
        """From the target to the eye."""
        flat = cos(self.pitch)
        return np.array([sin(self.yaw) * flat, -cos(self.yaw) * flat, sin(self.pitch)])

    @cached_property
    def up(self) -> Floats:
        """What runs upwards on the screen."""
        return np.cross(self.toward, self.right)

    @cached_property
    def axes_of_view(self) -> Floats:
        """(3, 3) rows: right, up, toward."""
        return np.stack([self.right, self.up, self.toward])

    @property
    def distance(self) -> float:
        """From the eye to the target."""
        return self.height / (2.0 * tan(FIELD_OF_VIEW / 2.0))

    @property
    def eye(self) -> Floats:
        """(3,) where the eye stands; of a parallel projection, far enough to see the target."""
        return np.array(self.target) + self.distance * self.toward

    @property
    def pixel(self) -> float:
        """The length of a pixel in the world at the depth of the target."""
        return self.height / max(self.size[1], 1.0)

    # From the world to the screen and back

    def in_view(self, points: Floats) -> Floats:
        """(m, 3) coordinates to the right, upwards and toward the eye, from the target on."""
        if points.shape[-1] == 2:
            points = np.column_stack([points, np.zeros(len(points))])
        seen: Floats = (points - np.array(self.target)) @ self.axes_of_view.T
        return seen

    def pixel_at(self, points: Floats) -> Floats:
        """(m,) the length of a pixel in the world at each point (m, dim)."""
        return self.pixel * self._shrink(self.in_view(points)[:, 2])

    def depths(self, points: Floats) -> Floats:
        """(m,) how far beyond the target each point lies; less is nearer to the eye."""
        depths: Floats = -self.in_view(points)[:, 2]
        return depths

    def to_screen(self, points: Floats) -> Floats:
        """(m, 2) pixels to the right and downwards, of points (m, 2) or (m, 3).

        What is behind the eye is seen far outside of the view.
        """
        x, y, toward = self.in_view(points).T
        scale = 1.0 / (self.pixel * self._shrink(toward))
        width, height = self.size
        return np.stack([width / 2.0 + x * scale, height / 2.0 - y * scale], axis=1)

    def to_world(self, screen: Floats, like: Floats) -> Floats:
        """(dim,) the point under a pixel (2,) in the plane parallel to the screen through `like`.

        Of a point `like` of a plane curve (2,), the point in z = 0 that is seen there, as far as
        the plane is not seen edge-on.
        """
        if len(like) == 2:
            flat = self.on_plane(screen, np.zeros(3), np.array([0.0, 0.0, 1.0]))
            return like.copy() if flat is None else flat[:2]
        toward = float(self.in_view(like[None])[0, 2])
        return self._at_depth(screen, toward)

    def ray(self, screen: Floats) -> tuple[Floats, Floats]:
        """Origin (3,) and unit direction (3,), away from the eye, of what is seen at a pixel."""
        through = self._at_depth(screen, 0.0)
        if not self.perspective:
            return through + self.distance * self.toward, -self.toward
        way = through - self.eye
        return self.eye, way / np.linalg.norm(way)

    def on_plane(self, screen: Floats, point: Floats, normal: Floats) -> Floats | None:
        """(3,) where the plane is seen at a pixel; None where it is edge-on or behind the eye."""
        origin, way = self.ray(screen)
        slant = float(normal @ way)
        if abs(slant) < 1e-9 * float(np.linalg.norm(normal)):
            return None
        along = float(normal @ (point - origin)) / slant
        if self.perspective and along <= 0.0:
            return None
        found: Floats = origin + along * way
        return found

    def _at_depth(self, screen: Floats, toward: float) -> Floats:
        width, height = self.size
        scale = self.pixel * float(self._shrink(np.array([toward]))[0])
        x, y = (screen[0] - width / 2.0) * scale, (height / 2.0 - screen[1]) * scale
        point: Floats = np.array(self.target) + np.array([x, y, toward]) @ self.axes_of_view
        return point

    def _shrink(self, toward: Floats) -> Floats:
        """How much more of the world a pixel covers at that depth than at the target's."""
        if not self.perspective:
            return np.ones(len(toward))
        shrink: Floats = np.maximum(1.0 - toward / self.distance, NEAREST)
        return shrink

    def matrix(self, nearest: float, farthest: float) -> Floats:
        """(4, 4) from homogeneous world coordinates to OpenGL's clip space, y upwards.

        `nearest` and `farthest` are depths as `depths` gives them: what is drawn lies between.
        """
        view = np.eye(4)
        view[:3, :3] = self.axes_of_view
        view[:3, 3] = -self.axes_of_view @ np.array(self.target)
        width, height = self.size
        half = np.array([self.height * width / max(height, 1.0), self.height]) / 2.0
        clip = np.zeros((4, 4))
        if not self.perspective:
            near, far = nearest, max(farthest, nearest + 1e-9 * self.height)
            clip[0, 0], clip[1, 1], clip[3, 3] = 1.0 / half[0], 1.0 / half[1], 1.0
            clip[2, 2], clip[2, 3] = -2.0 / (far - near), -(far + near) / (far - near)
            return clip @ view
        near = max(self.distance + nearest, NEAREST * self.distance)
        far = max(self.distance + farthest, 1.001 * near)
        clip[0, 0], clip[1, 1] = self.distance / half[0], self.distance / half[1]
        clip[2, 2], clip[2, 3] = -(far + near) / (far - near), -2.0 * far * near / (far - near)
        clip[3, 2] = -1.0
        back = np.eye(4)
        back[2, 3] = -self.distance
        return clip @ back @ view

    # Other cameras

    def panned(self, by: tuple[float, float]) -> "SpaceCamera":
        """Moved so that what lies as deep as the target shifts by pixels to the right and down."""
        shift = self.pixel * (by[0] * self.right - by[1] * self.up)
        return self._aimed(np.array(self.target) - shift)

    def orbited(self, yaw: float, pitch: float) -> "SpaceCamera":
        """Turned about the target by radians; pitch stops at the poles."""
        turned = (self.yaw + yaw + pi) % (2.0 * pi) - pi
        lifted = float(np.clip(self.pitch + pitch, -pi / 2.0, pi / 2.0))
        return replace(self, yaw=turned, pitch=lifted)

    def zoomed(self, factor: float, about: Floats) -> "SpaceCamera":
        """Nearer by `factor`; the point `about` (3,) of the world stays where it is seen."""
        height = float(np.clip(self.height / factor, SMALLEST, LARGEST))
        share = height / self.height
        moved = self._aimed(about + share * (np.array(self.target) - about))
        return replace(moved, height=height)

    def looking(self, name: str) -> "SpaceCamera":
        """Turned to a named view about the same target; "iso" in perspective, others parallel."""
        yaw, pitch = STANDARD[name]
        return replace(self, yaw=yaw, pitch=pitch, perspective=name == "iso")

    def framing(self, points: Floats, margin: float = 48.0) -> "SpaceCamera":
        """Moved and zoomed so that all points (m, dim) are seen, `margin` pixels inside.

        The direction of view stays. Points in one place are centered at the scale there is.
        """
        if points.shape[-1] == 2:
            points = np.column_stack([points, np.zeros(len(points))])
        low, high = points.min(axis=0), points.max(axis=0)
        extent = float(np.linalg.norm(high - low))
        camera = self._aimed((low + high) / 2.0)
        if not extent > 0.0:
            return camera
        camera = replace(camera, height=float(np.clip(extent, SMALLEST, LARGEST)))
        room = np.maximum(np.array(self.size) - 2.0 * margin, 16.0)
        for _ in range(ROUNDS):
            seen = camera.to_screen(points)
            left, right = seen.min(axis=0), seen.max(axis=0)
            off = (left + right) / 2.0 - np.array(self.size) / 2.0
            camera = camera.panned((-float(off[0]), -float(off[1])))
            factor = float((room / np.maximum(right - left, 1e-9)).min())
            height = float(np.clip(camera.height / factor, SMALLEST, LARGEST))
            camera = replace(camera, height=height)
            if abs(factor - 1.0) < SETTLED and float(np.abs(off).max()) < 0.5:
                break
        return camera

    def blended(self, other: "SpaceCamera", share: float) -> "SpaceCamera":
        """Between this camera (share 0) and another (share 1), the short way round."""
        turn = (other.yaw - self.yaw + pi) % (2.0 * pi) - pi
        here, there = np.array(self.target), np.array(other.target)
        height = exp((1.0 - share) * log(self.height) + share * log(other.height))
        pitch = (1.0 - share) * self.pitch + share * other.pitch
        moved = replace(other, height=height, yaw=self.yaw + share * turn, pitch=pitch)
        return moved._aimed((1.0 - share) * here + share * there)

    def _aimed(self, target: Floats) -> "SpaceCamera":
        x, y, z = (float(value) for value in target)
        return replace(self, target=(x, y, z))
