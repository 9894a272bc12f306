from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.selection import LineId, Selection
from plusedit.interaction.tool import Held
from tests.interaction.space_hand import (
    BOW,
    HELIX,
    PARALLEL,
    SAIL,
    SIZE,
    SPACE,
    VIEWS,
    SpaceHand,
)

every_view = pytest.mark.parametrize("camera", VIEWS, ids=str)
in_space = pytest.mark.parametrize("camera", [SPACE, PARALLEL], ids=str)

steps = st.lists(st.tuples(st.floats(-60.0, 60.0), st.floats(-60.0, 60.0)), min_size=1, max_size=8)


@every_view
def test_a_dragged_point_stays_under_the_pointer_and_as_deep_as_it_was(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(15)
    before = hand.planes[15]
    hand.nudge(before, (10.0, 5.0), (40.0, -25.0))
    after = hand.planes[15]
    seen = camera.to_screen(np.stack([before, after]))
    assert_allclose(seen[1] - seen[0], (40.0, -25.0), atol=1e-6)
    assert_allclose(*camera.depths(np.stack([before, after])), atol=1e-9)
    assert hand.session.undo_label == "Move control plane"


@every_view
def test_one_undo_gives_the_identical_design_back(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(15)
    before = hand.session.design
    hand.nudge(hand.planes[15], *((k, 2 * k) for k in range(1, 30)))
    hand.session.undo()
    assert hand.session.design is before


@in_space
@pytest.mark.parametrize("key", ["X", "Y", "Z"])
def test_a_key_locks_the_axis_and_the_point_follows_along_it(camera, key):
    hand = SpaceHand(camera=camera)
    hand.pick(15)
    start = hand.planes[15]
    axis = "XYZ".index(key)
    goal = start + 0.4 * np.eye(3)[axis]
    hand.hold(start, start + 0.1, moves=3)
    hand.gestures.key(key)
    hand.gestures.move(hand.at(goal))
    assert_allclose(hand.planes[15], goal, atol=1e-9)
    assert (hand.planes[15] - start)[[a for a in range(3) if a != axis]].tolist() == [0.0, 0.0]


@in_space
@pytest.mark.parametrize("key", ["X", "Y", "Z"])
def test_shift_and_a_key_lock_the_plane_across_the_axis(camera, key):
    hand = SpaceHand(camera=camera)
    hand.pick(15)
    start = hand.planes[15]
    axis = "XYZ".index(key)
    goal = start + np.where(np.arange(3) == axis, 0.0, (0.2, -0.3, 0.25))
    hand.hold(start, start + 0.1, moves=3)
    hand.gestures.key(key, Held.SHIFT)
    hand.gestures.move(hand.at(goal))
    assert_allclose(hand.planes[15], goal, atol=1e-9)
    assert hand.planes[15][axis] == start[axis]


def test_all_three_numbers_can_be_typed():
    hand = SpaceHand()
    hand.pick(15)
    start = hand.planes[15].copy()
    hand.hold(start, start + 0.1)
    assert all(hand.type("1", "Tab", "-", "2", "Tab", "0", ".", "5", "Enter"))
    assert_array_equal(hand.planes[15], np.add(start, (1.0, -2.0, 0.5)))


def test_numbers_are_of_the_axes_that_are_free():
    hand = SpaceHand()
    hand.pick(15)
    start = hand.planes[15].copy()
    hand.hold(start, start + 0.1)
    hand.gestures.key("Y", Held.SHIFT)
    hand.type("1", "Tab", "2", "Enter")
    assert_array_equal(hand.planes[15], np.add(start, (1.0, 0.0, 2.0)))


@in_space
def test_ctrl_brings_the_point_to_the_grid_in_all_axes_that_are_free(camera):
    hand = SpaceHand(camera=camera)
    hand.gestures.grid_step = 0.25
    hand.pick(15)
    start = hand.planes[15].copy()
    hand.hold(start, start + 0.6, held=Held.CTRL)
    assert_array_equal(hand.planes[15], np.round(hand.planes[15] * 4.0) / 4.0)
    hand.gestures.key("X", Held.CTRL)
    assert_array_equal(hand.planes[15][1:], start[1:])
    assert hand.planes[15][0] % 0.25 == 0.0


@in_space
def test_shift_keeps_to_the_axis_that_the_pointer_went_along(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(15)
    start = hand.planes[15].copy()
    for axis in range(3):
        goal = start + 0.5 * np.eye(3)[axis]
        hand.hold(start, goal, held=Held.SHIFT)
        assert_allclose(hand.planes[15], goal, atol=1e-9)
        hand.gestures.cancel()


@in_space
def test_a_plane_curve_stays_in_its_plane_under_the_pointer(camera):
    hand = SpaceHand(camera=camera)
    hand.session.select(Selection.of_lines([LineId(BOW, 1)]))
    hand.drag((2.0, -1.0, 0.0), (2.6, -0.7, 0.0))
    assert_allclose(hand.points(BOW)[1], (2.6, -0.7), atol=1e-9)


@in_space
def test_a_dragged_surface_moves_as_a_whole(camera):
    hand = SpaceHand(camera=camera)
    before = hand.planes
    place = hand.on_surface(0.83, 0.83)
    hand.drag(place, place + 0.5 * camera.axes_of_view[0], moves=4)
    shift = hand.planes - before
    assert_allclose(shift, np.broadcast_to(shift[0], shift.shape), atol=1e-9)
    assert np.linalg.norm(shift[0]) > 0.3
    assert hand.session.selection == Selection.of_shapes([SAIL])


@in_space
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_an_arrow_of_the_gizmo_moves_along_it(camera, axis):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    start, way = hand.planes[6].copy(), hand.gizmo.axes[axis]
    if not hand.gizmo.shown(axis):
        pytest.skip("the arrow points to the eye")
    grabbed = hand.on_arrow(axis)
    hand.drag(grabbed, grabbed + 0.2 * way, moves=5)
    off = hand.planes[6] - start
    assert_allclose(np.cross(off, way), 0.0, atol=1e-9)
    assert 0.15 < off @ way < 0.25
    hand.hold(hand.on_arrow(axis), hand.on_arrow(axis) + 0.1 * way)
    hand.type("1", "Enter")
    assert_allclose(hand.planes[6], start + off + way, atol=1e-9)


def test_the_gizmo_of_a_space_curve_has_the_axes_of_the_world():
    hand = SpaceHand()
    hand.session.select(Selection.of_lines([LineId(HELIX, 2)]))
    assert_array_equal(hand.gizmo.axes, np.eye(3))
    start = hand.points(HELIX)[2].copy()
    grabbed = hand.on_arrow(2)
    hand.drag(grabbed, np.add(grabbed, (0.0, 0.0, 0.3)), moves=5)
    assert_array_equal(hand.points(HELIX)[2][:2], start[:2])
    assert 0.25 < hand.points(HELIX)[2][2] - start[2] < 0.35


@settings(max_examples=30, deadline=None)
@given(st.sampled_from(VIEWS), st.sampled_from(["", "X", "Z", "Shift+Z"]), steps)
def test_a_drag_back_to_the_start_changes_nothing(camera, lock, way):
    hand = SpaceHand(camera=camera)
    hand.pick(15)
    before, at = hand.session.design, hand.at(hand.planes[15])
    hand.gestures.press(at)
    hand.gestures.move(replace(at, x=at.x + 9.0))
    if lock:
        hand.gestures.key(lock[-1], Held.SHIFT if "+" in lock else Held.NONE)
    for x, y in way:
        hand.gestures.move(replace(at, x=at.x + x, y=at.y + y))
    hand.gestures.release(at)
    assert hand.session.design is before


@settings(max_examples=40, deadline=None)
@given(
    st.floats(-0.02, 0.02),
    st.sampled_from(["X", "Y", "Z", "Shift+X", "Shift+Y", "Shift+Z"]),
    st.booleans(),
    st.floats(0.0, 6.3),
)
def test_an_axis_or_a_plane_seen_end_on_does_not_jump(tilt, lock, perspective, angle):
    camera = replace(SPACE, yaw=tilt, pitch=tilt, perspective=perspective)
    hand = SpaceHand(camera=camera)
    hand.pick(15)
    at = hand.at(hand.planes[15])
    hand.gestures.press(at)
    hand.gestures.move(replace(at, x=at.x + 4.0))
    hand.gestures.key(lock[-1], Held.SHIFT if "+" in lock else Held.NONE)
    places = []
    for pixels in np.arange(4.0, 200.0, 2.0):
        by = pixels * np.array([np.cos(angle), np.sin(angle)])
        hand.gestures.move(replace(at, x=at.x + by[0], y=at.y + by[1]))
        places.append(hand.planes[15])
    longest = np.linalg.norm(np.diff(places, axis=0), axis=1).max()
    assert longest < 2.0 * 40.0 * camera.pixel


def test_escape_restores_the_very_same_design_and_selection():
    hand = SpaceHand()
    hand.pick(6)
    before, selection = hand.session.design, hand.session.selection
    for grab in (hand.planes[15], hand.on_arrow(0), hand.on_surface(0.83, 0.83)):
        hand.hold(grab, np.add(grab, 0.4), moves=4)
        hand.gestures.key("Z")
        hand.gestures.key("Escape")
        assert hand.session.design is before
        assert hand.session.selection == selection


# Soft moves


@every_view
def test_a_soft_move_takes_neighbors_along_less_the_farther_off_they_are(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(5)
    before = hand.planes
    hand.hold(before[5], before[5] + 0.3)
    hand.gestures.key("O")
    hand.gestures.move(hand.at(before[5] + 0.3))
    shares = np.linalg.norm(hand.planes - before, axis=1) / np.linalg.norm(
        hand.planes[5] - before[5]
    )
    away = np.linalg.norm(before - before[5], axis=1)
    radius = 120.0 * camera.pixel_at(before[[5]])[0]
    assert ((shares > 1e-9) == (away < radius)).all()
    assert (np.diff(shares[np.argsort(away)]) < 1e-9).all()
    hand.gestures.key("O")
    assert (hand.planes != before).any(axis=1).tolist() == [row == 5 for row in range(16)]


def test_the_wheel_and_brackets_change_the_radius_which_is_kept_for_the_next_move():
    hand = SpaceHand()
    hand.pick(5)
    assert not hand.gestures.wheel(1.0)
    hand.hold(hand.planes[5], hand.planes[5] + 0.3)
    assert not hand.gestures.wheel(1.0)
    hand.type("O")
    radii = [_radius(hand)]
    assert hand.gestures.wheel(2.0)
    radii.append(_radius(hand))
    hand.type("[")
    radii.append(_radius(hand))
    assert radii[0] < radii[2] < radii[1]
    hand.type("Enter")
    hand.hold(hand.planes[5], hand.planes[5] + 0.3)
    hand.type("O")
    assert_allclose(_radius(hand), radii[2], rtol=0.1)


def test_the_radius_can_be_typed_after_the_numbers_of_the_move():
    hand = SpaceHand()
    hand.pick(5)
    hand.hold(hand.planes[5], hand.planes[5] + 0.3)
    hand.type("O", "Tab", "Tab", "1", "Tab", "2", ".", "5")
    assert _radius(hand) == 2.5
    assert_allclose(hand.planes[5][2] - SpaceHand().planes[5][2], 1.0)


def test_a_soft_move_shows_how_far_it_reaches():
    hand = SpaceHand(camera=replace(SPACE, size=SIZE))
    hand.pick(5)
    hand.hold(hand.planes[5], hand.planes[5] + 0.3)
    hand.type("O", "Tab", "Tab", "Tab", "2")
    (circle,) = hand.said.items
    assert_allclose(np.linalg.norm(circle.points - hand.planes[5], axis=1), 2.0)


def _radius(hand):
    return float(hand.said.readout.split("radius ")[1])
