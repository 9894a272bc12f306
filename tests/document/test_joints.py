"""Segments of one path of a drawing."""

from plusedit.document.joints import joined, whole_path
from plusedit.document.selection import LineId
from plusedit.document.shape import ShapeId
from plusedit.io.svg_reading import read_svg
from tests.geometry.surfaces import a_surface

TRIANGLE = b"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">
<path id="t" stroke="black" d="M0 0 C1 0 2 1 3 3 C4 4 5 5 6 3 L0 0 Z"/>
<path id="other" stroke="black" d="M0 0 L5 5"/></svg>"""


def a_drawing():
    return read_svg(TRIANGLE, "t.svg").design


def test_ends_of_one_path_at_one_point_are_joined():
    design = a_drawing()
    first, second = ShapeId("t-1"), ShapeId("t-2")
    last = LineId(first, len(design.curve(first).lines) - 1)
    assert joined(design, last) == {last, LineId(second, 0)}
    assert joined(design, LineId(second, 0)) == {last, LineId(second, 0)}


def test_a_closed_path_is_joined_where_it_begins_and_to_no_other_path():
    design = a_drawing()
    lines = joined(design, LineId(ShapeId("t-1"), 0))
    assert {line.shape for line in lines} == {"t-1", "t-3"}


def test_inner_lines_are_joined_to_nothing():
    inner = LineId(ShapeId("t-1"), 1)
    assert joined(a_drawing(), inner) == {inner}


def test_ends_that_were_torn_apart_or_locked_are_joined_no_longer():
    from dataclasses import replace

    design = a_drawing()
    second = ShapeId("t-2")
    locked = design.with_shape(second, replace(design[second], locked=True))
    last = LineId(ShapeId("t-1"), 2)
    assert joined(locked, last) == {last}


def test_control_planes_are_joined_to_nothing():
    design = a_drawing()
    first = ShapeId("t-1")
    design = design.with_shape(first, design[first].with_plus(a_surface()))
    assert joined(design, LineId(first, 0)) == {LineId(first, 0)}
    assert joined(design, LineId(ShapeId("t-2"), 0)) == {LineId(ShapeId("t-2"), 0)}


def test_a_path_is_all_its_segments():
    assert whole_path(a_drawing(), ShapeId("t-2")) == ("t-1", "t-2", "t-3")
    assert whole_path(a_drawing(), ShapeId("other")) == ("other",)
