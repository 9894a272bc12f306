"""Plus curves in standard form."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bernstein import Bernstein, bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevated, elevation
from plusedit.geometry.lines import ControlLines

IRREGULAR = BSpline(9, 4, knots=(0, 0, 0, 0, 0.1, 0.2, 0.2, 0.2, 0.7, 1, 1, 1, 1))
UNEVEN = tuple(np.sort(np.random.default_rng(5).uniform(0.0, 1.0, 196)).tolist())
BASES = [
    *(Bernstein(n) for n in (2, 3, 4, 9, 50, 200)),
    *(BSpline(n, k) for n, k in ((2, 2), (5, 2), (5, 3), (9, 4), (9, 9), (60, 30))),
    *(BSpline(200, k) for k in (2, 4, 5, 200)),
    IRREGULAR,
    BSpline(200, 4, knots=(0.0, 0.0, 0.0, 0.0, *UNEVEN, 1.0, 1.0, 1.0, 1.0)),
    *(BSpline(n, k, True) for n, k in ((2, 2), (2, 4), (3, 7), (5, 3), (8, 4), (20, 11))),
    *(BSpline(200, k, True) for k in (3, 4)),
]
every_basis = pytest.mark.parametrize("basis", BASES, ids=lambda b: f"{type(b).__name__}-{b.size}")


def a_curve(basis, *, weighted=False, dim=2, s=1.7):
    draw = np.random.default_rng(basis.size)
    points = draw.uniform(-3.0, 5.0, size=(basis.size, dim))
    directions = list(draw.normal(size=points.shape))
    weights = draw.uniform(0.1, 10.0, basis.size) if weighted else None
    return PlusCurve(basis, ControlLines.of(points, directions, weights), s)


def parameters_off_the_knots(basis):
    knots = basis.breaks if isinstance(basis, BSpline) else np.array([0.0, 1.0])
    shares = np.array([0.0917, 0.44, 0.913])
    return (knots[:-1, None] + np.diff(knots)[:, None] * shares).ravel()


@every_basis
@pytest.mark.parametrize("weighted", [False, True])
def test_the_standard_form_is_the_same_curve_with_the_same_derivatives(basis, weighted):
    curve = a_curve(basis, weighted=weighted, dim=3)
    u = parameters_off_the_knots(basis)
    form = elevated(curve)
    of_curve, of_form = curve.derivatives(u), form.derivatives(u)
    for expected, found in zip(of_curve, of_form, strict=True):
        assert_allclose(found, expected, rtol=0, atol=3e-12 * np.abs(expected).max())
    # A parameter itself is rounded: what the curve runs meanwhile is no error of the form.
    run = np.abs(of_curve[1]).max() * np.finfo(float).eps
    size = np.abs(curve.lines.points).max()
    assert_allclose(of_form[0], of_curve[0], rtol=0, atol=1e-13 * size + 2 * run)


@every_basis
def test_the_new_points_are_means_of_the_old_and_have_their_place(basis):
    values = elevation(basis).values
    assert values.entries.min() >= 0.0
    assert_allclose(values.entries.sum(axis=1), 1.0, rtol=1e-14)


@every_basis
def test_the_degree_rises_by_one_and_every_distinct_knot_comes_once_more(basis):
    form = elevated(a_curve(basis))
    order = basis.order if isinstance(basis, BSpline) else basis.size
    assert form.degree == order
    distinct, times = np.unique(form.knots, return_counts=True)
    expected = basis.breaks if isinstance(basis, BSpline) else [0.0, 1.0]
    assert_allclose(distinct, expected, rtol=1e-15)
    assert times[0] == times[-1] == order + 1
    if not isinstance(basis, BSpline) or basis.closed:
        assert (times[1:-1] == 2).all()


@every_basis
@pytest.mark.parametrize("weighted", [False, True])
def test_the_bezier_pieces_together_are_the_curve(basis, weighted):
    form = elevated(a_curve(basis, weighted=weighted))
    pieces = form.bezier_pieces()
    v = np.array([0.0, 0.25, 0.5, 0.8125])
    share = bernstein(v, form.degree)
    weights = np.ones(pieces.points.shape[:2]) if pieces.weights is None else pieces.weights
    tops = np.einsum("vr,pr,prd->pvd", share, weights, pieces.points)
    found = tops / np.einsum("vr,pr->pv", share, weights)[..., None]
    u = pieces.breaks[:-1, None] + np.diff(pieces.breaks)[:, None] * v
    assert_allclose(found.reshape(-1, 2), form.at(u.ravel()), atol=3e-12)
    assert_array_equal(pieces.points[1:, 0], pieces.points[:-1, -1])


def test_a_b_spline_of_full_order_rises_like_the_bezier_curve_it_is():
    as_bezier, as_spline = elevation(Bernstein(7)), elevation(BSpline(7, 7))
    assert_allclose(as_spline.values.dense(), as_bezier.values.dense(), atol=1e-15)
    assert_allclose(as_spline.reaches.dense(), as_bezier.reaches.dense(), atol=1e-15)


def test_a_closed_curve_ends_where_it_begins():
    form = elevated(a_curve(BSpline(6, 3, True)))
    assert_allclose(form.points[0], form.points[-1], rtol=1e-14)


def test_one_vector_added_to_all_gradients_leaves_the_form_as_it_is():
    curve = a_curve(IRREGULAR)
    directions = curve.directions + np.array([30.0, -20.0])
    shifted = replace(curve, lines=curve.lines.with_directions(directions))
    assert_allclose(elevated(shifted).points, elevated(curve).points, atol=1e-13 * 50.0)


def test_scaled_weights_scale_the_weights_of_the_form_and_nothing_else():
    curve = a_curve(IRREGULAR, weighted=True)
    scaled = replace(curve, lines=curve.lines.with_weights(1e90 * curve.lines.weights))
    assert_allclose(elevated(scaled).points, elevated(curve).points, rtol=1e-13)
    assert_allclose(elevated(scaled).weights, 1e90 * elevated(curve).weights, rtol=1e-14)


def test_the_matrices_are_worked_out_once_for_equal_bases():
    assert elevation(BSpline(9, 4)) is elevation(BSpline(9, 4))


def test_a_gaussian_curve_has_no_standard_form():
    with pytest.raises(ValueError, match="not piecewise polynomial"):
        elevated(a_curve(RationalGaussian.of_size(5)))
