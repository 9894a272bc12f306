"""Inflections of known curves, and counted by looking at very many parameters."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.frames import curvature_at
from plusedit.geometry.inflections import inflections
from plusedit.geometry.lines import ControlLines
from tests.geometry.curves import KINDS, random_curve


def by_looking(curve, count=4001):
    """Changes of the sign of the curvature among very many parameters off the knots."""
    u = (np.arange(count) + 0.5) / count
    sign = np.sign(curvature_at(curve, u))
    sign = sign[sign != 0.0]
    changes = int((sign[1:] != sign[:-1]).sum())
    return changes + int(curve.closed and sign[0] != sign[-1])


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "staircase"])
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("contrast", [None, 4.0])
def test_there_are_as_many_as_looking_shows(kind, seed, contrast):
    curve = random_curve(kind, seed=seed, contrast=contrast)
    assert len(inflections(curve)) == by_looking(curve)


@pytest.mark.parametrize("kind", ["bezier", "closed", "rag", "bspline", "high order"])
def test_the_curvature_is_zero_there_and_differs_in_sign_beside(kind):
    for seed in range(6):
        curve = random_curve(kind, seed=seed)
        at = inflections(curve)
        left, right = curvature_at(curve, at - 1e-7), curvature_at(curve, at + 1e-7)
        assert (left * right < 0.0).all()
        assert (
            np.abs(curvature_at(curve, at)) <= 1e-4 * (1.0 + np.abs(left) + np.abs(right))
        ).all()


def test_an_s_has_one_in_the_middle():
    curve = PlusCurve(Bernstein(4), ControlLines.of([(0, 0), (1, 1), (2, -1), (3, 0)]), s=0.0)
    assert_allclose(inflections(curve), [0.5], atol=1e-12)


def test_two_that_lie_close_together_are_both_found():
    # det(C', C'') of (t, t^4/12 - a t^2/2) is t^2 - a, here with t from -1 to 1.
    for a in (1e-2, 1e-4, 1e-6):
        t = np.linspace(-1.0, 1.0, 9)
        polynomial = np.stack([t, t**4 / 12.0 - a * t**2 / 2.0], axis=1)
        matrix = Bernstein(5).values((t + 1.0) / 2.0)
        points = np.linalg.lstsq(matrix, polynomial, rcond=None)[0]
        curve = PlusCurve(Bernstein(5), ControlLines.of(points), s=0.0)
        root = np.sqrt(a) / 2.0
        assert_allclose(inflections(curve), [0.5 - root, 0.5 + root], atol=1e-6)


def test_a_knot_across_which_the_curvature_jumps_is_one():
    points = [(0, 0), (1, 1), (2, 0), (3, -1), (4, 0)]
    curve = PlusCurve(BSpline(5, 3), ControlLines.of(points), s=0.0)
    assert_allclose(curve.basis.breaks, [0, 1 / 3, 2 / 3, 1])
    assert len(inflections(curve)) == 1
    zigzag = [(0, 0), (1, 1), (2, -1), (3, 1), (4, 0)]
    curve = PlusCurve(BSpline(5, 3), ControlLines.of(zigzag), s=0.0)
    assert_allclose(inflections(curve), [1 / 3, 2 / 3], atol=1e-15)


@pytest.mark.parametrize("points", [[(0, 0), (1, 0), (2, 0), (5, 0)], [(1, 1)] * 4])
def test_a_straight_curve_and_a_single_place_have_none(points):
    assert len(inflections(PlusCurve(Bernstein(4), ControlLines.of(points), 1.3))) == 0
    assert (
        len(inflections(PlusCurve(BSpline(4, 4, closed=True), ControlLines.of(points), 1.3))) == 0
    )


def test_a_straight_stretch_between_two_turns_counts_once():
    bend = [(-3, 1), (-2, 0), (-1, 0), (0, 0), (1, 0), (2, 0), (3, 0), (4, -1)]
    curve = PlusCurve(BSpline(8, 4), ControlLines.of(bend), s=0.0)
    at = inflections(curve)
    assert len(at) == 1
    assert 0.2 < at[0] < 0.8


def test_a_circle_has_none_and_a_flower_two_to_the_petal():
    angle = 2.0 * np.pi * np.arange(30) / 30
    round_one = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    flower = (1.0 + 0.5 * np.cos(5.0 * angle))[:, None] * round_one
    basis = BSpline(30, 4, closed=True)
    assert len(inflections(PlusCurve(basis, ControlLines.of(round_one), 3.0))) == 0
    assert len(inflections(PlusCurve(basis, ControlLines.of(flower), 3.0))) == 10


def test_an_inflection_at_the_seam_counts_once():
    t = 2.0 * np.pi * np.arange(12) / 12
    eight = np.stack([np.sin(t), np.sin(2.0 * t)], axis=1)
    curve = PlusCurve(BSpline(12, 4, closed=True), ControlLines.of(eight), 2.0)
    at = inflections(curve)
    assert len(at) == 2
    assert min(at[0], 1.0 - at[-1]) < 1e-9


@pytest.mark.parametrize("scale", [1e-90, 1e90])
def test_the_size_does_not_matter(scale):
    curve = random_curve("bezier", seed=1)
    lines = ControlLines.of(scale * curve.lines.points, list(scale * curve.directions))
    assert_allclose(
        inflections(PlusCurve(curve.basis, lines, curve.s)), inflections(curve), atol=1e-9
    )


def test_a_space_curve_is_refused():
    with pytest.raises(ValueError, match="in space"):
        inflections(random_curve("bezier", dimension=3))
