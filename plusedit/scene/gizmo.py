"""The gizmo: arrows that move what is selected along an axis, rings that turn it about one.

It stands at the active control plane, with the axes u, v and the normal, or at the active line of
a space curve, with the axes x, y and z and no rings. It has the same size at any zoom.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import pi, sqrt
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.items import Item, Polygon, Polyline, Segments
from plusedit.scene.plane_handles import Planar, plane_frames

RADIUS = 64.0  # pixels, of the rings
ARROW = (74.0, 102.0)  # pixels from the point to where an arrow begins and ends: beyond the rings
HEAD = (13.0, 4.5)  # pixels, length and half the width of an arrow's head
CORNERS = 64  # of a ring
END_ON = 0.2  # foreshortening below which an arrow is not shown: it would hide the point
LINE, HOVERED = 2.0, 3.5  # pixels, widths
FAR_SIDE = "@30"  # what of a ring is turned away from the eye

PLANE_COLORS = ("u", "v", "z")
LINE_COLORS = ("x", "y", "z")

Part = Literal["arrow", "ring"]


@dataclass(frozen=True, eq=False)
class Gizmo:
    """Arrows and rings about one point, in the world."""

    line: LineId
    """the control plane, or the line of a space curve, that it stands at"""
    point: Floats
    """(3,)"""
    axes: Floats
    """(3, 3) unit vectors in rows"""
    names: tuple[str, str, str]
    """of the axes, as people call them"""
    colors: tuple[str, str, str]
    turns: bool
    """whether it has rings"""
    pixel: float
    """the length of a pixel in the world at the point"""
    toward: Floats
    """(3,) unit vector from the point to the eye"""

    def shown(self, axis: int) -> bool:
        """Whether the arrow of an axis is seen well enough to be taken."""
        along = float(self.axes[axis] @ self.toward)
        return 1.0 - along * along > END_ON * END_ON

    def arrow(self, axis: int) -> Floats:
        """(2, 3) where the arrow begins and ends."""
        reach = np.array(ARROW)[:, None] * self.pixel
        ends: Floats = self.point + reach * self.axes[axis]
        return ends

    def ring(self, axis: int) -> Floats:
        """(CORNERS + 1, 3) the circle about an axis, its end the same as its beginning."""
        return self._rings[axis]

    @cached_property
    def _rings(self) -> tuple[Floats, ...]:
        return tuple(circle(self.point, axis, RADIUS * self.pixel) for axis in self.axes)

    def near_side(self, axis: int) -> NDArray[np.bool_]:
        """(CORNERS,) which parts of a ring are on the side of the eye, or seen from above."""
        ring = self.ring(axis)
        middles = (ring[1:] + ring[:-1]) / 2.0 - self.point
        near: NDArray[np.bool_] = middles @ self.toward > -0.25 * RADIUS * self.pixel
        return near


def circle(center: Floats, axis: Floats, radius: float, corners: int = CORNERS) -> Floats:
    """(corners + 1, 3) points of a circle about a unit vector, counter-clockwise about it."""
    points: Floats = center + _unit_circle(corners) @ (radius * np.stack(across(axis)))
    return points


@lru_cache(maxsize=8)
def _unit_circle(corners: int) -> Floats:
    """(corners + 1, 2)"""
    angles = np.linspace(0.0, 2.0 * pi, corners + 1)
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def across(axis: Floats) -> tuple[Floats, Floats]:
    """Two unit vectors (3,) that make a right-handed frame with a unit vector in third place."""
    x, y, z = axis.tolist()
    # The axis of the world that is least along it, times it; written out, as this is every frame.
    least = min((abs(x), 0), (abs(y), 1), (abs(z), 2))[1]
    a, b, c = ((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0))[least]
    length = sqrt(a * a + b * b + c * c)
    a, b, c = a / length, b / length, c / length
    return np.array([a, b, c]), np.array([y * c - z * b, z * a - x * c, x * b - y * a])


def gizmo_of(design: Design, selection: Selection, camera: Camera) -> Gizmo | None:
    """The gizmo of what is selected; None where there is nothing in space to take hold of.

    It is shown in views of space only: from the side, along an axis, it would be in the way.
    """
    line = selection.leading
    if line is None or isinstance(camera, PlaneCamera) or not design[line.shape].editable:
        return None
    geometry = design[line.shape].geometry
    point = geometry.net.control_points[line.number]
    if len(point) != 3 or not np.isfinite(camera.to_screen(point[None])).all():
        return None
    pixel = float(camera.pixel_at(point[None])[0])
    toward = -camera.ray(camera.to_screen(point[None])[0])[1]
    if isinstance(geometry, PlusCurve):
        names = ("x", "y", "z")
        return Gizmo(line, point, np.eye(3), names, LINE_COLORS, False, pixel, toward)
    axes = plane_axes(geometry, line.number, camera)
    return Gizmo(line, point, axes, ("u", "v", "normal"), PLANE_COLORS, True, pixel, toward)


def plane_axes(surface: Planar, number: int, camera: Camera) -> Floats:
    """(3, 3) the directions of d^u and d^v and the normal of a control plane, unit vectors.

    Where the two span no plane, three perpendicular ones, one of them along what there is.
    """
    directions = surface.vectors[:, [number]]
    frames, flat = plane_frames(directions, camera.axes_of_view)
    if not flat[0]:
        axes: Floats = frames[0]
        return axes
    return np.stack([*unit(directions[:, 0]), frames[0, 2]])


def gizmo_items(
    gizmo: Gizmo, camera: Camera, hovered: tuple[Part, int] | None = None
) -> Iterator[Item]:
    """What a gizmo looks like; what is hovered in another color."""
    if gizmo.turns:
        for axis in range(3):
            yield from _ring(gizmo, axis, hovered == ("ring", axis))
    for axis in range(3):
        if gizmo.shown(axis):
            yield from _arrow(gizmo, axis, camera, hovered == ("arrow", axis))


def part_items(gizmo: Gizmo, camera: Camera, part: Part, axis: int) -> tuple[Item, ...]:
    """One part of a gizmo, highlighted."""
    if part == "ring":
        return tuple(_ring(gizmo, axis, True))
    return tuple(_arrow(gizmo, axis, camera, True))


def _ring(gizmo: Gizmo, axis: int, hovered: bool) -> Iterator[Item]:
    ring, near = gizmo.ring(axis), gizmo.near_side(axis)
    color, width = ("hover", HOVERED) if hovered else (gizmo.colors[axis], LINE)
    for side, faint in ((near, color), (~near, color + FAR_SIDE)):
        if side.any():
            yield Segments(ring[:-1][side], ring[1:][side], faint, width)


def _arrow(gizmo: Gizmo, axis: int, camera: Camera, hovered: bool) -> Iterator[Item]:
    start, end = gizmo.arrow(axis)
    color, width = ("hover", HOVERED) if hovered else (gizmo.colors[axis], LINE)
    length, half = (size * gizmo.pixel for size in HEAD)
    along = gizmo.axes[axis]
    beside = unit(np.cross(along, gizmo.toward)) * half
    neck = end - length * along
    yield Polyline(np.stack([start, neck]), color, width)
    yield Polygon(np.stack([end, neck + beside, neck - beside]), color, color, 1.0)
