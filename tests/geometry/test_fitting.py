"""Fitted curves, judged by how near the given points they come."""

from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.fitting import fit_bspline_plus
from plusedit.geometry.nearest import nearest_parameters
from tests.geometry.curves import random_curve


def wave(count=400, dimension=2):
    """Points of a curve that bends in different ways; its size is about one."""
    t = np.linspace(0.0, 1.0, count)
    rows = [t, 0.3 * np.sin(7.0 * t) * np.exp(-2.0 * t), 0.2 * t**3]
    return np.stack(rows[:dimension], axis=1)


def ring(count=300):
    """Points around a flower, the first not repeated."""
    angle = 2.0 * np.pi * np.arange(count) / count
    radius = 1.0 + 0.2 * np.cos(3.0 * angle)
    return radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def zigzag(per_edge=30):
    """Points on the edges of three straight lines, and the numbers of the two corners."""
    ends = np.array([(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (3.0, 2.0)])
    edges = [np.linspace(a, b, per_edge, endpoint=False) for a, b in pairwise(ends)]
    return np.concatenate([*edges, ends[-1:]]), [per_edge, 2 * per_edge]


def misses(curve, points):
    """Distances of the points from the curve."""
    return np.linalg.norm(curve.at(nearest_parameters(curve, points)) - points, axis=1)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-7])
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("order", [2, 3, 4, 5])
def test_every_point_is_within_the_tolerance(tolerance, dimension, order):
    if order == 2 and tolerance < 1e-5:
        return
    points = wave(dimension=dimension)
    made = fit_bspline_plus(points, tolerance=tolerance, order=order)
    assert made.largest <= tolerance
    assert misses(made.curve, points).max() <= made.largest * (1.0 + 1e-9)
    assert made.rms <= made.largest


def test_the_distances_reported_are_those_from_the_nearest_points():
    points = wave()
    made = fit_bspline_plus(points, tolerance=1e-3)
    missed = misses(made.curve, points)
    assert_allclose(made.largest, missed.max(), rtol=1e-3)
    assert_allclose(made.rms, np.sqrt((missed**2).mean()), rtol=1e-3)


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6])
def test_a_closed_curve_is_closed_and_within_the_tolerance(tolerance):
    points = ring()
    made = fit_bspline_plus(points, tolerance=tolerance, closed=True)
    assert made.curve.closed
    assert made.largest <= tolerance
    assert misses(made.curve, points).max() <= tolerance


def test_the_first_point_may_be_repeated_at_the_end_of_a_closed_curve():
    points = ring()
    once = fit_bspline_plus(points, tolerance=1e-4, closed=True)
    twice = fit_bspline_plus(np.concatenate([points, points[:1]]), tolerance=1e-4, closed=True)
    assert_array_equal(twice.curve.lines.points, once.curve.lines.points)


def test_an_open_curve_begins_and_ends_with_the_points():
    points = wave()
    curve = fit_bspline_plus(points, tolerance=1e-2).curve
    assert_allclose(curve.at([0.0, 1.0]), points[[0, -1]], atol=1e-15)


def test_points_of_a_quadratic_need_no_more_lines_than_the_order():
    t = np.linspace(0.0, 1.0, 200)
    points = np.stack([t, t**2], axis=1)
    made = fit_bspline_plus(points, tolerance=1e-3)
    assert made.curve.basis.size <= 6


@pytest.mark.parametrize("kind", ["bezier", "bspline"])
def test_points_of_a_plus_curve_are_met_with_few_lines(kind):
    curve = random_curve(kind, size=4, s=2.0, seed=1)
    points = curve.at(np.linspace(0.0, 1.0, 500))
    made = fit_bspline_plus(points, tolerance=1e-5)
    assert made.largest <= 1e-5
    assert made.curve.basis.size < 40


def test_a_finer_tolerance_takes_more_lines():
    sizes = [fit_bspline_plus(wave(), tolerance=t).curve.basis.size for t in (1e-2, 1e-4, 1e-6)]
    assert sizes == sorted(set(sizes))


def test_lines_stand_close_where_the_points_bend():
    t = np.linspace(-1.0, 1.0, 600)
    points = np.stack([t, np.tanh(30.0 * t)], axis=1)
    made = fit_bspline_plus(points, tolerance=1e-4)
    assert made.largest <= 1e-4
    # The steep part is a half of the length of the chain, the bends beside it a tenth.
    knots = np.diff(made.curve.basis.breaks)
    assert knots.max() > 5.0 * knots.min()


def test_lines_lie_along_the_curve_so_that_they_can_be_edited():
    made = fit_bspline_plus(wave(), tolerance=1e-4)
    curve = made.curve
    velocity = curve.derivatives(curve.basis.nodes, highest=1)[1]
    away = curve.gradients - velocity / 2.0
    assert np.linalg.norm(away, axis=1).max() < 0.5 * np.linalg.norm(velocity, axis=1).max()
    away = curve.lines.points - curve.at(curve.basis.nodes)
    assert np.linalg.norm(away, axis=1).max() < 0.05


