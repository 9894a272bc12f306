from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape
from plusedit.geometry.arrays import unit
from plusedit.interaction.ball import Ball, from_angles, turn_between
from plusedit.interaction.revolving import EDGE_ON, Revolver, rotation
from plusedit.interaction.tool import Held
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.space_hand import (
    BOW,
    HELIX,
    PARALLEL,
    SAIL,
    SIZE,
    SPACE,
    VIEWS,
    SpaceHand,
    angles_between,
    sail,
)

every_view = pytest.mark.parametrize("camera", VIEWS, ids=str)
in_space = pytest.mark.parametrize("camera", [SPACE, PARALLEL], ids=str)

angles = st.floats(-3.1, 3.1)
tilts = st.floats(-1.5, 1.5)
vectors = st.tuples(*[st.floats(-1.0, 1.0)] * 3).map(np.array)
ways = vectors.filter(lambda v: np.linalg.norm(v) > 0.1).map(unit)
cameras = st.builds(
    lambda yaw, pitch, perspective: replace(SPACE, yaw=yaw, pitch=pitch, perspective=perspective),
    angles,
    tilts,
    st.booleans(),
)


def about(axis, degrees, vectors):
    """The vectors turned about an axis."""
    return vectors @ rotation(axis, np.radians(degrees)).T


# Rings


@in_space
@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("degrees", [40.0, -75.0])
def test_a_ring_turns_the_plane_rigidly_by_the_angle_that_the_pointer_goes_round_it(
    camera, axis, degrees
):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    gizmo, before = hand.gizmo, hand.vectors[:, 6]
    if abs(gizmo.axes[axis] @ gizmo.toward) < EDGE_ON:
        pytest.skip("the ring is seen from its edge")
    start = _free_place(hand, axis)
    places = [
        gizmo.point + about(gizmo.axes[axis], a, start - gizmo.point)
        for a in np.linspace(0.0, degrees, 12)
    ]
    hand.drag(*places)
    # A ring in perspective is seen as it were from infinitely far.
    assert_allclose(hand.vectors[:, 6], about(gizmo.axes[axis], degrees, before), atol=0.05)
    assert_allclose(np.linalg.norm(hand.vectors[:, 6], axis=1), np.linalg.norm(before, axis=1))
    assert_allclose(angles_between(*hand.vectors[:, 6]), angles_between(*before), atol=1e-6)
    assert hand.session.undo_label == "Rotate control plane"


