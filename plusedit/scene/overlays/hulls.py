"""Convex hulls, as figure 4 of the paper shows them.

An open plus curve is the mean of two classical curves, weighted by 1 - u and u; so it lies in
the hull of the union of their control points. The hulls of the two are pink, that of the union
is blue, the two curves thin. A closed B-spline+ has no such parents; each of its spans has.
"""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.hulls import convex_hull, parents, span_hulls
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn import drawn
from plusedit.scene.items import Item, Polygon, Polyline
from plusedit.scene.overlays import overlay


@overlay("hulls", title="Convex hulls", order=10, shortcut="Shift+H")
def draw(shape: Shape, curve: PlusCurve, camera: PlaneCamera) -> Iterator[Item]:
    """The hull of the union, the two hulls on it, the two curves on top."""
    if curve.closed:
        yield from _spans(curve, camera)
        return
    two = parents(curve)
    seen = [camera.plane(parent.lines.points) for parent in two]
    yield _area(np.concatenate(seen), "union", camera)
    for points in seen:
        yield _area(points, "parent", camera)
    for parent in two:
        yield Polyline(drawn(parent, camera).points, "classical@70", 1.0)


def _area(points: Floats, color: str, camera: PlaneCamera) -> Polygon:
    return Polygon(camera.placed(convex_hull(points)), color, color, 1.0)


def _spans(curve: PlusCurve, camera: PlaneCamera) -> Iterator[Item]:
    """The hull of each span of a closed B-spline+; nothing for other families."""
    if curve.dimension == 2 and camera.projection != "top":
        return
    try:
        hulls = span_hulls(curve, camera.axes)
    except ValueError:
        return
    for hull in hulls:
        yield Polygon(camera.placed(hull), "union@40", "union", 1.0)