def test_so_they_do_where_fewer_lines_would_be_near_enough():
    angle = 2.0 * np.pi * np.arange(59) / 59
    radius = 150.0 + 40.0 * np.cos(3.0 * angle)
    points = (radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)).round()
    made = fit_bspline_plus(points, tolerance=2.0, closed=True)
    curve = made.curve
    assert made.largest <= 2.0
    assert curve.basis.size <= 10
    away = curve.lines.points - curve.at(curve.basis.nodes)
    assert np.linalg.norm(away, axis=1).max() < 0.15 * np.ptp(points, axis=0).max()


def test_a_corner_is_met_and_stays_sharp():
    points, corners = zigzag()
    made = fit_bspline_plus(points, tolerance=1e-6, corners=corners)
    assert made.largest <= 1e-6
    assert made.curve.basis.size <= 10
    assert isinstance(made.curve.basis, BSpline)
    for corner in points[corners]:
        at = made.curve.at(made.curve.basis.breaks)
        assert np.linalg.norm(at - corner, axis=1).min() < 1e-14


def test_corner_after_corner_makes_a_polygon():
    points = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 3.0)])
    made = fit_bspline_plus(points, tolerance=1e-6, corners=[0, 1, 2], closed=True)
    ends = made.curve.at([0.0, 1.0])
    assert_allclose(ends, [(0.0, 0.0), (0.0, 0.0)], atol=1e-14)
    half = np.array([(2.0, 0.0), (4.0, 1.5), (2.0, 1.5)])
    assert misses(made.curve, np.concatenate([points, half])).max() < 1e-6


def test_a_closed_curve_may_begin_its_corners_anywhere():
    angle = 2.0 * np.pi * np.arange(200) / 200
    drop = np.stack([np.cos(angle), np.sin(angle) * np.sin(angle / 2.0) ** 3], axis=1)
    turned = np.roll(drop, 50, axis=0)
    made = fit_bspline_plus(turned, tolerance=1e-4, corners=[50], closed=True)
    assert_allclose(made.curve.at([0.0, 1.0]), [drop[0], drop[0]], atol=1e-14)
    assert misses(made.curve, turned).max() <= 1e-4


@pytest.mark.parametrize("scale", [2.0**-200, 2.0**200])
def test_the_size_does_not_matter(scale):
    small = fit_bspline_plus(wave(), tolerance=1e-4)
    large = fit_bspline_plus(scale * wave(), tolerance=1e-4 * scale)
    assert_array_equal(large.curve.lines.points, scale * small.curve.lines.points)


@pytest.mark.parametrize("count", [2, 3, 5])
@pytest.mark.parametrize("closed", [False, True])
def test_few_points_make_a_curve_too(count, closed):
    points = wave()[:: 400 // count][:count]
    made = fit_bspline_plus(points, tolerance=1e-3, closed=closed)
    assert made.largest < 0.1
    assert misses(made.curve, points).max() <= made.largest + 1e-12


def test_two_points_make_a_straight_line():
    made = fit_bspline_plus([(0.0, 0.0), (3.0, 4.0)], tolerance=1e-3)
    u = np.linspace(0.0, 1.0, 9)
    assert_allclose(made.curve.at(u), u[:, None] * (3.0, 4.0), atol=1e-9)


def test_points_all_in_one_place_make_a_curve_that_stays_there():
    made = fit_bspline_plus([(1.0, 2.0)] * 7, tolerance=1e-3)
    assert_allclose(made.curve.at([0.0, 0.3, 1.0]), [(1.0, 2.0)] * 3, atol=1e-12)


def test_repeated_points_do_no_harm():
    points = np.repeat(wave(100), 3, axis=0)
    made = fit_bspline_plus(points, tolerance=1e-4)
    assert made.largest <= 1e-4


def test_noise_is_not_followed_with_more_lines_than_points():
    noise = np.random.default_rng(0).normal(size=(60, 2))
    made = fit_bspline_plus(noise, tolerance=1e-9)
    assert made.curve.basis.size <= 60
    assert np.isfinite(made.largest)


@pytest.mark.parametrize(
    ("points", "options", "words"),
    [
        ([(0, 0)], {}, "at least 2 rows"),
        ([(0, 0), (1, np.nan)], {}, "not finite"),
        ([(0, 0), (1, 1)], {"tolerance": 0.0}, "must be positive"),
        ([(0, 0), (1, 1)], {"order": 1}, "2 or more"),
        ([(0, 0), (1, 1)], {"corners": [2]}, "corners"),
    ],
)
def test_what_can_not_be_fitted_is_refused(points, options, words):
    with pytest.raises(ValueError, match=words):
        fit_bspline_plus(points, **{"tolerance": 1e-3, **options})
