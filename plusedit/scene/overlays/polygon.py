"""The control polygon of a curve, the control net of a surface: neighbouring points joined."""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.items import Item, Polyline
from plusedit.scene.overlays import Seen, overlay

HAIRLINE = "quiet@55"

polygon = overlay("polygon", title="Control polygon and net", order=30, shortcut="Shift+P")


@polygon.of_curves
def control_polygon(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """A hairline, closed where the curve is."""
    yield Polyline(_joined(curve.lines.points, curve.closed), HAIRLINE, 1.0)


@polygon.of_surfaces
def control_net(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """A hairline along every row and column, closed where the surface is."""
    points, (closed_u, closed_v) = surface.planes.points, surface.closed
    for row in points:
        yield Polyline(_joined(row, closed_v), HAIRLINE, 1.0)
    for column in points.swapaxes(0, 1):
        yield Polyline(_joined(column, closed_u), HAIRLINE, 1.0)


def _joined(points: Floats, closed: bool) -> Floats:
    return np.vstack([points, points[:1]]) if closed else np.ascontiguousarray(points)
