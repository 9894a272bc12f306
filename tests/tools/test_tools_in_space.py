"""What every tool keeps to in every view, on surfaces and curves alike."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.interaction.tool import Held, Pointer, tools
from tests.interaction.space_hand import SAIL, SIZE, VIEWS, SpaceHand, scene

every_tool = pytest.mark.parametrize("tool", list(tools))
every_view = pytest.mark.parametrize("camera", VIEWS, ids=str)

PIXELS = [Pointer(x, y) for x in (180.0, 430.0, 520.0, 760.0) for y in (240.0, 410.0, 560.0)]


def over_all(hand):
    """Pointers over handles of every kind and over places between them."""
    held = [hand.planes[6], hand.grip(6), hand.grip(6, 2), hand.on_surface(0.4, 0.6)]
    return [hand.at(place) for place in held] + PIXELS


def moved(at, x, y, held=Held.NONE):
    return Pointer(at.x + x, at.y + y, held)


@every_view
@every_tool
def test_hovering_edits_and_selects_nothing_and_says_what_can_be_done(tool, camera):
    hand = SpaceHand(camera=camera, tool=tool)
    hand.pick(6)
    before, selection = hand.session.design, hand.session.selection
    for at in over_all(hand):
        hand.gestures.move(at)
        assert hand.said.hint
    assert hand.session.design is before and hand.session.selection == selection


@every_view
@every_tool
def test_cancelling_a_drag_restores_the_very_same_design_and_selection(tool, camera):
    hand = SpaceHand(camera=camera, tool=tool)
    hand.pick(6)
    before, selection = hand.session.design, hand.session.selection
    for at in over_all(hand):
        hand.gestures.press(at)
        for step in range(1, 6):
            hand.gestures.move(moved(at, 9.0 * step, -7.0 * step))
        hand.gestures.cancel()
        assert hand.session.design is before and hand.session.selection == selection
    assert hand.session.undo_label is None


@every_view
@every_tool
@pytest.mark.parametrize("held", [Held.NONE, Held.SHIFT, Held.CTRL, Held.ALT])
def test_a_drag_is_at_most_one_step(tool, held, camera):
    for number in range(4):
        hand = SpaceHand(camera=camera, tool=tool)
        hand.pick(6)
        before = hand.session.design
        at = over_all(hand)[number]
        hand.gestures.press(replace(at, held=held))
        for x, y in ((5.0, 2.0), (30.0, -20.0), (31.0, -45.0), (-12.0, 8.0)):
            hand.gestures.move(moved(at, x, y, held))
        hand.gestures.release(moved(at, -12.0, 8.0, held))
        hand.session.undo()
        assert hand.session.design is before
        assert hand.session.undo_label is None


@every_view
@every_tool
@pytest.mark.parametrize("mark", [{"locked": True}, {"visible": False}])
def test_locked_and_hidden_shapes_never_change(tool, mark, camera):
    start = scene()
    shapes = {i: replace(shape, **mark) for i, shape in start.shapes.items()}
    hand = SpaceHand(replace(start, shapes=shapes), camera, tool)
    before = dict(hand.session.design.shapes)
    hand.session.select(Selection.of_shapes([SAIL]))
    for at in over_all(hand):
        hand.gestures.press(at)
        hand.gestures.move(moved(at, 20.0, 10.0))
        hand.gestures.release(moved(at, 20.0, 10.0))
        hand.gestures.press(at)
        hand.gestures.release(at)
        hand.gestures.double_click(at)
        hand.gestures.release(at)
        hand.session.select(Selection.of_lines([LineId(SAIL, 6)]))
    assert all(hand.session.design.shapes[i] is before[i] for i in before)


@every_view
@every_tool
def test_a_tool_works_on_an_empty_design(tool, camera):
    hand = SpaceHand(Design(), camera, tool)
    at = PIXELS[4]
    hand.gestures.move(at)
    hand.gestures.press(at)
    hand.gestures.release(at)
    hand.gestures.press(at)
    hand.gestures.move(moved(at, 30.0, 5.0))
    hand.gestures.release(moved(at, 30.0, 5.0))
    hand.gestures.double_click(at)
    assert not hand.errors


pointers = st.builds(
    Pointer,
    st.floats(-50.0, SIZE[0] + 50.0),
    st.floats(-50.0, SIZE[1] + 50.0),
    st.sampled_from([Held.NONE, Held.SHIFT, Held.CTRL, Held.ALT, Held.CTRL | Held.ALT]),
)
marks = st.integers(0, 15)
keys = st.sampled_from([*"0123456789.-XYZCGPVO[]", "Tab", "Backspace", "Enter", "Escape"])
acts = st.one_of(
    st.tuples(st.sampled_from(["press", "move", "release", "double_click"]), pointers),
    st.tuples(st.sampled_from(["dot", "grip", "ring", "arrow"]), marks),
    st.tuples(st.just("key"), keys),
    st.tuples(st.just("wheel"), st.floats(-3.0, 3.0)),
    st.tuples(st.just("begin"), st.sampled_from(["move", "turn", "scale"])),
    st.tuples(st.just("choose"), st.sampled_from(sorted(tools))),
    st.tuples(st.sampled_from(["undo", "redo", "cancel", "leave"]), st.none()),
)


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(VIEWS), st.lists(acts, max_size=25))
def test_no_sequence_of_gestures_raises_or_leaves_the_session_in_pieces(camera, sequence):
    hand = SpaceHand(camera=camera)
    for act, what in sequence:
        _do(hand, act, what)
    hand.gestures.cancel()
    assert not hand.session.is_previewing
    design = hand.session.design
    assert hand.session.selection.cut_to(design) == hand.session.selection
    for _, geometry in design.drawn():
        assert np.isfinite(geometry.net.control_points).all()
        assert np.isfinite(geometry.vectors).all()
    while hand.session.undo_label is not None:
        hand.session.undo()
    assert [*hand.session.design] == [*scene()]


def _do(hand, act, what):
    if act in ("dot", "grip", "ring", "arrow"):
        _press_on(hand, act, what)
    elif act in ("undo", "redo"):
        getattr(hand.session, act)()
    elif act == "begin":
        hand.gestures.begin(what, PIXELS[0])
    elif what is None:
        getattr(hand.gestures, act)()
    else:
        getattr(hand.gestures, act)(what)


def _press_on(hand, kind, number):
    """Press on a part of a control plane or the gizmo, where they are there."""
    if SAIL not in hand.session.design or len(hand.surface.planes) <= number:
        return
    if kind in ("ring", "arrow"):
        hand.pick(number)
        if hand.gizmo is None:
            return
    places = {
        "dot": lambda: hand.planes[number],
        "grip": lambda: hand.grip(number, 1 + number % 2),
        "ring": lambda: hand.on_ring(number % 3, 22.0 * number),
        "arrow": lambda: hand.on_arrow(number % 3),
    }
    hand.gestures.press(hand.at(places[kind]()))
