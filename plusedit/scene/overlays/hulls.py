"""Convex hulls, as figure 4 of the paper shows them.

An open plus curve is the mean of two classical curves, weighted by 1 - u and u; so it lies in
the hull of the union of their control points. The hulls of the two are pink, that of the union
is blue, the two curves thin. A closed B-spline+ has no such parents; each of its spans has. An open
surface is the mean of four classical surfaces, those of its corner nets, and lies in their hull.
"""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.corner_nets import corner_hull, corner_nets
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.hulls import parents, span_points
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.drawn import drawn
from plusedit.scene.hull_areas import hull_area, hull_of, kept_hull
from plusedit.scene.items import Item, Polyline
from plusedit.scene.overlays import Seen, overlay

hulls = overlay("hulls", title="Convex hulls", order=10, shortcut="Shift+H", group="Constructions")


@hulls.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """The hull of the union, the two hulls on it, the two curves on top."""
    if curve.closed:
        yield from _spans(curve, seen.camera)
        return
    two = parents(curve)
    union = np.concatenate([parent.lines.points for parent in two])
    yield from hull_of(curve, "union", union, seen.camera, "union")
    for place, parent in enumerate(two):
        yield from hull_of(curve, f"parent {place}", parent.lines.points, seen.camera, "parent")
    for parent in two:
        yield Polyline(drawn(parent, seen.camera).points, "classical@70", 1.0)


@hulls.of_surfaces
def of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """The hull of all four nets, and the four hulls in it; of a closed surface the first alone.

    Nothing for closed families that have no hull.
    """
    union = kept_hull(surface, "union", lambda: corner_hull(surface))
    if union is None:
        return
    yield hull_area(union, seen.camera, "union@60", "union")
    if any(surface.closed):
        return
    for place, net in enumerate(corner_nets(surface)):
        yield from hull_of(
            surface, f"corner {place}", net.reshape(-1, 3), seen.camera, "parent@35", "parent"
        )


def _spans(curve: PlusCurve, camera: Camera) -> Iterator[Item]:
    """The hull of each span of a closed B-spline+; nothing for other families."""
    if curve.dimension == 2 and isinstance(camera, PlaneCamera) and camera.projection != "top":
        return
    try:
        spans = span_points(curve)
    except ValueError:
        return
    for place, points in enumerate(spans):
        yield from hull_of(curve, f"span {place}", points, camera, "union@40", "union")
