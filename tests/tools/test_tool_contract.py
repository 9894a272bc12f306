"""What every tool on the shelf keeps to."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plusedit.document.selection import Selection
from plusedit.interaction.tool import Held, tools
from tests.interaction.hand import BOW, EMPTY, WAVE, Hand, design

ON_A_POINT = (1.0, 2.0)
ELSEWHERE = (1.7, 2.6)

every_tool = pytest.mark.parametrize("tool", list(tools))


@every_tool
def test_a_tool_has_a_title_a_shortcut_and_a_place(tool):
    entry = tools[tool]
    assert entry.title and len(entry.shortcut) == 1 and entry.order > 0


def test_no_two_tools_have_the_same_shortcut_or_place():
    assert len({entry.shortcut for entry in tools.values()}) == len(tools)
    assert len({entry.order for entry in tools.values()}) == len(tools)


@every_tool
def test_a_press_alone_edits_nothing(tool):
    hand = Hand(tool=tool)
    before = hand.session.design
    hand.gestures.press(hand.at(ON_A_POINT))
    assert hand.session.design is before


@every_tool
def test_hovering_edits_and_selects_nothing_and_says_what_can_be_done(tool):
    hand = Hand(tool=tool)
    before, selection = hand.session.design, hand.session.selection
    for place in (ON_A_POINT, ELSEWHERE, EMPTY, (2.0, -1.25)):
        hand.gestures.move(hand.at(place))
        assert hand.said.hint
    assert hand.session.design is before
    assert hand.session.selection == selection
    assert not hand.session.is_previewing


@every_tool
@pytest.mark.parametrize("start", [ON_A_POINT, EMPTY, (2.0, -1.25)])
def test_cancelling_a_drag_restores_the_very_same_design_and_selection(tool, start):
    hand = Hand(tool=tool)
    hand.session.select(Selection.of_shapes([BOW]))
    before, selection = hand.session.design, hand.session.selection
    hand.hold(start, ELSEWHERE, moves=5)
    assert hand.gestures.cancel() or not hand.gestures.is_busy
    assert hand.session.design is before
    assert hand.session.selection == selection
    assert hand.session.undo_label is None


@every_tool
@pytest.mark.parametrize("held", [Held.NONE, Held.SHIFT, Held.CTRL, Held.ALT])
def test_a_drag_is_at_most_one_step(tool, held):
    hand = Hand(tool=tool)
    before = hand.session.design
    hand.drag(ON_A_POINT, (1.4, 2.2), ELSEWHERE, (0.2, 1.3), moves=20, held=held)
    hand.session.undo()
    assert hand.session.design is before
    assert hand.session.undo_label is None


@every_tool
@pytest.mark.parametrize("mark", ["locked", "hidden"])
def test_locked_and_hidden_shapes_never_change(tool, mark):
    hand = Hand(_marked(design(), mark), tool=tool)
    before = dict(hand.session.design.shapes)
    hand.session.select(Selection.of_shapes([WAVE]))
    hand.drag(ON_A_POINT, ELSEWHERE, moves=3)
    hand.click(ON_A_POINT)
    hand.double_click((2.0, 0.1))
    assert all(hand.session.design.shapes[i] is before[i] for i in before)


@every_tool
def test_a_tool_works_on_an_empty_design(tool):
    from plusedit.document.design import Design

    hand = Hand(Design(), tool=tool)
    hand.gestures.move(hand.at(ELSEWHERE))
    hand.click(ON_A_POINT)
    hand.drag(ON_A_POINT, ELSEWHERE)
    hand.double_click(EMPTY)
    assert not hand.errors


def _marked(start, mark):
    from dataclasses import replace

    marks = {"locked": True} if mark == "locked" else {"visible": False}
    return replace(start, shapes={i: replace(s, **marks) for i, s in start.shapes.items()})


places = st.tuples(
    st.floats(-2.0, 6.0, allow_nan=False), st.floats(-2.0, 4.0, allow_nan=False)
) | st.sampled_from([ON_A_POINT, (0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (2.0, -1.0)])
modifiers = st.sampled_from(
    [Held.NONE, Held.SHIFT, Held.CTRL, Held.ALT, Held.CTRL | Held.ALT, Held.SHIFT | Held.CTRL]
)
keys = st.sampled_from([*"0123456789.-XYZCGPV", "Tab", "Backspace", "Enter", "Escape"])
acts = st.one_of(
    st.tuples(st.sampled_from(["press", "move", "release", "double_click"]), places, modifiers),
    st.tuples(st.just("key"), keys, modifiers),
    st.tuples(st.just("begin"), st.sampled_from(["move", "turn", "scale"]), places),
    st.tuples(st.just("choose"), st.sampled_from(sorted(tools)), modifiers),
    st.tuples(st.sampled_from(["undo", "redo", "cancel", "leave"]), st.none(), st.none()),
)


@settings(max_examples=50, deadline=None)
@given(st.lists(acts, max_size=25))
def test_no_sequence_of_gestures_raises_or_leaves_the_session_in_pieces(sequence):
    hand = Hand()
    for act, what, how in sequence:
        _do(hand, act, what, how)
    hand.gestures.cancel()
    assert not hand.session.is_previewing
    design_now = hand.session.design
    assert hand.session.selection.cut_to(design_now) == hand.session.selection
    for _, curve in design_now.curves():
        assert np.isfinite(curve.lines.points).all()
    while hand.session.undo_label is not None:
        hand.session.undo()
    assert list(hand.session.design) == [WAVE, BOW]


def _do(hand, act, what, how):
    if act in ("press", "move", "release", "double_click"):
        getattr(hand.gestures, act)(hand.at(what, how))
    elif act == "key":
        hand.gestures.key(what, how)
    elif act == "begin":
        hand.gestures.begin(what, hand.at(how))
    elif act == "choose":
        hand.gestures.choose(what)
    elif act in ("undo", "redo"):
        getattr(hand.session, act)()
    else:
        getattr(hand.gestures, act)()
