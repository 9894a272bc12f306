"""Copies that differ in s."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.commands.multiples import FIGURE_1, Magnitude, Multiply, best_columns, points_of
from plusedit.document.design import Design, EditError
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.magnitude import polygon_length
from tests.designs import BOW, WING, a_design
from tests.geometry.curves import random_curve
from tests.geometry.surfaces import a_surface
from tests.scene.meshes import a_hill

NAME = ShapeId("shape")
SHAPES = {
    "curve": random_curve("bspline", s=0.3),
    "space curve": random_curve("closed", dimension=3),
    "surface": a_surface(),
    "mesh": a_hill(),
}


def one(geometry):
    return Design({NAME: Shape(geometry, "Arc")})


@pytest.mark.parametrize("kind", list(SHAPES))
def test_copies_have_the_s_they_are_named_by_and_lie_apart(kind):
    design = Multiply((NAME,)).apply(one(SHAPES[kind]))
    copies = [shape for i, shape in design.shapes.items() if i != NAME]
    assert [copy.name for copy in copies] == ["s = 0", "s = 0.5 L", "s = L", "s = 1.5 L"]
    for copy, magnitude in zip(copies, FIGURE_1, strict=True):
        assert copy.geometry.s == pytest.approx(magnitude.of(SHAPES[kind]))
    ends = [np.ptp(points_of(copy.geometry)[:, 0]) for copy in copies]
    middles = [points_of(copy.geometry)[:, 0].mean() for copy in copies]
    assert (np.diff(middles) > 0.8 * max(ends)).all()


def test_each_copy_is_the_shape_with_that_s_moved():
    curve = SHAPES["curve"]
    design = Multiply((NAME,), (Magnitude(0.7),), in_place=True).apply(one(curve))
    (shape,) = design.shapes.values()
    assert shape.geometry.s == pytest.approx(0.7 * polygon_length(curve))
    assert_allclose(shape.geometry.lines.points, curve.lines.points)
    assert_allclose(shape.geometry.directions, curve.directions)


def test_in_place_the_shapes_are_gone():
    design = Multiply((WING, BOW), FIGURE_1, 1.0, in_place=True).apply(a_design())
    assert len(design) == len(a_design()) - 2 + 8
    assert not {a_design()[i].name for i in (WING, BOW)} & {s.name for s in design.shapes.values()}


def test_they_are_one_undo_step_and_selected():
    session = Session(one(SHAPES["curve"]))
    session.commit(Multiply((NAME,)))
    assert len(session.selection.shapes) == 4
    assert NAME not in session.selection.shapes
    session.undo()
    assert list(session.design) == [NAME]


@pytest.mark.parametrize(
    ("count", "aspect", "columns"),
    [(4, 1.0, 2), (4, 9.0, 4), (4, 0.1, 1), (3, 1.4, 2), (6, 1.5, 3)],
)
def test_rows_suit_the_room(count, aspect, columns):
    assert best_columns(count, aspect) == columns


@pytest.mark.parametrize(
    ("word", "magnitude"),
    [("0", Magnitude(0.0, False)), ("L", Magnitude(1.0)), ("0.5L", Magnitude(0.5)),
     ("-2.5", Magnitude(-2.5, False))],
)  # fmt: skip
def test_values_are_read_as_they_are_written(word, magnitude):
    assert Magnitude.read(word) == magnitude


@pytest.mark.parametrize("word", ["", "x", "0.5M", "inf", "nanL", "0.5LL"])
def test_what_is_no_value_is_refused(word):
    with pytest.raises(ValueError, match="expected a number"):
        Magnitude.read(word)


def test_a_locked_shape_has_no_copies():
    from dataclasses import replace

    design = one(SHAPES["curve"])
    locked = design.with_shape(NAME, replace(design[NAME], locked=True))
    with pytest.raises(EditError, match="locked"):
        Multiply((NAME,)).apply(locked)
