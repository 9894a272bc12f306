"""Regions that a plus curve cannot leave."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.hulls import (
    convex_hull,
    elevated_hull,
    parent_hulls,
    parents,
    span_hulls,
    union_hull,
)
from tests.geometry.curves import KINDS, random_curve

U = np.linspace(0.0, 1.0, 501)
SPLINES = tuple(k for k in KINDS if "rag" not in k and k != "staircase")
OPEN = tuple(k for k in KINDS if not k.startswith("closed"))


def outside(hull, points):
    """How far the points stand off the hull, at most, seen from its edges; counter-clockwise."""
    edges = np.roll(hull, -1, axis=0) - hull
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return ((points[:, None] - hull) * normals).sum(axis=2).max()


@pytest.mark.parametrize("kind", OPEN)
@pytest.mark.parametrize("contrast", [None, 5.0])
def test_the_curve_is_the_mean_of_its_parents(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    first, second = parents(curve)
    assert first.s == second.s == 0.0
    mean = (1.0 - U)[:, None] * first.at(U) + U[:, None] * second.at(U)
    assert_allclose(mean, curve.at(U), atol=1e-13)


@pytest.mark.parametrize("kind", (*OPEN, "closed", "closed, odd order"))
@pytest.mark.parametrize("contrast", [None, 5.0])
def test_the_curve_lies_in_the_hull_of_the_union(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    assert outside(union_hull(curve), curve.at(U)) < 1e-12


@pytest.mark.parametrize("kind", SPLINES)
@pytest.mark.parametrize("contrast", [None, 5.0])
def test_the_curve_lies_in_the_hull_of_its_elevated_points(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    assert outside(elevated_hull(curve), curve.at(U)) < 1e-12


@pytest.mark.parametrize("kind", OPEN)
def test_the_hull_of_the_union_holds_the_hulls_of_both_parents(kind):
    curve = random_curve(kind)
    for hull in parent_hulls(curve):
        assert outside(union_hull(curve), hull) < 1e-12


@pytest.mark.parametrize("kind", ["bspline", "polygon", "kinks", "closed", "closed, odd order"])
@pytest.mark.parametrize("contrast", [None, 5.0])
def test_every_span_lies_in_its_own_hull(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    breaks, hulls = curve.basis.breaks, span_hulls(curve)
    assert len(hulls) == len(breaks) - 1
    for low, high, hull in zip(breaks[:-1], breaks[1:], hulls, strict=True):
        u = np.linspace(low, high, 40, endpoint=high == 1.0 and not curve.closed)
        assert outside(hull, curve.at(u)) < 1e-12


@pytest.mark.parametrize("kind", ["bezier", "rag"])
def test_a_curve_without_knots_is_one_piece(kind):
    curve = random_curve(kind)
    (hull,) = span_hulls(curve)
    assert_array_equal(hull, union_hull(curve))


def test_a_space_curve_shows_the_hull_of_two_of_its_coordinates():
    curve = random_curve("bspline", dimension=3)
    assert outside(union_hull(curve, axes=(0, 2)), curve.at(U)[:, [0, 2]]) < 1e-12


@pytest.mark.parametrize("hull", [union_hull, span_hulls])
def test_closed_gaussians_have_no_hull(hull):
    with pytest.raises(ValueError, match="only closed B-splines have hulls"):
        hull(random_curve("closed rag"))


def test_a_closed_curve_has_no_parents():
    with pytest.raises(ValueError, match="no parent curves"):
        parents(random_curve("closed"))


def test_the_hull_of_a_square_and_what_is_in_it_and_on_its_edges_is_the_square():
    points = np.array([[1, 1], [0, 0], [2, 2], [0, 2], [1, 0], [2, 0], [2, 1], [0.3, 0.4], [0, 0]])
    assert_array_equal(convex_hull(points), [[0, 0], [2, 0], [2, 2], [0, 2]])


def test_the_hull_of_points_in_a_row_is_its_two_ends():
    points = np.outer([0.3, -1.0, 2.0, 0.0], [1.0, 2.0])
    assert_array_equal(convex_hull(points), [[-1.0, -2.0], [2.0, 4.0]])


def test_the_hull_of_one_place_is_that_place():
    assert_array_equal(convex_hull(np.ones((3, 2))), [[1.0, 1.0]])


def test_the_hull_of_nothing_is_nothing():
    assert convex_hull(np.empty((0, 2))).shape == (0, 2)


@given(st.lists(st.tuples(*[st.integers(-50, 50)] * 2), min_size=3, max_size=12))
@settings(max_examples=50, deadline=None)
def test_a_hull_turns_left_at_every_corner_and_holds_all_points(rows):
    points = np.array(rows) / 7.0
    hull = convex_hull(points)
    if len(hull) >= 3:
        (x1, y1), (x2, y2) = (
            (np.roll(hull, -1, axis=0) - hull).T,
            (np.roll(hull, -2, axis=0) - np.roll(hull, -1, axis=0)).T,
        )
        assert (x1 * y2 - y1 * x2 >= 0.0).all()
        assert outside(hull, points) <= 1e-9
