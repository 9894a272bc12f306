"""The session: previews come and go, steps stay, listeners hear of every change once."""

from dataclasses import dataclass, replace

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from plusedit.document.design import Design, EditError
from plusedit.document.selection import NOTHING_SELECTED, LineId, Selection
from plusedit.document.session import Session
from plusedit.document.shape import Shape
from tests.designs import BOW, WING, a_curve, a_design


@dataclass(frozen=True)
class SetS:
    """An edit of five lines will do."""

    s: float
    label = "Set s"

    def label_in(self, design):
        return self.label

    def apply(self, design):
        return design.edited(WING, lambda curve: replace(curve, s=self.s))

    def reselect(self, selection, old, new):
        return selection


class Nothing(SetS):
    def apply(self, design):
        return design


class Impossible(SetS):
    def apply(self, design):
        raise EditError("that can't be done")


class Remove(SetS):
    label = "Delete"

    def apply(self, design):
        return design.without(WING)


class SwapLines(SetS):
    """Its lines keep being selected, under other numbers."""

    def reselect(self, selection, old, new):
        return Selection.of_lines(LineId(WING, 3 - line.number) for line in selection.lines)


def told(session):
    """What the session tells from now on."""
    heard = []
    session.changed.listen(lambda old, new: heard.append((old, new)))
    return heard


def test_a_preview_is_on_screen_and_no_step(session, design):
    session.preview(SetS(5.0))
    assert session.design.curve(WING).s == 5.0
    assert session.committed is design
    assert session.undo_label is None
    assert session.is_saved


def test_a_preview_replaces_the_one_before(session, design):
    session.preview(Remove(0.0))
    session.preview(SetS(5.0))
    assert list(session.design) == list(design)


def test_an_aborted_preview_leaves_the_very_same_design(session, design):
    session.preview(SetS(5.0))
    session.abort()
    assert session.design is design
    assert not session.is_previewing


def test_an_aborted_preview_leaves_the_same_selection(session):
    session.select(chosen := Selection.of_lines([LineId(WING, 1)]))
    session.preview(Remove(0.0))
    assert session.selection == NOTHING_SELECTED
    session.abort()
    assert session.selection == chosen


def test_a_commit_takes_the_place_of_the_preview(session, design):
    for s in (3.0, 4.0, 5.0):
        session.preview(SetS(s))
    session.commit(SetS(5.0))
    assert not session.is_previewing
    session.undo()
    assert session.design is design
    assert session.undo_label is None


def test_undo_after_a_preview_drops_it(session, design):
    session.commit(SetS(5.0))
    session.preview(SetS(6.0))
    session.undo()
    assert session.design is design


def test_an_edit_that_changes_nothing_is_no_step(session):
    session.commit(Nothing(0.0))
    assert session.undo_label is None


def test_an_impossible_edit_changes_nothing(session):
    session.preview(SetS(5.0))
    before, heard = session.design, told(session)
    for take in (session.preview, session.commit):
        with pytest.raises(EditError):
            take(Impossible(0.0))
    assert session.design is before
    assert not heard


def test_every_change_is_told_once_with_old_and_new(session, design):
    heard = told(session)
    session.preview(SetS(5.0))
    session.commit(SetS(6.0))
    session.undo()
    session.undo()
    session.redo()
    assert [old for old, _ in heard] == [design, *[new for _, new in heard[:-1]]]
    assert heard[-1][1] is session.design
    assert len(heard) == 4


def test_nothing_is_told_where_nothing_changed(session):
    heard = told(session)
    session.abort()
    session.undo()
    session.redo()
    session.commit(Nothing(0.0))
    assert not heard


def test_a_commit_selects_what_the_edit_says(session):
    session.select(Selection.of_lines([LineId(WING, 0)]))
    session.commit(SwapLines(5.0))
    assert session.selection.lines == {LineId(WING, 3)}


