"""The magnitude s: the length it is measured by, and the value that serves best.

The curve is C = base + s plus. With f_i = base(x_i), p_i = plus(x_i) at the nodes, the sum of
|f_i + s p_i - P_i|^2 is least for

    s* = sum p_i . (P_i - f_i) / sum p_i . p_i.

It brings the curve closest to its control points: exactly through the points of a regular
polygon, and exactly onto a quadratic that the lines are tangent to.
"""

import numpy as np

from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve, terms

NO_EFFECT = 1e-12  # of the longest direction: a plus term this small is rounding


def polygon_length(curve: PlusCurve) -> float:
    """L, the length of the control polygon, with the closing edge on a closed curve.

    The natural unit of s: useful values lie between 0 and 2 L, whatever the size of the model.
    """
    points = curve.lines.points
    ahead = np.roll(points, -1, axis=0) if curve.closed else points[1:]
    return float(np.linalg.norm(ahead - points[: len(ahead)], axis=1).sum())


def best_s(curve: PlusCurve) -> float | None:
    """s*, which brings the curve closest to its control points; None if s changes nothing.

    Closest at the nodes and in the sense of least squares, for the directions the curve has;
    it may be negative where they run against the polygon.
    """
    largest = float(np.abs(curve.directions).max())
    if largest == 0.0:
        return None
    base, plus = terms(curve.basis, curve.lines, Grid(curve.basis.nodes))
    pull = plus / largest
    effect = float((pull * pull).sum())
    if effect <= NO_EFFECT**2:
        return None
    return float((pull * (curve.lines.points - base)).sum() / effect / largest)
