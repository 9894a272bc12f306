"""Stripes that light makes on surfaces: which an overlay asks for, and where the light comes from.

Each is a band of a function of the normal n, of the way v to the eye and of what a mirror sees,
r = 2 (n . v) n - v; a kink of a band shows a kink of the surface, a jump a jump of its tangents.

    zebra       the angle between r and the vertical of the view: bands in the sky of a room that
                turns with the eye
    reflection  the angle of r around the x axis of the world: straight lamps in a hall that stands
    isophotes   the angle between n and a light that stands, alike from everywhere
"""

from collections.abc import Iterable
from dataclasses import dataclass

from plusedit.scene.bearings import Vector, vector_at
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import Overlay, StripeKind, in_order


@dataclass(frozen=True)
class Stripes:
    """How surfaces are striped."""

    kind: StripeKind
    count: int
    """pairs of a dark band and a light one, over half a turn"""
    light: Vector = (0.0, 0.0, 1.0)
    """a unit vector toward it, in the world"""


def striping_overlay(names: Iterable[str]) -> Overlay | None:
    """The overlay that stripes surfaces while those are switched on: one at most."""
    chosen = frozenset(names)
    return next((o for o in in_order() if o.name in chosen and o.stripes), None)


def stripes_of(options: ViewOptions) -> Stripes | None:
    """What a view with those options stripes surfaces with, if with anything."""
    entry = striping_overlay(options.overlays)
    if entry is None:
        return None
    numbers = entry.numbers(options.settings)
    toward = vector_at(numbers.get("height", 90.0), numbers.get("bearing", 360.0))
    return Stripes(entry.stripes, round(numbers["count"]), toward)
