"""Standard curves become plus curves and come back from them."""

from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.elevation import elevated
from plusedit.geometry.standard import (
    elliptic_arc,
    from_bezier,
    from_bezier_path,
    from_rational_quadratic,
    from_rational_quadratic_path,
)

QUARTER_ARC = np.array([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
QUARTER_WEIGHTS = np.array([1.0, np.sqrt(0.5), 1.0])


def some_points(*shape):
    return np.random.default_rng(7).uniform(-50.0, 80.0, size=shape)


def a_chain(count, dim=2):
    """Cubics that begin where the one before ends, with corners."""
    rows = some_points(3 * count + 1, dim)
    return np.stack([rows[3 * i : 3 * i + 4] for i in range(count)])


def a_smooth_chain(count):
    """Cubics of one length of handle on both sides of every joint."""
    joints, handles = some_points(count + 1, 2), some_points(count + 1, 2) / 4.0
    return np.stack([joints[:-1], (joints + handles)[:-1], (joints - handles)[1:], joints[1:]], 1)


@pytest.mark.parametrize("dim", [2, 3])
@pytest.mark.parametrize("degree", [2, 3, 4, 5, 8, 20, 60, 200])
def test_a_bezier_curve_of_degree_n_comes_back_from_n_lines(degree, dim):
    points = some_points(degree + 1, dim)
    curve = from_bezier(points)
    assert curve.basis.size == degree
    assert_allclose(elevated(curve).points, points, rtol=0, atol=1e-13 * np.abs(points).max())


def test_the_lines_of_a_cubic_touch_it_at_both_ends_and_pass_through_its_middle():
    points = some_points(4, 2)
    curve = from_bezier(points)
    velocity = curve.derivatives([0.0, 1.0], highest=1)[1]
    assert_allclose(curve.gradients[[0, 2]], velocity / 2.0, atol=1e-12)
    assert_allclose(curve.lines.points[1], points.T @ [0.125, 0.375, 0.375, 0.125], atol=1e-12)


@pytest.mark.parametrize("degree", [2, 3, 6, 13])
def test_the_control_points_lie_on_the_curve(degree):
    curve = from_bezier(some_points(degree + 1, 3))
    assert_allclose(curve.at(curve.basis.nodes), curve.lines.points, atol=1e-10)


def test_a_straight_line_has_two_lines_along_it_and_uniform_speed():
    curve = from_bezier([[0.0, 1.0], [3.0, 5.0]])
    u = np.array([0.0, 0.3, 1.0])
    assert_allclose(curve.at(u), [0.0, 1.0] + u[:, None] * [3.0, 4.0], atol=1e-15)
    assert_allclose(curve.directions, [[0.6, 0.8]] * 2)
    assert curve.s == pytest.approx(2.5)


def test_a_curve_without_extent_has_s_one():
    curve = from_bezier(np.ones((4, 2)))
    assert curve.s == 1.0
    assert not curve.directions.any()


def test_a_loop_that_ends_where_it_begins_is_kept():
    points = np.array([[0.0, 0.0], [1.0, 2.0], [0.0, 0.0]])
    assert_allclose(elevated(from_bezier(points)).points, points, atol=1e-15)


def test_a_single_point_is_no_bezier_curve():
    with pytest.raises(ValueError, match="at least 2, got 1"):
        from_bezier([[0.0, 0.0]])


@pytest.mark.parametrize("s", [1.0, 7.0])
def test_a_rational_quadratic_is_exact_for_every_s(s):
    arc = from_rational_quadratic(QUARTER_ARC, QUARTER_WEIGHTS)
    on = type(arc)(arc.basis, arc.lines, s).at(np.linspace(0.0, 1.0, 33))
    assert_allclose(np.linalg.norm(on, axis=1), 1.0, atol=1e-15)


@pytest.mark.parametrize("breaks", [None, "uniform"])
@pytest.mark.parametrize("count", [1, 2, 5, 90])
@pytest.mark.parametrize("chain", [a_chain, a_smooth_chain])
def test_a_chain_of_cubics_comes_back_piece_by_piece(chain, count, breaks):
    pieces = chain(count)
    at = None if breaks is None else np.arange(count + 1) / count
    curve = from_bezier_path(pieces, at)
    assert curve.basis.size == 2 * count + 1
    back = elevated(curve).bezier_pieces()
    assert_allclose(back.points, pieces, rtol=0, atol=1e-13 * np.abs(pieces).max())


def test_where_cubics_join_smoothly_the_line_of_the_joint_is_the_tangent():
    pieces = a_smooth_chain(3)
    curve = from_bezier_path(pieces, [0.0, 1 / 3, 2 / 3, 1.0])
    assert_allclose(curve.gradients[2], 1.5 * 3 * (pieces[1, 1] - pieces[1, 0]), rtol=1e-12)


def test_pieces_of_no_length_are_kept():
    pieces = a_chain(3)
    pieces[1:, :] = pieces[0, 3]
    back = elevated(from_bezier_path(pieces)).bezier_pieces()
    assert_allclose(back.points, pieces, rtol=0, atol=1e-12 * np.abs(pieces).max())


def test_a_chain_with_a_gap_is_refused():
    pieces = a_chain(3)
    pieces[2, 0] += 1.0
    with pytest.raises(ValueError, match="piece 2 does not begin where piece 1 ends"):
        from_bezier_path(pieces)


def test_breaks_that_do_not_increase_are_refused():
    with pytest.raises(ValueError, match="breaks: must increase from 0 to 1"):
        from_bezier_path(a_chain(3), [0.0, 0.5, 0.5, 1.0])


def test_a_chain_of_conics_comes_back_piece_by_piece():
    rows = some_points(9, 3)
    pieces = np.stack([rows[2 * i : 2 * i + 3] for i in range(4)])
    weights = np.random.default_rng(3).uniform(0.2, 5.0, size=(4, 3))
    curve = from_rational_quadratic_path(pieces, weights)
    breaks = np.unique(curve.basis.knot_vector)
    v = np.linspace(0.0, 1.0, 9)
    for (a, b), points, w in zip(pairwise(breaks), pieces, weights, strict=True):
        share = bernstein(v, 2) * w
        expected = share @ points / share.sum(axis=1)[:, None]
        assert_allclose(curve.at(a + (b - a) * v), expected, atol=1e-10)


@pytest.mark.parametrize("sweep", [0.1, 1.5, np.pi / 2, 2.0, np.pi, 5.0, 2 * np.pi, -4.0])
def test_an_arc_lies_on_its_ellipse_from_start_to_end(sweep):
    center, axes = np.array([3.0, -2.0]), np.array([[4.0, 1.0], [-0.5, 2.0]])
    arc = elliptic_arc(center, *axes, start=0.7, sweep=sweep)
    local = (arc.at(np.linspace(0.0, 1.0, 101)) - center) @ np.linalg.inv(axes)
    assert_allclose(np.linalg.norm(local, axis=1), 1.0, atol=1e-14)
    angles = np.unwrap(np.arctan2(local[:, 1], local[:, 0]))
    assert_allclose(angles[[0, 50, -1]], [0.7, 0.7 + sweep / 2, 0.7 + sweep], atol=1e-13)


def test_a_whole_circle_is_one_curve_of_nine_lines_that_ends_where_it_begins():
    circle = elliptic_arc([0.0, 0.0], [1.0, 0.0], [0.0, 1.0])
    assert circle.basis == BSpline(9, 3, knots=(0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1))
    assert (circle.lines.points[0] == circle.lines.points[-1]).all()


@pytest.mark.parametrize("sweep", [0.0, 7.0])
def test_an_arc_of_no_angle_or_more_than_a_turn_is_refused(sweep):
    with pytest.raises(ValueError, match="sweep"):
        elliptic_arc([0.0, 0.0], [1.0, 0.0], [0.0, 1.0], sweep=sweep)
