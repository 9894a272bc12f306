"""What every command keeps to."""

from dataclasses import replace

import numpy as np
import pytest

from plusedit.commands.curves import ChangeFamily, ChangeOrder, SetClosed, SetMagnitude
from plusedit.commands.lines import (
    MovePoints,
    ResetDirections,
    Rotate,
    ScaleDirections,
    SoftMove,
    Transform,
    Turn,
)
from plusedit.commands.shapes import (
    DeleteLines,
    DeleteShapes,
    Rename,
    Reorder,
    SetLocked,
    SetStyle,
    SetVisible,
)
from plusedit.commands.surfaces import (
    Balance,
    ChangeFamilyOf,
    ChangeOrderOf,
    DeletePlanes,
    SetBasisFieldOf,
    SetClosedOf,
)
from plusedit.document.design import Design, EditError
from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.document.shape import Style
from plusedit.geometry.surface_magnitude import balanced
from tests.commands.edits import BY, EDITS, LIFT, LINES, OTHERS, PLANES, SURFACE_EDITS
from tests.commands.known import A, B, geometries, known, sheet, spline

CURVE_CASES = [(label, command, spline) for label, command in (EDITS | OTHERS).items()]
SURFACE_CASES = [(label, command, sheet) for label, command in SURFACE_EDITS.items()]
EDIT_CASES = [(command, spline) for command in EDITS.values()]
EDIT_CASES += [(command, sheet) for command in SURFACE_EDITS.values()]

every_command = pytest.mark.parametrize(
    "label, command, shape",
    CURVE_CASES + SURFACE_CASES,
    ids=[label for label, *_ in CURVE_CASES + SURFACE_CASES],
)
every_edit = pytest.mark.parametrize("command, shape", EDIT_CASES, ids=[*EDITS, *SURFACE_EDITS])


@every_command
def test_a_command_has_the_label_that_undo_says(label, command, shape):
    session = Session(known(shape()))
    session.commit(command)
    assert session.undo_label == label


@every_command
def test_a_command_makes_another_design_and_undo_brings_the_identical_one_back(
    label, command, shape
):
    session = Session(known(shape()))
    before = session.design
    session.commit(command)
    assert session.design is not before
    session.undo()
    assert session.design is before


@every_command
def test_a_command_shares_the_shapes_that_it_does_not_touch(label, command, shape):
    before = known(shape())
    after = command.apply(before)
    assert after.shapes[B] is before.shapes[B]


@every_command
def test_a_command_applied_twice_to_one_design_gives_the_same(label, command, shape):
    before = known(shape())
    first, second = command.apply(before), command.apply(before)
    assert list(first) == list(second)
    for one, other in zip(geometries(first), geometries(second), strict=True):
        assert type(one) is type(other) and one.s == other.s
        np.testing.assert_array_equal(one.net.control_points, other.net.control_points)
        np.testing.assert_array_equal(one.net.given_vectors, other.net.given_vectors)


@every_command
def test_what_is_selected_afterwards_is_there(label, command, shape):
    session = Session(known(shape()))
    session.select(Selection.of_lines([LineId(A, 1), LineId(A, 5), LineId(B, 0)]))
    session.commit(command)
    assert session.selection.cut_to(session.design) is session.selection


@every_edit
@pytest.mark.parametrize("state, mark", [("locked", {"locked": True}), ("hidden", {"visible": 0})])
def test_no_edit_touches_a_locked_or_hidden_shape(command, shape, state, mark):
    start = known(shape())
    kept = start.with_shape(A, replace(start[A], **mark))
    with pytest.raises(EditError, match=f"A is {state}"):
        command.apply(kept)


@every_edit
def test_an_edit_of_a_shape_that_is_not_there_says_so(command, shape):
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
        Rotate(LINES, np.eye(3)),
        SoftMove(LINES, np.zeros(2), 1.0),
    ],
    ids=lambda command: command.label,
)
def test_an_edit_that_changes_nothing_is_no_step(command):
    session = Session(known())
    before = session.design
    session.commit(command)
    assert session.design is before
    assert session.undo_label is None


@pytest.mark.parametrize(
    "command",
    [
        MovePoints(PLANES, np.zeros(3)),
        SoftMove(PLANES, np.zeros(3), 1.0),
        Turn(PLANES, 0.0),
        Rotate(PLANES, np.eye(3), "u"),
        ScaleDirections(PLANES, 1.0),
        Transform(PLANES, np.eye(3), np.zeros(3)),
        ResetDirections({A: (0,)}),
        SetMagnitude({A: sheet().s}),
        ChangeFamilyOf((A,), "u", "bspline"),
        ChangeOrderOf((A,), "v", 4),
        SetClosedOf((A,), "u", False),
        SetBasisFieldOf((A,), "v", "order", 4),
        DeletePlanes({A: ()}),
        DeleteLines({A: ()}),
    ],
    ids=lambda command: command.label,
)
def test_an_edit_that_changes_nothing_of_a_surface_is_no_step(command):
    session = Session(known(sheet()))
    before = session.design
    session.commit(command)
    assert session.design is before
    assert session.undo_label is None


def test_a_surface_that_is_balanced_is_balanced_no_further():
    start = known(balanced(sheet()))
    assert Balance((A,)).apply(start) is start


@pytest.mark.parametrize("row", [-1, 20, 100])
def test_a_plane_that_is_not_there_is_named(row):
    with pytest.raises(EditError, match=f"A has no control plane {row + 1}"):
        MovePoints({A: (row,)}, LIFT).apply(known(sheet()))


def test_an_edit_of_lines_and_planes_names_both():
    session = Session(known(sheet()))
    session.commit(MovePoints({A: (1, 2), B: (0,)}, BY))
    assert session.undo_label == "Move control line and 2 control planes"
    session.commit(SetMagnitude({A: 2.0, B: 2.0}))
    assert session.undo_label == "Set s of 2 shapes"


@pytest.mark.parametrize("row", [-1, 6, 100])
def test_a_line_that_is_not_there_is_named(row):
    with pytest.raises(EditError, match=f"A has no control line {row + 1}"):
        MovePoints({A: (row,)}, BY).apply(known())
