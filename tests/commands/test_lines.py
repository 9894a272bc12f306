import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.commands.lines import (
    Landing,
    MovePoints,
    ResetDirections,
    ReverseDirections,
    ScaleDirections,
    SetAngle,
    SetCoordinate,
    SetDirection,
    SetLength,
    SetWeight,
    Transform,
    Turn,
)
from plusedit.document.design import EditError
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from tests.commands.known import POINTS, A, B, arch, known, spline

PARAMETERS = np.linspace(0.0, 1.0, 33)
ALL = tuple(range(6))


def after(command, curve=None):
    return command.apply(known(curve)).curve(A)


def space():
    points = [[0.0, 0.0, 1.0], [1.0, 2.0, 0.0], [2.0, 0.0, 3.0]]
    return PlusCurve(BSpline(3, 3), ControlLines.of(points, [None, [1.0, 0.0, 2.0], None]), 1.0)


def test_moving_a_point_leaves_the_others_and_turns_the_automatic_neighbors():
    curve = after(MovePoints({A: (1,)}, np.array([0.0, 1.0])))
    assert_array_equal(curve.lines.points[[0, 2, 3, 4, 5]], np.array(POINTS)[[0, 2, 3, 4, 5]])
    assert_array_equal(curve.lines.points[1], [1.0, 3.0])
    assert (curve.directions[0] != spline().directions[0]).any()
    assert_array_equal(curve.directions[2], spline().directions[2])


def test_a_landing_point_is_met_to_the_last_bit():
    far, goal = np.array([-1000.1, 3.3]), np.array([0.1, 0.2])
    start = spline(lines=spline().lines.with_points(np.array(POINTS) + far))
    by = goal - start.lines.points[1]
    assert (start.lines.points[1] + by != goal).any()
    curve = after(MovePoints({A: (1,)}, by, Landing(A, 1, goal)), start)
    assert_array_equal(curve.lines.points[1], goal)


def test_a_shift_in_the_plane_leaves_the_height_of_a_space_curve():
    curve = after(MovePoints({A: (0,)}, np.array([1.0, 2.0])), space())
    assert_array_equal(curve.lines.points[0], [1.0, 2.0, 1.0])


def test_a_shift_out_of_the_plane_leaves_a_plane_curve():
    before = known()
    assert MovePoints({A: (0,)}, np.array([0.0, 0.0, 2.0])).apply(before) is before


def test_a_coordinate_is_set_for_all_lines_meant():
    curve = after(SetCoordinate({A: (1, 3)}, 1, 7.0))
    assert_array_equal(curve.lines.points[:, 1], [0.0, 7.0, 0.5, 7.0, 0.0, 1.0])


def test_a_plane_curve_has_no_third_coordinate_to_set():
    with pytest.raises(EditError, match="A: a plane curve has no z"):
        SetCoordinate({A: (1,)}, 2, 7.0).apply(known())


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e200])
def test_numbers_that_no_curve_can_have_are_refused_in_words(value):
    with pytest.raises(EditError, match="A: points"):
        SetCoordinate({A: (1,)}, 0, value).apply(known())


def test_turning_keeps_lengths_and_makes_directions_given():
    curve = after(Turn({A: (1, 2)}, np.pi / 3))
    before = spline().directions
    lengths = np.linalg.norm(curve.directions, axis=1)
    assert_allclose(lengths, np.linalg.norm(before, axis=1), atol=1e-15)
    cosine = (curve.directions * before).sum(axis=1) / lengths**2
    assert_allclose(cosine, [1.0, 0.5, 0.5, 1.0, 1.0, 1.0], atol=1e-15)
    assert_array_equal(curve.lines.automatic, [True, False, False, True, True, True])


def test_turning_by_a_quarter_is_free_of_rounding():
    curve = after(Turn({A: (2,)}, np.pi / 2))
    assert_array_equal(curve.directions[2], [-0.5, 2.0])


def test_a_space_curve_turns_in_the_plane_meant():
    curve = after(Turn({A: (1,)}, np.pi / 2, (0, 2)), space())
    assert_array_equal(curve.directions[1], [-2.0, 0.0, 1.0])


def test_a_plane_curve_turns_in_its_plane_only():
    with pytest.raises(EditError, match="turned in the top view"):
        Turn({A: (1,)}, 0.5, (0, 2)).apply(known())
    turn = Transform({A: ALL}, np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]]), np.zeros(3))
    with pytest.raises(EditError, match="turned in the top view"):
        turn.apply(known())


def test_a_direction_is_set_and_reset():
    given = after(SetDirection(A, 1, np.array([3.0, -1.0])))
    assert_array_equal(given.directions[1], [3.0, -1.0])
    assert SetDirection(A, 2, None).apply(known()).curve(A).lines.automatic.all()


