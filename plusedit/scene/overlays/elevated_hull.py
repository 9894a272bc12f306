"""The hull of the control points of the same curve in standard form, one degree higher.

It is never larger than the hull of the union of the two parents, and mostly much smaller.
"""

from collections.abc import Iterator

from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevated
from plusedit.scene.camera import Camera
from plusedit.scene.hull_areas import hull_area
from plusedit.scene.items import Item, Markers, Polyline
from plusedit.scene.overlays import overlay

elevated_hull = overlay(
    "elevated_hull", title="Hull of the elevated points", order=20, shortcut="Shift+E"
)


@elevated_hull.of_curves
def of_curve(shape: Shape, curve: PlusCurve, camera: Camera) -> Iterator[Item]:
    """An outlined area with its polygon; nothing for families that have no standard form."""
    try:
        points = elevated(curve).points
    except ValueError:
        return
    yield hull_area(points, camera, "union@60", "accent@60")
    yield Polyline(points, "accent@45", 1.0, "dash")
    yield Markers(points, "diamond", 6.0, None, "accent@70", 1.0)
