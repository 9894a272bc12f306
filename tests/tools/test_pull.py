import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.commands.constraints import Constrain
from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.constraints import Wish
from plusedit.geometry.keeping import holds
from plusedit.geometry.making.primitives import sheet
from plusedit.geometry.nearest import nearest_parameter
from plusedit.interaction.tool import Held, Pointer
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.hand import EMPTY, WAVE, Hand

NEAR = 1e-3  # what is taken hold of is the nearest point of the curve as it is drawn


def test_the_curve_follows_the_pointer():
    hand = Hand(tool="pull")
    place = hand.curve().at([0.4])[0]
    hand.drag(place, np.add(place, (0.3, 0.5)), moves=8)
    assert_allclose(hand.curve().at([0.4])[0], np.add(place, (0.3, 0.5)), atol=NEAR)
    assert hand.session.undo_label == "Pull curve"


def test_a_pull_is_one_step_that_undo_takes_back():
    hand = Hand(tool="pull")
    before = hand.session.design
    place = hand.curve().at([0.6])[0]
    hand.drag(place, place + 0.5, moves=8)
    hand.session.undo()
    assert hand.session.design is before


def test_escape_restores_the_very_same_design():
    hand = Hand(tool="pull")
    before = hand.session.design
    place = hand.curve().at([0.6])[0]
    hand.hold(place, place + 0.5, moves=4)
    assert hand.session.design is not before
    hand.gestures.key("Escape")
    assert hand.session.design is before


@pytest.mark.parametrize("presses, moves_points, turns", [(0, True, False), (1, False, True)])
def test_w_chooses_what_changes(presses, moves_points, turns):
    hand = Hand(tool="pull")
    before = hand.curve()
    place = before.at([0.4])[0]
    hand.gestures.move(hand.at(place))
    for _ in range(presses):
        hand.gestures.key("W")
    hand.drag(place, np.add(place, (0.0, 0.4)), moves=4)
    after = hand.curve()
    assert (after.lines.points != before.lines.points).any() == moves_points
    assert (after.lines.automatic != before.lines.automatic).any() == turns
    assert_allclose(after.at([0.4])[0], np.add(place, (0.0, 0.4)), atol=NEAR)


def test_what_changes_is_remembered_by_the_tool_of_every_view():
    first, second = Hand(tool="pull"), Hand(tool="pull")
    first.gestures.key("W")
    first.gestures.choose("select")
    for hand in (first, second):
        hand.gestures.choose("pull")
        place = hand.curve().at([0.4])[0]
        hand.drag(place, np.add(place, (0.0, 0.4)), moves=4)
        assert not hand.curve().lines.automatic.all()


def test_what_changes_is_read_beside_the_pointer():
    hand = Hand(tool="pull")
    read = []
    hand.gestures.feedback.listen(lambda feedback: read.append(feedback.readout))
    hand.gestures.move(hand.at(hand.curve().at([0.4])[0]))
    for _ in range(3):
        hand.gestures.key("W")
    words = [text for text in read if text]
    assert words[0] == words[-1]
    assert len(set(words)) == 3
    hand.gestures.move(hand.at(EMPTY))
    assert read[-1] == ""


def test_with_alt_only_lines_turn():
    hand = Hand(tool="pull")
    before = hand.curve()
    place = before.at([0.4])[0]
    hand.drag(place, np.add(place, (0.0, 0.4)), held=Held.ALT, moves=4)
    assert (hand.curve().lines.points == before.lines.points).all()


def test_with_control_the_point_lands_on_the_grid():
    hand = Hand(tool="pull")
    place = hand.curve().at([0.4])[0]
    hand.drag(place, np.add(place, (0.31, 0.52)), held=Held.CTRL, moves=4)
    goal = np.round(np.add(place, (0.31, 0.52)) / hand.gestures.grid_step)
    goal *= hand.gestures.grid_step
    u = nearest_parameter(hand.curve(), goal)
    assert_allclose(hand.curve().at([u])[0], goal, atol=1e-9)


def test_a_drag_on_empty_ground_does_nothing():
    hand = Hand(tool="pull")
    before = hand.session.design
    hand.drag(EMPTY, (0.0, 3.9))
    assert hand.session.design is before


def test_an_end_that_lines_have_no_hold_on_is_told_in_a_sentence():
    hand = Hand(tool="pull")
    before = hand.session.design
    hand.drag(hand.curve().at([0.0])[0], (-0.5, 0.5), held=Held.ALT, moves=3)
    assert hand.session.design is before
    assert "pull points" in hand.errors[-1]


def test_a_surface_is_pulled_in_space():
    sail = ShapeId("sail")
    camera = SpaceCamera((800.0, 600.0), (0.0, 0.0, 0.0), 6.0)
    hand = Hand(Design({sail: Shape(sheet(), "Sail")}), camera, "pull")
    before = hand.session.design.surface(sail)
    start = camera.to_screen(before.derivatives_at([[0.4, 0.6]], highest=0)[0])[0]
    hand.gestures.press(Pointer(*start))
    hand.gestures.move(Pointer(*np.add(start, (10.0, -20.0))))
    hand.gestures.move(Pointer(*np.add(start, (20.0, -40.0))))
    hand.gestures.release(Pointer(*np.add(start, (20.0, -40.0))))
    assert hand.session.undo_label == "Pull surface"
    assert hand.session.design.surface(sail) is not before


def test_the_wave_is_the_shape_that_is_selected_by_a_pull():
    hand = Hand(tool="pull")
    hand.click(hand.curve().at([0.4])[0])
    assert hand.session.selection.shapes == {WAVE}


def test_a_curve_that_keeps_something_follows_the_pointer_all_the_same():
    hand = Hand(tool="pull")
    hand.session.commit(Constrain({WAVE: Wish("passing", (1, 3))}))
    hand.session.commit(Constrain({WAVE: Wish("tangent_start")}))
    place = hand.curve().at([0.45])[0]
    hand.drag(place, np.add(place, (0.2, 0.4)), moves=6)
    assert_allclose(hand.curve().at([0.45])[0], np.add(place, (0.2, 0.4)), atol=NEAR)
    assert all(holds(hand.curve(), wish) for wish in hand.session.design[WAVE].constraints)