def test_what_an_edit_removed_is_not_selected(session):
    session.select(Selection.of_shapes([WING, BOW]))
    session.commit(Remove(0.0))
    assert session.selection == Selection.of_shapes([BOW])
    session.undo()
    assert session.selection == Selection.of_shapes([BOW])


def test_the_selection_is_cut_before_anyone_hears_of_the_change(session):
    session.select(Selection.of_shapes([WING]))
    seen = []
    session.changed.listen(lambda _old, _new: seen.append(session.selection))
    session.commit(Remove(0.0))
    assert seen == [NOTHING_SELECTED]


def test_a_selection_is_told_only_if_it_is_another(session):
    heard = []
    session.selected.listen(lambda old, new: heard.append((old, new)))
    session.select(chosen := Selection.of_shapes([WING]))
    session.select(Selection.of_shapes([WING]))
    assert heard == [(NOTHING_SELECTED, chosen)]


def test_opening_starts_over(session, design):
    session.select(Selection.of_shapes([WING]))
    session.commit(SetS(5.0))
    heard = told(session)
    old, other = session.design, a_design()
    session.open(other)
    assert heard == [(old, other)]
    assert (session.design, session.undo_label, session.is_saved) == (other, None, True)
    assert session.selection == NOTHING_SELECTED


def test_a_recovered_design_is_unsaved(session):
    session.open(a_design(), saved=False)
    assert not session.is_saved
    session.mark_saved()
    assert session.is_saved


def test_a_listener_can_stop_listening(session):
    heard = []
    stop = session.changed.listen(lambda old, new: heard.append(new))
    stop()
    session.commit(SetS(5.0))
    assert not heard


class AnySession(RuleBasedStateMachine):
    """A session against a list of designs and a place in it."""

    def __init__(self):
        super().__init__()
        self.session = Session(Design({WING: Shape(a_curve(), "wing")}))
        self.designs, self.at, self.saved = [self.session.design], 0, self.session.design
        self.shown = self.session.design
        self.session.changed.listen(self.hear)

    def hear(self, old, new):
        assert old is self.shown
        self.shown = new

    @rule(s=st.integers(0, 9))
    def commit(self, s):
        self.session.commit(SetS(float(s)))
        self.at += 1
        self.designs[self.at :] = [self.session.design]

    @rule(s=st.integers(0, 9))
    def preview(self, s):
        self.session.preview(SetS(float(s)))
        assert self.session.design.curve(WING).s == s

    @rule()
    def abort(self):
        self.session.abort()
        assert self.session.design is self.designs[self.at]

    @rule()
    def undo(self):
        self.session.undo()
        self.at = max(0, self.at - 1)
        assert self.session.design is self.designs[self.at]

    @rule()
    def redo(self):
        self.session.redo()
        self.at = min(len(self.designs) - 1, self.at + 1)
        assert self.session.design is self.designs[self.at]

    @precondition(lambda self: self.at > 0)
    @rule()
    def undo_and_redo(self):
        before = self.session.committed
        self.session.undo()
        self.session.redo()
        assert self.session.design is before

    @rule()
    def save(self):
        self.session.mark_saved()
        self.saved = self.session.committed

    @rule(numbers=st.sets(st.integers(0, 6)))
    def select(self, numbers):
        self.session.select(Selection.of_lines(LineId(WING, n) for n in numbers))

    @invariant()
    def nothing_is_lost(self):
        assert self.session.committed is self.designs[self.at]
        assert (self.session.undo_label is None) == (self.at == 0)
        assert (self.session.redo_label is None) == (self.at == len(self.designs) - 1)
        assert self.session.is_saved == (self.session.committed is self.saved)

    @invariant()
    def listeners_know_what_is_on_screen(self):
        assert self.shown is self.session.design

    @invariant()
    def the_selection_is_there(self):
        assert all(line.number < 4 for line in self.session.selection.lines)


TestAnySession = AnySession.TestCase
TestAnySession.settings = settings(max_examples=30, stateful_step_count=20, deadline=None)
