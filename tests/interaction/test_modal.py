import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.selection import Selection
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.interaction.tool import Held, Pointer
from plusedit.scene.camera import PlaneCamera
from tests.interaction.hand import BOW, WAVE, Hand, design

FAR = (3.0, 1.0)


def holding(drag, *lines, start=FAR):
    hand = Hand()
    hand.select(*lines)
    hand.gestures.begin(drag, hand.at(start))
    return hand


def middle(hand, *numbers):
    return hand.points()[list(numbers)].mean(axis=0)


@pytest.mark.parametrize("drag", ["move", "turn", "scale"])
def test_with_nothing_selected_it_says_so(drag):
    hand = Hand()
    hand.gestures.begin(drag, hand.at(FAR))
    assert hand.errors == ["Nothing is selected."]
    assert not hand.gestures.is_busy


@pytest.mark.parametrize("drag", ["move", "turn", "scale"])
def test_begun_and_accepted_in_place_it_is_no_step(drag):
    hand = holding(drag, 1, 3)
    before = hand.session.committed
    hand.gestures.key("Enter")
    assert hand.session.design is before
    assert hand.session.undo_label is None


@pytest.mark.parametrize("drag", ["move", "turn", "scale"])
def test_it_follows_the_pointer_without_a_button_and_a_press_accepts(drag):
    hand = holding(drag, 1, 3)
    hand.gestures.move(hand.at((3.5, 2.5)))
    hand.gestures.press(hand.at((3.5, 2.5)))
    shown = hand.session.design
    hand.gestures.release(hand.at((3.5, 2.5)))
    assert not hand.gestures.is_busy and not hand.session.is_previewing
    assert hand.session.design is shown
    hand.session.undo()
    assert hand.session.undo_label is None


@pytest.mark.parametrize("drag", ["move", "turn", "scale"])
def test_escape_restores_the_identical_design(drag):
    hand = holding(drag, 1, 3)
    before = hand.session.committed
    hand.gestures.move(hand.at((3.5, 2.5)))
    hand.gestures.key("Escape")
    assert hand.session.design is before


def test_moving_takes_typed_numbers_along_a_locked_axis():
    hand = holding("move", 1, 3)
    assert all(hand.type("X", "2", "Enter"))
    assert_array_equal(hand.points()[[1, 3]], [[3.0, 2.0], [5.0, 2.0]])


def test_turning_several_lines_turns_points_and_directions_about_the_middle():
    hand = holding("turn", 1, 2)
    center = middle(hand, 1, 2)
    arms = hand.points()[[1, 2]] - center
    hand.type("9", "0", "Enter")
    assert_allclose(hand.points()[[1, 2]] - center, arms @ [[0.0, 1.0], [-1.0, 0.0]])
    assert_allclose(hand.directions()[2], [0.0, 2.0])
    assert hand.session.undo_label == "Rotate 2 control lines"


def test_turning_one_line_turns_its_direction_only():
    hand = holding("turn", 2)
    before = hand.points()
    hand.type("9", "0", "Enter")
    assert_array_equal(hand.points(), before)
    assert_array_equal(hand.directions()[2], [0.0, 2.0])


def test_turning_snaps_to_15_degrees_with_ctrl():
    hand = holding("turn", 1, 3, start=(3.0, 2.0))
    hand.gestures.move(hand.at((3.0, 2.9), Held.CTRL))
    assert hand.said.readout == "angle 45.0°"


def test_a_whole_curve_scaled_by_a_number_is_its_image():
    hand = Hand()
    hand.session.select(Selection.of_shapes([WAVE]))
    u = np.linspace(0.0, 1.0, 17)
    before, center = hand.curve().at(u), hand.points().mean(axis=0)
    hand.gestures.begin("scale", hand.at(FAR))
    hand.type("-", ".", "5", "Enter")
    assert_allclose(hand.curve().at(u), center - 0.5 * (before - center), atol=1e-12)


def test_scaling_along_an_axis_leaves_the_other():
    hand = holding("scale", 0, 1, 2, 3, 4)
    before = hand.points()
    hand.type("Y", "3", "Enter")
    assert_array_equal(hand.points()[:, 0], before[:, 0])
    assert_allclose(np.ptp(hand.points()[:, 1]), 6.0)


def test_scaling_follows_the_distance_of_the_pointer_from_the_middle():
    hand = holding("scale", 1, 3, start=(3.0, 2.0))
    hand.gestures.move(hand.at((4.0, 2.0)))
    assert_allclose(hand.points()[[1, 3], 0], [0.0, 4.0], atol=1e-12)
    assert hand.said.readout == "scale 2.000×"
    hand.gestures.move(hand.at((3.52, 2.0), Held.CTRL))
    assert hand.said.readout == "scale 1.500×"


def test_scaling_by_zero_is_shown_and_can_be_gone_on_from():
    hand = holding("scale", 0, 1, 2, 3, 4)
    hand.type("0")
    assert_allclose(np.ptp(hand.points(), axis=0), 0.0, atol=1e-12)
    hand.type(".", "5", "Enter")
    assert_allclose(np.ptp(hand.points()[:, 0]), 2.0)


def test_shapes_of_several_curves_turn_about_one_middle():
    hand = Hand()
    hand.session.select(Selection.of_shapes([WAVE, BOW]))
    every = np.concatenate([hand.points(), hand.points(BOW)])
    center = every.mean(axis=0)
    hand.gestures.begin("turn", hand.at(FAR))
    hand.type("1", "8", "0", "Enter")
    now = np.concatenate([hand.points(), hand.points(BOW)])
    assert_allclose(now, 2.0 * center - every, atol=1e-12)


def test_a_plane_curve_can_not_be_turned_in_a_side_view_and_says_so():
    hand = Hand(camera=PlaneCamera((800.0, 600.0), (2.0, 0.0), 100.0, "front"))
    before = hand.session.design
    hand.session.select(Selection.of_shapes([WAVE]))
    hand.gestures.begin("turn", Pointer(500.0, 300.0))
    hand.gestures.move(Pointer(400.0, 100.0))
    assert "top view" in hand.errors[-1]
    hand.gestures.key("Enter")
    assert hand.session.design is before


def test_space_curves_turn_in_the_plane_of_the_view():
    points = [[0.0, 0.0, 0.0], [1.0, 5.0, 1.0], [2.0, 1.0, 0.0]]
    start = design(wave=PlusCurve(BSpline(3, 3), ControlLines.of(points), 2.0))
    hand = Hand(start, PlaneCamera((800.0, 600.0), (1.0, 0.0), 100.0, "front"))
    hand.session.select(Selection.of_shapes([WAVE]))
    hand.gestures.begin("turn", Pointer(500.0, 300.0))
    hand.type("9", "0", "Enter")
    assert_array_equal(hand.points()[:, 1], [0.0, 5.0, 1.0])
    arms = np.array(points)[:, [0, 2]] - np.mean(points, axis=0)[[0, 2]]
    turned = hand.points()[:, [0, 2]] - hand.points()[:, [0, 2]].mean(axis=0)
    assert_allclose(turned, arms @ [[0.0, 1.0], [-1.0, 0.0]], atol=1e-12)
