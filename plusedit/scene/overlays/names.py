"""The name of each shape below it, as the captions of figures have it."""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.camera import Camera
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.items import Item, Label
from plusedit.scene.overlays import overlay

BELOW = 26.0  # pixels from the lowest point to the base line

names = overlay("names", title="Names", order=60, shortcut="Shift+T")


@names.of_curves
def curve_name(shape: Shape, curve: PlusCurve, camera: Camera) -> Iterator[Item]:
    """The name, centred under the curve and its control points."""
    yield _caption(shape.name, np.vstack([drawn(curve, camera).points, curve.lines.points]), camera)


@names.of_surfaces
def surface_name(shape: Shape, surface: PlusSurface, camera: Camera) -> Iterator[Item]:
    """The name, centred under the surface and its control points."""
    points = surface.sample(*surface_grids(surface, camera)).reshape(-1, 3)
    yield _caption(shape.name, np.vstack([points, surface.planes.control_points]), camera)


def _caption(name: str, points: Floats, camera: Camera) -> Label:
    screen = camera.to_screen(points)
    (left, _), (right, bottom) = screen.min(axis=0), screen.max(axis=0)
    like = points.mean(axis=0)
    if len(like) == 2:
        like = np.append(like, 0.0)
    at = camera.to_world(np.array([(left + right) / 2.0, bottom]), like)
    return Label(at, name, "text", (0.0, BELOW), "center", 13.0)
