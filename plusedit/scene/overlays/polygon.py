"""The control polygon: control points joined in their order."""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Item, Polyline
from plusedit.scene.overlays import overlay


@overlay("polygon", title="Control polygon", order=30, shortcut="Shift+P")
def draw(shape: Shape, curve: PlusCurve, camera: PlaneCamera) -> Iterator[Item]:
    """A hairline, closed where the curve is."""
    points = curve.lines.points
    if curve.closed:
        points = np.vstack([points, points[:1]])
    yield Polyline(points, "quiet@55", 1.0)
