"""Cameras: from the world to the screen and back, without a window."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal, Protocol, TypeAlias

import numpy as np

from plusedit.geometry.arrays import Floats

Projection: TypeAlias = Literal["top", "front", "right"]

AXES: dict[Projection, tuple[int, int]] = {"top": (0, 1), "front": (0, 2), "right": (1, 2)}
"""Which coordinates run to the right and upwards."""

SMALLEST, LARGEST = 1e-9, 1e12  # pixels per unit; beyond, doubles no longer tell pixels apart


class Camera(Protocol):
    """How a view sees the world; an immutable value that can key a cache."""

    def __hash__(self) -> int: ...

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the view in logical pixels."""
        ...

    @property
    def pixel(self) -> float:
        """The length of a pixel in the world (where it is nearest, in perspective)."""
        ...

    @property
    def axes_of_view(self) -> Floats:
        """(3, 3) unit vectors of the world, in rows: to the right, upwards, toward the eye."""
        ...

    def pixel_at(self, points: Floats) -> Floats:
        """(m,) the length of a pixel in the world at each point (m, dim)."""
        ...

    def depths(self, points: Floats) -> Floats:
        """(m,) how deep in the view each point (m, dim) lies; less is nearer to the eye."""
        ...

    def ray(self, screen: Floats) -> tuple[Floats, Floats]:
        """Origin (3,) and unit direction (3,), away from the eye, of what is seen at a pixel."""
        ...

    def to_screen(self, points: Floats) -> Floats:
        """(m, 2) pixels to the right and downwards, of points (m, 2) or (m, 3)."""
        ...

    def to_world(self, screen: Floats, like: Floats) -> Floats:
        """(dim,) the point under a pixel (2,), as deep in the view as the point `like` (dim,)."""
        ...


@dataclass(frozen=True)
class PlaneCamera:
    """A parallel projection along an axis: the camera of the 2D view."""

    size: tuple[float, float]
    center: tuple[float, float] = (0.0, 0.0)
    """what is in the middle of the view, in the two coordinates that are seen"""
    scale: float = 100.0
    """pixels per unit"""
    projection: Projection = "top"

    @property
    def pixel(self) -> float:
        return 1.0 / self.scale

    @property
    def axes(self) -> tuple[int, int]:
        """Which coordinates run to the right and upwards."""
        return AXES[self.projection]

    def plane(self, points: Floats) -> Floats:
        """(m, 2) the two coordinates that are seen; a plane curve lies in z = 0."""
        across, up = self.axes
        if points.shape[1] == 2:
            if self.projection == "top":
                return points
            points = np.column_stack([points, np.zeros(len(points))])
        return points[:, [across, up]]

    @cached_property
    def axes_of_view(self) -> Floats:
        """(3, 3) unit vectors of the world, in rows: to the right, upwards, toward the eye."""
        across, up = (np.eye(3)[axis] for axis in self.axes)
        return np.stack([across, up, np.cross(across, up)])

    def pixel_at(self, points: Floats) -> Floats:
        """(m,) the length of a pixel in the world, the same at every point."""
        return np.full(len(points), self.pixel)

    def depths(self, points: Floats) -> Floats:
        """(m,) how deep each point lies; a plane curve lies in z = 0."""
        toward = self.axes_of_view[2]
        depths: Floats = -points @ toward[: points.shape[1]]
        return depths

    def ray(self, screen: Floats) -> tuple[Floats, Floats]:
        """A point (3,) that is seen at the pixel, the third coordinate 0, and the view."""
        origin = np.zeros(3)
        origin[list(self.axes)] = self.in_plane(screen[None])[0]
        return origin, -self.axes_of_view[2]

    def to_screen(self, points: Floats) -> Floats:
        # The center first: far from the origin, what is left of both is exact.
        screen: Floats = (self.plane(points) - self._middle) * self._factors + self._half
        return screen

    @cached_property
    def _middle(self) -> Floats:
        return np.array(self.center)

    @cached_property
    def _factors(self) -> Floats:
        return np.array([self.scale, -self.scale])

    @cached_property
    def _half(self) -> Floats:
        """(2,) the pixel in the middle."""
        return np.array(self.size) / 2.0

    def in_plane(self, screen: Floats) -> Floats:
        """(m, 2) the two coordinates that are seen at pixels (m, 2)."""
        seen: Floats = (np.asarray(screen) - self._half) / self._factors + self._middle
        return seen

    def placed(self, seen: Floats) -> Floats:
        """(m, 2) or (m, 3) points of the world that have those two coordinates (m, 2)."""
        if self.projection == "top":
            return seen
        points = np.zeros((len(seen), 3))
        points[:, self.axes] = seen
        return points

    def to_world(self, screen: Floats, like: Floats) -> Floats:
        point = like.copy()
        for axis, value in zip(self.axes, self.in_plane(screen[None])[0], strict=True):
            if axis < len(point):
                point[axis] = value
        return point

    @property
    def window(self) -> tuple[Floats, Floats]:
        """Lower left and upper right corner of what is seen, (2,) each."""
        half = np.array(self.size) / (2.0 * self.scale)
        center = np.array(self.center)
        return center - half, center + half

    def panned(self, by: tuple[float, float]) -> "PlaneCamera":
        """Moved so that what is seen shifts by that many pixels to the right and downwards."""
        x, y = self.center
        return replace(self, center=(x - by[0] / self.scale, y + by[1] / self.scale))

    def zoomed(self, factor: float, about: tuple[float, float]) -> "PlaneCamera":
        """Nearer by `factor`; what is under the pixel `about` stays there."""
        scale = float(np.clip(self.scale * factor, SMALLEST, LARGEST))
        held = self.in_plane(np.array([about]))[0]
        moved = replace(self, scale=scale)
        there = moved.in_plane(np.array([about]))[0]
        x, y = np.array(self.center) + held - there
        return replace(moved, center=(float(x), float(y)))

    def framing(self, points: Floats, margin: float = 48.0) -> "PlaneCamera":
        """Moved and zoomed so that all points (m, dim) are seen, `margin` pixels inside."""
        seen = self.plane(points)
        low, high = seen.min(axis=0), seen.max(axis=0)
        room = np.maximum(np.array(self.size) - 2.0 * margin, 16.0)
        extent = high - low
        with np.errstate(divide="ignore"):
            fits = np.where(extent > 0.0, room / extent, np.inf).min()
        scale = float(np.clip(fits, SMALLEST, LARGEST)) if np.isfinite(fits) else self.scale
        x, y = (low + high) / 2.0
        return replace(self, center=(float(x), float(y)), scale=scale)