@in_space
def test_degrees_can_be_typed_and_are_about_the_axis_of_the_ring(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    axis, before = hand.gizmo.axes[2], hand.vectors[:, 6]
    hand.hold(_free_place(hand, 2), _free_place(hand, 2) + 0.1)
    hand.type("3", "0", "Enter")
    assert_allclose(hand.vectors[:, 6], about(axis, 30.0, before), atol=1e-12)


def test_ctrl_turns_a_ring_by_multiples_of_15_degrees_and_shift_slowly():
    hand = SpaceHand()
    hand.pick(6)
    axis, before = hand.gizmo.axes[0], hand.vectors[:, 6].copy()
    place = _free_place(hand, 0)
    goal = hand.gizmo.point + about(axis, 33.0, place - hand.gizmo.point)
    hand.hold(place, goal, held=Held.CTRL, moves=6)
    assert_allclose(hand.vectors[:, 6], about(axis, 30.0, before), atol=1e-12)
    hand.gestures.cancel()
    hand.hold(place, goal, held=Held.SHIFT, moves=6)
    assert_allclose(hand.vectors[:, 6], about(axis, 3.3, before), atol=0.02)


def test_several_planes_turn_alike_each_about_its_own_point():
    hand = SpaceHand()
    hand.pick(5, 10, 6)
    axis, points, before = hand.gizmo.axes[2], hand.planes, hand.vectors
    hand.hold(_free_place(hand, 2), _free_place(hand, 2) + 0.1)
    hand.type("6", "0", "Enter")
    assert hand.planes is points or (hand.planes == points).all()
    turned = [5, 6, 10]
    assert_allclose(hand.vectors[:, turned], about(axis, 60.0, before[:, turned]), atol=1e-12)
    others = [row for row in range(16) if row not in turned]
    assert_array_equal(hand.vectors[:, others], before[:, others])


def test_a_ring_shows_the_sector_it_has_turned_through():
    hand = SpaceHand()
    hand.pick(6)
    hand.hold(_free_place(hand, 2), _free_place(hand, 2) + 0.1)
    hand.type("9", "0")
    (sector,) = hand.said.items
    assert_allclose(sector.points[0], hand.planes[6])
    first, last = sector.points[1] - sector.points[0], sector.points[-1] - sector.points[0]
    assert_allclose(angles_between(first, last), 90.0)
    assert hand.said.readout == "normal +90.0°"


@settings(max_examples=60, deadline=None)
@given(cameras, ways, st.floats(0.0, 6.3), st.floats(0.0, 6.3), st.floats(0.2, 1.0))
def test_small_steps_of_the_pointer_turn_a_ring_by_little_however_it_is_seen(
    camera, axis, begin, course, radius
):
    point = np.array([1.0, 2.0, 0.0])
    center = camera.to_screen(point[None])[0]
    start = center + 64.0 * radius * np.array([np.cos(begin), np.sin(begin)])
    way = np.array([np.cos(course), np.sin(course)])
    revolver = Revolver(camera, point, axis, start)
    said = [revolver.to(start + step * way) for step in np.arange(0.0, 200.0)]
    assert np.degrees(np.abs(np.diff(said))).max() < 45.0


@given(cameras, ways)
def test_a_ring_follows_once_round_by_a_full_turn(camera, axis):
    point = np.zeros(3)
    toward = -camera.ray(camera.to_screen(point[None])[0])[1]
    center, pixel = camera.to_screen(point[None])[0], camera.pixel_at(point[None])[0]
    first = unit(np.cross(axis, toward + 0.01))
    places = [point + 64.0 * pixel * about(axis, a, first) for a in np.arange(0.0, 361.0, 4.0)]
    seen = camera.to_screen(np.array(places))
    if np.hypot(*(seen - center).T).min() < 30.0:
        return
    revolver = Revolver(camera, point, axis, seen[0])
    assert np.degrees([revolver.to(at) for at in seen][-1]) == pytest.approx(360.0, abs=1e-6)


# Grips


@in_space
@pytest.mark.parametrize("side", [1, 2])
def test_a_grip_follows_the_pointer_and_turns_its_direction_alone(camera, side):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    before, length = hand.vectors[:, 6], np.linalg.norm(hand.vectors[side - 1, 6])
    start = hand.grip(6, side)
    hand.nudge(start, (2.0, -3.0), (5.0, -9.0))
    after = hand.vectors[:, 6]
    assert_array_equal(after[2 - side], before[2 - side])
    assert_allclose(np.linalg.norm(after[side - 1]), length)
    seen = camera.to_screen(np.stack([start, hand.grip(6, side)]))
    assert_allclose(seen[1] - seen[0], (5.0, -9.0), atol=2.5)
    given = ~hand.surface.planes.automatic_vectors[:, 6]
    assert given[side - 1]


@every_view
def test_a_grip_drawn_back_to_its_start_changes_nothing(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    before = hand.session.design
    hand.nudge(hand.grip(6), (9.0, 9.0), (4.0, 13.0), (12.0, -8.0), (0.0, 0.0))
    assert hand.session.design is before


@given(cameras, ways, vectors, st.floats(0.0, 6.3))
def test_a_grip_moves_over_its_ball_by_little_for_little_steps_and_keeps_to_its_half(
    camera, arm, center, course
):
    pixel = camera.pixel_at(center[None])[0]
    ball = Ball(camera, center, center + 40.0 * pixel * arm)
    way = np.array([np.cos(course), np.sin(course)])
    said = np.array([ball.to(step * way) for step in np.arange(0.25, 150.0)])
    assert_allclose(np.linalg.norm(said, axis=1), 1.0)
    assert angles_between(said[:-1], said[1:]).max() < 6.0
    assert angles_between(said[0], arm) < 2.0
    half = np.sign(arm @ ball.toward)
    assert (half * (said @ ball.toward) > -1e-9).all()


@in_space
def test_ctrl_points_a_grip_to_round_angles_of_the_world(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    hand.hold(hand.grip(6, 2), hand.grip(6, 2) + 0.1, held=Held.CTRL)
    x, y, z = hand.vectors[1, 6]
    found = np.degrees([np.arctan2(y, x), np.arctan2(z, np.hypot(x, y))]) / 15.0
    assert_allclose(found, np.round(found), atol=1e-9)


@in_space
def test_alt_stretches_a_direction_along_itself(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    before = hand.vectors[0, 6].copy()
    arm = hand.grip(6) - hand.planes[6]
    hand.gestures.press(hand.at(hand.grip(6)))
    for share in (1.2, 1.5):
        hand.gestures.move(hand.at(hand.planes[6] + share * arm, Held.ALT))
    assert_allclose(hand.vectors[0, 6], 1.5 * before, rtol=1e-6)
    assert hand.said.readout == "length 1.50×"


@in_space
def test_degrees_typed_to_a_grip_turn_it_as_seen_and_a_key_about_an_axis(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    before = hand.vectors[0, 6].copy()
    hand.hold(hand.grip(6), hand.grip(6) + 0.1)
    hand.type("Z", "9", "0")
    assert_allclose(hand.vectors[0, 6], about(np.array([0.0, 0.0, 1.0]), 90.0, before))
    hand.type("Z", "Enter")
    seen = camera.to_screen(hand.planes[[6]]) - camera.to_screen(hand.grip(6)[None])
    assert np.isfinite(seen).all()
    assert_allclose(np.linalg.norm(hand.vectors[0, 6]), np.linalg.norm(before))


@every_view
@pytest.mark.parametrize("side", [1, 2])
def test_a_double_click_on_a_grip_makes_that_direction_automatic_again(camera, side):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    hand.double_click(hand.grip(6, side))
    assert hand.surface.planes.automatic_vectors[:, 6].tolist() == [side == 1, side == 2]


@pytest.mark.parametrize("camera", VIEWS[:3], ids=str)
def test_in_a_view_of_a_plane_a_grip_turns_in_that_plane(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    plane, before = list(camera.axes), hand.vectors[:, 6].copy()
    hand.hold(hand.grip(6), hand.grip(6) + 0.3)
    hand.type("9", "0", "Enter")
    after = hand.vectors[:, 6]
    (across,) = {0, 1, 2} - set(plane)
    assert_allclose(after[0, plane], [-before[0, plane[1]], before[0, plane[0]]])
    assert after[0, across] == before[0, across]
    assert_array_equal(after[1], before[1])


@pytest.mark.parametrize("side", [1, -1])
def test_the_direction_of_a_space_curve_follows_the_pointer_too(side):
    hand = SpaceHand()
    hand.session.select(Selection.of_lines([LineId(HELIX, 1)]))
    start, before = hand.tip_in_space(HELIX, 1, side), hand.directions(HELIX)[1].copy()
    dot, tip = SPACE.to_screen(np.stack([hand.points(HELIX)[1], start]))
    by = 0.2 * (dot - tip)
    hand.nudge(start, by / 2.0, by)
    after = hand.directions(HELIX)[1]
    assert_allclose(np.linalg.norm(after), np.linalg.norm(before))
    assert_allclose(SPACE.to_screen(hand.tip_in_space(HELIX, 1, side)[None])[0] - tip, by, atol=4.0)


def test_a_direction_of_a_plane_curve_turns_in_its_plane():
    hand = SpaceHand()
    hand.session.select(Selection.of_lines([LineId(BOW, 1)]))
    hand.hold(hand.tip_in_space(BOW, 1, 1), hand.tip_in_space(BOW, 1, 1) + 0.1)
    hand.type("9", "0", "Enter")
    assert_allclose(hand.directions(BOW)[1], [0.0, 1.0], atol=1e-12)


def test_alt_pulls_a_direction_out_of_a_plane_that_lacks_one():
    surface = sail()
    given = surface.planes.given.copy()
    given[1, 1, 2] = 0.0
    flat = surface.with_net(surface.planes.with_vectors(given, surface.planes.automatic))
    hand = SpaceHand(Design({SAIL: Shape(flat, "Sail")}))
    assert not hand.vectors[1, 6].any()
    at = hand.at(hand.planes[6], Held.ALT)
    hand.gestures.press(at)
    hand.gestures.move(replace(at, x=at.x + 50.0))
    hand.gestures.release(replace(at, x=at.x + 50.0))
    assert_allclose(unit(hand.vectors[1, 6]), SPACE.right, atol=0.1)


# Turning by a key


@every_view
def test_a_plane_turned_by_a_key_turns_rigidly_as_seen(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    before = hand.vectors[:, 6]
    hand.gestures.begin("turn", hand.at(hand.planes[6] + 0.5))
    hand.type("3", "0", "Enter")
    assert_allclose(angles_between(*hand.vectors[:, 6]), angles_between(*before), atol=1e-6)
    _, sight = camera.ray(camera.to_screen(hand.planes[[6]])[0])
    assert_allclose(hand.vectors[:, 6], about(-sight, 30.0, before), atol=1e-9)


@in_space
@pytest.mark.parametrize("key", ["X", "Y", "Z"])
def test_x_y_and_z_turn_several_planes_about_their_middle(camera, key):
    hand = SpaceHand(camera=camera)
    hand.pick(5, 6, 10)
    rows, axis = [5, 6, 10], np.eye(3)["XYZ".index(key)]
    before, middle = hand.planes, hand.planes[[5, 6, 10]].mean(axis=0)
    hand.gestures.begin("turn", hand.at(middle + 0.5))
    hand.type(key, "9", "0", "Enter")
    assert_allclose(hand.planes[rows] - middle, about(axis, 90.0, before[rows] - middle), atol=1e-9)


@every_view
def test_scaling_across_an_axis_leaves_that_one(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(5, 6, 10)
    rows, before = [5, 6, 10], hand.planes
    hand.gestures.begin("scale", hand.at(before[6]))
    hand.gestures.key("Z", Held.SHIFT)
    hand.type("2", "Enter")
    middle = before[rows].mean(axis=0)
    assert_allclose(hand.planes[rows] - middle, (before[rows] - middle) * (2.0, 2.0, 1.0))


@in_space
def test_escape_and_undo_give_the_very_same_design_back(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    before, selection = hand.session.design, hand.session.selection
    for grab in (_free_place(hand, 2), hand.grip(6), hand.grip(6, 2)):
        hand.hold(grab, grab + 0.2, moves=5)
        assert hand.session.design is not before
        hand.gestures.key("Escape")
        assert hand.session.design is before and hand.session.selection == selection
        hand.drag(grab, grab + 0.2, moves=5)
        hand.session.undo()
        assert hand.session.design is before


@given(ways, ways)
def test_the_smallest_turn_between_two_directions_is_a_rotation(before, after):
    matrix = turn_between(before, after)
    assert_allclose(matrix @ matrix.T, np.eye(3), atol=1e-9)
    assert_allclose(matrix @ before, after, atol=1e-9)
    assert_allclose(np.linalg.det(matrix), 1.0)


def test_round_angles_are_exact_directions():
    assert_array_equal(from_angles(np.pi / 2, 0.0), [0.0, 1.0, 0.0])
    assert_array_equal(from_angles(0.0, -np.pi / 2), [0.0, 0.0, -1.0])


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_quarter_turn_about_an_axis_of_the_world_is_exact(axis):
    matrix = rotation(np.eye(3)[axis], np.pi / 2)
    assert set(np.abs(matrix).ravel().tolist()) == {0.0, 1.0}


def test_an_edge_on_ring_turns_by_the_angle_on_the_screen():
    camera = SpaceCamera(SIZE, yaw=0.0, pitch=0.0)
    start = camera.to_screen(np.zeros((1, 3)))[0] + (64.0, 0.0)
    for axis, sign in ((np.array([0.0, 0.1, 1.0]), -1.0), (np.array([0.0, -0.1, 1.0]), 1.0)):
        revolver = Revolver(camera, np.zeros(3), unit(axis), start)
        turned = revolver.to(np.add(start, (-64.0, -64.0)))
        assert turned == pytest.approx(sign * np.pi / 2)


def _free_place(hand, axis):
    """A place on a ring of the gizmo that nothing else is near to."""
    from plusedit.interaction.picking import under

    for degrees in range(17, 377, 20):
        place = hand.on_ring(axis, degrees)
        hit = under(hand.at(place).at, hand.gestures.stage())
        if hit is not None and (hit.kind, hit.axis) == ("ring", axis) and hit.depth == 0.0:
            return place
    raise AssertionError("the ring can't be taken anywhere")
