"""Directions that lead the curve through its own control points.

At the nodes the curve is linear in the gradients, C(x_i) = sum_j B_ij P_j + sum_j D_ij g_j. Of all
changes of the gradients that put it onto the control points the pseudo-inverse of D gives the
smallest; where none does, as on most closed curves of an even number of lines, it gives the
smallest of those that come closest.
"""

from dataclasses import dataclass, replace

import numpy as np

from plusedit.geometry.blend import Grid, blend
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.matrices import dense

RANK = 1e-10  # of the largest singular value: what is below is rounding
UNCHANGED = 1e-12  # of the largest change: such a direction stays automatic


@dataclass(frozen=True, eq=False)
class Passed:
    """A curve with new directions, and how far it still misses its control points."""

    curve: PlusCurve
    largest_miss: float
    """in the unit of the points; rounding where the curve passes through all of them"""


def passing_through(curve: PlusCurve) -> PlusCurve:
    """The curve through its control points with the least change of its directions.

    Where that can't be done, the one that comes closest; `passed` says how close. Points,
    weights and s stay. Raises ValueError if s is zero, so that directions have no effect.
    """
    return passed(curve).curve


def passed(curve: PlusCurve) -> Passed:
    """`passing_through`, and how far the curve still is from its control points."""
    if curve.s == 0.0:
        raise ValueError("With s = 0 control lines have no effect; set s first.")
    nodes = curve.basis.nodes
    matrices = blend(curve.basis, Grid(nodes))
    weights = curve.lines.unit_weights
    values, reaches = dense(matrices.values), dense(matrices.reaches)
    rational = reaches * weights / (values @ weights)[:, None]
    missing = curve.lines.points - curve.at(nodes)
    change = np.linalg.lstsq(rational, missing, rcond=RANK)[0]
    lines, size = curve.lines, np.linalg.norm(change, axis=1)
    directions = curve.directions + change / curve.s
    for index in np.flatnonzero(size > UNCHANGED * max(size.max(), np.abs(curve.gradients).max())):
        lines = lines.with_direction(int(index), directions[index])
    through = replace(curve, lines=lines)
    miss = np.linalg.norm(lines.points - through.at(nodes), axis=1)
    return Passed(through, float(miss.max()))
