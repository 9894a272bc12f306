"""The name of each shape below it, as the captions of figures have it.

Where shapes are crowded a name stands lower or above its shape, or is left out; those of selected
shapes come first.
"""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.items import Item, Label
from plusedit.scene.overlays import Seen, overlay

BELOW = 26.0  # pixels from the lowest point to the base line
ABOVE = 14.0  # from the base line to the highest point, where there is no room below
LOWER = 19.0  # from one name to another below or above the same place

names = overlay("names", title="Names", order=60, shortcut="Shift+T")


@names.of_curves
def curve_name(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """The name, centred under the curve and its control points."""
    points = np.vstack([drawn(curve, seen.camera).points, curve.lines.points])
    yield _caption(shape.name, points, seen)


@names.of_surfaces
def surface_name(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """The name, centred under the surface and its control points."""
    points = surface.sample(*surface_grids(surface, seen.camera)).reshape(-1, 3)
    yield _caption(shape.name, np.vstack([points, surface.planes.control_points]), seen)


@names.of_meshes
def mesh_name(shape: Shape, surface: MeshSurface, seen: Seen) -> Iterator[Item]:
    """The name, centred under the mesh, which its surface keeps close to at any S."""
    yield _caption(shape.name, surface.mesh.vertices, seen)


def _caption(name: str, points: Floats, seen: Seen) -> Label:
    screen = seen.camera.to_screen(points)
    (left, top), (right, bottom) = screen.min(axis=0), screen.max(axis=0)
    like = points.mean(axis=0)
    if len(like) == 2:
        like = np.append(like, 0.0)
    at = seen.camera.to_world(np.array([(left + right) / 2.0, bottom]), like)
    above = float(top - bottom) - ABOVE
    return Label(
        at,
        name,
        "text",
        (0.0, BELOW),
        "center",
        13.0,
        rank=0 if seen.is_selected else 1,
        instead=((0.0, above), (0.0, BELOW + LOWER), (0.0, above - LOWER)),
    )
