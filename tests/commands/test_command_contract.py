"""What every command keeps to."""

from dataclasses import replace

import numpy as np
import pytest

from plusedit.commands.base import Together
from plusedit.commands.curves import (
    ChangeFamily,
    ChangeOrder,
    CloseSmoothly,
    MakeTangent,
    PassThrough,
    SetBasisField,
    SetClosed,
    SetMagnitude,
    SetView,
)
from plusedit.commands.lines import (
    MovePoints,
    ResetDirections,
    ReverseDirections,
    ScaleDirections,
    SetAngle,
    SetCoordinate,
    SetDirection,
    SetLength,
    SetWeight,
    Transform,
    Turn,
)
from plusedit.commands.shapes import (
    AddShapes,
    AppendLine,
    DeleteLines,
    DeleteShapes,
    Duplicate,
    InsertLine,
    Rename,
    Reorder,
    ReverseCurves,
    SetLocked,
    SetStyle,
    SetVisible,
)
from plusedit.document.design import Design, EditError
from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.document.shape import Style
from tests.commands.known import A, B, curves, known, spline

LINES = {A: (1, 2)}
BY = np.array([0.5, -0.25])

EDITS = {
    "Move 2 control lines": MovePoints(LINES, BY),
    "Set x of 2 control lines": SetCoordinate(LINES, 0, 3.0),
    "Set weight of 2 control lines": SetWeight(LINES, 2.0),
    "Mirror 2 control lines": Transform(LINES, np.diag([-1.0, 1.0]), np.zeros(2), "Mirror"),
    "Rotate 2 control lines": Turn(LINES, 0.5),
    "Stretch 2 control lines": ScaleDirections(LINES, 2.0),
    "Set direction": SetDirection(A, 1, np.array([1.0, 0.5])),
    "Set angle of 2 control lines": SetAngle(LINES, 0.5),
    "Set length of 2 control lines": SetLength(LINES, 0.5),
    "Reverse 2 control lines": ReverseDirections(LINES),
    "Reset control line": ResetDirections({A: (2,)}),
    "Delete 2 control lines": DeleteLines(LINES),
    "Delete shape": DeleteShapes((A,)),
    "Duplicate shape": Duplicate((A,), BY),
    "Set style of shape": SetStyle((A,), Style("#ff0000")),
    "Insert control line": InsertLine(A, 0.4),
    "Add control line": AppendLine(A, True, np.array([6.0, 1.0])),
    "Reverse curve": ReverseCurves((A,)),
    "Set s": SetMagnitude({A: 3.0}),
    "Change family of curve": ChangeFamily((A,), "rag"),
    "Change order of curve": ChangeOrder((A,), 3),
    "Close curve": SetClosed((A,), True),
    "Set knots of curve": SetBasisField((A,), "knots", [0, 0, 0, 0, 0.3, 0.6, 1, 1, 1, 1]),
    "Smoothly close curve": CloseSmoothly((A,)),
    "Make ends tangent of curve": MakeTangent((A,)),
    "Pass through the points of curve": PassThrough((A,)),
}
"""By label; each acts on the shape A alone and changes it."""

OTHERS = {
    "Add shape": AddShapes((("new", known()[B]),)),
    "Draw curve": AddShapes((("new", known()[B]),), "Draw curve"),
    "Rename to Bow": Rename(A, "Bow"),
    "Hide shape": SetVisible((A,), False),
    "Lock shape": SetLocked((A,), True),
    "Reorder shapes": Reorder((B, A)),
    "Change view": SetView({"grid": False}),
    "Both": Together("Both", (MovePoints(LINES, BY), DeleteLines({A: (0,)}))),
}
"""Those that a locked shape need not refuse, or that act on more."""

every_command = pytest.mark.parametrize(
    "label, command", [*EDITS.items(), *OTHERS.items()], ids=[*EDITS, *OTHERS]
)
every_edit = pytest.mark.parametrize("command", EDITS.values(), ids=EDITS)


@every_command
def test_a_command_has_the_label_that_undo_says(label, command):
    assert command.label == label


@every_command
def test_a_command_makes_another_design_and_undo_brings_the_identical_one_back(label, command):
    session = Session(known())
    before = session.design
    session.commit(command)
    assert session.design is not before
    session.undo()
    assert session.design is before


@every_command
def test_a_command_shares_the_shapes_that_it_does_not_touch(label, command):
    before = known()
    after = command.apply(before)
    assert after.shapes[B] is before.shapes[B]


@every_command
def test_a_command_applied_twice_to_one_design_gives_the_same(label, command):
    before = known()
    first, second = command.apply(before), command.apply(before)
    assert list(first) == list(second)
    for one, other in zip(curves(first), curves(second), strict=True):
        assert one.basis == other.basis and one.s == other.s
        np.testing.assert_array_equal(one.lines.points, other.lines.points)
        np.testing.assert_array_equal(one.lines.given, other.lines.given)


@every_command
def test_what_is_selected_afterwards_is_there(label, command):
    session = Session(known())
    session.select(Selection.of_lines([LineId(A, 1), LineId(A, 5), LineId(B, 0)]))
    session.commit(command)
    assert session.selection.cut_to(session.design) is session.selection


@every_edit
@pytest.mark.parametrize("state, mark", [("locked", {"locked": True}), ("hidden", {"visible": 0})])
def test_no_edit_touches_a_locked_or_hidden_shape(command, state, mark):
    start = known()
    kept = start.with_shape(A, replace(start[A], **mark))
    with pytest.raises(EditError, match=f"A is {state}"):
        command.apply(kept)


@every_edit
def test_an_edit_of_a_shape_that_is_not_there_says_so(command):
    with pytest.raises(EditError, match="no shape 'a'"):
        command.apply(Design({B: known()[B]}))


@pytest.mark.parametrize(
    "command",
    [
        MovePoints(LINES, np.zeros(2)),
        Turn(LINES, 0.0),
        ScaleDirections(LINES, 1.0),
        Transform(LINES, np.eye(2), np.zeros(2)),
        ResetDirections({A: (0,)}),
        SetMagnitude({A: spline().s}),
        ChangeFamily((A,), "bspline"),
        ChangeOrder((A,), 4),
        SetClosed((A,), False),
        DeleteLines({}),
        DeleteShapes(()),
        SetLocked((A,), False),
        SetVisible((A,), True),
        Reorder((A, B)),
        Rename(A, " A "),
        SetStyle((A,), Style()),
    ],
    ids=lambda command: command.label,
)
def test_an_edit_that_changes_nothing_is_no_step(command):
    session = Session(known())
    before = session.design
    session.commit(command)
    assert session.design is before
    assert session.undo_label is None


@pytest.mark.parametrize("row", [-1, 6, 100])
def test_a_line_that_is_not_there_is_named(row):
    with pytest.raises(EditError, match=f"A has no control line {row + 1}"):
        MovePoints({A: (row,)}, BY).apply(known())
