from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

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
    SetVisible,
)
from plusedit.document.design import EditError
from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.magnitude import polygon_length
from tests.commands.known import POINTS, A, B, known, spline
from tests.designs import KNEE, a_mesh

PARAMETERS = np.linspace(0.0, 1.0, 33)


def committed(command, start=None, selected=()):
    session = Session(known() if start is None else start)
    session.select(Selection.of_lines(LineId(A, number) for number in selected))
    session.commit(command)
    return session


def test_added_shapes_lie_in_front_and_are_selected():
    session = committed(AddShapes(((ShapeId("c"), known()[B]),)))
    assert list(session.design) == [A, B, "c"]
    assert session.selection == Selection.of_shapes(["c"])


def test_a_shape_can_not_be_added_over_another():
    with pytest.raises(EditError, match="there is a shape 'a' already"):
        AddShapes(((A, known()[B]),)).apply(known())


def test_deleting_lines_keeps_the_others_as_they_were():
    curve = committed(DeleteLines({A: (1, 4)})).design.curve(A)
    assert_array_equal(curve.lines.points, np.array(POINTS)[[0, 2, 3, 5]])
    assert_array_equal(curve.directions[1], [2.0, 0.5])
    assert curve.basis == BSpline(4, 4)


def test_a_curve_too_short_for_its_order_gets_a_lower_one():
    assert committed(DeleteLines({A: (0, 1, 2)})).design.curve(A).basis == BSpline(3, 3)


@pytest.mark.parametrize("rows", [(0, 1, 2, 3, 4), (0, 1, 2, 3, 4, 5)])
def test_a_curve_left_with_fewer_than_two_lines_goes_whole(rows):
    assert list(committed(DeleteLines({A: rows})).design) == [B]


def test_deleting_a_line_takes_the_knot_nearest_to_its_node():
    knots = (0.0,) * 4 + (0.2, 0.7) + (1.0,) * 4
    start = known(spline(basis=BSpline(6, 4, knots=knots)))
    basis = committed(DeleteLines({A: (1,)}), start).design.curve(A).basis
    assert basis == BSpline(5, 4, knots=(0.0,) * 4 + (0.7,) + (1.0,) * 4)


def test_a_shorter_rag_curve_is_as_smooth_for_the_distance_of_its_nodes():
    start = known(spline(basis=RationalGaussian(6, 0.12)))
    basis = committed(DeleteLines({A: (1,)}), start).design.curve(A).basis
    assert basis.sigma == pytest.approx(0.12 * 5 / 4)


def test_after_deleting_the_line_before_is_selected_so_that_delete_can_go_on():
    assert committed(DeleteLines({A: (2,)}), selected=[2]).selection.active == LineId(A, 1)
    assert committed(DeleteLines({A: (0,)}), selected=[0]).selection.active == LineId(A, 0)


def test_lines_that_stay_selected_keep_being_the_same_lines():
    session = committed(DeleteLines({A: (1,)}), selected=[1, 3, 5])
    assert session.selection.by_shape() == {A: (2, 4)}


def test_duplicates_are_shifted_named_anew_and_selected():
    session = committed(Duplicate((A, B), np.array([1.0, -1.0])))
    assert list(session.design) == [A, B, "a-2", "b-2"]
    assert [shape.name for shape in session.design.shapes.values()] == ["A", "B", "A 2", "B 2"]
    assert session.selection == Selection.of_shapes(["a-2", "b-2"])
    copied = session.design.curve("a-2").lines.points
    assert_array_equal(copied, np.add(POINTS, (1.0, -1.0)))


def test_copies_of_copies_are_numbered_on():
    design = Duplicate((A,), np.ones(2)).apply(known())
    design = Duplicate((ShapeId("a-2"),), np.ones(2)).apply(design)
    assert list(design) == [A, B, "a-2", "a-3"]
    assert design[ShapeId("a-3")].name == "A 3"


def test_targets_can_be_duplicated_as_the_shapes_they_are_in():
    assert "a-2" in Duplicate({A: (1,)}, np.ones(2)).apply(known())


