"""The classical shape of the same control points: what control lines and planes pull away from."""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.isolines import isolines
from plusedit.scene.items import Item, Polyline
from plusedit.scene.overlays import Seen, overlay

STRAIGHT = 1e-9  # what a direction may stray from the stroke

classical = overlay("classical", title="Classical shape", order=40, shortcut="Shift+C")


@classical.of_curves
def classical_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """A thin line; nothing where it is the curve itself: at s = 0, and of a straight stroke."""
    if curve.s != 0.0 and not _is_straight(curve):
        yield Polyline(drawn(curve.classical, seen.camera).points, "classical", 1.0)


@classical.of_surfaces
def classical_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """Thin lines at the nodes and along the edges; nothing at s = 0, where it is the surface."""
    if surface.s == 0.0:
        return
    # As fine as the surface itself: they are near each other, and it is worked out already.
    lines = isolines(surface.classical, surface_grids(surface, seen.camera))
    for points in (*lines.along_u, *lines.along_v):
        yield Polyline(points, "classical@50", 1.0)
    for points in lines.edges:
        yield Polyline(points, "classical", 1.0)


def _is_straight(curve: PlusCurve) -> bool:
    """Whether it is a stroke from point to point, as drawings have many, with no bend in it."""
    if len(curve.lines) > 2:
        return False
    chord = curve.lines.points[1] - curve.lines.points[0]
    length = float(np.linalg.norm(chord))
    if not length:
        return False
    along = chord / length
    aside = curve.directions - np.outer(curve.directions @ along, along)
    return bool(np.abs(aside).max() <= STRAIGHT)
