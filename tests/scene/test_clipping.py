from itertools import pairwise

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.scene.clipping import (
    clipped_polygon,
    clipped_polyline,
    clipped_segments,
    reaches_beyond,
)

BOX = (np.array([0.0, 0.0]), np.array([10.0, 10.0]))
# Never on a side of the box: the oracle counts samples.
numbers = st.integers(-240, 240).map(lambda count: count / 8.0 + 0.03)
corners = st.tuples(numbers, numbers)
lines = st.lists(corners, min_size=2, max_size=6).map(np.array)


def inside(points):
    return ((points >= -1e-9) & (points <= 10.0 + 1e-9)).all(axis=-1)


def length_inside(points, count=4000):
    """How much of a line lies in the box, by many samples: the oracle."""
    total = 0.0
    for start, end in pairwise(points):
        shares = (np.arange(count) + 0.5) / count
        samples = start + shares[:, None] * (end - start)
        total += inside(samples).mean() * np.linalg.norm(end - start)
    return total


def length(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


def area(points):
    x, y = points.T
    return abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2.0


@given(lines)
def test_the_pieces_of_a_line_are_what_lies_inside(points):
    pieces = clipped_polyline(points, BOX)
    assert all(inside(piece).all() for piece in pieces)
    assert_allclose(sum(length(piece) for piece in pieces), length_inside(points), atol=0.2)


def test_a_line_inside_stays_one_piece():
    points = np.array([[1.0, 1.0], [5.0, 9.0], [9.0, 2.0]])
    (piece,) = clipped_polyline(points, BOX)
    assert_array_equal(piece, points)


def test_a_line_that_leaves_and_comes_back_makes_two_pieces():
    points = np.array([[5.0, 5.0], [5.0, 20.0], [8.0, 20.0], [8.0, 5.0]])
    first, second = clipped_polyline(points, BOX)
    assert_allclose(first, [[5.0, 5.0], [5.0, 10.0]])
    assert_allclose(second, [[8.0, 10.0], [8.0, 5.0]])


def test_a_line_outside_leaves_nothing():
    assert clipped_polyline(np.array([[20.0, 0.0], [20.0, 10.0]]), BOX) == []


def test_a_line_that_stands_still_inside_does_no_harm():
    assert all(len(piece) for piece in clipped_polyline(np.array([[5.0, 5.0]] * 3), BOX))


def test_a_line_that_hardly_leaves_a_side_lies_on_it():
    (piece,) = clipped_polyline(np.array([[0.0, 0.0], [1.0, -5e-170]]), BOX)
    assert length(piece) == 1.0


def test_segments_are_cut_one_by_one():
    starts, ends = np.array([[-5.0, 5.0], [20.0, 20.0]]), np.array([[15.0, 5.0], [30.0, 20.0]])
    cut_starts, cut_ends = clipped_segments(starts, ends, BOX)
    assert_allclose(cut_starts, [[0.0, 5.0]])
    assert_allclose(cut_ends, [[10.0, 5.0]])


@given(st.tuples(corners, corners, corners).map(np.array))
def test_the_area_of_a_triangle_is_cut_to_the_box(points):
    cut = clipped_polygon(points, BOX)
    assert inside(cut).all()
    grid = np.stack(np.meshgrid(*[(np.arange(200) + 0.5) / 20.0] * 2), axis=-1).reshape(-1, 2)
    edges, sides = np.roll(points, -1, axis=0) - points, []
    for start, edge in zip(points, edges, strict=True):
        to = grid - start
        sides.append(edge[0] * to[:, 1] - edge[1] * to[:, 0])
    within = (np.array(sides) >= 0.0).all(axis=0) | (np.array(sides) <= 0.0).all(axis=0)
    if area(points) > 1e-6:
        assert_allclose(area(cut) if len(cut) else 0.0, within.mean() * 100.0, atol=0.6)


def test_an_area_around_the_box_becomes_the_box():
    around = np.array([[-9.0, -9.0], [99.0, -9.0], [99.0, 99.0], [-9.0, 99.0]])
    assert area(clipped_polygon(around, BOX)) == 100.0


def test_only_what_lies_outside_reaches_beyond():
    assert not reaches_beyond(np.array([[0.0, 10.0], [5.0, 5.0]]), BOX)
    assert reaches_beyond(np.array([[0.0, 10.1], [5.0, 5.0]]), BOX)
