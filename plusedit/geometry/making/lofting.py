"""A surface through several curves, its sections.

In one basis, section k has control points P^k_i, directions d^k_i and weights W^k_i. For each i the
planes (i, j) are a plus curve in v, which has to meet, at the parameters v_k and all at once,

    sum_j c_j(v_k) W_ij = W^k_i,    sum_j c_j(v_k) W_ij d^u_ij = W^k_i d^k_i,
    sum_j c_j(v_k) W_ij (P_ij + s (v_k - y_j) d^v_ij) = W^k_i P^k_i:

then S(u, v_k) is section k. The directions by v come first: half the velocity at y_j of the smooth
curve through the P^k_i, with which the control points come to lie next to the surface. The points
and the directions by u follow from the equations, which have as many unknowns.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.making.compatible import compatible, unweighted
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface

ORDER = 4  # by v, where there are sections enough
LEAST = 1e-2  # of the mean: weights between sections must not come nearer to zero


def lofted(
    curves: Sequence[PlusCurve], *, closed: bool = False, tolerance: float | None = None
) -> PlusSurface:
    """A smooth surface through the curves in their order, each at one value of v.

    Parameters
    ----------
    curves
        Two or more; u runs along them. See `compatible` for how they get one basis; they are met
        exactly, at the s that they have, unless they had to be fitted.
    closed
        Whether the surface goes on from the last curve to the first; asks for three.
    tolerance
        How far fitted curves may leave theirs, a distance.

    The values of v are those of `section_parameters`. Raises ValueError for too few curves, and
    where one follows another that is the same.
    """
    if len(curves) < (3 if closed else 2):
        least = "three curves to close" if closed else "two curves"
        raise ValueError(f"A loft needs at least {least}.")
    alike = compatible(curves, tolerance=tolerance).curves
    planes = _planes(alike, closed)
    if planes is None:
        # No positive weights lead from section to section.
        alike = unweighted(curves, tolerance=tolerance).curves
        planes = _planes(alike, closed)
    if planes is None:
        raise ValueError("Through these curves there is no surface.")
    basis = _basis(section_parameters(alike, closed=closed), closed)
    return PlusSurface(alike[0].basis, basis, planes, alike[0].s)


def section_parameters(curves: Sequence[PlusCurve], *, closed: bool = False) -> Floats:
    """(m,) the value of v at which a loft meets each curve.

    By the mean distance from curve to curve, from 0 to 1; of a closed loft evenly spread. Raises
    ValueError where two curves that follow each other lie in one place.
    """
    if closed:
        return np.arange(len(curves)) / len(curves)
    alike = compatible(curves).curves
    u = np.linspace(0.0, 1.0, 33)
    at = [curve.at(u) for curve in alike]
    steps = np.array([np.linalg.norm(b - a, axis=1).mean() for a, b in pairwise(at)])
    if steps.min() <= 1e-9 * steps.max():
        raise ValueError("Two curves of the loft lie in the same place.")
    ends = np.concatenate([[0.0], np.cumsum(steps)])
    parameters: Floats = ends / ends[-1]
    return parameters


def _basis(at: Floats, closed: bool) -> BSpline:
    """B-splines for the sections: knots are means of neighboring parameters (The NURBS Book, 9.8).

    So each function has a section of its own where it is not zero.
    """
    size = len(at)
    if closed:
        return BSpline(size, min(ORDER, size), closed=True)
    order = min(ORDER, size)
    inner: tuple[float, ...] = ()
    if size > order:
        windows = np.lib.stride_tricks.sliding_window_view(at[1:-1], order - 1)
        inner = tuple(windows.mean(axis=1).tolist())
    return BSpline(size, order, knots=(0.0,) * order + inner + (1.0,) * order)


def _planes(curves: Sequence[PlusCurve], closed: bool) -> ControlPlanes | None:
    """The control planes through the sections; None where a weight would not be positive."""
    at = section_parameters(curves, closed=closed)
    basis = _basis(at, closed)
    values, reaches = basis.values(at), basis.reaches(at)
    on = np.stack([curve.lines.points for curve in curves], axis=1)
    along = np.stack([curve.directions for curve in curves], axis=1)
    # Of each section only ratios matter: about one, they vary least from section to section.
    weights = np.stack([_evened(curve.lines.unit_weights) for curve in curves], axis=1)
    between = _solved(values, weights[..., None])[..., 0]
    if between.min() < LEAST * between.mean():
        return None
    s = curves[0].s
    # The smooth curve through the control points of all sections, and half its velocity.
    ahead = np.einsum("kj,ijd->ikd", basis.values(basis.nodes, derivative=1), _solved(values, on))
    by_v: Floats = ahead / (2.0 * s) if s else np.zeros_like(on)
    pulled = np.einsum("kj,ijd->ikd", reaches, between[..., None] * by_v)
    points = _solved(values, weights[..., None] * on - s * pulled) / between[..., None]
    by_u = _solved(values, weights[..., None] * along) / between[..., None]
    automatic = np.zeros((2, *on.shape[:2]), dtype=np.bool_)
    automatic[1] = s == 0.0
    plain = all(curve.lines.weights is None for curve in curves)
    return ControlPlanes(points, np.stack([by_u, by_v]), automatic, None if plain else between)


def _evened(weights: Floats) -> Floats:
    """The weights divided by their geometric mean."""
    evened: Floats = weights / np.exp(np.log(weights).mean())
    return evened


def _solved(values: Floats, rows: Floats) -> Floats:
    """(n, m, dim) for each i the x_ij with sum_j values[k, j] x_ij = rows[i, k]."""
    return np.asarray(np.linalg.solve(values, rows), dtype=np.float64)
