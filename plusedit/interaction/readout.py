"""Numbers of a drag in words, and the marks that go with it."""

from math import degrees, pi

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.interaction.places import in_world, seen_axes
from plusedit.interaction.snapping import decimals
from plusedit.scene.camera import Camera
from plusedit.scene.gizmo import circle
from plusedit.scene.items import Item, Markers, Polygon, Polyline

PARTS = 10.0  # of a sector's rim, for one radian
HOVER_SIZE = 14.0  # pixels, around a dot of 9 or a grip of 8


def number(value: float, places: int, *, signed: bool = False) -> str:
    """Such as "1.25" or "−0.50", with a true minus sign; "+1.25" if signed."""
    rounded = round(value, places) + 0.0
    text = f"{rounded:+.{places}f}" if signed and rounded else f"{rounded:.{places}f}"
    return text.replace("-", "−")


def shift_text(by: Floats, camera: Camera) -> str:
    """Such as "dx 1.25  dy −0.50": the axes that are seen, all three in space."""
    places = decimals(camera.pixel)
    return "  ".join(f"d{'xyz'[axis]} {number(by[axis], places)}" for axis in seen_axes(camera))


def angle_text(angle: float, by: float) -> str:
    """Such as "angle 37.5° (+12.0°)"; angles in radians."""
    whole = (degrees(angle) + 180.0) % 360.0 - 180.0
    return f"angle {number(whole, 1)}° ({number(degrees(by), 1, signed=True)}°)"


def ring(points: Floats) -> Markers:
    """A highlight around what a press would take."""
    return Markers(points, "ring", HOVER_SIZE, None, "hover", 2.0)


def box(corner: Floats, other: Floats, camera: Camera) -> Item:
    """The rectangle between two pixels."""
    (left, top), (right, bottom) = corner, other
    pixels = np.array([(left, top), (right, top), (right, bottom), (left, bottom)])
    return Polygon(in_world(pixels, camera), "accent@12", "accent", 1.0)


def sphere(center: Floats, radius: float, camera: Camera) -> Item:
    """The outline of what lies within a radius of a point (3,)."""
    return Polyline(circle(center, camera.axes_of_view[2], radius), "hover@70", 1.0)


def pie(
    center: Floats, axis: Floats, first: Floats, angle: float, radius: float
) -> tuple[Item, ...]:
    """The sector that a unit vector `first` (3,) sweeps over on its way round an axis."""
    swept = float(np.clip(angle, -2.0 * pi, 2.0 * pi))
    if not swept:
        return ()
    angles = np.linspace(0.0, swept, 2 + int(abs(swept) * PARTS))[:, None]
    rim = center + radius * (np.cos(angles) * first + np.sin(angles) * np.cross(axis, first))
    return (Polygon(np.vstack([center, rim]), "hover@25", "hover", 1.0),)


def thread(points: Floats) -> Item:
    """A thin line that leads from a control point to the pointer."""
    return Polyline(points, "hover", 1.0, "dot")
