import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.interaction.tool import Held
from plusedit.io.svg_reading import read_svg
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.options import ViewOptions
from tests.interaction.hand import BOW, CAMERA, EMPTY, WAVE, Hand, design, wave

PIXEL = CAMERA.pixel
DOT_1 = (1.0, 2.0)
DOT_2 = (2.0, 0.0)


# Selecting


def test_a_click_selects_one_control_line():
    hand = Hand()
    hand.select(0, 3)
    hand.click(DOT_1)
    assert hand.numbers == (1,)
    assert hand.session.selection.active == LineId(WAVE, 1)


def test_a_click_within_ten_pixels_takes_a_dot():
    hand = Hand()
    hand.click((1.0 - 7 * PIXEL, 2.0 + 7 * PIXEL))
    assert hand.numbers == (1,)


def test_shift_click_adds_and_takes_out():
    hand = Hand()
    hand.select(0)
    hand.click(DOT_1, Held.SHIFT)
    assert hand.numbers == (0, 1)
    hand.click(DOT_1, Held.SHIFT)
    assert hand.numbers == (0,)


def test_a_click_on_a_grip_selects_its_line():
    hand = Hand()
    hand.click(hand.tip(2))
    assert hand.numbers == (2,)


def test_a_near_miss_keeps_the_selection():
    hand = Hand()
    hand.select(1)
    hand.click((1.0, 2.0 + 15 * PIXEL))
    assert hand.numbers == (1,)


def test_a_click_far_from_everything_clears_the_selection():
    hand = Hand()
    hand.select(1)
    hand.click(EMPTY)
    assert not hand.session.selection


def test_a_click_on_a_curve_selects_the_shape():
    hand = Hand()
    hand.click(_on_the_curve(hand))
    assert hand.session.selection == Selection.of_shapes([WAVE])


def test_a_double_click_on_a_curve_selects_all_lines_of_the_shape():
    hand = Hand()
    hand.double_click(_on_the_curve(hand))
    assert hand.numbers == (0, 1, 2, 3, 4)


def test_alt_click_cycles_through_what_lies_under_the_pointer():
    crossed = PlusCurve(BSpline(4, 4), ControlLines.of([[1, 2], [1, 1], [1, 0], [1, -1]]), 1.0)
    hand = Hand(design(wave=wave(), pole=crossed))
    seen = set()
    for _ in range(6):
        hand.click(DOT_1, Held.ALT)
        seen.add(hand.session.selection)
    assert Selection.of_lines([LineId(WAVE, 1)]) in seen
    assert Selection.of_lines([LineId("pole", 0)]) in seen
    assert Selection.of_shapes(["pole"]) in seen


def test_handles_that_are_not_shown_are_not_taken():
    hand = Hand()
    hand.gestures.options = ViewOptions(handles="selected")
    hand.click(DOT_1)
    assert not hand.session.selection
    hand.session.select(Selection.of_shapes([WAVE]))
    hand.click(DOT_1)
    assert hand.numbers == (1,)


def test_of_two_dots_in_one_place_the_selected_one_is_taken():
    ends = PlusCurve(BSpline(4, 4), ControlLines.of([[0, 0], [1, 1], [2, 0], [0, 0]]), 1.0)
    hand = Hand(design(wave=ends))
    hand.select(3)
    hand.drag((0.0, 0.0), (-0.5, 0.0))
    assert_array_equal(hand.points()[0], [0.0, 0.0])
    assert_allclose(hand.points()[3], [-0.5, 0.0], atol=1e-12)


# Boxes


def test_a_box_selects_the_control_lines_inside_live():
    hand = Hand()
    hand.hold((0.6, 3.0), (3.4, 1.6), moves=4)
    assert hand.numbers == (1, 3)
    assert hand.said.items
    hand.gestures.release(hand.at((3.4, 1.6)))
    assert hand.numbers == (1, 3)
    assert hand.session.undo_label is None


def test_shift_adds_a_box_and_ctrl_takes_it_out():
    hand = Hand()
    hand.select(0)
    hand.drag((0.6, 3.0), (3.4, 1.6), held=Held.SHIFT)
    assert hand.numbers == (0, 1, 3)
    hand.drag((0.6, 3.0), (1.4, 1.6), held=Held.CTRL)
    assert hand.numbers == (0, 3)


def test_a_box_selects_shapes_that_are_wholly_inside_though_their_handles_are_hidden():
    hand = Hand()
    hand.gestures.options = ViewOptions(handles="none")
    hand.drag((-0.5, -0.8), (4.5, -1.9))
    assert hand.session.selection == Selection.of_shapes([BOW])


