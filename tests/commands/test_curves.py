import numpy as np
import pytest
from numpy.testing import assert_allclose

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
)
from plusedit.commands.shapes import DeleteLines, InsertLine
from plusedit.document.design import EditError
from plusedit.document.selection import NOTHING_SELECTED
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from tests.commands.known import A, B, known, spline


def after(command, curve=None):
    return command.apply(known(curve)).curve(A)


def test_every_curve_gets_its_own_s():
    design = SetMagnitude({A: 0.0, B: -3.0}).apply(known())
    assert (design.curve(A).s, design.curve(B).s) == (0.0, -3.0)


@pytest.mark.parametrize("s", [np.nan, np.inf, 1e200])
def test_s_must_be_a_number_to_calculate_with(s):
    with pytest.raises(EditError, match="A: s"):
        SetMagnitude({A: s}).apply(known())


@pytest.mark.parametrize("family, kind", [("bezier", Bernstein), ("rag", RationalGaussian)])
def test_another_family_blends_the_same_lines(family, kind):
    start = known()
    curve = ChangeFamily((A,), family).apply(start).curve(A)
    assert isinstance(curve.basis, kind)
    assert curve.lines is start.curve(A).lines


def test_a_closed_curve_stays_closed_in_another_family_that_can_be():
    closed = spline(basis=BSpline(6, 4, closed=True))
    assert after(ChangeFamily((A,), "rag"), closed).closed
    with pytest.raises(EditError, match="open the curve first"):
        ChangeFamily((A,), "bezier").apply(known(closed))


@pytest.mark.parametrize("wanted, order", [(2, 2), (5, 5), (6, 6), (9, 6)])
def test_an_open_curve_takes_an_order_up_to_the_number_of_its_lines(wanted, order):
    assert after(ChangeOrder((A,), wanted)).basis == BSpline(6, order)


def test_a_closed_curve_takes_any_order_from_two():
    closed = spline(basis=BSpline(6, 4, closed=True))
    assert after(ChangeOrder((A,), 9), closed).basis == BSpline(6, 9, closed=True)
    with pytest.raises(EditError, match="order"):
        ChangeOrder((A,), 1).apply(known(closed))


def test_only_splines_have_an_order():
    with pytest.raises(EditError, match="B: only B-splines"):
        ChangeOrder((B,), 3).apply(known())


def test_closing_and_opening_a_spline_comes_back_to_it():
    there = SetClosed((A,), True).apply(known())
    assert there.curve(A).basis == BSpline(6, 4, closed=True)
    assert SetClosed((A,), False).apply(there).curve(A).basis == BSpline(6, 4)


def test_closing_a_rag_curve_keeps_its_width_in_distances_of_nodes():
    curve = after(SetClosed((A,), True), spline(basis=RationalGaussian(6, 0.6 / 5)))
    assert curve.basis.closed and curve.basis.sigma == pytest.approx(0.6 / 6)


def test_given_nodes_are_pushed_together_to_close():
    nodes = (0.0, 0.1, 0.5, 0.6, 0.9, 1.0)
    curve = after(SetClosed((A,), True), spline(basis=RationalGaussian(6, 0.1, False, nodes)))
    assert_allclose(curve.basis.given_nodes, np.array(nodes) * 5 / 6)


def test_a_bezier_is_closed_smoothly_only():
    with pytest.raises(EditError, match="closed smoothly"):
        SetClosed((B,), True).apply(known())
    curve = CloseSmoothly((B,)).apply(known()).curve(B)
    assert_allclose(curve.at([0.0]), curve.at([1.0]), atol=1e-12)


def test_ends_are_made_tangent_to_their_lines():
    curve = after(MakeTangent((A,), True, True))
    _, velocity = curve.derivatives([0.0, 1.0], highest=1)
    for way, direction in zip(velocity, curve.directions[[0, -1]], strict=True):
        assert way @ direction > 0.0
        assert abs(way[0] * direction[1] - way[1] * direction[0]) < 1e-9


def test_a_curve_passes_through_its_points():
    curve = after(PassThrough((A,)))
    assert_allclose(curve.at(curve.basis.nodes), curve.lines.points, atol=1e-9)


def test_a_parameter_of_the_basis_is_set_by_its_name():
    rag = spline(basis=RationalGaussian(6, 0.1))
    assert after(SetBasisField((A,), "sigma", 0.3), rag).basis.sigma == 0.3
    knots = [0, 0, 0, 0, 0.25, 0.5, 1, 1, 1, 1]
    assert after(SetBasisField((A,), "knots", knots)).basis.knots == tuple(knots)


@pytest.mark.parametrize(
    "name, value, words",
    [
        ("sigma", 1.0, "has no sigma"),
        ("size", 7, "has no size"),
        ("order", 77, "order"),
        ("knots", [0.0, 1.0], "knots"),
    ],
)
def test_a_parameter_that_makes_no_sense_is_refused_in_words(name, value, words):
    with pytest.raises(EditError, match=words):
        SetBasisField((A,), name, value).apply(known())


def test_edits_together_select_one_after_the_other():
    both = Together("Both", (InsertLine(A, 0.5), DeleteLines({A: (0,)})))
    start = known()
    middle = InsertLine(A, 0.5).reselect(NOTHING_SELECTED, start, start)
    (inserted,) = middle.lines
    (line,) = both.reselect(NOTHING_SELECTED, start, both.apply(start)).lines
    assert line.number == inserted.number - 1
