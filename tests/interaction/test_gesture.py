import numpy as np
import pytest
from numpy.testing import assert_array_equal

from plusedit.commands.lines import MovePoints
from plusedit.document.selection import LineId, Selection
from plusedit.interaction.tool import Held, Pointer
from tests.interaction.hand import BOW, WAVE, Hand

DOT_1 = (1.0, 2.0)
AWAY = (1.5, 2.5)


def test_a_press_and_release_within_three_pixels_is_a_click():
    hand = Hand()
    before = hand.session.design
    at = hand.at(DOT_1)
    hand.gestures.press(at)
    hand.gestures.move(Pointer(at.x + 2.0, at.y - 2.0))
    hand.gestures.release(Pointer(at.x + 2.0, at.y - 2.0))
    assert hand.session.design is before
    assert hand.numbers == (1,)


def test_a_drag_of_200_moves_is_one_step():
    hand = Hand()
    before = hand.session.design
    hand.drag(DOT_1, AWAY, moves=200)
    hand.session.undo()
    assert hand.session.design is before
    assert hand.session.undo_label is None


def test_while_it_lasts_a_drag_is_a_preview():
    hand = Hand()
    before = hand.session.committed
    hand.hold(DOT_1, AWAY)
    assert hand.session.is_previewing and hand.gestures.is_busy
    assert hand.session.committed is before
    assert hand.session.undo_label is None


def test_a_drag_may_leave_the_view():
    hand = Hand()
    hand.hold(DOT_1, AWAY)
    hand.gestures.leave()
    assert hand.gestures.is_busy
    hand.gestures.move(hand.at((40.0, 40.0)))
    hand.gestures.release(hand.at((40.0, 40.0)))
    np.testing.assert_allclose(hand.points()[1], [40.0, 40.0])


def test_other_modifiers_count_at_once():
    hand = Hand()
    hand.hold(DOT_1, (1.5, 2.2))
    hand.gestures.hold(Held.SHIFT)
    assert hand.points()[1][1] == 2.0
    hand.gestures.hold(Held.NONE)
    assert hand.points()[1][1] != 2.0


def test_undo_in_the_midst_of_a_drag_ends_it():
    hand = Hand()
    hand.drag(DOT_1, AWAY)
    first = hand.session.committed
    hand.hold(AWAY, (1.0, 1.0))
    hand.session.undo()
    before = hand.session.design
    hand.gestures.move(hand.at((0.0, 3.0)))
    hand.gestures.release(hand.at((0.0, 3.0)))
    assert hand.session.design is before is not first


def test_an_error_is_told_and_nothing_changes():
    hand = Hand()
    before = hand.session.design
    hand.gestures.perform(MovePoints({WAVE: (77,)}, np.ones(2)))
    assert hand.errors == ["Wave has no control line 78"]
    assert hand.session.design is before


def test_performing_gives_up_a_drag_first():
    hand = Hand()
    hand.hold(DOT_1, AWAY)
    hand.gestures.perform(MovePoints({WAVE: (0,)}, np.ones(2)))
    assert_array_equal(hand.points()[:2], [[1.0, 1.0], [1.0, 2.0]])
    assert not hand.gestures.is_busy


def test_a_selection_can_be_performed():
    hand = Hand()
    hand.gestures.perform(Selection.of_shapes([BOW]))
    assert hand.session.selection.shapes == {BOW}
    hand.gestures.perform(None)
    assert hand.session.selection.shapes == {BOW}


def test_a_drag_that_is_given_up_gives_the_selection_back():
    hand = Hand()
    hand.select(4)
    hand.hold(DOT_1, AWAY)
    assert hand.numbers == (1,)
    assert hand.gestures.cancel()
    assert hand.session.selection == Selection.of_lines([LineId(WAVE, 4)])
    assert not hand.gestures.cancel()


def test_choosing_a_tool_gives_up_what_is_under_way_and_tells():
    hand = Hand()
    told = []
    hand.gestures.tool_changed.listen(told.append)
    before = hand.session.design
    hand.hold(DOT_1, AWAY)
    hand.gestures.choose("pen")
    assert hand.session.design is before
    assert told == ["pen"] and hand.gestures.tool_name == "pen"


def test_there_is_no_tool_of_an_unknown_name():
    hand = Hand()
    with pytest.raises(KeyError, match="there are"):
        hand.gestures.choose("hammer")


@pytest.mark.parametrize("held", [Held.NONE, Held.CTRL, Held.ALT, Held.SHIFT])
def test_escape_is_taken_during_a_drag_whatever_is_held(held):
    hand = Hand()
    before = hand.session.design
    hand.hold(DOT_1, AWAY)
    assert hand.gestures.takes("Escape", held)
    assert hand.gestures.key("Escape", held)
    assert hand.session.design is before


def test_keys_are_left_to_shortcuts_where_nothing_is_under_way():
    hand = Hand()
    for key in (*"XYZ123-.", "Tab", "Backspace", "Enter", "Escape"):
        assert not hand.gestures.takes(key)
        assert not hand.gestures.key(key)


def test_undo_is_never_taken_for_an_axis():
    hand = Hand()
    hand.hold(DOT_1, AWAY)
    assert not hand.gestures.takes("Z", Held.CTRL)
    assert hand.gestures.takes("z")


def test_return_is_enter():
    hand = Hand()
    hand.hold(DOT_1, AWAY)
    assert hand.gestures.key("Return")
    assert hand.session.undo_label == "Move control line"


def test_a_press_of_another_button_during_a_drag_changes_nothing():
    hand = Hand()
    hand.hold(DOT_1, AWAY)
    shown = hand.session.design
    hand.gestures.press(hand.at((0.0, 0.0)))
    assert hand.session.design is shown and hand.gestures.is_busy


def test_what_the_pointer_is_over_is_told_again_when_the_design_changes():
    hand = Hand()
    hand.gestures.move(hand.at(DOT_1))
    assert hand.said.cursor == "move"
    hand.session.commit(MovePoints({WAVE: (0, 1, 2, 3, 4)}, np.array([0.0, 9.0])))
    assert hand.said.cursor == "arrow" and not hand.said.items


def test_a_release_without_a_press_does_nothing():
    hand = Hand()
    hand.select(3)
    before = hand.session.design
    hand.gestures.release(hand.at(DOT_1))
    assert hand.session.design is before and hand.numbers == (3,)


def test_a_second_quick_press_on_a_dot_begins_a_drag_like_any_other():
    hand = Hand()
    hand.click(DOT_1)
    hand.gestures.double_click(hand.at(DOT_1))
    hand.gestures.move(hand.at(AWAY))
    hand.gestures.release(hand.at(AWAY))
    np.testing.assert_allclose(hand.points()[1], AWAY)


def test_a_drag_goes_on_where_the_pointer_is_while_the_view_zooms():
    hand = Hand()
    hand.hold(DOT_1, AWAY)
    hand.gestures.camera = hand.gestures.camera.zoomed(3.0, (100.0, 50.0))
    hand.gestures.move(hand.at((0.7, 1.9)))
    np.testing.assert_allclose(hand.points()[1], [0.7, 1.9], atol=1e-12)
