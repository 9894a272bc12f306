"""The very same curve written with more control lines: of higher order, with more knots, cut open.

All of these go by `insertion.refined`: the functions of the old basis are sums of those of the new
one, so each new line is a mean of old ones. The shares come from de Boor's triangle with the knots
of the new basis for its arguments. Closed B-splines are looked at unrolled, with the images of
their lines before 0 and beyond 1.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline, weights_of_span
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevation
from plusedit.geometry.insertion import exact_shares, refined
from plusedit.geometry.matrices import Banded

KNOT = 1e-9  # of a span: a knot may be that far off by rounding


def raised(curve: PlusCurve) -> PlusCurve:
    """The same open Bezier+ or B-spline+ curve with an order of one more.

    ValueError for closed curves and rational Gaussians, which have none.
    """
    basis = curve.basis
    if curve.closed or not isinstance(basis, Bernstein | BSpline):
        raise ValueError("only open Bezier and B-spline curves can be raised exactly")
    if isinstance(basis, Bernstein):
        larger = Bernstein(basis.size + 1)
        shares = exact_shares(basis, larger)
        if shares is None:
            raise ValueError("a Bezier curve that can't be raised")
        return refined(curve, larger, shares)
    form = elevation(basis)
    return refined(curve, _on_knots(form.order, form.knots), form.values)


def as_bspline(curve: PlusCurve) -> PlusCurve:
    """A Bezier+ curve of n lines as the B-spline+ curve of order n that it is; others as they are.

    The lines are the same.
    """
    if not isinstance(curve.basis, Bernstein):
        return curve
    size = curve.basis.size
    return PlusCurve(BSpline(size, size), curve.lines, curve.s)


def with_knots(curve: PlusCurve, knots: Floats) -> PlusCurve:
    """The same open B-spline+ curve on knots that hold all of its own. ValueError if not open."""
    basis = curve.basis
    if not isinstance(basis, BSpline):
        raise ValueError("only B-spline curves have knots")
    larger = _on_knots(basis.order, knots)
    if larger.size == basis.size:
        return curve
    shares = exact_shares(basis, larger)
    if shares is None:
        raise ValueError("a closed B-spline curve has knots that can't be chosen")
    return refined(curve, larger, shares)


def opened(curve: PlusCurve) -> PlusCurve:
    """The same closed B-spline+ curve cut open at u = 0; open curves as they are.

    It still ends where it begins. ValueError for closed rational Gaussians.
    """
    basis = curve.basis
    if not curve.closed:
        return curve
    if not isinstance(basis, BSpline):
        raise ValueError("a closed curve of rational Gaussians can't be cut open exactly")
    n, order = basis.size, basis.order
    tau = np.concatenate([np.zeros(order), n * basis.breaks[1:-1], np.full(order, float(n))])
    windows = np.lib.stride_tricks.sliding_window_view(tau, order + 1)
    return _from_windows(curve, _on_knots(order, tau / n), windows)


def finer(curve: PlusCurve, factor: int) -> PlusCurve:
    """The same closed B-spline+ curve with `factor` times as many lines.

    ValueError where there is none: for an even factor at an odd order, and for other families.
    """
    basis = curve.basis
    if not (isinstance(basis, BSpline) and basis.closed):
        raise ValueError("only closed B-spline curves can be made finer as a whole")
    if basis.order % 2 and not factor % 2:
        raise ValueError(f"a closed B-spline of order {basis.order} has no knots in between")
    if factor == 1:
        return curve
    n, k = basis.size, basis.order
    larger = BSpline(factor * n, k, closed=True)
    first = (np.arange(larger.size) - k / 2.0) / factor
    return _from_windows(curve, larger, first[:, None] + np.arange(k + 1) / factor)


def _from_windows(curve: PlusCurve, basis: BSpline, windows: Floats) -> PlusCurve:
    """By the order + 1 knots (m, order + 1) of every new function.

    They are measured in n u: the nodes of the closed B-spline there was are the whole numbers, and
    its knots as well for an even order, half-way between for an odd one.
    """
    n, k = curve.basis.size, basis.order
    at = windows - (k % 2) / 2.0
    span = np.floor(at[:, 0] + KNOT).astype(np.intp)
    low = int(span.min()) - k
    t = np.arange(low, int(np.ceil(at.max())) + k + 1, dtype=np.float64)
    shares = weights_of_span(np.ascontiguousarray(at[:, 1:-1].T), t, span - low)
    unrolled = span[:, None] + np.arange(1 - k, 1) + (k + 1) // 2
    nodes = windows[:, 1:-1].mean(axis=1)
    distances = (nodes[:, None] - unrolled) / n
    return refined(curve, basis, Banded(unrolled % n, shares, n), distances)


def _on_knots(order: int, knots: Floats) -> BSpline:
    basis = BSpline(len(knots) - order, order)
    if np.array_equal(basis.knot_vector, knots):
        return basis
    return BSpline(len(knots) - order, order, knots=tuple(knots.tolist()))
