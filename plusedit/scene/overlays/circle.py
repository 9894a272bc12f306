"""The osculating circle at the point of a curve under the pointer, with its center and radius.

The circle that touches the curve there as closely as any: in its plane, with its curvature. Where
the curve is straight it is the tangent.
"""

from collections.abc import Iterator
from math import ceil, pi, sqrt

import numpy as np

from plusedit.document.shape import Geometry, Shape
from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curvature_profile import curvature_vectors
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.frames import curvature
from plusedit.scene.items import Item, Label, Markers, Polyline, Segments
from plusedit.scene.overlays import Seen, overlay

COLOR = "hover"
FLATTEST = 1e5  # pixels of a radius: larger circles are straight as far as anyone sees
STRAY = 0.2  # pixels by which chords may stray from the circle
FEWEST = 64  # of them
WORDS = 12.0  # pixels, the height of letters
ASIDE = (12.0, -12.0)  # pixels from the point to the words

circle = overlay(
    "circle",
    title="Osculating circle under the pointer",
    order=112,
    shortcut="O",
    group="Curve analysis",
)


@circle.under_pointer
def at_place(
    shape: Shape, geometry: Geometry, place: tuple[float, ...], seen: Seen
) -> Iterator[Item]:
    """The circle, its center joined to the point, and the radius and the curvature in words."""
    if not isinstance(geometry, PlusCurve):
        return
    points, velocity, acceleration = geometry.derivatives([place[0]])
    tangent, bend = unit(velocity)[0], curvature_vectors(velocity, acceleration)[0]
    point = points[0]
    if not (tangent.any() and np.isfinite(bend).all()):
        return
    size = float(np.linalg.norm(bend))
    pixel = float(seen.camera.pixel_at(points)[0])
    if size * FLATTEST * pixel <= 1.0:
        yield from _tangent(point, tangent, pixel)
        yield _words(point, "straight   κ 0")
        return
    radius, normal = 1.0 / size, bend / size
    center = point + radius * normal
    angles = np.linspace(0.0, 2.0 * pi, _chords(radius / pixel) + 1)[:, None]
    ring = center + radius * (np.sin(angles) * tangent - np.cos(angles) * normal)
    yield Polyline(ring, COLOR, 1.5)
    yield Segments(point[None], center[None], f"{COLOR}@70", 1.0, "dash")
    yield Markers(center[None], "cross", 8.0, None, COLOR, 1.5)
    yield Markers(point[None], "circle", 8.0, COLOR, "canvas", 1.5)
    signed = float(curvature(velocity, acceleration)[0]) if geometry.dimension == 2 else size
    yield _words(point, f"r {radius:.4g}   κ {signed:.4g}")


def _tangent(point: Floats, tangent: Floats, pixel: float) -> Iterator[Item]:
    reach = FLATTEST * pixel / 10.0 * tangent
    yield Segments((point - reach)[None], (point + reach)[None], COLOR, 1.5)
    yield Markers(point[None], "circle", 8.0, COLOR, "canvas", 1.5)


def _words(point: Floats, text: str) -> Label:
    return Label(point, text.replace("-", "\N{MINUS SIGN}"), "text", ASIDE, "left", WORDS)


def _chords(radius: float) -> int:
    """How many chords a circle of that many pixels takes."""
    return max(FEWEST, ceil(pi * sqrt(radius / (2.0 * STRAY))))
