"""Curves moved, turned, scaled and mirrored as wholes, and run the other way.

For x -> T x + t: P -> T P + t and d -> T d, not made unit again, with s as it was. Then the curve
of the images is the image of the curve.
"""

from dataclasses import replace
from functools import singledispatch

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines

ALIKE = 1e-12  # relative deviation from equal scaling of all lengths that is rounding


def transformed(curve: PlusCurve, matrix: ArrayLike, offset: ArrayLike | float = 0.0) -> PlusCurve:
    """The image of the curve under x -> matrix x + offset, exactly.

    A map that scales all lengths alike scales s in place of the directions, so that automatic
    ones may stay automatic; any other makes every direction a given one. The matrix is
    (dim', dim); dim' may differ from dim.
    """
    old = curve.lines
    T = frozen(matrix, shape=(None, curve.dimension), name="matrix")
    points = old.points @ T.T + np.asarray(offset, dtype=np.float64)
    scale = similarity(T)
    if scale is None:
        lines = ControlLines.of(points, list(curve.directions @ T.T), old.weights)
        return replace(curve, lines=lines)
    given = old.given @ T.T / scale
    lines = ControlLines(points, given, old.automatic, old.weights)
    return replace(curve, lines=lines, s=curve.s * scale)


def similarity(matrix: Floats) -> float | None:
    """The factor by which a square matrix scales all lengths alike; None if it does not."""
    if matrix.shape[0] != matrix.shape[1]:
        return None
    product = matrix.T @ matrix
    square = float(np.trace(product)) / len(product)
    even = np.abs(product - square * np.eye(len(product))).max() <= ALIKE * square
    return float(np.sqrt(square)) if even and square > 0.0 else None


def reversed_curve(curve: PlusCurve) -> PlusCurve:
    """The curve C(1 - u). Its lines are those of `reversed_rows`, their directions negated."""
    rows = reversed_rows(curve.basis)
    lines = curve.lines.taken(rows)
    turned = replace(lines, given=-lines.given)
    return replace(curve, basis=reversed_basis(curve.basis), lines=turned)


def reversed_rows(basis: Basis) -> NDArray[np.intp]:
    """(n,) the old number of each line of the reversed curve.

    A line at the seam of a closed curve, node 0, stays the first; otherwise the last comes first.
    """
    rows = np.arange(basis.size)[::-1]
    return np.roll(rows, 1) if basis.closed and basis.nodes[0] == 0.0 else rows


@singledispatch
def reversed_basis(basis: Basis) -> Basis:
    """The basis of the functions b_i(1 - u), i in the order of `reversed_rows`."""
    return basis


@reversed_basis.register
def _(basis: BSpline) -> Basis:
    if basis.knots is None:
        return basis
    return replace(basis, knots=tuple(1.0 - knot for knot in reversed(basis.knots)))


@reversed_basis.register
def _(basis: RationalGaussian) -> Basis:
    rows = reversed_rows(basis)
    sigma, nodes = basis.sigma, basis.given_nodes
    if isinstance(sigma, tuple):
        sigma = tuple(sigma[row] for row in rows)
    if nodes is not None:
        period = 1.0 if basis.closed else np.inf
        nodes = tuple(float((1.0 - nodes[row]) % period) for row in rows)
    return replace(basis, sigma=sigma, given_nodes=nodes)
