"""Convex hulls, as figure 4 of the paper shows them.

An open plus curve is the mean of two classical curves, weighted by 1 - u and u; so it lies in
the hull of the union of their control points. The hulls of the two are pink, that of the union
is blue, the two curves thin. A closed B-spline+ has no such parents; each of its spans has.
"""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.hulls import parents, span_points
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.drawn import drawn
from plusedit.scene.hull_areas import hull_area
from plusedit.scene.items import Item, Polyline
from plusedit.scene.overlays import overlay

hulls = overlay("hulls", title="Convex hulls", order=10, shortcut="Shift+H")


@hulls.of_curves
def of_curve(shape: Shape, curve: PlusCurve, camera: Camera) -> Iterator[Item]:
    """The hull of the union, the two hulls on it, the two curves on top."""
    if curve.closed:
        yield from _spans(curve, camera)
        return
    two = parents(curve)
    yield hull_area(np.concatenate([parent.lines.points for parent in two]), camera, "union")
    for parent in two:
        yield hull_area(parent.lines.points, camera, "parent")
    for parent in two:
        yield Polyline(drawn(parent, camera).points, "classical@70", 1.0)


def _spans(curve: PlusCurve, camera: Camera) -> Iterator[Item]:
    """The hull of each span of a closed B-spline+; nothing for other families."""
    if curve.dimension == 2 and isinstance(camera, PlaneCamera) and camera.projection != "top":
        return
    try:
        spans = span_points(curve)
    except ValueError:
        return
    for points in spans:
        yield hull_area(points, camera, "union@40", "union")
