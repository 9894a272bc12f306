"""Length, bending energy and inflections of a curve, and how many inflections it can have."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.curve_numbers import curve_numbers, known_numbers, most_inflections
from plusedit.geometry.lines import ControlLines
from tests.geometry.curves import random_curve


def a_curve(basis, s=1.0, weights=None, seed=0):
    points = np.random.default_rng(seed).random((basis.size, 2))
    return PlusCurve(basis, ControlLines.of(points, weights=weights), s)


@pytest.mark.parametrize(("lines", "most"), [(2, 0), (3, 2), (4, 4), (7, 10)])
def test_a_plus_curve_can_have_two_more_than_the_curve_of_its_points(lines, most):
    """Degree n with n lines, where the classical curve has degree n - 1."""
    curve = a_curve(Bernstein(lines))
    assert most_inflections(curve) == most
    assert most_inflections(curve.classical) == max(0, most - 2)


def test_weights_allow_more():
    weights = np.array([1.0, 2.0, 0.5, 1.0])
    assert most_inflections(a_curve(Bernstein(4), weights=weights)) == 6


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("order", [2, 3, 4, 6])
@pytest.mark.parametrize("s", [0.0, 2.0])
def test_no_curve_has_more_than_the_bound(order, closed, s):
    for seed in range(5):
        curve = a_curve(BSpline(9, order, closed), s, seed=seed)
        numbers = curve_numbers(curve)
        assert numbers.inflections <= numbers.most


def test_gaussians_have_no_bound_and_curves_in_space_no_inflections():
    assert most_inflections(a_curve(RationalGaussian.of_size(5))) is None
    numbers = curve_numbers(random_curve("bspline", dimension=3))
    assert numbers.inflections is None and numbers.most is None


def test_a_quarter_of_a_circle_has_the_numbers_that_are_known():
    points = 2.0 * np.array([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    weights = np.array([1.0, np.sqrt(0.5), 1.0])
    arc = PlusCurve(Bernstein(3), ControlLines.of(points, weights=weights), 0.0)
    assert known_numbers(arc) is None
    numbers = curve_numbers(arc)
    assert_allclose([numbers.length, numbers.energy], [np.pi, np.pi / 4.0])
    assert numbers.inflections == 0
    assert known_numbers(arc) is numbers
