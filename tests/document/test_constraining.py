"""What a shape keeps, it keeps through every edit, its undoing, and a file."""

import json

import numpy as np
import pytest

from plusedit.commands.constraints import Constrain, Release
from plusedit.commands.directions import Turn
from plusedit.commands.lines import MovePoints
from plusedit.commands.planes import InsertRow
from plusedit.commands.shapes import AppendLine, DeleteLines, InsertLine, ReverseCurves
from plusedit.commands.surfaces import ReverseWay, Transpose
from plusedit.document.constraining import problems_of
from plusedit.document.design import Design, EditError
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.constraints import Wish
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.keeping import holds
from plusedit.geometry.lines import ControlLines
from plusedit.io.formats import FormatError
from plusedit.io.formats.json_document import dumps, loads
from tests.geometry.surfaces import a_surface

A = ShapeId("a")
START, THROUGH = Wish("tangent_start"), Wish("passing", (2, 4))


def session(*wishes, shape=None):
    points = [[0, 0], [1, 2], [2.5, 2.5], [4, 2], [5, 0], [7, 1], [8, 3]]
    curve = PlusCurve(BSpline(7, 4), ControlLines.of(points), 3.0)
    found = Session(Design({A: shape or Shape(curve, "Arch")}))
    for wish in wishes:
        found.commit(Constrain({A: wish}))
    return found


def wishes_of(found):
    return set(found.design[A].constraints)


def keeps_all(found):
    shape = found.design[A]
    return all(holds(shape.plus, wish) for wish in shape.constraints)


def test_a_constraint_holds_from_the_moment_that_it_is_set():
    found = session(START, THROUGH)
    assert wishes_of(found) == {START, THROUGH}
    assert keeps_all(found)
    assert found.undo_label == "Through control points: curve"


@pytest.mark.parametrize(
    "edit",
    [
        MovePoints({A: (0,)}, np.array([0.5, -1.0, 0.0])),
        MovePoints({A: (3, 4)}, np.array([0.5, 1.0, 0.0])),
        Turn({A: (0,)}, 0.7),
        Turn({A: (1, 2)}, -0.7),
    ],
)
def test_it_is_kept_in_every_preview_and_step_and_undo_restores_the_very_same_design(edit):
    found = session(START, THROUGH)
    before = found.design
    found.preview(edit)
    assert found.design is not before
    assert keeps_all(found)
    found.abort()
    assert found.design is before
    found.commit(edit)
    assert keeps_all(found)
    found.undo()
    assert found.design is before


def test_a_released_shape_stays_as_it_is_and_is_free_then():
    found = session(START)
    geometry = found.design[A].geometry
    found.commit(Release((A,), "tangent_start"))
    assert found.design[A].geometry is geometry
    found.commit(Turn({A: (0,)}, 1.0))
    assert not holds(found.design[A].plus, START)


def test_what_cannot_be_kept_is_refused_and_nothing_changes():
    found = session()
    before = found.design
    with pytest.raises(EditError, match="corners"):
        found.commit(Constrain({A: Wish("corner_tangency", (0,))}))
    assert found.design is before


def test_what_an_edit_makes_impossible_is_told_and_kept_again_as_soon_as_it_can_be():
    found = session(START)
    found.commit(DeleteLines({A: (1, 2, 3, 4, 5)}))
    (problem,) = problems_of(found.design[A]).values()
    assert "at least 3 control lines" in problem
    found.commit(AppendLine(A, True, np.array([9.0, 5.0])))
    assert not problems_of(found.design[A])
    assert keeps_all(found)


@pytest.mark.parametrize(
    "edit, numbers",
    [
        (DeleteLines({A: (0,)}), (1, 3)),
        (DeleteLines({A: (2,)}), (3,)),
        (InsertLine(A, 0.05), (3, 5)),
        (AppendLine(A, False, np.array([-1.0, 0.0])), (3, 5)),
        (AppendLine(A, True, np.array([9.0, 0.0])), (2, 4)),
    ],
)
def test_points_keep_being_passed_through_under_their_new_numbers(edit, numbers):
    found = session(THROUGH)
    found.commit(edit)
    assert wishes_of(found) == {Wish("passing", numbers)}
    assert keeps_all(found)


@pytest.mark.parametrize("numbers", [(1, 3, 4), tuple(range(7))])
@pytest.mark.parametrize("u", [0.2, 0.55, 0.9])
@pytest.mark.parametrize("basis", [BSpline(7, 4), Bernstein(7)], ids=str)
def test_a_line_is_inserted_where_the_curve_runs_though_it_passes_through_points(basis, numbers, u):
    arch = session().design.curve(A)
    shape = Shape(PlusCurve(basis, arch.lines, arch.s), "Arch")
    found = session(Wish("passing", numbers), shape=shape)
    params = np.linspace(0.0, 1.0, 200)
    before = found.design.curve(A).at(params)
    found.commit(InsertLine(A, u))
    after = found.design.curve(A).at(params)
    assert keeps_all(found)
    distances = np.linalg.norm(after[:, None] - before, axis=2).min(axis=1)
    assert distances.max() < 0.02 * np.ptp(before, axis=0).max()


def test_of_a_curve_that_runs_the_other_way_the_other_end_is_tangent():
    found = session(START, Wish("passing", (1,)))
    found.commit(ReverseCurves((A,)))
    assert wishes_of(found) == {Wish("tangent_end"), Wish("passing", (5,))}
    assert keeps_all(found)


@pytest.mark.parametrize(
    "edit, corners, elements",
    [
        (Transpose((A,)), (0, 2), (5, 7)),
        (ReverseWay((A,), "u"), (0, 1), (11, 21)),
        (InsertRow(A, "v", 0.9), (0, 1), (1, 13)),
    ],
)
def test_constraints_of_surfaces_follow_their_planes(edit, corners, elements):
    shape = Shape(a_surface(5, 5), "Sheet")
    found = session(Wish("corner_tangency", (0, 1)), Wish("passing", (1, 11)), shape=shape)
    found.commit(edit)
    assert wishes_of(found) == {Wish("corner_tangency", corners), Wish("passing", elements)}
    assert keeps_all(found)


def test_a_file_keeps_constraints_and_those_of_other_programs():
    found = session(START, THROUGH)
    tree = json.loads(dumps(found.design))
    assert tree["shapes"][0]["constraints"] == [
        {"kind": "tangent_start"},
        {"kind": "passing", "elements": [2, 4]},
    ]
    tree["shapes"][0]["constraints"].append({"kind": "isophotic", "at": 3})
    again = loads(json.dumps(tree).encode(), "arch.json").design
    assert set(again[A].constraints) == {START, THROUGH}
    assert json.loads(dumps(again)) == tree


@pytest.mark.parametrize("numbers", [[7], [-1], [1.5], [], "2", [True]])
def test_numbers_of_lines_that_are_not_there_are_refused(numbers):
    tree = json.loads(dumps(session().design))
    tree["shapes"][0]["constraints"] = [{"kind": "passing", "elements": numbers}]
    with pytest.raises(FormatError, match="constraints: passing: elements"):
        loads(json.dumps(tree).encode(), "arch.json")
