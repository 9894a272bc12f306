"""Path data against another reader of it, and what errors leave."""

import numpy as np
import pytest
import svgelements
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.io.svg_paths import numbers_of, parse_path
from plusedit.io.svg_pieces import ellipse, rectangle
from tests.io.svg_drawings import draws, samples

T = np.linspace(0.0, 1.0, 33)


def pieces(data):
    return [piece for outline in parse_path(data).outlines for piece in outline.pieces]


def on_ellipse(points, center, radii, turn=0.0):
    """How far points are from fulfilling the equation of an ellipse, turned by radians."""
    frame = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    seen = (points - center) @ frame.T / radii
    return np.abs(np.linalg.norm(seen, axis=1) - 1.0).max()


def assert_same_as_another_reader(data):
    """The same segments one after the other; of an arc, several pieces here are one there."""
    ours = [
        points for points in (p.at(T) for p in pieces(data)) if np.ptp(points, axis=0).max() > 1e-9
    ]
    for theirs in (segment for segment in svgelements.Path(data) if draws(segment)):
        mine = ours.pop(0)
        if not isinstance(theirs, svgelements.Arc):
            assert_allclose(mine, samples(theirs), atol=1e-9)
            continue
        while np.abs(mine[-1] - tuple(theirs.end)).max() > 1e-9:
            mine = np.vstack([mine, ours.pop(0)])
        radii, turn = (theirs.rx, theirs.ry), float(theirs.get_rotation())
        assert on_ellipse(mine, tuple(theirs.center), radii, turn) < 1e-6
        middle = tuple(theirs.point(0.5))
        assert np.linalg.norm(mine - middle, axis=1).min() < 0.05 * max(radii)
    assert not ours


NUMBER = st.integers(-50, 50).map(str) | st.floats(-50, 50).map(lambda x: f"{x:.4f}")
RADIUS = st.floats(1.0, 60.0).map(lambda x: f"{x:.4f}")
FLAG = st.sampled_from("01")


def command(letters, *arguments):
    return st.tuples(st.sampled_from(letters), st.tuples(*arguments)).map(
        lambda drawn: drawn[0] + " ".join(drawn[1])
    )


def several(count):
    return [NUMBER] * count


MOVES = command("Mm", *several(2))
LINES = command("Ll", *several(2)) | command("HhVv", NUMBER)
CUBICS = st.tuples(command("Cc", *several(6)), command("Ss", *several(4))).map(" ".join)
QUADRATICS = st.tuples(command("Qq", *several(4)), command("Tt", *several(2))).map(" ".join)
ARCS = command("Aa", RADIUS, RADIUS, NUMBER, FLAG, FLAG, *several(2))
PATHS = st.tuples(
    MOVES,
    st.lists(MOVES | LINES | CUBICS | QUADRATICS | ARCS | st.sampled_from("Zz"), min_size=1),
).map(lambda parts: " ".join([parts[0], *parts[1]]))


@settings(max_examples=50, deadline=None)
@given(PATHS)
def test_every_command_draws_what_another_reader_draws(data):
    assert_same_as_another_reader(data)


@pytest.mark.parametrize(
    "data",
    [
        "M 1 2 L 30 40",
        "m1 2l3 4 5 6",
        "M10 10h20v30H5V2z",
        "M10-20.5L.5.5 1e1,2E1",
        "M0 0C10 0 20 10 20 20S30 40 40 40",
        "m0 0c10 0 20 10 20 20s10 20 20 20",
        "M0 0Q10 0 20 20T40 40t5 5",
        "M5 5L6 9S30 40 40 40",
        "M5 5L6 9T30 40",
        "M0 0L10 0 10 10zl5 5",
        "M1 1 2 2 3 1m5 5 1 1",
    ],
)
def test_lines_and_curves_are_those_of_another_reader(data):
    assert_same_as_another_reader(data)


def test_a_smooth_cubic_after_a_quadratic_has_nothing_to_mirror():
    after = pieces("M0 0Q10 0 20 20S30 40 40 40")[1]
    assert_allclose(after.points[1], [20.0, 20.0])


def across(a, b):
    """Positive where b lies to the side of a towards which y turns from x."""
    return a[0] * b[1] - a[1] * b[0]


@pytest.mark.parametrize("large", [0, 1])
@pytest.mark.parametrize("sweep", [0, 1])
def test_an_arc_lies_on_its_ellipse_and_turns_as_its_flags_say(large, sweep):
    chain = pieces(f"M 30 0 A 30 20 0 {large} {sweep} 0 20")
    # Of the two ellipses through both points one is about the origin, the other about (30, 20).
    center = [30.0, 20.0] if large == sweep else [0.0, 0.0]
    points = np.vstack([piece.at(T) for piece in chain])
    assert on_ellipse(points, center, [30.0, 20.0]) < 1e-13
    assert len(chain) == (3 if large else 1)
    assert_allclose(points[[0, -1]], [[30.0, 0.0], [0.0, 20.0]])
    turned = across(points[1] - points[0], points[3] - points[0])
    assert np.sign(turned) == (1.0 if sweep else -1.0)


