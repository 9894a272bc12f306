"""The classical curve of the same control points: what the control lines pull away from."""

from collections.abc import Iterator

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn import drawn
from plusedit.scene.items import Item, Polyline
from plusedit.scene.overlays import overlay

STRAIGHT = 1e-9  # what a direction may stray from the stroke


@overlay("classical", title="Classical curve", order=40, shortcut="Shift+C")
def draw(shape: Shape, curve: PlusCurve, camera: PlaneCamera) -> Iterator[Item]:
    """A thin line; nothing where it is the curve itself: at s = 0, and of a straight stroke."""
    if curve.s != 0.0 and not _is_straight(curve):
        yield Polyline(drawn(curve.classical, camera).points, "classical", 1.0)


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
