"""Four designs that prove what the paper has wrong; `make_examples.py` writes them.

A. A. Goshtasby, Plus Curves and Surfaces, says that the hull of a plus curve is the union of two
hulls, that end lines of opposite directions close a curve smoothly, that two nets hold a surface,
and that a plus curve has one inflection more. Nearly so: the designs show what is true.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from curve_examples import bezier, design, panels, parent_points, turned
from surface_examples import Eye, legible, moved, scene

from plusedit.document.design import Design
from plusedit.document.shape import Style
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.tangency import closed_smoothly, tangent_at_ends

FRAME = ((0.0, 0.0), (1.2, 2.0), (2.8, 2.0), (4.0, 0.0))
DROP = ((2.0, 0.0), (4.6, 1.2), (3.6, 3.6), (0.4, 3.6), (-0.6, 1.2), (2.0, 0.0))
GABLE = ((0.0, 0.0), (2.0, 3.0), (4.0, 0.0))
SLOPE = 2.0  # height per unit of parameter, of the planes at two corners


def fact_hull_of_the_union() -> Design:
    """One curve that is outside of both hulls nearly everywhere."""
    about = (
        "A plus curve lies in the convex hull (blue) of the union of the control points of its two"
        " parents, not in the union of their hulls (pink): nearly all of this one is outside of"
        " both."
    )
    curve = turned(bezier(FRAME, 0.8), {0: -30.0, 1: -20.0, 2: 20.0, 3: 30.0})
    return design(panels([curve], 1, extent=parent_points), about, "hulls")


def fact_equal_ends_close_smoothly() -> Design:
    """The same points closed twice."""
    about = (
        "Both curves end where they begin, tangent to their end control lines. (a) Equal directions"
        " at both ends close a curve smoothly. (b) Opposite directions close it with a cusp."
    )
    smooth = closed_smoothly(bezier(DROP, 0.5))
    last, reversed_ = len(DROP) - 1, -smooth.directions[0]
    lines = smooth.lines.with_direction(last, reversed_)
    cusp = tangent_at_ends(replace(smooth, lines=lines), start=False, how="exact", speed=18.0)
    return design(panels([smooth, rounded(cusp)], 2, 3.0), about, "names polygon classical", "all")


def fact_four_nets_of_a_surface() -> Design:
    """Surfaces whose nets at opposite corners both are flat squares."""
    about = (
        "A plus surface is a mean of four classical ones and lies in the convex hull (blue) of"
        " their nets (pink). Two nets are not enough: (a) those of the corners (0, 0) and (1, 1)"
        " are the same flat square, (b) those of (1, 0) and (0, 1) are; neither surface is flat."
    )
    eye = Eye((0.0, 0.0, 0.0), 4.4, 0.5, 0.62, perspective=False)
    right, _ = eye.ground
    pairs = (((0, 0), (1, 1)), ((1, 0), (0, 1)))
    layers = [
        (f"({letter})", moved(between_flat_nets(pair), place * right), Style())
        for letter, pair, place in zip("ab", pairs, (-1.7, 1.7), strict=True)
    ]
    return scene(layers, about, eye, "hulls names polygon", "all")


def fact_two_inflections_more() -> Design:
    """Convex control polygons, and curves that are not."""
    about = (
        "Going from Bezier (red) to Bezier+ a curve can gain two inflections, not only one, even"
        " where the control polygon is convex: (a) with four control points, (b) with three."
    )
    curves = [
        turned(bezier(FRAME, 1.0), {0: -60.0, 1: -120.0, 2: 120.0, 3: 60.0}),
        turned(bezier(GABLE, 0.45), {1: 180.0}),
    ]
    return design(panels(curves, 2), about, "classical names polygon extrema", "all")


def between_flat_nets(flat: tuple[tuple[int, int], tuple[int, int]]) -> PlusSurface:
    """A Bezier+ surface of four planes on a flat square, whose nets at those corners are flat.

    The planes there slope so that they meet both corners at height 0; the other two are level.
    """
    points = np.array([[(x, y, 0.0) for y in (-1.0, 1.0)] for x in (-1.0, 1.0)])
    directions = np.zeros((2, 2, 2, 3))
    directions[0, ..., 0] = directions[1, ..., 1] = 2.0
    for i, j in flat:
        directions[0, i, j, 2] = SLOPE
        directions[1, i, j, 2] = SLOPE if i != j else -SLOPE
    planes = ControlPlanes.of(points).with_directions(directions)
    return legible(PlusSurface(Bernstein(2), Bernstein(2), planes, 1.0))


def rounded(curve: PlusCurve) -> PlusCurve:
    """The curve with directions that people can read."""
    directions = np.round(curve.directions, 9) + 0.0
    return replace(curve, lines=curve.lines.with_directions(directions))


FACTS: tuple[Callable[[], Design], ...] = (
    fact_hull_of_the_union,
    fact_equal_ends_close_smoothly,
    fact_four_nets_of_a_surface,
    fact_two_inflections_more,
)
