"""Curves led through their control points."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.passing import passed, passing_through
from tests.geometry.curves import random_curve

OPEN = [Bernstein(3), Bernstein(8), BSpline(8, 4), BSpline(8, 3), RationalGaussian.of_size(8)]
ODD = [BSpline(7, 4, closed=True), BSpline(7, 3, closed=True), RationalGaussian(7, 0.1, True)]


def a_curve(basis, *, weighted=False):
    random = np.random.default_rng(0)
    weights = random.uniform(0.5, 2.0, basis.size) if weighted else None
    return PlusCurve(
        basis, ControlLines.of(random.normal(size=(basis.size, 2)), None, weights), 2.0
    )


@pytest.mark.parametrize("basis", OPEN + ODD, ids=str)
def test_open_curves_and_closed_ones_of_odd_size_pass_through_every_point(basis):
    curve = a_curve(basis)
    made = passed(curve)
    assert made.largest_miss < 1e-12
    assert_allclose(made.curve.at(basis.nodes), curve.lines.points, atol=1e-12)
    assert_array_equal(made.curve.lines.points, curve.lines.points)
    assert made.curve.s == 2.0


@pytest.mark.parametrize("basis", OPEN, ids=str)
def test_with_weights_open_curves_still_do(basis):
    curve = a_curve(basis, weighted=True)
    made = passed(curve)
    assert made.largest_miss < 1e-12
    assert_array_equal(made.curve.lines.weights, curve.lines.weights)


def test_open_rational_gaussians_of_odd_size_are_one_short():
    # Their reaches are those of a skew-symmetric matrix, which has an odd rank nowhere.
    assert passed(a_curve(RationalGaussian.of_size(7))).largest_miss > 1e-3


def test_a_closed_curve_of_even_size_comes_as_close_as_it_can():
    random = np.random.default_rng(1)
    curve = PlusCurve(BSpline(6, 4, closed=True), ControlLines.of(random.normal(size=(6, 2))), 2.0)
    made = passed(curve)
    nodes = curve.basis.nodes
    miss = made.curve.at(nodes) - curve.lines.points
    assert_allclose(made.largest_miss, np.linalg.norm(miss, axis=1).max())
    assert made.largest_miss > 1e-3
    for seed in range(20):
        other = made.curve.directions + 0.1 * np.random.default_rng(seed).normal(size=(6, 2))
        tried = replace(curve, lines=curve.lines.with_directions(other))
        assert ((tried.at(nodes) - curve.lines.points) ** 2).sum() >= (miss**2).sum() - 1e-12


def test_no_other_directions_that_do_are_nearer_to_the_old_ones():
    curve = random_curve("bspline", seed=3, s=1.5)
    made = passing_through(curve)
    change = made.gradients - curve.gradients
    # Adding one vector to all gradients changes nothing, so the least change has none of it.
    assert_allclose(change.mean(axis=0), 0.0, atol=1e-12)


def test_a_curve_that_passes_already_stays_as_it_is():
    once = passing_through(random_curve("bezier", seed=4))
    again = passing_through(once)
    assert_allclose(again.directions, once.directions, atol=1e-10)


def test_directions_that_need_no_change_stay_automatic():
    points = np.stack([np.linspace(0.0, 4.0, 5), np.zeros(5)], axis=1)
    curve = PlusCurve(Bernstein(5), ControlLines.of(points), 4.0)
    assert passing_through(curve).lines.automatic.all()


def test_without_s_it_is_refused():
    with pytest.raises(ValueError, match="set s first"):
        passing_through(random_curve("bezier", s=0.0))
