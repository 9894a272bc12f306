"""Curvature, bending energy and continuity of curves whose values are known."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bending import bending_energy
from plusedit.geometry.continuity import joints, meeting
from plusedit.geometry.curvature_profile import curvature_extrema, curvature_profile
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.frames import curvature_at
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.standard import elliptic_arc
from plusedit.geometry.transforms import reversed_curve, transformed
from tests.geometry.curves import KINDS, random_curve


def bent(size=6, order=4, closed=False, s=3.0):
    points = [[0, 0], [1, 2], [2.5, 2.5], [4, 2], [5, 0], [7, 1]][:size]
    return PlusCurve(BSpline(size, order, closed=closed), ControlLines.of(points), s)


def parabola():
    """y = x^2 from x = -1 to 1."""
    return PlusCurve(Bernstein(3), ControlLines.of([[-1, 1], [0, -1], [1, 1]]), 0.0)


def arc(center, radius, start, end):
    return elliptic_arc(center, [radius, 0.0], [0.0, radius], start=start, sweep=end - start)


def circle(radius=2.0):
    return arc((1.0, -1.0), radius, 0.0, 1.5 * np.pi)


def test_the_curvature_of_a_circle_is_one_over_its_radius_and_points_to_its_center():
    for piece in curvature_profile(circle(), 60):
        assert_allclose(piece.curvatures, 0.5, atol=1e-12)
        centers = piece.points + 4.0 * piece.vectors
        assert_allclose(centers, np.broadcast_to([1.0, -1.0], centers.shape), atol=1e-11)


def test_pieces_end_just_before_the_next_begins_and_tell_the_jump_of_the_curvature():
    curve = bent(order=3)
    profile = curvature_profile(curve, 40)
    assert len(profile) == 4
    for before, after in pairwise(profile):
        assert before.u[-1] < after.u[0]
        assert_allclose(before.points[-1], after.points[0], atol=1e-12)
    jumps = [after.curvatures[0] - before.curvatures[-1] for before, after in pairwise(profile)]
    assert max(map(abs, jumps)) > 1e-3


@pytest.mark.parametrize("kind", KINDS)
def test_curvature_vectors_are_as_long_as_the_curvature(kind):
    curve = random_curve(kind, seed=3, dimension=3)
    for piece in curvature_profile(curve, 50):
        assert_allclose(np.linalg.norm(piece.vectors, axis=1), piece.curvatures, rtol=1e-9)


def test_a_parabola_bends_most_at_its_vertex():
    assert_allclose(curvature_extrema(parabola()), [0.5], atol=1e-7)


def test_a_circle_has_no_extremal_curvature():
    assert len(curvature_extrema(circle())) == 0


@given(seed=st.integers(0, 200))
def test_extrema_are_where_samples_have_them(seed):
    curve = random_curve("bezier", size=5, seed=seed, s=1.5)
    u = np.linspace(0.0, 1.0, 4001)
    k = curvature_at(curve, u)
    peaks = (k[1:-1] - k[:-2]) * (k[1:-1] - k[2:]) > 1e-12 * np.abs(k).max() ** 2
    for place in u[1:-1][peaks]:
        assert np.abs(curvature_extrema(curve) - place).min() < 1e-3


def test_the_energy_of_an_arc_is_its_angle_over_its_radius():
    assert_allclose(bending_energy(circle(2.0)), 1.5 * np.pi / 2.0, rtol=1e-11)


def test_the_energy_of_a_parabola_is_that_of_the_books():
    # With y = x^2 it is the integral of 4 / (1 + 4 x^2)^(5/2) from -1 to 1.
    x = 2.0
    once = x / np.sqrt(1.0 + x * x)
    expected = 2.0 * 2.0 * (once - once**3 / 3.0)
    assert_allclose(bending_energy(parabola()), expected, rtol=1e-11)


def test_a_straight_line_has_no_energy():
    line = PlusCurve(Bernstein(3), ControlLines.of([(0, 0), (3, 4), (6, 8)]), 10.0)
    assert bending_energy(line) < 1e-20


@given(seed=st.integers(0, 100), scale=st.floats(0.01, 100.0))
def test_energy_falls_with_the_size(seed, scale):
    curve = random_curve("bspline", seed=seed, s=0.3)
    larger = transformed(curve, scale * np.eye(2), np.array([1.0, 2.0]))
    assert_allclose(bending_energy(larger), bending_energy(curve) / scale, rtol=1e-8)


def test_a_cusp_makes_the_energy_infinite():
    cusp = PlusCurve(Bernstein(4), ControlLines.of([(0, 0), (1, 1), (0, 1), (1, 0)]), 0.0)
    assert bending_energy(cusp) > 1e3


@pytest.mark.parametrize("order, expected", [(2, 0), (3, 1), (4, 2), (5, 2)])
def test_a_b_spline_plus_curve_is_as_smooth_at_its_knots_as_its_order_says(order, expected):
    found = joints(bent(order=order))
    assert len(found) == 6 - order
    assert {joint.order for joint in found} == {expected}


def test_a_closed_curve_goes_on_over_its_seam():
    found = joints(bent(closed=True))
    assert {joint.order for joint in found} == {2}
    assert found[-1].u == 0.0


def test_ends_that_meet_at_an_angle_are_told():
    points = [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]
    (seam,) = joints(PlusCurve(Bernstein(5), ControlLines.of(points), 0.0))
    assert seam.order == 0
    assert seam.angle == pytest.approx(np.pi / 2.0)


def test_curves_that_meet_are_as_smooth_as_one_cut_in_two():
    first, second = arc((0.0, 0.0), 1.0, 0.0, 1.0), arc((0.0, 0.0), 1.0, 1.0, 2.0)
    for one, other in (
        (first, second),
        (reversed_curve(first), second),
        (first, reversed_curve(second)),
    ):
        (joint,) = meeting(one, other)
        assert joint.order == 2
        assert joint.angle < 1e-9


def test_a_line_that_leaves_an_arc_along_its_tangent_is_smooth_to_first_order():
    line = PlusCurve(Bernstein(2), ControlLines.of([(1, 0), (1, -2)]), 0.0)
    (joint,) = meeting(line, arc((0.0, 0.0), 1.0, 0.0, 1.0))
    assert joint.order == 1
    assert joint.jump == pytest.approx(1.0)


def test_curves_apart_do_not_meet():
    line = PlusCurve(Bernstein(2), ControlLines.of([(5, 0), (5, -2)]), 0.0)
    assert meeting(line, arc((0.0, 0.0), 1.0, 0.0, 1.0)) == ()
    assert meeting(replace(line, s=1.0), bent(closed=True)) == ()
