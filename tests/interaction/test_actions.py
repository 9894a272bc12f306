from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.design import Design, EditError
from plusedit.document.selection import LineId, Selection
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.magnitude import best_s, polygon_length
from plusedit.interaction.actions import edit_actions
from plusedit.scene.camera import PlaneCamera
from tests.interaction.hand import BOW, WAVE, Hand, bow, design, wave

ACTIONS = {action.name: action for action in edit_actions()}

NEEDS_NOTHING = {"select_all", "select_none", "invert", "next_line", "previous_line"}
NEEDS_SHAPES = {"s_up", "s_down", "s_zero", "s_half", "s_best"}
NEEDS_MARKED = {"show_all", "unlock_all"}

every_action = pytest.mark.parametrize("name", list(ACTIONS))


def does(hand, *names):
    for name in names:
        hand.gestures.perform_by(lambda name=name: ACTIONS[name].make(hand.gestures.stage()))
    return hand


def with_lines(*lines):
    hand = Hand()
    hand.select(*lines)
    return hand


def with_shapes(*shapes, start=None):
    hand = Hand(start)
    hand.session.select(Selection.of_shapes(shapes))
    return hand


def test_no_two_actions_share_a_name_or_a_shortcut():
    shortcuts = [shortcut for action in ACTIONS.values() for shortcut in action.shortcuts]
    assert len(ACTIONS) == len(edit_actions())
    assert len(shortcuts) == len(set(shortcuts))


@every_action
def test_an_action_has_a_title_and_stands_in_a_menu(name):
    action = ACTIONS[name]
    assert action.title and action.menu
    assert action.shortcut == (action.shortcuts[0] if action.shortcuts else "")


@every_action
def test_with_nothing_to_act_on_an_action_says_so_in_a_sentence(name):
    if name in {"select_all", "select_none", "invert"} or ACTIONS[name].menu == "Surface/New":
        return
    hand = does(Hand(Design()), name)
    (error,) = hand.errors
    assert error[0].isupper() and error.endswith(".")


@every_action
def test_no_action_touches_a_locked_shape(name):
    start = design()
    start = start.with_shape(WAVE, replace(start[WAVE], locked=True))
    hand = with_shapes(WAVE, start=start)
    does(hand, name)
    if name not in {"unlock_all"}:
        assert hand.session.design[WAVE] is start[WAVE]


@every_action
def test_an_action_is_at_most_one_step_and_its_undo_is_exact(name):
    for selected in (Selection.of_shapes([WAVE, BOW]), Selection.of_lines([LineId(WAVE, 2)])):
        hand = Hand()
        before = hand.session.design
        hand.session.select(selected)
        does(hand, name)
        hand.session.undo()
        assert hand.session.design is before


@pytest.mark.parametrize(
    "name, by",
    [
        ("nudge_left", (-0.5, 0.0)),
        ("nudge_right", (0.5, 0.0)),
        ("nudge_up", (0.0, 0.5)),
        ("nudge_down", (0.0, -0.5)),
        ("nudge_right_far", (5.0, 0.0)),
        ("nudge_up_a_little", (0.0, 0.05)),
    ],
)
def test_nudges_are_steps_of_the_grid(name, by):
    hand = with_lines(1)
    hand.gestures.grid_step = 0.5
    does(hand, name)
    assert_allclose(hand.points()[1], np.add((1.0, 2.0), by))


def test_a_plane_curve_can_not_be_nudged_out_of_its_plane():
    assert does(with_lines(1), "nudge_nearer").errors == ["A plane curve can't leave its plane."]


@pytest.mark.parametrize(
    "name, degrees",
    [("turn_left", 5), ("turn_right", -5), ("turn_left_far", 15), ("turn_right_a_little", -0.5)],
)
def test_turn_keys_turn_the_direction(name, degrees):
    hand = does(with_lines(2), name)
    x, y = hand.directions()[2]
    assert_allclose(np.degrees(np.arctan2(y, x)), degrees)


def test_delete_takes_lines_and_whole_shapes_in_one_step():
    hand = with_lines(1)
    hand.session.select(hand.session.selection | Selection.of_shapes([BOW]))
    does(hand, "delete")
    assert list(hand.session.design) == [WAVE] and len(hand.points()) == 4
    hand.session.undo()
    assert list(hand.session.design) == [WAVE, BOW]


def test_delete_again_and_again_takes_line_after_line():
    hand = with_lines(3)
    does(hand, "delete", "delete")
    assert_array_equal(hand.points()[:, 0], [0.0, 1.0, 4.0])


def test_duplicates_lie_one_grid_step_to_the_right_and_below():
    hand = with_shapes(BOW)
    hand.gestures.grid_step = 0.25
    does(hand, "duplicate")
    assert_allclose(hand.points("bow-2"), np.add(hand.points(BOW), (0.25, -0.25)))