def test_a_name_can_not_be_empty():
    with pytest.raises(EditError, match="needs a name"):
        Rename(A, "  ").apply(known())


@pytest.mark.parametrize("command", [SetVisible((A,), False), SetLocked((A,), True)])
def test_what_is_hidden_or_locked_is_no_longer_selected(command):
    assert not committed(command, selected=[1, 2]).selection


def test_locked_shapes_can_be_renamed_hidden_and_unlocked():
    locked = SetLocked((A,), True).apply(known())
    assert Rename(A, "Bow").apply(locked)[A].name == "Bow"
    assert not SetVisible((A,), False).apply(locked)[A].visible
    assert not SetLocked((A,), False).apply(locked)[A].locked


def test_meshes_can_be_deleted_and_duplicated():
    start = known().with_shape(KNEE, Shape(a_mesh(), "Knee"))
    assert KNEE not in DeleteShapes((KNEE,)).apply(start)
    [(_, copy)] = set(Duplicate((KNEE,), np.array([1.0, 2.0])).apply(start).meshes()) - set(
        start.meshes()
    )
    places = a_mesh().vertex_places
    assert_allclose(copy.at(places) - a_mesh().at(places), [[1.0, 2.0, 0.0]] * 5)


def test_an_order_names_every_shape_once():
    for order in ((A,), (A, A), (A, B, ShapeId("c"))):
        with pytest.raises(EditError, match="every shape once"):
            Reorder(order).apply(known())


def test_an_inserted_line_is_selected_and_the_shape_stays():
    session = committed(InsertLine(A, 0.5), selected=[5])
    curve = session.design.curve(A)
    assert_allclose(curve.at(PARAMETERS), spline().at(PARAMETERS), atol=1e-9)
    (line,) = session.selection.lines
    assert len(curve.lines) == 7 and 2 <= line.number <= 4


@pytest.mark.parametrize("at_end, number", [(True, 6), (False, 0)])
def test_a_line_is_added_at_either_end_and_selected(at_end, number):
    session = committed(AppendLine(A, at_end, np.array([9.0, 9.0]), np.array([1.0, 0.0])))
    curve = session.design.curve(A)
    assert_array_equal(curve.lines.points[number], [9.0, 9.0])
    assert_array_equal(curve.directions[number], [1.0, 0.0])
    assert session.selection.active == LineId(A, number)
    assert curve.s == 2.0


def test_s_goes_on_being_half_the_length_where_it_was():
    half = replace(spline(), s=polygon_length(spline()) / 2.0)
    curve = committed(AppendLine(A, True, np.array([9.0, 9.0])), known(half)).design.curve(A)
    assert curve.s == pytest.approx(polygon_length(curve) / 2.0)
    assert curve.s > half.s


@pytest.mark.parametrize("at_end, inner", [(True, (0.15, 0.45, 0.75)), (False, (0.25, 0.4, 0.7))])
def test_given_knots_are_pushed_together_for_the_new_piece(at_end, inner):
    knots = (0.0,) * 4 + (0.2, 0.6) + (1.0,) * 4
    start = known(spline(basis=BSpline(6, 4, knots=knots)))
    basis = committed(AppendLine(A, at_end, np.zeros(2)), start).design.curve(A).basis
    assert_allclose(basis.knots[4:-4], inner)


def test_a_closed_curve_has_no_end_to_draw_on_from():
    start = known(spline(basis=BSpline(6, 4, closed=True)))
    with pytest.raises(EditError, match="no end"):
        AppendLine(A, True, np.zeros(2)).apply(start)


@pytest.mark.parametrize("closed", [False, True])
def test_a_reversed_curve_has_the_same_shape_and_the_selection_stays_on_its_lines(closed):
    start = known(spline(basis=BSpline(6, 4, closed=closed)))
    session = committed(ReverseCurves((A,)), start, selected=[1, 4])
    curve, chosen = session.design.curve(A), session.selection.by_shape()[A]
    assert_allclose(curve.at(1.0 - PARAMETERS), start.curve(A).at(PARAMETERS), atol=1e-12)
    assert {tuple(curve.lines.points[n]) for n in chosen} == {(1.0, 2.0), (4.0, 0.0)}
