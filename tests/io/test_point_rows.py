"""Lists of points become fitted curves."""

import numpy as np
import pytest

from plusedit.commands.fitting import fit_source
from plusedit.geometry.residual import residual
from plusedit.io.formats import FormatError, formats
from tests.designs import a_design

ROWS = formats["point_rows"]


def read(text):
    return ROWS.read(text.encode(), "points.csv")


def rows(points, between=","):
    return "\n".join(between.join(map(repr, row)) for row in np.asarray(points).tolist()) + "\n"


def spiral(dimension=2, count=150):
    t = np.linspace(0.3, 6.0, count)
    return np.stack([t * np.cos(t), t * np.sin(t), t], axis=1)[:, :dimension]


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("between", [",", ";", " ", "\t", ", "])
def test_points_become_a_curve_within_the_tolerance_that_it_tells(dimension, between):
    design = read(rows(spiral(dimension), between)).design
    (shape,) = design.shapes.values()
    source = fit_source(shape)
    assert (source.points == spiral(dimension)).all()
    assert residual(shape.curve, source.points).largest <= source.tolerance
    assert len(shape.curve.lines) < 40


def test_titles_comments_and_repeated_points_are_passed_over():
    text = "x,y\n# a comment\n0,0\n0,0\n1,2 # here\n3,2\n"
    (shape,) = read(text).design.shapes.values()
    assert fit_source(shape).points.tolist() == [[0, 0], [1, 2], [3, 2]]


def test_an_empty_line_begins_another_curve():
    assert len(read("0 0\n1 1\n\n\n5 5\n6 7\n8 8\n").design) == 2


def test_points_that_end_where_they_began_are_closed():
    angles = np.linspace(0.0, 2.0 * np.pi, 40)
    ring = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    ring[-1] = ring[0]
    (shape,) = read(rows(ring)).design.shapes.values()
    assert shape.curve.closed


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("1 2\n", "no two different points"),
        ("1 2\n1 2\n", "no two different points"),
        ("1 2\n3 x\n", 'line 2: expected numbers, got "x"'),
        ("1 2\n3\n", "line 2: has 1 number, expected 2 or 3"),
        ("1 2\n3 4 5\n", "line 2: has 3 numbers"),
        ("1 2\n3 nan\n", "line 2: has a number that is not finite"),
        ("1 2\n3 1e200\n", "too large"),
        ("x y\n1 2\nthree four\n", "expected numbers"),
        ("", "is empty"),
    ],
)
def test_what_is_no_list_of_points_is_refused_in_a_sentence(text, words):
    with pytest.raises(FormatError, match=r"^points.csv: ") as error:
        read(text)
    assert words in str(error.value)


def test_curves_are_written_as_points_of_theirs():
    again = ROWS.read(ROWS.write(a_design()), "again.csv").design
    curves = [curve for _, curve in a_design().curves()]
    assert len(again) == len(curves)
    for shape, curve in zip(again.shapes.values(), curves, strict=True):
        assert np.abs(fit_source(shape).points[[0]] - curve.at([0.0])).max() < 1e-15