def test_select_all_none_and_invert():
    hand = does(Hand(), "select_all")
    assert len(hand.session.selection.lines) == 8
    does(hand, "select_none")
    assert not hand.session.selection
    hand.select(1, 2)
    does(hand, "invert")
    assert hand.numbers == (0, 3, 4)
    assert hand.session.selection.by_shape()[BOW] == (0, 1, 2)
    assert does(with_shapes(WAVE), "invert").session.selection.shapes == {BOW}


def test_tab_goes_through_all_lines_across_shapes_and_round():
    hand, seen = Hand(), []
    for _ in range(9):
        does(hand, "next_line")
        seen.append(hand.session.selection.active)
    every = [LineId(WAVE, n) for n in range(5)] + [LineId(BOW, n) for n in range(3)]
    assert seen == [*every, every[0]]
    does(hand, "previous_line")
    assert hand.session.selection.active == every[-1]


def test_tab_begins_with_the_first_line_of_a_selected_shape():
    assert does(with_shapes(BOW), "next_line").session.selection.active == LineId(BOW, 0)
    assert does(with_shapes(BOW), "previous_line").session.selection.active == LineId(BOW, 2)


def test_s_goes_up_and_down_by_a_hundredth_of_the_length():
    hand = does(with_shapes(WAVE), "s_up")
    assert_allclose(hand.curve().s, 2.0 + polygon_length(wave()) / 100.0)
    assert_allclose(does(hand, "s_down").curve().s, 2.0)
    assert hand.curve(BOW).s == bow().s


def test_without_a_selection_s_is_that_of_all_curves():
    hand = does(Hand(), "s_zero")
    assert (hand.curve().s, hand.curve(BOW).s) == (0.0, 0.0)
    does(hand, "s_half")
    assert_allclose(hand.curve(BOW).s, polygon_length(bow()) / 2.0)
    does(hand, "s_best")
    assert hand.curve().s == best_s(wave())


def test_the_order_goes_up_and_down_within_its_limits():
    hand = does(with_shapes(WAVE), "order_up")
    assert hand.curve().basis == BSpline(5, 5)
    does(hand, "order_up")
    assert hand.errors == ["The order is the highest that this curve can have."]
    does(hand, "order_down", "order_down", "order_down")
    assert hand.curve().basis == BSpline(5, 2)
    does(hand, "order_down")
    assert hand.errors[-1] == "The order is the lowest that this curve can have."
    assert does(with_shapes(BOW), "order_up").errors == [
        "Only B-splines have an order that can be chosen."
    ]


def test_a_curve_closes_and_opens():
    hand = does(with_shapes(WAVE), "close_curve")
    assert hand.curve().closed
    assert does(hand, "close_curve").errors == ["What is selected is closed already."]
    assert not does(hand, "open_curve").curve().closed


def test_shapes_are_raised_and_lowered():
    start = design(a=wave(), b=bow(), c=bow(), d=bow())
    for name, order in {
        "to_front": "cdab",
        "to_back": "abcd",
        "forward": "cabd",
        "backward": "abcd",
    }.items():
        hand = does(with_shapes("a", "b", start=start), name)
        assert "".join(hand.session.design) == order


def test_what_is_hidden_or_locked_comes_back():
    hand = does(with_shapes(WAVE), "hide")
    assert not hand.session.design[WAVE].visible and not hand.session.selection
    assert does(hand, "show_all").session.design[WAVE].visible
    hand.session.select(Selection.of_shapes([WAVE]))
    assert does(hand, "lock").session.design[WAVE].locked
    assert not does(hand, "unlock_all").session.design[WAVE].locked


@pytest.mark.parametrize("name, axis", [("mirror_horizontally", 0), ("mirror_vertically", 1)])
def test_mirroring_stays_in_place_and_twice_is_nothing(name, axis):
    hand = does(with_shapes(WAVE), name)
    for measure in (np.min, np.max):
        assert_allclose(measure(hand.points(), axis=0), measure(wave().lines.points, axis=0))
    u = np.linspace(0.0, 1.0, 17)
    image = wave().at(u)
    image[:, axis] = (4.0 if axis == 0 else 2.0) - image[:, axis]
    assert_allclose(hand.curve().at(u), image, atol=1e-12)
    assert_allclose(does(hand, name).points(), wave().lines.points)


def test_nudges_go_along_the_axes_that_are_seen():
    from plusedit.geometry.curve import PlusCurve
    from plusedit.geometry.lines import ControlLines

    space = PlusCurve(BSpline(3, 3), ControlLines.of(np.zeros((3, 3)) + np.eye(3)), 1.0)
    hand = Hand(design(wave=space), PlaneCamera((800.0, 600.0), projection="front"))
    hand.select(0)
    does(hand, "nudge_up")
    assert_array_equal(hand.points()[0], [1.0, 0.0, 1.0])
    does(hand, "nudge_nearer")
    assert_array_equal(hand.points()[0], [1.0, -1.0, 1.0])


def test_an_error_names_what_the_family_can_not_do():
    with pytest.raises(EditError, match="closed smoothly"):
        hand = with_shapes(BOW)
        ACTIONS["close_curve"].make(hand.gestures.stage()).apply(hand.session.design)
