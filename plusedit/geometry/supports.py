"""Where blending functions are not zero: the part of a shape that a control line or plane moves."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bspline import BSpline


def supports(basis: Basis) -> Floats:
    """(2, n) the parameters between which each function differs from zero.

    Those of a closed B-spline reach beyond 0 and 1, and beyond one period where there are few
    lines. Other families have no ends: an open one acts on all of [0, 1], a closed one on the
    period about the node.
    """
    nodes = basis.nodes
    if isinstance(basis, BSpline) and not basis.closed:
        knots = basis.knot_vector
        return np.stack([knots[: basis.size], knots[basis.order :]])
    if not basis.closed:
        return np.stack([np.zeros(basis.size), np.ones(basis.size)])
    half = basis.order / (2.0 * basis.size) if isinstance(basis, BSpline) else 0.5
    return np.stack([nodes - half, nodes + half])


def stretches(basis: Basis, number: int) -> list[tuple[float, float]]:
    """The parts of [0, 1] on which one function differs from zero: one, or two across a seam."""
    low, high = (float(end) for end in supports(basis)[:, number])
    if not basis.closed:
        return [(low, high)]
    if high - low >= 1.0:
        return [(0.0, 1.0)]
    low, high = low - np.floor(low), high - np.floor(low)
    return [(low, high)] if high <= 1.0 else [(0.0, high - 1.0), (low, 1.0)]