def test_a_box_over_a_part_of_a_curve_does_not_take_the_shape():
    hand = Hand()
    hand.gestures.options = ViewOptions(handles="none")
    hand.drag((-0.5, -0.8), (3.5, -1.9))
    assert not hand.session.selection


def test_escape_during_a_box_brings_the_selection_back():
    hand = Hand()
    hand.select(4)
    hand.hold((0.6, 3.0), (3.4, 1.6), moves=4)
    assert hand.gestures.key("Escape")
    assert hand.numbers == (4,)


# Moving


def test_a_drag_moves_a_dot_with_the_pointer_and_selects_its_line():
    hand = Hand()
    hand.drag(DOT_1, (1.5, 2.25), moves=200)
    assert_allclose(hand.points()[1], [1.5, 2.25], atol=1e-12)
    assert hand.numbers == (1,)
    assert hand.session.undo_label == "Move control line"


def test_a_drag_moves_all_selected_lines_of_all_curves():
    hand = Hand()
    hand.select(1, 3, (BOW, 0))
    before = hand.points(), hand.points(BOW)
    hand.drag(DOT_1, (1.5, 2.5))
    by = [0.5, 0.5]
    assert_allclose(hand.points() - before[0], np.outer([0, 1, 0, 1, 0], by), atol=1e-12)
    assert_allclose(hand.points(BOW) - before[1], np.outer([1, 0, 0], by), atol=1e-12)
    assert hand.session.undo_label == "Move 3 control lines"


def test_a_drag_back_and_forth_leaves_no_rounding_behind_and_no_step():
    hand = Hand()
    before = hand.session.design
    places = [(1.0 + x, 2.0 - x * x) for x in np.linspace(0.1, 1.373, 1000)]
    hand.drag(DOT_1, *places, DOT_1)
    assert hand.session.design is before
    assert hand.session.undo_label is None


def test_escape_during_a_drag_restores_the_identical_design():
    hand = Hand()
    before = hand.session.design
    hand.hold(DOT_1, (1.5, 2.25), moves=20)
    assert hand.session.design is not before
    assert hand.gestures.key("Escape", Held.CTRL)
    assert hand.session.design is before


def test_ctrl_brings_the_grabbed_point_to_the_grid_exactly():
    start = design(wave=wave())
    hand = Hand(start)
    hand.gestures.grid_step = 0.1
    hand.drag((1.0, 2.0), (1.234, 1.687), held=Held.CTRL)
    assert_array_equal(hand.points()[1], [1.2, 1.7])


def test_snapping_keeps_the_others_at_their_distance():
    hand = Hand()
    hand.select(1, 2)
    hand.gestures.grid_step = 0.25
    apart = hand.points()[1] - hand.points()[2]
    hand.drag(DOT_1, (1.31, 2.2), held=Held.CTRL)
    assert_allclose(hand.points()[1] - hand.points()[2], apart, atol=1e-12)


def test_where_the_view_snaps_by_itself_ctrl_frees():
    hand = Hand()
    hand.gestures.options = ViewOptions(snap=True)
    hand.drag(DOT_1, (1.4, 2.7))
    assert_array_equal(hand.points()[1], [1.0, 3.0])
    hand.drag((1.0, 3.0), (1.4, 2.7), held=Held.CTRL)
    assert_allclose(hand.points()[1], [1.4, 2.7], atol=1e-12)


def test_shift_keeps_to_the_longer_axis():
    hand = Hand()
    hand.drag(DOT_1, (1.5, 2.3), held=Held.SHIFT)
    assert_allclose(hand.points()[1], [1.5, 2.0], atol=1e-12)
    assert hand.points()[1][1] == 2.0


def test_a_key_locks_the_axis_and_the_same_key_frees_it():
    hand = Hand()
    hand.hold(DOT_1, (1.5, 2.3))
    assert hand.gestures.key("y")
    assert_allclose(hand.points()[1], [1.0, 2.3], atol=1e-12)
    hand.gestures.key("Y")
    assert_allclose(hand.points()[1], [1.5, 2.3], atol=1e-12)


def test_numbers_can_be_typed_during_a_drag():
    hand = Hand()
    hand.hold(DOT_1, (1.5, 2.3))
    assert all(hand.type("1", ".", "5", "Tab", "-", "2", "5", "Backspace"))
    assert_array_equal(hand.points()[1], [2.5, 0.0])
    hand.type("Enter")
    assert_array_equal(hand.points()[1], [2.5, 0.0])
    assert hand.session.undo_label == "Move control line"
    assert not hand.gestures.is_busy


def test_a_number_typed_with_an_axis_locked_is_along_that_axis():
    hand = Hand()
    hand.hold(DOT_1, (1.5, 2.3))
    hand.type("Y", "3", "Enter")
    assert_array_equal(hand.points()[1], [1.0, 5.0])


