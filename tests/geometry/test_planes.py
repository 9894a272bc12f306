"""Control planes: what they take in, and directions that follow the points."""

from dataclasses import FrozenInstanceError

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.lines import ControlLines, automatic_directions
from plusedit.geometry.planes import ControlPlanes, automatic_planes

POINTS = np.random.default_rng(0).normal(size=(4, 3, 3))


@given(st.integers(2, 6), st.integers(2, 6), st.booleans(), st.booleans(), st.integers(0, 99))
@settings(max_examples=40, deadline=None)
def test_automatic_directions_are_those_of_the_curves_through_each_row(
    n, m, round_u, round_v, seed
):
    points = np.random.default_rng(seed).normal(size=(n, m, 3))
    by_u, by_v = automatic_planes(points, closed_u=round_u, closed_v=round_v)
    for j in range(m):
        assert_allclose(by_u[:, j], automatic_directions(points[:, j], closed=round_u), atol=1e-15)
    for i in range(n):
        assert_allclose(by_v[i], automatic_directions(points[i], closed=round_v), atol=1e-15)


@pytest.mark.parametrize("scale", [1e-300, 1e-160, 1.0, 1e99])
def test_neighbors_in_one_place_leave_a_zero_direction_whatever_the_scale(scale):
    points = scale * POINTS
    points[2, 1] = points[0, 1]
    by_u, by_v = automatic_planes(points, closed_u=False, closed_v=False)
    assert_array_equal(by_u[1, 1], 0.0)
    assert_allclose(np.linalg.norm(by_v, axis=-1), 1.0)


def test_round_directions_of_two_rows_are_zero():
    by_u, _ = automatic_planes(POINTS[:2], closed_u=True, closed_v=False)
    assert_array_equal(by_u, 0.0)


def test_directions_that_were_given_stay_as_they_are_and_the_others_follow():
    by_u = [[None] * 3 for _ in range(4)]
    by_u[1][2] = [3.0, 0.0, 0.0]
    planes = ControlPlanes.of(POINTS, directions_u=by_u)
    moved = planes.with_points(-POINTS)
    before, after = (p.directions(closed_u=False, closed_v=False) for p in (planes, moved))
    free = planes.automatic
    assert free.sum() == 2 * 12 - 1
    assert_array_equal(after[0, 1, 2], [3.0, 0.0, 0.0])
    assert_allclose(after[free], -before[free])


def test_a_direction_depends_on_its_neighbors_only():
    planes = ControlPlanes.of(POINTS)
    points = POINTS.copy()
    points[0, 0] += 1.0
    moved = planes.with_points(points)
    before, after = (p.directions(closed_u=False, closed_v=False) for p in (planes, moved))
    changed = (before != after).any(axis=-1)
    assert_array_equal(np.argwhere(changed), [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 0, 1]])


def test_they_are_worked_out_once():
    planes = ControlPlanes.of(POINTS)
    first = planes.directions(closed_u=True, closed_v=False)
    assert planes.directions(closed_u=True, closed_v=False) is first
    assert planes.directions(closed_u=False, closed_v=False) is not first


def test_planes_look_like_lines_in_the_order_of_their_numbers():
    planes = ControlPlanes.of(POINTS, weights=np.arange(1.0, 13.0).reshape(4, 3))
    assert len(planes) == 12
    assert planes.dimension == 3
    assert_array_equal(planes.control_points[1 * 3 + 2], POINTS[1, 2])
    assert planes.given_vectors.shape == (2, 12, 3)
    assert planes.automatic_vectors.shape == (2, 12)
    assert planes.weight_row[5] == 6.0
    assert ControlPlanes.of(POINTS).weight_row is None


