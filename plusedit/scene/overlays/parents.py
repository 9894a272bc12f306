"""The two classical curves that an open plus curve is the mean of, with their control points.

The control points of the first parent are all lines at u = 0, P1_i = L_i(0), those of the second
all lines at u = 1, P2_i = L_i(1), and C(u) = (1 - u) C_1(u) + u C_2(u): eq. 11 of the paper.
"""

from collections.abc import Iterator
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Geometry, Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.hulls import parents as parents_of
from plusedit.scene.drawn import drawn
from plusedit.scene.items import Caption, Dash, Item, Label, Mark, Markers, Polyline, Row, Segments
from plusedit.scene.overlays import Seen, overlay
from plusedit.scene.shapes import shown_shapes

FIRST, SECOND = "#0A7FB8", "#D2691E"  # blue and orange: told apart by everyone, on both canvases
MARKS: tuple[tuple[str, Mark, Dash, str], ...] = (
    (FIRST, "circle", "solid", "P1"),
    (SECOND, "square", "dash", "P2"),
)

_KEPT: "WeakKeyDictionary[PlusCurve, tuple[PlusCurve, PlusCurve]]" = WeakKeyDictionary()
"""What is drawn of a curve is kept with it: so its parents are."""

parents = overlay(
    "parents", title="Parent curves", order=12, shortcut="Shift+U", group="Constructions"
)


@parents.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """Each line from its end on one parent to that on the other; both polygons, both curves.

    Nothing for a closed curve: it has no parents that close.
    """
    if curve.closed:
        return
    two = _kept(curve)
    first, second = (parent.lines.points for parent in two)
    yield Segments(first, second, "quiet@60", 1.0, "dot")
    for parent, (color, mark, dash, name) in zip(two, MARKS, strict=True):
        points = parent.lines.points
        yield Polyline(points, f"{color}@50", 1.0, dash)
        yield Polyline(drawn(parent, seen.camera).points, color, 1.5)
        yield Markers(points, mark, 6.0, color, "canvas", 1.0)
        farthest = points[-1] if name == "P1" else points[0]
        yield Label(farthest, name, color, (7.0, -6.0))


@parents.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """What the colors stand for, where there is a curve that has parents."""
    if any(isinstance(g, PlusCurve) and not g.closed for _, _, g in shown_shapes(design)):
        rows = (
            Row("P1: all lines at u = 0", color=FIRST),
            Row("P2: all lines at u = 1", color=SECOND),
        )
        yield Caption("C = (1 − u) C1 + u C2", rows)


@parents.under_pointer
def at_place(
    shape: Shape, geometry: Geometry, place: tuple[float, ...], seen: Seen
) -> Iterator[Item]:
    """The points of both parents that make the point under the pointer."""
    if not isinstance(geometry, PlusCurve) or geometry.closed:
        return
    (first,), (second,) = (parent.at(place) for parent in _kept(geometry))
    yield Segments(first[None], second[None], "hover", 1.5)
    for at, (color, mark, _, _) in zip((first, second), MARKS, strict=True):
        yield Markers(at[None], mark, 8.0, color, "canvas", 1.0)
    yield Markers(np.atleast_2d(geometry.at(place)), "circle", 8.0, "hover", "canvas", 1.0)


def _kept(curve: PlusCurve) -> tuple[PlusCurve, PlusCurve]:
    if curve not in _KEPT:
        _KEPT[curve] = parents_of(curve)
    return _KEPT[curve]