def test_a_drag_says_how_far_it_goes():
    hand = Hand()
    hand.hold(DOT_1, (2.25, 1.5))
    assert hand.said.readout == "dx 1.25  dy −0.50"


def test_a_drag_on_a_curve_moves_the_whole_shape():
    hand = Hand()
    start = _on_the_curve(hand)
    before, others = hand.points(), hand.points(BOW)
    hand.drag(start, np.add(start, (0.5, 0.25)))
    assert_allclose(hand.points() - before, np.full((5, 2), (0.5, 0.25)), atol=1e-12)
    assert hand.points(BOW) is others


def test_a_drag_on_a_selected_curve_moves_all_selected_shapes():
    hand = Hand()
    hand.session.select(Selection.of_shapes([WAVE, BOW]))
    start = _on_the_curve(hand)
    before = hand.points(BOW)
    hand.drag(start, np.add(start, (0.5, 0.25)))
    assert_allclose(hand.points(BOW) - before, np.full((3, 2), (0.5, 0.25)), atol=1e-12)


# Turning


def test_a_drag_on_a_grip_turns_the_direction_and_keeps_its_length():
    hand = Hand()
    hand.drag(hand.tip(2), (2.0, 0.5), moves=20)
    assert_allclose(hand.directions()[2], [0.0, 2.0], atol=1e-12)
    assert hand.session.undo_label == "Rotate control line"


def test_the_opposite_grip_turns_alike():
    hand = Hand()
    hand.drag(hand.tip(2, -1), (2.0, -0.5), moves=20)
    assert_allclose(hand.directions()[2], [0.0, 2.0], atol=1e-12)


def test_a_grip_turns_all_selected_lines_by_the_same_angle_and_makes_them_given():
    hand = Hand()
    hand.select(1, 2)
    before = _angles(hand.directions())
    hand.drag(hand.tip(2), (2.0, 0.5), moves=20)
    turned = _angles(hand.directions()) - before
    assert_allclose(turned, [0.0, np.pi / 2, np.pi / 2, 0.0, 0.0], atol=1e-12)
    assert_array_equal(hand.curve().lines.automatic, [True, False, False, True, True])


@pytest.mark.parametrize("turns", [1, -1, 3])
def test_the_angle_follows_through_full_turns_without_jumps(turns):
    hand = Hand()
    angles = np.linspace(0.0, turns * 2 * np.pi, abs(turns) * 90 + 1)
    hand.gestures.press(hand.at(hand.tip(2)))
    said = []
    for angle in angles[1:]:
        hand.gestures.move(hand.at((2.0 + 0.8 * np.cos(angle), 0.8 * np.sin(angle))))
        said.append(float(hand.said.readout.split("(")[1].rstrip("°)").replace("−", "-")))
    assert np.abs(np.diff(said)).max() < 5.0
    assert_allclose(said[-1], turns * 360.0, atol=0.1)
    assert_allclose(hand.directions()[2], [2.0, 0.0], atol=1e-12)


def test_a_drag_past_the_control_point_does_not_flip_the_direction():
    hand = Hand()
    hand.drag(hand.tip(2), (1.2, 0.001), moves=97)
    assert_allclose(hand.directions()[2], [2.0, 0.0], atol=0.01)


def test_a_turn_there_and_back_leaves_no_rounding_behind():
    hand = Hand()
    before = hand.session.design
    tip = hand.tip(2)
    hand.drag(tip, (2.3, 0.4), (2.1, 0.6), (2.5, 0.1), tip, moves=50)
    assert hand.session.design is before


def test_ctrl_snaps_the_direction_to_multiples_of_15_degrees():
    hand = Hand()
    hand.select(2, 1)
    hand.hold(hand.tip(2), (2.5, 0.4))
    hand.gestures.hold(Held.CTRL)
    assert_allclose(np.degrees(_angles(hand.directions())[2]), 45.0, atol=1e-9)
    hand.gestures.move(hand.at((2.02, 0.6), Held.CTRL))
    assert_array_equal(hand.directions()[2], [0.0, 2.0])


def test_shift_turns_at_a_tenth_of_the_speed():
    hand = Hand()
    hand.drag(hand.tip(2), (2.0, 0.5), moves=20, held=Held.SHIFT)
    assert_allclose(np.degrees(_angles(hand.directions())[2]), 9.0, atol=1e-9)


def test_pressing_shift_in_the_midst_of_a_turn_does_not_jump():
    hand = Hand()
    hand.hold(hand.tip(2), (2.5, 0.5), moves=10)
    before = hand.directions()[2].copy()
    hand.gestures.hold(Held.SHIFT)
    assert_allclose(hand.directions()[2], before, atol=1e-12)