def test_the_flat_look_leads_back_to_the_same_planes():
    planes = ControlPlanes.of(POINTS, weights=np.arange(1.0, 13.0).reshape(4, 3))
    vectors, automatic = np.random.default_rng(1).normal(size=(2, 12, 3)), np.zeros((2, 12), bool)
    turned = planes.with_vectors(vectors, automatic)
    assert_array_equal(turned.given_vectors, vectors)
    assert not turned.automatic.any()
    assert_array_equal(turned.with_control_points(2.0 * planes.control_points).points, 2.0 * POINTS)
    assert_array_equal(planes.with_weight_row(np.ones(12)).weights, np.ones((4, 3)))
    assert planes.with_weight_row(None).weights is None


def test_taken_planes_keep_everything_they_have():
    random = np.random.default_rng(2)
    automatic = random.random((2, 4, 3)) < 0.5
    given_ones = np.where(automatic[..., None], 0.0, random.normal(size=(2, 4, 3, 3)))
    planes = ControlPlanes(POINTS, given_ones, automatic, np.arange(1.0, 13.0).reshape(4, 3))
    some = planes.taken([3, 0], [1, 2])
    assert_array_equal(some.points, POINTS[[3, 0]][:, [1, 2]])
    assert_array_equal(some.given, given_ones[:, [3, 0]][:, :, [1, 2]])
    assert_array_equal(some.automatic, automatic[:, [3, 0]][:, :, [1, 2]])
    assert_array_equal(some.weights, [[11.0, 12.0], [2.0, 3.0]])


def test_only_ratios_of_weights_count():
    weights = np.array([[1.0, 2.0], [4.0, 8.0]])
    planes = ControlPlanes.of(POINTS[:2, :2], weights=1e90 * weights)
    assert_allclose(planes.unit_weights, weights / 8.0)
    assert_array_equal(ControlPlanes.of(POINTS).unit_weights, np.ones((4, 3)))


def test_an_edit_leaves_the_old_planes_alone():
    planes = ControlPlanes.of(POINTS)
    planes.with_points(POINTS + 1.0)
    assert_array_equal(planes.points, POINTS)
    with pytest.raises(ValueError, match="read-only"):
        planes.points[0, 0] = 0.0
    with pytest.raises(FrozenInstanceError):
        planes.weights = None


def test_planes_are_compared_by_identity():
    assert ControlPlanes.of(POINTS) != ControlPlanes.of(POINTS)


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"points": np.zeros((1, 3, 3))}, "points: a surface needs at least 2 x 2, got 1 x 3"),
        ({"points": np.zeros((3, 3, 2))}, "points: expected shape"),
        ({"points": np.full((2, 2, 3), np.nan)}, "points: has a value that is not finite"),
        ({"points": np.full((40, 70, 3), np.inf)}, "points: has a value that is not finite"),
        ({"points": np.full((2, 2, 3), 1e101)}, "points: has a value beyond 1e[+]100"),
        ({"points": np.full((60, 70, 3), -1e101)}, "points: has a value beyond 1e[+]100"),
        ({"points": POINTS, "weights": np.ones((3, 4))}, "weights: expected shape"),
        ({"points": POINTS, "weights": np.zeros((4, 3))}, "weights: must be positive, got 0"),
        ({"points": POINTS, "directions_u": [[None] * 3]}, "directions_u: expected 4 rows, got 1"),
        (
            {"points": POINTS, "directions_v": [[None] * 2] * 4},
            "directions_v: row 0: expected 3 entries, got 2",
        ),
    ],
)
def test_what_does_not_fit_is_refused_and_named(fields, message):
    with pytest.raises(ValueError, match=message):
        ControlPlanes.of(**fields)


def test_flags_of_another_shape_are_refused():
    with pytest.raises(ValueError, match="automatic: expected shape"):
        ControlPlanes(POINTS, np.zeros((2, 4, 3, 3)), np.ones((4, 3), dtype=bool))


def test_a_row_of_planes_has_the_directions_of_its_lines():
    row = ControlLines.of(POINTS[:, 0])
    by_u, _ = ControlPlanes.of(POINTS).directions(closed_u=False, closed_v=False)
    assert_allclose(by_u[:, 0], row.directions(closed=False), atol=1e-15)
