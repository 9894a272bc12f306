"""The hull of the control points of the same shape in standard form, one degree higher.

It is never larger than the hull of the union of the parents, and mostly much smaller.
"""

from collections.abc import Iterator

from plusedit.document.shape import Shape
from plusedit.geometry.corner_nets import elevated_surface_hull
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevated
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_elevation import elevated_surface
from plusedit.scene.hull_areas import hull_area, hull_of, kept_hull
from plusedit.scene.items import Item, Markers, Polyline
from plusedit.scene.overlays import Seen, overlay

elevated_hull = overlay(
    "elevated_hull",
    title="Hull of the elevated points",
    order=20,
    shortcut="Shift+E",
    group="Constructions",
)


@elevated_hull.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """An outlined area with its polygon; nothing for families that have no standard form."""
    try:
        points = elevated(curve).points
    except ValueError:
        return
    yield from hull_of(curve, "elevated", points, seen.camera, "union@60", "accent@60")
    yield Polyline(points, "accent@45", 1.0, "dash")
    yield Markers(points, "diamond", 6.0, None, "accent@70", 1.0)


@elevated_hull.of_surfaces
def of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """A body with its control points; nothing for families that have no standard form."""
    hull = kept_hull(surface, "elevated", lambda: elevated_surface_hull(surface))
    if hull is None:
        return
    yield hull_area(hull, seen.camera, "union@60", "accent@60")
    points = elevated_surface(surface).points.reshape(-1, 3)
    yield Markers(points, "diamond", 6.0, None, "accent@70", 1.0)
