"""Control planes under the commands that control lines know too."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.commands.base import Together
from plusedit.commands.lines import (
    Landing,
    MovePoints,
    ResetDirections,
    ReverseDirections,
    Rotate,
    ScaleDirections,
    SetCoordinate,
    SetDirection,
    SetLength,
    SetWeight,
    SoftMove,
    Transform,
    Turn,
)
from plusedit.commands.rotation import rotation
from plusedit.document.design import EditError
from plusedit.geometry.lines import ControlLines
from tests.commands.known import A, B, known, sheet, spline

ALL = tuple(range(20))
AXIS = np.array([2.0, -1.0, 2.0]) / 3.0
LIFT = np.array([0.5, -0.25, 1.0])
SIDES = {"both": (True, True), "u": (True, False), "v": (False, True)}

every_side = pytest.mark.parametrize("side", list(SIDES))


def after(command, surface=None):
    return command.apply(known(sheet() if surface is None else surface)).surface(A)


def changed(surface):
    """(2, 20) which directions by u and by v are others than those of the sheet."""
    return (surface.vectors != sheet().vectors).any(axis=2)


def test_moving_a_plane_leaves_the_other_points_and_turns_the_automatic_neighbors():
    surface = after(MovePoints({A: (11,)}, LIFT))
    moved = surface.planes.control_points - sheet().planes.control_points
    assert_allclose(moved[11], LIFT, atol=1e-15)
    assert not np.delete(moved, 11, axis=0).any()
    by_u, by_v = changed(surface)
    assert set(np.flatnonzero(by_u)) == {6, 16}
    assert set(np.flatnonzero(by_v)) == {10, 12}


def test_a_landing_plane_is_met_to_the_last_bit():
    goal = np.array([0.1, 0.2, 0.3])
    by = goal - sheet().planes.control_points[7]
    surface = after(MovePoints({A: (6, 7)}, by, Landing(A, 7, goal)))
    assert_array_equal(surface.planes.control_points[7], goal)


def test_a_coordinate_is_set_for_all_planes_meant():
    surface = after(SetCoordinate({A: (1, 3)}, 2, 7.0))
    assert_array_equal(surface.planes.control_points[[1, 3], 2], [7.0, 7.0])


def test_weights_of_planes_that_are_all_one_are_none():
    heavy = SetWeight({A: (6,)}, 3.0).apply(known(sheet()))
    assert heavy.surface(A).planes.weights[1, 1] == 3.0
    assert SetWeight({A: (6,)}, 1.0).apply(heavy).surface(A).planes.weights is None


@every_side
@pytest.mark.parametrize(
    "edit",
    [
        lambda targets, side: Rotate(targets, rotation(AXIS, 0.7), side),
        lambda targets, side: Turn(targets, 0.7, (0, 2), side=side),
        lambda targets, side: ScaleDirections(targets, 2.0, side),
        lambda targets, side: SetLength(targets, 2.5, side),
        lambda targets, side: ReverseDirections(targets, side),
    ],
    ids=["rotate", "turn", "scale", "length", "reverse"],
)
def test_an_edit_of_one_direction_leaves_the_other(edit, side):
    surface = after(edit({A: (6, 7)}, side))
    by_side = changed(surface)
    assert_array_equal(by_side[:, 6] & by_side[:, 7], SIDES[side])
    assert not np.delete(by_side, [6, 7], axis=1).any()
    assert_array_equal(surface.planes.automatic_vectors[:, 6], np.logical_not(SIDES[side]))


@every_side
def test_a_reset_direction_follows_its_neighbors_again(side):
    surface = after(ResetDirections({A: (7,)}, side))
    assert_array_equal(surface.planes.automatic_vectors[:, 7], SIDES[side])
    assert not surface.planes.given_vectors[:, 7][list(SIDES[side])].any()


def test_one_direction_of_a_plane_is_set_at_a_time():
    surface = after(SetDirection(A, 6, LIFT, "v"))
    assert_array_equal(surface.vectors[1, 6], LIFT)
    assert_array_equal(surface.vectors[0, 6], sheet().vectors[0, 6])
    with pytest.raises(EditError, match="A: the directions by u and by v are set one at a time"):
        SetDirection(A, 6, LIFT).apply(known(sheet()))


def test_a_rotated_plane_is_rigid():
    turn = rotation(AXIS, 0.7)
    old, new = sheet().vectors[:, 7], after(Rotate({A: (7,)}, turn)).vectors[:, 7]
    assert_allclose(new @ new.T, old @ old.T, atol=1e-15)
    assert_allclose(np.cross(*new), turn @ np.cross(*old), atol=1e-15)


def test_a_rotation_is_right_handed_and_keeps_its_axis():
    turn = rotation(AXIS, 0.7)
    assert_allclose(turn @ turn.T, np.eye(3), atol=1e-15)
    assert_allclose(turn @ AXIS, AXIS, atol=1e-15)
    assert_allclose(np.trace(turn), 1.0 + 2.0 * np.cos(0.7))
    quarter = rotation(np.array([0.0, 0.0, 1.0]), np.pi / 2.0)
    assert_array_equal(quarter, [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def test_a_plane_that_is_turned_and_stretched_lands_where_it_is_told():
    landings = (Landing(A, 7, LIFT, "v"), Landing(A, 6, 2.0 * LIFT, "u"))
    surface = after(Rotate({A: (6, 7)}, rotation(AXIS, 0.7), factor=2.0, landings=landings))
    assert_array_equal(surface.vectors[1, 7], LIFT)
    assert_array_equal(surface.vectors[0, 6], 2.0 * LIFT)
    longer = np.linalg.norm(surface.vectors[0, 7]) / np.linalg.norm(sheet().vectors[0, 7])
    assert_allclose(longer, 2.0)


def test_a_landing_of_a_direction_that_is_not_meant_is_left_out():
    turn = Rotate({A: (7,)}, rotation(AXIS, 0.7), "u", landings=(Landing(A, 7, LIFT, "v"),))
    assert_array_equal(after(turn).vectors[1, 7], sheet().vectors[1, 7])


def test_a_plane_curve_rotates_about_z_only():
    flat = Rotate({A: (2,)}, rotation(np.array([0.0, 0.0, 1.0]), np.pi / 2.0)).apply(known())
    assert_array_equal(flat.curve(A).directions[2], [-0.5, 2.0])
    with pytest.raises(EditError, match="A: a plane curve can be turned in the top view only"):
        Rotate({A: (2,)}, rotation(AXIS, 0.1)).apply(known())


def test_a_view_from_above_that_is_so_but_for_rounding_turns_a_plane_curve():
    toward = np.array([np.cos(np.pi / 2.0), 0.0, 1.0])
    assert toward[0] != 0.0
    Rotate({A: (2,)}, rotation(toward, 0.3)).apply(known())


@pytest.mark.parametrize(
    "matrix",
    [
        rotation(AXIS, 1.0),
        -2.0 * np.eye(3),
        np.diag([1.0, 3.0, 0.5]),
        np.eye(3) + 0.3 * np.eye(3, k=1),
    ],
)
def test_a_whole_surface_becomes_its_exact_image(matrix):
    surface = after(Transform({A: ALL}, matrix, LIFT))
    u = np.linspace(0.0, 1.0, 9)
    assert_allclose(surface.at(u, u), sheet().at(u, u) @ matrix.T + LIFT, atol=1e-12)


def test_of_a_part_of_a_surface_given_directions_are_mapped_as_vectors():
    matrix = np.diag([2.0, 2.0, 3.0])
    surface = after(Transform({A: (6, 7)}, matrix, LIFT))
    old = sheet()
    assert_allclose(
        surface.planes.control_points[7], matrix @ old.planes.control_points[7] + LIFT, atol=1e-15
    )
    assert_allclose(surface.vectors[:, 7], old.vectors[:, 7] @ matrix, atol=1e-15)
    assert_array_equal(surface.planes.automatic, old.planes.automatic)
    assert surface.s == old.s


def test_lines_and_planes_move_together():
    both = MovePoints({A: (0,), B: (3,)}, LIFT).apply(known(sheet()))
    assert_allclose(both.surface(A).planes.points[0, 0] - sheet().planes.points[0, 0], LIFT)
    assert_allclose(both.curve(B).lines.points[3], [3.5, -1.25])


def test_a_soft_move_takes_what_is_near_along_and_less_what_is_farther():
    surface = after(SoftMove({A: (7,)}, LIFT, 1.6))
    old = sheet().planes.control_points
    shares = (surface.planes.control_points - old) @ LIFT / (LIFT @ LIFT)
    t = np.linalg.norm(old - old[7], axis=1) / 1.6
    assert shares[7] == pytest.approx(1.0)
    assert_allclose(shares[t >= 1.0], 0.0, atol=1e-15)
    order = np.argsort(t)
    assert (np.diff(shares[order]) <= 1e-12).all()
    assert ((shares > 0.05) & (shares < 0.95)).any()


def test_the_share_of_a_soft_move_begins_and_ends_flat():
    points = np.column_stack([np.linspace(0.0, 1.0, 401), np.zeros(401)])
    lines = ControlLines.of(points)
    curve = spline(basis=type(spline().basis)(401, 4), lines=lines)
    design = SoftMove({A: (0,)}, np.array([0.0, 1.0]), 0.5).apply(known(curve))
    shares = design.curve(A).lines.points[:, 1]
    slopes = np.diff(shares) / np.diff(points[:, 0])
    assert_allclose(slopes[[0, 199, 200, -1]], 0.0, atol=0.05)
    assert np.abs(np.diff(slopes)).max() < 0.2
    assert shares[100] == pytest.approx(0.5)


@pytest.mark.parametrize("many", [1, 7, 300])
def test_the_selection_itself_moves_as_one_however_large_it_is(many):
    random = np.random.default_rng(3)
    curve = spline(
        basis=type(spline().basis)(400, 4), lines=ControlLines.of(random.random((400, 3)))
    )
    rows = tuple(range(many))
    points = SoftMove({A: rows}, LIFT, 0.2).apply(known(curve)).curve(A).lines.points
    old = curve.lines.points
    assert_allclose(points[:many] - old[:many], np.tile(LIFT, (many, 1)), atol=1e-15)
    nearest = np.array([np.linalg.norm(old[:many] - p, axis=1).min() for p in old])
    is_still = (points == old).all(axis=1)
    assert_array_equal(is_still, nearest >= 0.2)


def test_a_soft_move_without_a_radius_moves_the_selection_alone():
    hard, soft = after(MovePoints({A: (7,)}, LIFT)), after(SoftMove({A: (7,)}, LIFT, 0.0))
    assert_allclose(soft.planes.points, hard.planes.points, atol=1e-15)
    with pytest.raises(EditError, match="A: a radius can't be -1"):
        SoftMove({A: (7,)}, LIFT, -1.0).apply(known(sheet()))


def test_a_soft_move_lands_where_it_is_told():
    goal = np.array([0.1, 0.2, 0.3])
    by = goal - sheet().planes.control_points[7]
    surface = after(SoftMove({A: (7,)}, by, 1.0, Landing(A, 7, goal)))
    assert_array_equal(surface.planes.control_points[7], goal)


def test_edits_of_planes_add_up():
    twice = Together("Twice", (Rotate({A: (7,)}, rotation(AXIS, 0.5)),) * 2)
    once = after(Rotate({A: (7,)}, rotation(AXIS, 1.0)))
    assert_allclose(after(twice).vectors, once.vectors, atol=1e-14)
