"""L by hand, s* against known shapes and against trying every s."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.magnitude import best_s, polygon_length
from tests.geometry.curves import KINDS, random_curve

SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


def with_s(curve, s):
    return PlusCurve(curve.basis, curve.lines, s)


def miss(curve):
    """The sum of squared distances of the curve at its nodes from its control points."""
    return ((curve.at(curve.basis.nodes) - curve.lines.points) ** 2).sum()


def test_the_length_of_an_open_square_has_three_sides_and_of_a_closed_one_four():
    lines = ControlLines.of(SQUARE)
    assert polygon_length(PlusCurve(BSpline(4, 4), lines)) == 3.0
    assert polygon_length(PlusCurve(BSpline(4, 4, closed=True), lines)) == 4.0


@pytest.mark.parametrize("order", [3, 4])
@pytest.mark.parametrize("n", [3, 4, 5, 8, 30])
def test_on_a_regular_polygon_it_is_half_the_length_over_the_cosine(n, order):
    angle = 2.0 * np.pi * np.arange(n) / n
    lines = ControlLines.of(np.stack([np.cos(angle), np.sin(angle)], axis=1))
    curve = PlusCurve(BSpline(n, order, closed=True), lines)
    assert_allclose(best_s(curve), polygon_length(curve) / (2.0 * np.cos(np.pi / n)), rtol=1e-12)
    assert miss(with_s(curve, best_s(curve))) < 1e-24


@pytest.mark.parametrize("basis", [Bernstein(6), BSpline(6, 3), BSpline(6, 4)], ids=str)
def test_on_a_quadratic_with_half_its_slopes_it_is_one_and_exact(basis):
    x = basis.nodes
    points = np.stack([x, 3.0 * x**2 - x], axis=1)
    slopes = np.stack([np.ones_like(x), 6.0 * x - 1.0], axis=1)
    curve = PlusCurve(basis, ControlLines.of(points, slopes / 2.0))
    assert_allclose(best_s(curve), 1.0, rtol=1e-12)
    u = np.linspace(0.0, 1.0, 50)
    assert_allclose(curve.at(u), np.stack([u, 3.0 * u**2 - u], axis=1), atol=1e-14)


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind not in ("polygon", "staircase")])
@pytest.mark.parametrize("contrast", [None, 5.0])
def test_no_other_s_comes_closer(kind, contrast):
    curve = random_curve(kind, seed=1, contrast=contrast)
    best = best_s(curve)
    least = miss(with_s(curve, best))
    assert all(miss(with_s(curve, best + by)) > least for by in (-1.0, -1e-3, 1e-3, 1.0))


@pytest.mark.parametrize("kind", ["polygon", "staircase"])
def test_a_curve_that_meets_its_points_for_every_s_has_no_best_one(kind):
    curve = random_curve(kind, seed=1)
    assert best_s(curve) is None
    assert miss(with_s(curve, 7.0)) < 1e-28


def test_it_has_the_unit_of_the_points():
    curve = random_curve("bspline", seed=2)
    large = PlusCurve(
        curve.basis,
        ControlLines.of(1e6 * curve.lines.points, list(curve.directions)),
        curve.s,
    )
    assert_allclose(best_s(large), 1e6 * best_s(curve), rtol=1e-10)


@pytest.mark.parametrize("basis", [Bernstein(5), BSpline(5, 3), BSpline(5, 4, closed=True)])
def test_equal_directions_leave_nothing_for_s_to_do(basis):
    points = np.random.default_rng(3).normal(size=(5, 2))
    assert best_s(PlusCurve(basis, ControlLines.of(points, [(0.3, 0.7)] * 5))) is None


def test_without_directions_there_is_nothing_for_s_to_do():
    curve = PlusCurve(RationalGaussian.of_size(4), ControlLines.of(SQUARE, [(0, 0)] * 4))
    assert best_s(curve) is None


def test_very_short_directions_ask_for_a_very_large_s():
    curve = random_curve("bezier", seed=4)
    short = curve.lines.with_directions(1e-200 * curve.directions)
    assert_allclose(
        best_s(PlusCurve(curve.basis, short)),
        1e200 * best_s(PlusCurve(curve.basis, curve.lines.with_directions(curve.directions))),
        rtol=1e-12,
    )
