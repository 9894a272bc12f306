"""Single families of blending functions: known values, arguments refused."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bernstein import Bernstein, bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian


def cox_de_boor(i, k, t, u):
    """N_{i,k}(u) by the recursion as it is written, 0 / 0 being 0; the last span is closed."""
    if k == 1:
        last = t[i + 1] == t[-1] and t[i] < t[i + 1]
        return float(t[i] <= u < t[i + 1] or (last and u == t[-1]))
    left, right = t[i + k - 1] - t[i], t[i + k] - t[i + 1]
    value = 0.0
    if left > 0.0:
        value += (u - t[i]) / left * cox_de_boor(i, k - 1, t, u)
    if right > 0.0:
        value += (t[i + k] - u) / right * cox_de_boor(i + 1, k - 1, t, u)
    return value


@pytest.mark.parametrize(
    "basis",
    [
        BSpline(2, 2),
        BSpline(7, 4),
        BSpline(6, 6),
        BSpline(7, 3, knots=(0, 0, 0, 0.1, 0.1, 0.3, 0.9, 1, 1, 1)),
        BSpline(9, 4, knots=(0, 0, 0, 0, 0.5, 0.5, 0.5, 0.6, 0.7, 1, 1, 1, 1)),
    ],
)
def test_b_splines_follow_the_recursion_of_cox_and_de_boor(basis):
    t = basis.knot_vector
    u = np.union1d(np.linspace(0.0, 1.0, 41), t)
    expected = [[cox_de_boor(i, basis.order, t, x) for i in range(basis.size)] for x in u]
    assert_allclose(basis.values(u), expected, atol=1e-14)


def test_a_closed_b_spline_is_one_bump_repeated():
    basis = BSpline(6, 4, closed=True)
    u = np.linspace(0.0, 1.0, 25)
    first = basis.values(u)[:, 0]
    for i in range(1, 6):
        assert_allclose(basis.values(u + i / 6)[:, i], first, atol=1e-15)
    assert_allclose(first, basis.values(-u)[:, 0], atol=1e-15)
    assert first[0] == pytest.approx(2 / 3)
    assert_array_equal(first[np.minimum(u, 1.0 - u) >= 1 / 3 + 1e-9], 0.0)


def test_the_node_of_a_b_spline_is_the_mean_of_its_inner_knots():
    basis = BSpline(6, 4, knots=(0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1))
    assert_allclose(basis.nodes, [0.0, 0.1, 0.3, 1.9 / 3, 2.6 / 3, 1.0])


@pytest.mark.parametrize("basis", [Bernstein(7), BSpline(9, 4), BSpline(12, 3)])
def test_distances_from_the_nodes_cancel_out_on_an_open_basis(basis):
    u = np.linspace(0.0, 1.0, 50)
    assert_allclose(basis.reaches(u).sum(axis=1), 0.0, atol=1e-15)


@pytest.mark.parametrize("size", [2, 3, 5, 8])
@pytest.mark.parametrize("order", [2, 3, 4, 7])
def test_distances_from_the_nodes_cancel_out_on_a_closed_b_spline(size, order):
    u = np.linspace(-1.0, 2.0, 50)
    reaches = BSpline(size, order, closed=True).reaches(u)
    assert_allclose(reaches.sum(axis=1), 0.0, atol=1e-14)


def test_bernstein_polynomials_of_degree_two():
    u = np.array([0.0, 0.25, 1.0])
    assert_allclose(Bernstein(3).values(u), [[1, 0, 0], [0.5625, 0.375, 0.0625], [0, 0, 1]])


@pytest.mark.parametrize("degree", [999, 1001, 1003])
def test_very_high_degrees_have_finite_polynomials(degree):
    values = bernstein(np.linspace(0.0, 1.0, 9), degree)
    assert_allclose(values.sum(axis=1), 1.0, rtol=1e-11)


def gaussians(u, nodes, sigma, images):
    """The quotients as written; fine as long as sigma is neither small nor large."""
    away = (u[:, None, None] - nodes[:, None] - images) / sigma[:, None]
    g = np.exp(-0.5 * away**2).sum(axis=2)
    return g / g.sum(axis=1, keepdims=True)


def test_open_rational_gaussians_follow_their_formula():
    nodes, sigma = np.array([0.1, 0.4, 0.5, 0.95]), np.array([0.2, 0.1, 0.3, 0.15])
    basis = RationalGaussian(4, tuple(sigma.tolist()), given_nodes=tuple(nodes.tolist()))
    u = np.linspace(0.0, 1.0, 33)
    assert_allclose(basis.values(u), gaussians(u, nodes, sigma, np.zeros(1)), rtol=1e-12)


@pytest.mark.parametrize("sigma", [0.05, 0.12, 0.3, 0.9, 1.9])
def test_closed_rational_gaussians_are_sums_over_all_images(sigma):
    nodes, widths = np.array([0.0, 0.3, 0.31, 0.8]), sigma * np.array([1.0, 0.7, 0.9, 0.5])
    basis = RationalGaussian(4, tuple(widths.tolist()), True, tuple(nodes.tolist()))
    u = np.linspace(0.0, 1.0, 33)
    expected = gaussians(u, nodes, widths, np.arange(-30, 31))
    assert_allclose(basis.values(u), expected, rtol=1e-12, atol=1e-16)


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("sigma", [1e-3, 1e-9, 1e-100, 5e-324])
def test_narrow_gaussians_are_steps_between_the_middles_of_the_nodes(sigma, closed):
    basis = RationalGaussian(4, sigma, closed, (0.0, 0.2, 0.6, 0.9))
    values = basis.values(np.array([0.05, 0.15, 0.35, 0.7, 0.8]))
    assert_allclose(values.argmax(axis=1), [0, 1, 1, 2, 3])
    assert_allclose(values.max(axis=1), 1.0)
    for derivative in (1, 2):
        slopes = basis.values(np.array([0.05, 0.15]), derivative=derivative)
        assert_allclose(slopes, 0.0, atol=1e-9)


@pytest.mark.parametrize("sigma", [3.0, 1e3, 1e9, 1e300])
def test_wide_closed_gaussians_count_by_their_widths(sigma):
    basis = RationalGaussian(3, (sigma, sigma, 2.0 * sigma), closed=True)
    # The sum over all images of a wide Gaussian is its integral, sigma sqrt(2 pi).
    assert_allclose(basis.values(np.array([0.0, 0.4])), [[0.25, 0.25, 0.5]] * 2, rtol=1e-12)


def test_wide_open_gaussians_share_evenly():
    values = RationalGaussian(4, 1e9).values(np.array([0.0, 0.4]))
    assert_allclose(values, 0.25, rtol=1e-12)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Bernstein(1), "points: a Bezier curve needs at least 2"),
        (lambda: BSpline(1, 2), "points: a B-spline needs at least 2"),
        (lambda: BSpline(5, 1), "order: expected 2 to 5"),
        (lambda: BSpline(5, 6), "order: expected 2 to 5, the number of control lines, got 6"),
        (lambda: BSpline(5, 1, closed=True), "order: expected 2 or more, got 1"),
        (lambda: BSpline(3, 3, True, (0.0,) * 3 + (1.0,) * 3), "closed B-spline has uniform knots"),
        (lambda: BSpline(4, 3, knots=(0, 0, 0, 1, 1, 1)), "knots: expected 7 numbers, got 6"),
        (lambda: BSpline(4, 3, knots=(0, 0, 0, np.nan, 1, 1, 1)), "knots: has a value that is not"),
        (lambda: BSpline(5, 3, knots=(0, 0, 0, 0.6, 0.5, 1, 1, 1)), "knots: must never fall"),
        (lambda: BSpline(4, 3, knots=(0, 0, 0.1, 0.5, 1, 1, 1)), "begin with 3 zeros"),
        (lambda: BSpline(4, 3, knots=(0, 0, 0, 0, 1, 1, 1)), "must lie between 0 and 1"),
        (
            lambda: BSpline(6, 3, knots=(0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1)),
            "0.5 stands more than 2 times",
        ),
        (lambda: RationalGaussian(1, 0.1), "points: a RaG curve needs at least 2"),
        (lambda: RationalGaussian(3, 0.0), "sigma: must be positive and finite, got 0"),
        (lambda: RationalGaussian(3, np.inf), "sigma: must be positive and finite"),
        (lambda: RationalGaussian(3, (0.1, 0.1)), "sigma: expected one number or 3, got 2"),
        (lambda: RationalGaussian(2, 0.1, given_nodes=(0.5, 0.5)), "nodes: must increase"),
        (lambda: RationalGaussian(2, 0.1, given_nodes=(0.5,)), "nodes: expected 2 numbers, got 1"),
        (lambda: RationalGaussian(2, 0.1, given_nodes=(0.5, 1.5)), r"nodes: must lie in \[0, 1\]"),
        (lambda: RationalGaussian(2, 0.1, True, (0.5, 1.0)), r"nodes: must lie in \[0, 1\)"),
        (lambda: RationalGaussian(2, 0.1, given_nodes=(0, np.nan)), "nodes: has a value that is"),
    ],
)
def test_what_makes_no_basis_is_refused_in_a_sentence(make, message):
    with pytest.raises(ValueError, match=message):
        make()
