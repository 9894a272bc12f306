"""The name of each shape below it, as the captions of figures have it."""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn import drawn
from plusedit.scene.items import Item, Label
from plusedit.scene.overlays import overlay

BELOW = 26.0  # pixels from the lowest point to the base line


@overlay("names", title="Names", order=60, shortcut="Shift+T")
def draw(shape: Shape, curve: PlusCurve, camera: PlaneCamera) -> Iterator[Item]:
    """The name, centred under the curve and its control points."""
    seen = camera.plane(np.concatenate([drawn(curve, camera).points, curve.lines.points]))
    low, high = seen.min(axis=0), seen.max(axis=0)
    at = camera.placed(np.array([[(low[0] + high[0]) / 2.0, low[1]]]))[0]
    yield Label(at, shape.name, "text", (0.0, BELOW), "center", 13.0)