def test_a_turned_arc_lies_on_the_turned_ellipse():
    chain = pieces("M 40 30 A 50 20 30 1 1 39 31")
    theirs = svgelements.Path("M 40 30 A 50 20 30 1 1 39 31")[1]
    center = tuple(theirs.center)
    points = np.vstack([piece.at(T) for piece in chain])
    assert on_ellipse(points, center, [50.0, 20.0], np.radians(30.0)) < 1e-12


def test_radii_too_small_to_reach_grow_just_enough():
    chain = pieces("M 0 0 A 1 1 0 0 1 10 0")
    points = np.vstack([piece.at(T) for piece in chain])
    assert on_ellipse(points, [5.0, 0.0], [5.0, 5.0]) < 1e-13


def test_an_almost_straight_arc_keeps_its_digits():
    (arc,) = pieces("M 0 0 A 1e9 1e9 0 0 1 10 0")
    assert_allclose(arc.at(np.array([0.5])), [[5.0, -25.0 / 2e9]], rtol=1e-9)


def test_an_arc_without_a_radius_is_a_line():
    (line,) = pieces("M 0 0 A 0 5 0 0 1 10 0")
    assert line.degree == 1


def test_an_arc_to_where_it_starts_is_nothing():
    assert not pieces("M 3 4 A 5 5 0 1 1 3 4")


def test_flags_need_no_blanks():
    assert_allclose(pieces("M0 0a5 5 0 0110 0")[-1].points[-1], [10.0, 0.0])


def test_a_closed_outline_returns_to_its_start():
    (outline,) = parse_path("M 1 2 L 5 6 L 7 1 Z").outlines
    assert outline.closed
    assert outline.end == (1.0, 2.0)


def test_closing_where_the_start_is_reached_adds_no_line():
    (outline,) = parse_path("M 1 2 L 5 6 L 1 2 Z").outlines
    assert len(outline.pieces) == 2


def test_after_closing_another_outline_begins_at_the_same_start():
    first, second = parse_path("M 1 2 L 5 6 z l 1 1").outlines
    assert first.closed
    assert not second.closed
    assert second.start == (1.0, 2.0)


@pytest.mark.parametrize(
    ("data", "kept", "why"),
    [
        ("M 0 0 L 1 1 L 2", 1, "a number is missing"),
        ("M 0 0 L 1 1 X 2 2", 1, "'X' is no command"),
        ("M 0 0 L 1 1 nan 4", 1, "'n' is no command"),
        ("M 0 0 L 1 1 C 1 1 2 2 3", 1, "a number is missing"),
        ("M 0 0 L 1 1 A 1 1 0 2 1 3 3", 1, "a flag 0 or 1 is missing"),
        ("M 0 0 L 1 1 L 1e999 0", 1, "1e999 is too large a number"),
        ("M 0 0 L 1 1 Z 5 5", 2, "'5' is no command"),
        ("L 1 1", 0, "a path begins with M"),
        ("M 0", 0, "a number is missing"),
        ("gibberish", 0, "'g' is no command"),
    ],
)
def test_what_comes_before_an_error_is_kept(data, kept, why):
    read = parse_path(data)
    assert sum(len(outline.pieces) for outline in read.outlines) == kept
    assert read.error is not None
    assert why in read.error


@pytest.mark.parametrize("data", ["", "   ", "M 0 0", "M 1 1 M 2 2", "M 1 1 Z"])
def test_a_path_that_draws_nothing_is_no_error(data):
    read = parse_path(data)
    assert not read.outlines
    assert read.error is None


def test_long_rubbish_is_left_at_once():
    read = parse_path("M 0 0 L 1 1 " + "x" * 1_000_000)
    assert len(read.outlines[0].pieces) == 1


def test_numbers_end_at_the_first_that_is_none():
    assert numbers_of("1, 2 3;4") == [1.0, 2.0, 3.0]


def test_an_ellipse_is_closed_and_exact():
    outline = ellipse(3.0, 4.0, 5.0, 2.0)
    points = np.vstack([piece.at(T) for piece in outline.pieces])
    assert on_ellipse(points, [3.0, 4.0], [5.0, 2.0]) < 1e-14
    assert outline.end == outline.start


def test_a_rectangle_without_round_corners_has_four_lines():
    outline = rectangle(1.0, 2.0, 30.0, 40.0, 0.0, 5.0)
    assert [piece.degree for piece in outline.pieces] == [1, 1, 1, 1]


def test_round_corners_take_their_part_of_the_sides():
    outline = rectangle(0.0, 0.0, 30.0, 40.0, 5.0, 10.0)
    assert [piece.degree for piece in outline.pieces] == [1, 2] * 4
    corner = outline.pieces[1].at(T)
    assert on_ellipse(corner, [25.0, 10.0], [5.0, 10.0]) < 1e-14


def test_corners_that_take_whole_sides_leave_no_lines():
    outline = rectangle(0.0, 0.0, 30.0, 40.0, 15.0, 20.0)
    assert [piece.degree for piece in outline.pieces] == [2] * 4