def test_alt_stretches_so_that_the_tip_follows_the_pointer():
    hand = Hand()
    curve = hand.curve()
    hand.drag(hand.tip(2), (2.0, 0.7), moves=5, held=Held.ALT)
    expected = np.array([0.0, 0.7]) / (curve.spacing * curve.s)
    assert_allclose(hand.directions()[2], expected, atol=1e-12)
    assert_allclose(hand.tip(2), [2.0, 0.7], atol=1e-9)


def test_alt_on_the_opposite_grip_keeps_the_sense_of_the_direction():
    hand = Hand()
    hand.drag(hand.tip(2, -1), (1.4, 0.0), moves=5, held=Held.ALT)
    assert_allclose(hand.tip(2, -1), [1.4, 0.0], atol=1e-9)
    assert hand.directions()[2][0] > 0.0


def test_alt_with_s_zero_gives_a_unit_direction():
    from dataclasses import replace

    hand = Hand(design(wave=replace(wave(), s=0.0)))
    hand.drag(hand.tip(2), (2.0, 0.7), moves=5, held=Held.ALT)
    assert_allclose(hand.directions()[2], [0.0, 1.0], atol=1e-12)


def test_degrees_can_be_typed_during_a_turn():
    hand = Hand()
    hand.hold(hand.tip(2), (2.5, 0.4))
    hand.type("9", "0", "Enter")
    assert_array_equal(hand.directions()[2], [0.0, 2.0])


def test_alt_drag_pulls_a_direction_out_of_a_line_that_has_none():
    lines = ControlLines.of([[0, 0], [1, 1], [2, 0]], [None, [0.0, 0.0], None])
    hand = Hand(design(wave=PlusCurve(BSpline(3, 3), lines, 2.0)))
    hand.drag((1.0, 1.0), (1.5, 1.0), held=Held.ALT)
    assert_allclose(hand.directions()[1], [0.5, 0.0], atol=1e-12)
    assert_array_equal(hand.points()[1], [1.0, 1.0])


def test_a_double_click_on_a_grip_makes_the_direction_automatic_again():
    hand = Hand()
    hand.double_click(hand.tip(2))
    assert hand.curve().lines.automatic.all()
    assert hand.session.undo_label == "Reset control line"


def test_a_space_curve_is_turned_in_the_plane_of_the_view():
    points = [[0.0, 0.0, 0.0], [1.0, 5.0, 1.0], [2.0, 0.0, 0.0]]
    lines = ControlLines.of(points, [None, [1.0, 0.5, 0.0], None])
    camera = PlaneCamera((800.0, 600.0), (1.0, 0.5), 100.0, "front")
    hand = Hand(design(wave=PlusCurve(BSpline(3, 3), lines, 2.0)), camera)
    x, z = hand.tip(1)
    hand.drag((x, 0.0, z), (1.0, 0.0, 1.8), moves=10)
    assert_allclose(hand.directions()[1], [0.0, 0.5, 1.0], atol=1e-12)


# What is shown


def test_hovering_rings_what_a_press_would_take():
    hand = Hand()
    hand.gestures.move(hand.at(DOT_1))
    (ring,) = hand.said.items
    assert_allclose(ring.points, [DOT_1])
    assert (ring.mark, ring.size, ring.outline, hand.said.cursor) == ("ring", 14.0, "hover", "move")
    tip = hand.tip(2)
    hand.gestures.move(hand.at(tip))
    assert_allclose(hand.said.items[0].points[0], tip, atol=1e-9)
    assert hand.said.cursor == "turn"


def test_nothing_is_shown_once_the_pointer_has_left():
    hand = Hand()
    hand.gestures.move(hand.at(DOT_1))
    hand.gestures.leave()
    assert hand.said.items == () and hand.said.hint == ""


def _on_the_curve(hand):
    """A point of the wave, far from all handles."""
    place = hand.curve().at([0.62])[0]
    for side in (1, -1):
        for number in range(5):
            assert np.linalg.norm(hand.tip(number, side) - place) > 11 * PIXEL
    return place


def _angles(vectors):
    return np.arctan2(vectors[:, 1], vectors[:, 0])


def test_a_joint_of_a_drawing_is_dragged_as_one():
    design = read_svg(
        b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">'
        b'<path id="t" stroke="black" d="M0 0 C1 0 2 1 3 -3 L6 0"/></svg>',
        "t.svg",
    ).design
    hand = Hand(design)
    joint = design.curve(ShapeId("t-2")).lines.points[0]
    hand.drag(joint, joint + 1.0)
    first, second = (hand.session.design.curve(ShapeId(f"t-{k}")).lines.points for k in (1, 2))
    assert_array_equal(first[-1], second[0])
    assert (first[-1] != joint).all()
