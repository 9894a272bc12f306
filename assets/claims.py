"""A design of what plus curves do better, and what that takes; `make_examples.py` writes it.

A. A. Goshtasby, Plus Curves and Surfaces, says that they come as near with fewer control points.
The curves are those that the panel "Fit comparison" finds for a spiral, their numbers rounded.
"""

from collections.abc import Iterator

import numpy as np
from curve_examples import Layer, design, moved

from plusedit.document.design import Design
from plusedit.document.shape import Style
from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines

POINTS = (
    (0.15, 0), (-1.0096, -0.6799), (1.9616, 0.6244), (-2.4587, 0.2419), (1.2624, -1.6374), (1, 0),
)  # fmt: skip
LINES = (
    (0.15, 0), (-0.3806, 1.3962), (0.3935, -1.855), (-0.7273, 2.1605), (0.2429, -2.3613), (1, 0),
)  # fmt: skip
GRADIENTS = (
    (1.835, -7.884), (-3.876, -2.415), (4.63, 2.124), (-6.047, -0.583), (7.937, -1.354),
    (3.152, -5.297),
)  # fmt: skip
MORE_POINTS = (
    (0.15, 0), (0.2115, 0.2399), (-0.3069, 0.3819), (-0.4645, -0.3159), (0.2148, -0.61),
    (0.7336, -0.0067), (0.3259, 0.7541), (-0.6154, 0.6761), (-0.9712, -0.3206), (-0.0503, -1.1751),
    (0.9397, -0.6311), (1, 0),
)  # fmt: skip

THIN = 64  # lines of the spiral itself
GRAY, RED, GREEN = "#8A94A6", "#C8372D", "#12824A"
APART = 5.6  # from panel to panel


def claims() -> Design:
    """The same spiral three times, and what comes near to it."""
    about = (
        "A spiral (gray) fitted by least squares. Left: a B-spline of 6 control points stays 0.26"
        " away (rms). Middle: a B-spline+ of 6 control lines comes within 0.0032. But a line takes"
        " twice the numbers of a point: a B-spline of 12 points, on the right, stores as many and"
        " comes within 0.0015. View > Fit comparison draws all of this, of any shape."
    )
    return design(_panels(), about, "polygon", "none")


def spiral_at(t: Floats) -> Floats:
    """(m, 2) the points of the spiral, t from 0 to 1."""
    angle = 4.0 * np.pi * t
    ring: Floats = (0.15 + 0.85 * t)[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return ring


def _panels() -> Iterator[Layer]:
    points = PlusCurve(BSpline(6), ControlLines.of(POINTS), 0.0)
    lines = PlusCurve(BSpline(6), ControlLines.of(LINES, np.array(GRADIENTS)), 1.0)
    more = PlusCurve(BSpline(12), ControlLines.of(MORE_POINTS), 0.0)
    for number, (letter, curve) in enumerate(zip("abc", (points, lines, more), strict=True)):
        place = np.array([APART * number, 0.0])
        yield f"spiral {letter}", moved(_spiral(), place), Style(GRAY, 7.0)
        yield f"({letter})", moved(curve, place), Style(GREEN if curve.s else RED, 2.0)


def _spiral() -> PlusCurve:
    """The spiral itself: with P = f(x) and g = f'(x) / 2 a B-spline+ is nearly f."""
    basis, step = BSpline(THIN), 1e-6
    x = basis.nodes
    low, high = np.maximum(x - step, 0.0), np.minimum(x + step, 1.0)
    slopes = (spiral_at(high) - spiral_at(low)) / (high - low)[:, None]
    points, halves = np.round(spiral_at(x), 6) + 0.0, np.round(slopes / 2.0, 4) + 0.0
    return PlusCurve(basis, ControlLines.of(points, halves), 1.0)
