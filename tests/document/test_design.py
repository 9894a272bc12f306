"""Designs: ordered, immutable, sharing what an edit did not touch."""

import pytest

from plusedit.document.design import Design, EditError, changed
from plusedit.document.shape import Shape, ShapeId, Style
from tests.designs import BOW, KNEE, WING, a_curve, a_design, a_mesh


def with_a_knee(design):
    return design.with_shape(KNEE, Shape(a_mesh(), "Knee"))


def test_an_edit_shares_every_shape_that_it_did_not_touch(design):
    edited = design.with_curve(WING, a_curve())
    assert edited[BOW] is design[BOW]
    assert edited[WING] is not design[WING]
    assert changed(design, edited) == {WING}


def test_an_edit_leaves_the_design_before_as_it_was(design):
    before = dict(design.shapes)
    design.with_curve(WING, a_curve())
    design.without(WING)
    design.ordered([BOW, WING])
    assert dict(design.shapes) == before


def test_the_shapes_can_not_be_replaced_from_outside(design):
    with pytest.raises(TypeError):
        design.shapes[WING] = design[BOW]
    own = {WING: design[WING]}
    copied = Design(own)
    own.clear()
    assert WING in copied


def test_a_new_shape_comes_in_front(design):
    assert list(with_a_knee(design)) == [WING, BOW, KNEE]


def test_a_replaced_shape_stays_in_its_place(design):
    assert list(design.with_curve(WING, a_curve())) == [WING, BOW]


def test_what_came_or_went_has_changed(design):
    assert changed(design, with_a_knee(design)) == {KNEE}
    assert changed(design, design.without(BOW)) == {BOW}
    assert changed(design, design.ordered([BOW, WING])) == set()


def test_an_order_names_every_shape_once(design):
    assert list(design.ordered([BOW, WING])) == [BOW, WING]
    for wrong in ([BOW], [BOW, WING, KNEE], [BOW, BOW, WING]):
        with pytest.raises(EditError, match="every shape once"):
            design.ordered(wrong)


def test_a_missing_shape_is_named(design):
    with pytest.raises(EditError, match="there is no shape 'knee'"):
        design[KNEE]


def test_a_mesh_is_not_a_curve(design):
    assert [shape_id for shape_id, _ in with_a_knee(design).curves()] == [WING, BOW]
    with pytest.raises(EditError, match="Knee is not a curve"):
        with_a_knee(design).curve(KNEE)


@pytest.mark.parametrize(
    ("state", "word"), [({"locked": True}, "locked"), ({"visible": False}, "hidden")]
)
def test_a_locked_or_hidden_shape_is_not_edited(design, state, word):
    shape = Shape(a_curve(), "Wing", **state)
    with pytest.raises(EditError, match=f"Wing is {word}"):
        design.with_shape(WING, shape).with_curve(WING, a_curve())


def test_what_the_geometry_refuses_is_an_edit_error_with_the_name(design):
    def too_large(curve):
        return curve.__class__(curve.basis, curve.lines, 1e200)

    with pytest.raises(EditError, match=r"^Bow: s: must be a finite number"):
        design.edited(BOW, too_large)


def test_an_unused_id_is_the_stem_while_it_is_free(design):
    assert design.unused_id("sail") == "sail"
    assert design.unused_id("wing") == "wing-2"
    twice = design.with_shape(ShapeId("wing-2"), design[WING])
    assert twice.unused_id("wing") == "wing-3"


@pytest.mark.parametrize("color", ["red", "#fff", "#12345g", "#1234567", "", "#123456\n"])
def test_a_color_is_six_digits(color):
    with pytest.raises(ValueError, match="color"):
        Style(color)


@pytest.mark.parametrize("width", [-1.0, float("nan"), float("inf")])
def test_a_width_is_a_number_of_pixels(width):
    with pytest.raises(ValueError, match="width"):
        Style(width=width)


def test_two_designs_of_the_same_shapes_are_two():
    assert a_design() != a_design()
