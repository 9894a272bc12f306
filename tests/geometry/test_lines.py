"""Control lines: what they take in, and directions that follow the points."""

from dataclasses import FrozenInstanceError

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.arrays import frozen, unit
from plusedit.geometry.lines import ControlLines, automatic_directions

SQUARE = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])
HALF = np.sqrt(0.5)


def test_automatic_directions_run_from_neighbor_to_neighbor_and_one_sided_at_the_ends():
    expected = [[1.0, 0.0], [HALF, HALF], [-HALF, HALF], [-1.0, 0.0]]
    assert_allclose(ControlLines.of(SQUARE).directions(closed=False), expected)


def test_on_a_closed_curve_the_last_point_is_a_neighbor_of_the_first():
    expected = [[HALF, -HALF], [HALF, HALF], [-HALF, HALF], [-HALF, -HALF]]
    assert_allclose(ControlLines.of(SQUARE).directions(closed=True), expected)


@pytest.mark.parametrize("closed", [False, True])
def test_two_lines_have_directions(closed):
    found = automatic_directions(np.array([[0.0, 0.0], [0.0, 2.0]]), closed=closed)
    # On a closed curve of two lines both neighbors are the same point.
    assert_array_equal(found, np.zeros((2, 2)) if closed else [[0.0, 1.0]] * 2)


@pytest.mark.parametrize("scale", [1e-300, 1e-160, 1.0, 1e99])
def test_neighbors_in_one_place_leave_a_zero_direction_whatever_the_scale(scale):
    points = scale * np.array([[0.0, 0.0], [1.0, 1.0], [0.0, 0.0], [0.0, -3.0]])
    expected = [[HALF, HALF], [0.0, 0.0], [-1.0 / 17**0.5, -4.0 / 17**0.5], [0.0, -1.0]]
    assert_allclose(automatic_directions(points, closed=False), expected, atol=1e-12)


def test_a_direction_that_was_given_stays_as_it_is_and_the_others_follow():
    lines = ControlLines.of(SQUARE, [None, [3.0, 0.0], None, None])
    moved = lines.with_points(SQUARE * [1.0, -1.0]).directions(closed=False)
    assert_array_equal(moved[1], [3.0, 0.0])
    assert_allclose(moved[0], [1.0, 0.0])
    assert_allclose(moved[2], [-HALF, -HALF])


def test_a_direction_can_be_given_and_made_automatic_again():
    lines = ControlLines.of(SQUARE)
    given_one = lines.with_direction(2, np.array([0.0, 5.0]))
    assert given_one.automatic.tolist() == [True, True, False, True]
    assert_array_equal(given_one.directions(closed=False)[2], [0.0, 5.0])
    again = given_one.with_direction(2, None)
    assert again.automatic.all()
    assert not again.given.any()


def test_an_edit_leaves_the_old_lines_alone():
    lines = ControlLines.of(SQUARE)
    before = lines.directions(closed=True).copy()
    lines.with_points(SQUARE[::-1].copy())
    lines.with_direction(1, np.ones(2))
    assert_array_equal(lines.points, SQUARE)
    assert_array_equal(lines.directions(closed=True), before)


def test_lines_of_other_points_keep_directions_weights_and_their_checks():
    lines = ControlLines.of(SQUARE, [None, [3.0, 0.0], None, None], [1.0, 2.0, 3.0, 4.0])
    moved = lines.with_points(SQUARE + 1.0)
    assert_array_equal(moved.points, SQUARE + 1.0)
    assert_array_equal(moved.given, lines.given)
    assert_array_equal(moved.weights, lines.weights)
    assert_array_equal(moved.unit_weights, [0.25, 0.5, 0.75, 1.0])
    with pytest.raises(ValueError, match="points: has a value that is not finite"):
        lines.with_points(np.full((4, 2), np.nan))
    with pytest.raises(ValueError, match="points: expected shape"):
        lines.with_points(np.ones((4, 3)))


def test_lines_cannot_be_written_to():
    lines = ControlLines.of(SQUARE, weights=[1.0] * 4).with_points(SQUARE)
    with pytest.raises(FrozenInstanceError):
        lines.points = SQUARE
    for array in (lines.points, lines.given, lines.automatic, lines.weights):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    with pytest.raises(ValueError, match="read-only"):
        lines.directions(closed=False)[0] = 0


def test_lines_have_arrays_of_their_own():
    points = SQUARE.copy()
    lines = ControlLines.of(points)
    points[0] = 99.0
    assert_array_equal(lines.points, SQUARE)


def test_some_of_the_lines_can_be_taken_in_any_order():
    lines = ControlLines.of(SQUARE, [None, [3.0, 0.0], None, None], [1.0, 2.0, 3.0, 4.0])
    taken = lines.taken([3, 1])
    assert_array_equal(taken.points, SQUARE[[3, 1]])
    assert taken.automatic.tolist() == [True, False]
    assert_array_equal(taken.weights, [4.0, 2.0])


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: ControlLines.of([[0.0, 0.0]]), "at least 2 control lines, got 1"),
        (lambda: ControlLines.of([[0.0], [1.0]]), "rows need 2 or 3 numbers, got 1"),
        (lambda: ControlLines.of([0.0, 1.0]), "points: expected shape"),
        (lambda: ControlLines.of([[0.0, 0.0], [np.inf, 0.0]]), "points: has a value that is not"),
        (lambda: ControlLines.of([[0.0, 0.0], [1e101, 0.0]]), "points: has a value beyond 1e"),
        (lambda: ControlLines.of(SQUARE, [None]), "directions: expected 4 rows, got 1"),
        (lambda: ControlLines.of(SQUARE, [[np.nan, 0.0]] * 4), "directions: has a value that is"),
        (lambda: ControlLines.of(SQUARE, weights=[1.0, 2.0]), "weights: expected shape"),
        (lambda: ControlLines.of(SQUARE, weights=[1.0, 2.0, 0.0, 1.0]), "must be positive, got 0"),
        (lambda: ControlLines(SQUARE, SQUARE, np.array([True])), "automatic: expected shape"),
    ],
)
def test_what_makes_no_lines_is_refused_in_a_sentence(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@given(st.lists(st.tuples(*[st.floats(-1e300, 1e300)] * 3), min_size=1, max_size=6))
@settings(max_examples=50, deadline=None)
def test_unit_vectors_have_length_one_or_zero(rows):
    vectors = np.array(rows)
    found = unit(vectors)
    is_zero = ~vectors.any(axis=1)
    assert_allclose(np.linalg.norm(found, axis=1), np.where(is_zero, 0.0, 1.0), rtol=1e-12)
    assert_array_equal(np.sign(found) * np.sign(vectors) >= 0.0, True)


def test_a_single_vector_is_made_unit_too():
    assert_allclose(unit(np.array([3.0, 4.0])), [0.6, 0.8])
    assert_array_equal(unit(np.zeros(2)), [0.0, 0.0])


def test_frozen_arrays_may_be_empty():
    assert frozen([], shape=(None,), name="knots").shape == (0,)
