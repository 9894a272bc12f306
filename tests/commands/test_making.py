"""Commands that add surfaces."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.commands.making import AddSurface, Extrude, Fill, Loft, Revolve, Rule
from plusedit.document.design import Design, EditError
from plusedit.document.session import Session
from plusedit.document.shape import Shape
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.making.primitives import torus
from plusedit.geometry.transforms import reversed_curve, transformed
from tests.commands.known import A, B, known, spline
from tests.geometry.making.test_from_curves import edges

UP = np.array([0.0, 0.0, 2.0])
T = np.linspace(0.0, 1.0, 33)

EDITS = {
    "Add torus": AddSurface(torus(), "Torus"),
    "Extrude 2 curves": Extrude((A, B), UP),
    "Extrude curve": Extrude((A,), UP),
    "Revolve curve": Revolve((A,), np.zeros(3), np.array([1.0, 0.0, 0.0]), 1.0),
    "Rule surface between 2 curves": Rule((A, B)),
    "Loft 2 curves": Loft((A, B)),
}

every_edit = pytest.mark.parametrize(("label", "command"), EDITS.items(), ids=EDITS)


def with_curves(*curves):
    """The curves as shapes a, b, c, ..., back to front."""
    return Design({name: Shape(curve, name) for name, curve in zip("abcd", curves, strict=False)})


def made(command, design):
    """The surface that the command adds in front."""
    return list(command.apply(design).shapes.values())[-1].surface


@every_edit
def test_a_surface_is_added_in_front_and_selected(label, command):
    session = Session(known())
    before = session.design
    session.commit(command)
    assert session.undo_label == label
    new = [shape_id for shape_id in session.design if shape_id not in before]
    assert list(session.design)[: len(before)] == list(before)
    assert session.selection.shapes == set(new)
    assert all(session.design[i].surface is not None for i in new)
    session.undo()
    assert session.design is before


@every_edit
def test_the_curves_stay_the_very_same(label, command):
    after = command.apply(known())
    assert after[A].curve.lines.points.shape == (6, 2)
    assert len({*after}) == len(after)


def test_names_and_ids_are_free():
    session = Session(known())
    for _ in range(2):
        session.commit(Extrude((A,), UP))
        session.commit(AddSurface(torus(), "Torus"))
    names = [shape.name for shape in session.design.shapes.values()]
    assert names == ["A", "B", "A, extruded", "Torus", "A, extruded 2", "Torus 2"]
    assert list(session.design)[2:] == ["surface", "surface-2", "surface-3", "surface-4"]


def test_a_ruled_surface_does_not_twist():
    curve = spline()
    above = transformed(reversed_curve(curve), np.eye(3)[:, :2], UP)
    surface = made(Rule(("a", "b")), with_curves(curve, above))
    middle = surface.at(T, [0.5])[:, 0]
    assert_allclose(middle[:, :2], curve.at(T), atol=1e-12)
    assert_allclose(middle[:, 2], 1.0)


def test_a_patch_is_filled_in_whatever_order_its_edges_come():
    u0, u1, v0, v1 = edges()
    design = with_curves(v1, reversed_curve(u0), u1, v0)
    surface = made(Fill(("a", "b", "c", "d")), design)
    corners = surface.at([0.0, 1.0], [0.0, 1.0]).reshape(4, 3)
    for curve in (u0, u1):
        for end in curve.at([0.0, 1.0]):
            assert np.linalg.norm(corners - end, axis=1).min() < 1e-12


def test_a_closed_loft_goes_round():
    curves = [
        PlusCurve(BSpline(4, 4, closed=True), ControlLines.of(ring))
        for ring in (
            [[2 + x, 0, z] for x, z in ((1, 0), (0, 1), (-1, 0), (0, -1))],
            [[0, 2 + y, z] for y, z in ((1, 0), (0, 1), (-1, 0), (0, -1))],
            [[-2 - x, 0, z] for x, z in ((1, 0), (0, 1), (-1, 0), (0, -1))],
            [[0, -2 - y, z] for y, z in ((1, 0), (0, 1), (-1, 0), (0, -1))],
        )
    ]
    surface = made(Loft(tuple("abcd"), closed=True), with_curves(*curves))
    assert surface.closed == (True, True)


def test_a_surface_that_only_comes_near_its_curves_says_how_near():
    gaussian = PlusCurve(RationalGaussian.of_size(6), spline().lines, 2.0)
    above = transformed(spline(), np.eye(3)[:, :2], UP)
    after = Rule(("a", "b")).apply(with_curves(gaussian, above))
    assert after["surface"].name.startswith("Ruled surface, fitted within ")
    exact = Rule(("a", "b")).apply(with_curves(spline(), above))
    assert exact["surface"].name == "Ruled surface"


@pytest.mark.parametrize(
    ("command", "sentence"),
    [
        (Rule((A,)), "two curves"),
        (Loft((A,)), "two curves"),
        (Loft((A, B), closed=True), "three curves"),
        (Fill((A, B)), "needs four"),
        (Extrude((A,), np.zeros(3)), "more than nothing"),
        (Revolve((A,), np.zeros(3), np.zeros(3)), "direction"),
        (Extrude(("nowhere",), UP), "no shape"),
    ],
)
def test_what_can_not_be_made_is_said(command, sentence):
    with pytest.raises(EditError, match=sentence):
        command.apply(known())


def test_only_curves_are_extruded():
    design = AddSurface(torus(), "Torus").apply(known())
    with pytest.raises(EditError, match="not a curve"):
        Extrude(("surface",), UP).apply(design)
