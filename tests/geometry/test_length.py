"""Lengths in closed form, and of polygons with very many corners."""

from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.length import arc_length
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.pieces import breaks
from tests.geometry.curves import KINDS, random_curve


def of_polygon(curve, a=0.0, b=1.0, count=20001):
    knots = breaks(curve.basis)
    knots = np.append(knots, 1.0 + knots)
    points = curve.at(np.union1d(np.linspace(a, b, count), knots[(knots > a) & (knots < b)]))
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "staircase"])
@pytest.mark.parametrize("dimension", [2, 3])
def test_it_is_what_polygons_tend_to(kind, dimension):
    curve = random_curve(kind, seed=1, dimension=dimension, contrast=3.0)
    assert_allclose(arc_length(curve), of_polygon(curve), rtol=1e-6)


def test_a_staircase_of_still_lines_is_as_long_as_its_polygon():
    # The points are met but for exp(-40), and between them the curve is straight.
    points = [(0, 0), (1, 2), (3, 3), (3, 0)]
    curve = PlusCurve(RationalGaussian(4, 0.01), ControlLines.of(points), s=0.0)
    assert_allclose(arc_length(curve), np.sqrt(5.0) + np.sqrt(5.0) + 3.0, rtol=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_it_adds_up(kind):
    curve = random_curve(kind, seed=2)
    parts = np.array([0.0, 0.1234, 0.5, 0.87, 1.0])
    summed = sum(arc_length(curve, a, b) for a, b in pairwise(parts))
    assert_allclose(summed, arc_length(curve), rtol=1e-10)


def test_a_straight_line_is_as_long_as_it_is():
    curve = PlusCurve(Bernstein(3), ControlLines.of([(0, 0), (3, 4), (6, 8)]), s=10.0)
    assert_allclose(arc_length(curve), 10.0, rtol=1e-14)
    assert_allclose(arc_length(curve, 0.25, 0.5), 2.5, rtol=1e-14)


def test_a_parabola_has_the_length_of_the_books():
    curve = PlusCurve(Bernstein(3), ControlLines.of([(0, 0), (0.5, 0), (1, 1)]), s=0.0)
    expected = np.sqrt(5.0) / 2.0 + np.arcsinh(2.0) / 4.0
    assert_allclose(arc_length(curve), expected, rtol=1e-13)


def test_a_quarter_of_a_circle_has_the_length_of_one():
    lines = ControlLines.of([(1, 0), (1, 1), (0, 1)], [(0, 0)] * 3, [1.0, np.sqrt(0.5), 1.0])
    assert_allclose(arc_length(PlusCurve(Bernstein(3), lines)), np.pi / 2.0, rtol=1e-13)


def test_there_and_back_over_a_cusp_counts_both_ways():
    curve = PlusCurve(Bernstein(3), ControlLines.of([(0, 0), (1, 0), (0, 0)]), s=0.0)
    assert_allclose(arc_length(curve), 1.0, rtol=1e-10)


def test_a_closed_curve_goes_round_as_often_as_asked():
    curve = random_curve("closed", seed=3)
    once = arc_length(curve)
    assert_allclose(arc_length(curve, -0.25, 3.0), 3.0 * once + arc_length(curve, 0.75, 1.0))
    assert_allclose(arc_length(curve, 0.7, 1.2), of_polygon(curve, 0.7, 1.2), rtol=1e-6)


def test_an_open_curve_ends_at_its_ends():
    curve = random_curve("bspline", seed=3)
    assert arc_length(curve, -3.0, 7.0) == arc_length(curve)
    assert arc_length(curve, 2.0, 3.0) == 0.0


def test_backwards_it_is_negative():
    curve = random_curve("bspline", seed=3)
    assert arc_length(curve, 0.8, 0.3) == -arc_length(curve, 0.3, 0.8)


def test_a_curve_that_stays_in_one_place_has_none():
    curve = PlusCurve(BSpline(4, 3), ControlLines.of([(1.1, 2.3)] * 4))
    assert_allclose(arc_length(curve), 0.0, atol=1e-14)


def test_a_parameter_that_is_not_finite_is_refused():
    with pytest.raises(ValueError, match="finite"):
        arc_length(random_curve("bezier"), 0.0, np.inf)