def test_an_angle_is_set_and_the_length_kept():
    curve = after(SetAngle({A: (2,)}, np.pi / 2))
    assert_allclose(curve.directions[2], [0.0, np.hypot(2.0, 0.5)])


def test_a_line_without_direction_gets_length_one_with_its_angle():
    zero = SetDirection(A, 2, np.zeros(2)).apply(known())
    curve = SetAngle({A: (2,)}, np.pi).apply(zero).curve(A)
    assert_array_equal(curve.directions[2], [-1.0, 0.0])


def test_a_length_is_set_and_the_way_kept():
    curve = after(SetLength({A: (2,)}, 4.0))
    assert_allclose(curve.directions[2], np.array([2.0, 0.5]) * 4.0 / np.hypot(2.0, 0.5))


def test_a_length_can_not_be_negative_nor_given_to_a_line_without_direction():
    with pytest.raises(EditError, match="can't be negative"):
        SetLength({A: (2,)}, -1.0).apply(known())
    zero = SetDirection(A, 2, np.zeros(2)).apply(known())
    with pytest.raises(EditError, match="without a direction"):
        SetLength({A: (2,)}, 1.0).apply(zero)
    assert_array_equal(SetLength({A: (2,)}, 0.0).apply(zero).curve(A).directions[2], [0.0, 0.0])


def test_reversing_twice_brings_the_directions_back():
    there = ReverseDirections({A: ALL}).apply(known())
    assert_array_equal(there.curve(A).directions, -spline().directions)
    back = ReverseDirections({A: ALL}).apply(there).curve(A)
    assert_array_equal(back.directions, spline().directions)


def test_a_reversed_zero_is_no_negative_zero():
    curve = after(ReverseDirections({A: (1,)}))
    assert not np.signbit(curve.lines.given[curve.lines.given == 0.0]).any()


def test_stretching_multiplies():
    curve = after(ScaleDirections({A: (2,)}, -2.0))
    assert_array_equal(curve.directions[2], [-4.0, -1.0])


def test_resetting_follows_the_neighbors_again():
    curve = after(ResetDirections({A: ALL}))
    assert curve.lines.automatic.all()


def test_weights_that_are_all_one_are_none():
    heavy = SetWeight({A: (1,)}, 3.0).apply(known())
    assert_array_equal(heavy.curve(A).lines.weights, [1.0, 3.0, 1.0, 1.0, 1.0, 1.0])
    assert SetWeight({A: (1,)}, 1.0).apply(heavy).curve(A).lines.weights is None


@pytest.mark.parametrize("weight", [0.0, -1.0, np.nan])
def test_a_weight_must_be_positive(weight):
    with pytest.raises(EditError, match="A: weights"):
        SetWeight({A: (1,)}, weight).apply(known())


@pytest.mark.parametrize(
    "matrix",
    [
        [[0.0, -2.0], [2.0, 0.0]],
        [[-1.0, 0.0], [0.0, 1.0]],
        [[1.0, 0.7], [0.0, 0.5]],
        [[3.0, 0.0], [0.0, 1.0]],
    ],
)
def test_a_whole_curve_becomes_its_exact_image(matrix):
    matrix, offset = np.array(matrix), np.array([0.5, -2.0])
    curve = after(Transform({A: ALL}, matrix, offset))
    expected = spline().at(PARAMETERS) @ matrix.T + offset
    assert_allclose(curve.at(PARAMETERS), expected, atol=1e-12)


def test_under_a_similarity_automatic_directions_stay_automatic():
    curve = after(Transform({A: ALL}, 2.0 * np.eye(2), np.zeros(2)))
    assert_array_equal(curve.lines.automatic, spline().lines.automatic)
    assert curve.s == 2.0 * spline().s


def test_of_a_part_of_a_curve_given_directions_are_mapped_as_vectors():
    curve = after(Transform({A: (1, 2)}, 2.0 * np.eye(2), np.array([1.0, 0.0])))
    assert_array_equal(curve.lines.points[[1, 2]], [[3.0, 4.0], [5.0, 1.0]])
    assert_array_equal(curve.directions[2], [4.0, 1.0])
    assert curve.s == spline().s


def test_an_edit_acts_on_several_curves_at_once():
    both = MovePoints({A: (0,), B: (3,)}, np.array([1.0, 1.0])).apply(known())
    assert_array_equal(both.curve(A).lines.points[0], [1.0, 1.0])
    assert_array_equal(both.curve(B).lines.points[3], arch().lines.points[3] + 1.0)
