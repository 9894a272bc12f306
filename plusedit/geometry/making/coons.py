"""A surface between four curves: the tensor sum, or Coons patch, of its edges.

    S(u, v) = (1 - v) C_0(u) + v C_1(u) + (1 - u) E_0(v) + u E_1(v)
              - the bilinear surface of the four corners.

Functions that are linear in v are sums over y_j (Greville's abscissae), so with the nodes x_i, y_j

    P_ij = (1 - y_j) P0_i + y_j P1_i + (1 - x_i) Q0_j + x_i Q1_j - bilinear(x_i, y_j),
    d^u_ij = (1 - y_j) d0_i + y_j d1_i,    d^v_ij = (1 - x_i) e0_j + x_i e1_j

are its control planes, exactly and for every s: what the gradients of the edges contribute is
linear across, and nothing is taken away from it. With weights all that is done to W P, W d and W.
"""

from collections.abc import Sequence

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.making.compatible import (
    TOLERANCE,
    compatible,
    in_space,
    of_one_magnitude,
    unweighted,
)
from plusedit.geometry.making.refitting import fitted_together
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface

MEETING = 1e-6  # of the extent: ends that are closer meet
SAME_WEIGHT = 1e-9  # relative

Pair = tuple[PlusCurve, PlusCurve]


def coons(
    u0: PlusCurve,
    u1: PlusCurve,
    v0: PlusCurve,
    v1: PlusCurve,
    *,
    tolerance: float | None = None,
) -> PlusSurface:
    """The surface between four open curves that meet at their ends.

    Parameters
    ----------
    u0, u1
        The edges v = 0 and v = 1, along u.
    v0, v1
        The edges u = 0 and u = 1, along v: from the start of `u0` to that of `u1`, and from the
        end of `u0` to that of `u1`.
    tolerance
        How far edges that have to be fitted may leave theirs, a distance.

    The edges are met with their directions and s: exactly, unless opposite ones have no basis in
    common or their weights don't agree at the corners. Raises ValueError if an edge is closed, or
    two don't meet.
    """
    first, second, third, fourth = of_one_magnitude([in_space(c) for c in (u0, u1, v0, v1)])
    _check_corners((first, second, third, fourth))
    along_u, along_v = _pair(first, second, tolerance), _pair(third, fourth, tolerance)
    planes = _planes(along_u, along_v)
    if planes is None:
        along_u, along_v = (_pair(*two, tolerance, weighted=False) for two in (along_u, along_v))
        planes = _planes(along_u, along_v)
    if planes is None:
        raise ValueError("Between these curves there is no surface.")
    return PlusSurface(along_u[0].basis, along_v[0].basis, planes, first.s)


def _pair(
    first: PlusCurve, second: PlusCurve, tolerance: float | None, *, weighted: bool = True
) -> Pair:
    """Opposite edges in one basis, of Bezier or B-spline functions."""
    alike = (compatible if weighted else unweighted)([first, second], tolerance=tolerance).curves
    if isinstance(alike[0].basis, RationalGaussian):
        # Rational Gaussians don't begin at their first point: no corner would be met.
        extent = float(np.ptp(np.concatenate([curve.lines.points for curve in alike])))
        alike = fitted_together(alike, tolerance or TOLERANCE * extent or 1.0)[0]
    return alike[0], alike[1]


def _check_corners(edges: Sequence[PlusCurve]) -> None:
    if any(curve.closed for curve in edges):
        raise ValueError("A closed curve can't be an edge of a surface between four curves.")
    extent = float(np.ptp(np.concatenate([c.lines.points for c in edges]), axis=0).max())
    u0, u1, v0, v1 = (curve.at([0.0, 1.0]) for curve in edges)
    meetings = ((u0[0], v0[0]), (u0[1], v1[0]), (u1[0], v0[1]), (u1[1], v1[1]))
    gap = max(float(np.linalg.norm(b - a)) for a, b in meetings)
    if gap > MEETING * extent:
        raise ValueError(f"The four curves don't meet at their ends: there is a gap of {gap:.3g}.")


def _planes(along_u: Pair, along_v: Pair) -> ControlPlanes | None:
    """The tensor sum; None if weights don't agree at the corners, or one would not be positive."""
    scales = _scales(along_u, along_v)
    if scales is None:
        return None
    x, y = along_u[0].basis.nodes, along_v[0].basis.nodes
    edges = [*along_u, *along_v]
    W = [f * curve.lines.unit_weights for f, curve in zip(scales, edges, strict=True)]
    P = [w[:, None] * c.lines.points for w, c in zip(W, edges, strict=True)]
    D = [w[:, None] * c.directions for w, c in zip(W, edges, strict=True)]
    weights = _summed([w[:, None] for w in W], x, y)
    if weights.min() <= 0.0:
        return None
    given = np.stack([_across_v(D[0], D[1], y), _across_u(D[2], D[3], x)]) / weights
    automatic = np.zeros((2, len(x), len(y)), dtype=np.bool_)
    plain = all(curve.lines.weights is None for curve in edges)
    kept = None if plain else weights[..., 0]
    return ControlPlanes(_summed(P, x, y) / weights, given, automatic, kept)


def _summed(edges: Sequence[Floats], x: Floats, y: Floats) -> Floats:
    """(n_u, n_v, dim) the tensor sum of rows (n_u, dim) twice and columns (n_v, dim) twice."""
    u0, u1, v0, v1 = edges
    corners = _across_v(np.stack([u0[0], u0[-1]]), np.stack([u1[0], u1[-1]]), y)
    summed: Floats = (
        _across_v(u0, u1, y) + _across_u(v0, v1, x) - _across_u(corners[0], corners[1], x)
    )
    return summed


def _across_v(first: Floats, last: Floats, y: Floats) -> Floats:
    """(n_u, n_v, dim) linear in v between two rows along u (n_u, dim)."""
    across: Floats = (1.0 - y)[:, None] * first[:, None] + y[:, None] * last[:, None]
    return across


def _across_u(first: Floats, last: Floats, x: Floats) -> Floats:
    """(n_u, n_v, dim) linear in u between two columns along v (n_v, dim)."""
    across: Floats = (1.0 - x)[:, None, None] * first + x[:, None, None] * last
    return across


def _scales(along_u: Pair, along_v: Pair) -> tuple[float, float, float, float] | None:
    """Factors on the weights of the four edges with which they agree at every corner."""
    (a0, a1), (b0, b1) = (
        [curve.lines.unit_weights[[0, -1]] for curve in pair] for pair in (along_u, along_v)
    )
    # a0 stays; at its two ends it settles b0 and b1, and at the end of b0 that settles a1.
    f0, f1 = a0[0] / b0[0], a0[1] / b1[0]
    g1 = f0 * b0[1] / a1[0]
    if abs(g1 * a1[1] - f1 * b1[1]) > SAME_WEIGHT * f1 * b1[1]:
        return None
    return 1.0, float(g1), float(f0), float(f1)
