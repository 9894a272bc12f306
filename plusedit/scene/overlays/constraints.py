"""Small badges where shapes keep something: T tangent, C closed smoothly, P through a point.

A badge with an exclamation mark says that there is no solution now; the status bar and the
Inspector say why, and what would make one.
"""

from collections.abc import Iterator

import numpy as np

from plusedit.document.constraining import problems_of
from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.constraints import Constrained, constraints
from plusedit.scene.camera import Camera
from plusedit.scene.items import Item, Label, Markers
from plusedit.scene.overlays import Seen, overlay

LETTERS = {
    "tangent_start": "T",
    "tangent_end": "T",
    "smooth_closing": "C",
    "corner_tangency": "T",
    "passing": "P",
}
SIZE = 15.0  # pixels
ASIDE = np.array([13.0, -13.0])  # pixels from the place itself to its badge
STEP = np.array([16.0, 0.0])  # to the next where several stand in one place
MOST = 60  # badges of one constraint: where more points are passed, each is a dot

badges = overlay("constraints", title="Constraints", order=65, shortcut="Shift+B")


def constraint_badges(shape: Shape, geometry: Constrained, seen: Seen) -> Iterator[Item]:
    """A badge for each constraint, at every place where it is at work."""
    problems = problems_of(shape)
    taken: dict[tuple[float, float], int] = {}
    for wish in shape.constraints:
        constraint = constraints[wish.kind]
        if wish in problems and constraint.counts != "none" and not wish.numbers:
            continue
        places = constraint.places(geometry, wish.numbers)
        if len(places) > MOST:
            yield Markers(places, "diamond", 7.0, "accent", "canvas", 1.0)
            continue
        color, letter = ("classical", "!") if wish in problems else ("accent", LETTERS[wish.kind])
        for place in places:
            pixel = seen.camera.to_screen(place[None])[0]
            if not np.isfinite(pixel).all():
                continue
            key = (round(float(pixel[0])), round(float(pixel[1])))
            count = taken[key] = taken.get(key, -1) + 1
            yield from _badge(pixel + ASIDE + count * STEP, place, letter, color, seen.camera)


badges.of_curves(constraint_badges)
badges.of_surfaces(constraint_badges)


def _badge(pixel: Floats, like: Floats, letter: str, color: str, camera: Camera) -> Iterator[Item]:
    """A disk with a letter at a pixel, as deep in the view as a point."""
    deep = np.append(like, 0.0) if len(like) == 2 else like
    at = camera.to_world(pixel, deep)
    yield Markers(at[None], "circle", SIZE, color, "canvas", 1.0)
    yield Label(at, letter, "canvas", (0.0, 3.5), "center", 10.0)
