"""A small arrow near the start of a curve: which way its parameter runs."""

from collections.abc import Iterator

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import Camera
from plusedit.scene.drawn import drawn
from plusedit.scene.items import Item, Polygon

FROM_START = 26.0  # pixels along the curve: clear of the first dot and of short grips
LENGTH, HALF_WIDTH = 9.0, 4.5  # pixels


def direction_arrow(curve: PlusCurve, camera: Camera) -> Iterator[Item]:
    """A filled triangle on the curve, pointing forwards; none on a curve of a few pixels."""
    shown = drawn(curve, camera)
    place = _place(shown.screen)
    if place is None:
        return
    tip, way = place
    across = np.array([-way[1], way[0]])
    back = tip - LENGTH * way
    corners = np.stack([tip, back + HALF_WIDTH * across, back - HALF_WIDTH * across])
    nearest = int(np.hypot(*(shown.screen - tip).T).argmin())
    like = np.zeros(3)
    like[: curve.dimension] = shown.points[nearest]
    seen = np.stack([camera.to_world(corner, like) for corner in corners])
    yield Polygon(seen, "selected", "canvas", 1.0)


def _place(screen: Floats) -> tuple[Floats, Floats] | None:
    """Where the tip of the arrow stands and its unit direction, in pixels."""
    steps = np.diff(screen, axis=0)
    along = np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))
    tip = FROM_START + LENGTH / 2.0
    if along[-1] < 2.0 * tip:
        return None
    ends = [_at(screen, along, distance) for distance in (FROM_START - LENGTH / 2.0, tip)]
    way = ends[1] - ends[0]
    length = float(np.hypot(*way))
    return (ends[1], way / length) if length > LENGTH / 4.0 else None


def _at(screen: Floats, along: Floats, distance: float) -> Floats:
    index = int(np.searchsorted(along, distance))
    before = along[index - 1] if index else 0.0
    share = (distance - before) / (along[index] - before)
    point: Floats = screen[index] + share * (screen[index + 1] - screen[index])
    return point
