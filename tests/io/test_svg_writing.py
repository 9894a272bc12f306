"""Designs as SVG: the same shapes for any other reader, painted as they were."""

from dataclasses import replace
from itertools import groupby, pairwise
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.shape import Shape, Style
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.io.formats.json_document import dumps, loads
from plusedit.io.svg_cubics import chain_of
from plusedit.io.svg_reading import read_svg
from plusedit.io.svg_writing import left_out, write_svg
from tests.designs import a_mesh
from tests.geometry.surfaces import a_surface
from tests.io.svg_drawings import (
    cubic,
    distances,
    every_file,
    length,
    path_svg,
    samples,
    segments_by_another_reader,
    svg,
)

SVG = "{http://www.w3.org/2000/svg}"
POINTS = np.array([[0.0, 0.0], [1.0, 2.0], [3.0, 2.5], [4.0, -1.0], [6.0, 0.0]])
EVERY_COMMAND = (
    "M 10 10 h 20 v 5 l 5 5 L 50 10 H 60 V 15 c 5 0 10 5 10 10 C 70 30 60 40 50 40 s 5 10 9 9"
    " S 30 60 30 50 q -5 5 -10 0 Q 15 40 10 50 t 5 5 T 9 70 a 5 8 20 1 0 9 9 A 9 9 0 0 1 30 90 z"
    " m 50 50 1 1 2 3 Z M 80 80 l 5 5"
)


def design(**curves):
    return Design({name: Shape(curve, name) for name, curve in curves.items()})


def bezier(points=POINTS, **options):
    return PlusCurve(Bernstein(len(points)), ControlLines.of(points), **options)


def paths_of(data):
    return list(ElementTree.fromstring(data).iter(SVG + "path"))


def written(what):
    return paths_of(write_svg(what))


def rewritten(data, how="segments"):
    return write_svg(read_svg(data, "drawing.svg", how).design)


def assert_same_drawing(one, other, tolerance=1e-6):
    """The same paths for a reader that is not ours, within that share of the drawing's size."""
    before, after = segments_by_another_reader(one), segments_by_another_reader(other)
    assert len(before) == len(after)
    sampled = [np.vstack([samples(s, 5) for s in path]) for path in before]
    size = np.ptp(np.vstack(sampled), axis=0).max()
    for old, new, points in zip(before, after, sampled, strict=True):
        cubics = np.array([cubic(segment) for segment in new])
        assert distances(points, cubics).max() < tolerance * size
        assert length(new) == pytest.approx(length(old), rel=5e-3)


@every_file
@pytest.mark.parametrize("how", ["segments", "paths"])
def test_a_real_file_comes_out_as_it_went_in(file, how):
    data = file.read_bytes()
    again = rewritten(data, how)
    if len(data) < 20_000:
        assert_same_drawing(data, again)
    first, second = read_svg(data, "x", how).design, read_svg(again, "x", how).design
    assert first.extra == second.extra
    assert looks(first) == looks(second)


def looks(what):
    """The styles of the paths of a design, one after the other."""
    style = [
        (s.style.color, round(s.style.width or 0.0, 9), s.visible) for s in what.shapes.values()
    ]
    return [look for look, _ in groupby(style)]


@pytest.mark.parametrize("how", ["segments", "paths"])
def test_a_path_with_every_command_comes_out_as_it_went_in(how):
    data = path_svg(EVERY_COMMAND)
    assert_same_drawing(data, rewritten(data, how))


@pytest.mark.parametrize("how", ["segments", "paths"])
def test_basic_shapes_under_transforms_come_out_as_they_went_in(how):
    data = svg(
        '<g transform="translate(9) rotate(30) scale(1 -2)" stroke="black">',
        '<rect x="5" y="6" width="30" height="20" rx="8" ry="4"/><circle cx="5" cy="5" r="9"/>',
        '<ellipse cx="50" cy="20" rx="20" ry="5"/><line x1="0" y1="0" x2="9" y2="5"/>',
        '<polyline points="1,2 3,4 8,1"/><polygon points="1,2 3,4 8,1"/></g>',
        attributes='viewBox="-20 -30 200 100" width="500" height="90"',
    )
    assert_same_drawing(data, rewritten(data, how))


def test_degrees_up_to_three_come_out_as_they_are():
    lines = path_svg("M 0.1 0.2 L 3 4 Q 5.3 6 7 8 C 9 1 1 2 3 3.3")
    (path,) = paths_of(rewritten(lines))
    assert path.get("d") == "M0.1 0.2 L3 4 Q5.3 6 7 8 C9 1 1 2 3 3.3"


@pytest.mark.parametrize("how", ["segments", "paths"])
def test_a_second_time_nothing_changes_any_more(how):
    data = svg(
        f'<path d="{EVERY_COMMAND}" stroke="red"/><circle r="5" fill="blue"/>',
        '<path id="a b" display="none" d="M 0 0 L 1 1"/>',
    )
    once = rewritten(data)
    assert rewritten(once, how) == once


def random_curves():
    """Plane curves of every family with random lines."""
    row = st.tuples(st.integers(-100, 100), st.integers(-100, 100))
    weight = st.floats(0.2, 5.0)

    def curve(size):
        bases = st.sampled_from(
            [
                Bernstein(size),
                BSpline(size, 2),
                BSpline(size, min(3, size)),
                BSpline(size, size),
                BSpline(size, 3, closed=True),
                BSpline(size, 4, closed=True),
                RationalGaussian.of_size(size),
                RationalGaussian(size, 0.6 / size, closed=True),
            ]
        )
        weights = st.none() | st.lists(weight, min_size=size, max_size=size)
        rows = st.lists(row, min_size=size, max_size=size)
        return st.builds(
            lambda basis, points, directions, weights, s: PlusCurve(
                basis, ControlLines.of(points, directions, weights), s
            ),
            bases,
            rows,
            rows,
            weights,
            st.floats(-3.0, 3.0),
        )

    return st.integers(2, 8).flatmap(curve)


@settings(max_examples=30, deadline=None)
@given(random_curves())
def test_a_curve_of_any_family_is_met_within_a_ten_millionth_of_its_size(curve):
    points = curve.at(np.linspace(0.0, 1.0, 41))
    size = np.ptp(points, axis=0).max()
    chain = [raised(piece) for piece in chain_of(curve)]
    if size > 1e-3:
        assert distances(points, np.array(chain)).max() <= 1e-7 * size


def raised(points):
    """A line or quadratic as a cubic."""
    while len(points) < 4:
        n = len(points)
        share = np.arange(1, n)[:, None] / n
        points = np.vstack(
            [points[:1], share * points[:-1] + (1 - share) * points[1:], points[-1:]]
        )
    return points


@settings(max_examples=20, deadline=None)
@given(random_curves())
def test_the_pieces_of_a_curve_touch(curve):
    chain = chain_of(curve)
    for before, after in pairwise(chain):
        assert_allclose(before[-1], after[0], atol=1e-12)


def test_a_smooth_curve_has_no_kinks_in_its_copy():
    curve = PlusCurve(BSpline(5, 4), ControlLines.of(POINTS), 3.0)
    chain = [raised(piece) for piece in chain_of(curve)]
    for before, after in pairwise(chain):
        arriving, leaving = before[3] - before[2], after[1] - after[0]
        turn = arriving[0] * leaving[1] - arriving[1] * leaving[0]
        assert abs(turn) < 1e-9 * np.linalg.norm(arriving) * np.linalg.norm(leaving)


def test_a_kink_stays_where_it_is():
    knots = (0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0)
    curve = PlusCurve(BSpline(5, 3, knots=knots), ControlLines.of(POINTS), 0.0)
    assert any((piece[-1] == POINTS[2]).all() for piece in chain_of(curve))


def test_a_quarter_circle_takes_few_cubics():
    curve = read_svg(path_svg("M 10 0 A 10 10 0 0 1 0 10"), "x").design.shapes["path-1"].curve
    assert len(chain_of(curve)) <= 6


def test_a_straight_curve_is_one_line():
    assert [len(p) for p in chain_of(bezier(np.array([[0.0, 0], [1, 2]]), s=0.5))] == [2]


def test_closed_curves_end_with_z():
    ring = PlusCurve(BSpline(5, 3, closed=True), ControlLines.of(POINTS), 2.0)
    first, second = written(design(ring=ring, bow=bezier()))
    assert first.get("d").endswith("Z")
    assert "Z" not in second.get("d")


def test_color_width_name_and_id_are_written():
    shape = Shape(bezier(), "The <bow>", style=Style("#12ab34", 2.5))
    (path,) = written(replace(Design({"bow": shape}), extra={"svg": {"viewBox": [0, 0, 9, 9]}}))
    assert (path.get("stroke"), path.get("stroke-width")) == ("#12ab34", "2.5")
    assert path.get("fill") == "none"
    assert path.get("id") == "bow"
    assert path.find(SVG + "title").text == "The <bow>"


def test_a_color_left_to_the_theme_is_left_to_whoever_shows_the_drawing():
    data = write_svg(design(bow=bezier()))
    assert paths_of(data)[0].get("stroke") == "currentColor"
    assert all(s.style.color is None for s in read_svg(data, "x").design.shapes.values())


def test_ids_become_names_that_xml_allows_and_stay_unique():
    names = ["a b", "a_b", "7", "", 'x"<&>', "größe", "a b\x00"]
    paths = written(design(**{name: bezier() for name in names}))
    ids = [path.get("id") for path in paths]
    assert ids == ["a_b", "a_b-2", "_7", "_", "x____", "größe", "a_b_"]


def test_hidden_shapes_stay_hidden():
    data = write_svg(Design({"bow": Shape(bezier(), "bow", visible=False)}))
    assert paths_of(data)[0].get("display") == "none"
    assert not next(iter(read_svg(data, "x").design.shapes.values())).visible


def test_without_a_frame_the_drawing_is_framed_and_widths_are_pixels_of_it():
    root = ElementTree.fromstring(write_svg(design(bow=bezier())))
    x, y, width, height = (float(n) for n in root.get("viewBox").split())
    points = bezier().at(np.linspace(0.0, 1.0, 99)) * (1.0, -1.0)
    assert (points > (x, y)).all()
    assert (points < (x + width, y + height)).all()
    pixels = float(root.get("width")) / width
    assert float(written(design(bow=bezier()))[0].get("stroke-width")) * pixels == pytest.approx(2)


def test_segments_of_a_path_are_one_filled_path_again():
    data = svg('<path id="a" d="M0 0H9V9Z M3 2h1v1Z" fill="#00ff00" fill-rule="evenodd"/>')
    (path,) = paths_of(rewritten(data))
    assert path.get("d") == "M0 0 L9 0 L9 9 Z M3 2 L4 2 L4 3 Z"
    assert (path.get("fill"), path.get("fill-rule")) == ("#00ff00", "evenodd")
    assert (path.get("stroke"), path.get("id")) == (None, "a")


def test_a_path_of_which_a_segment_is_gone_is_not_filled_but_drawn():
    data = svg('<path id="a" d="M0 0H9V9Z" fill="#00ff00"/>')
    (path,) = written(read_svg(data, "x").design.without("a-2"))[:1]
    assert path.get("fill") == "none"
    assert path.get("stroke") == "currentColor"


def test_a_segment_that_was_moved_away_leaves_the_path_open():
    data = svg('<path id="a" d="M0 0H9V9Z" stroke="red" fill="none"/>')
    loaded = read_svg(data, "x").design
    shape = loaded["a-2"]
    lines = shape.curve.lines
    moved = replace(shape.curve, lines=lines.with_points(lines.points + 1.0))
    (path,) = written(loaded.with_curve("a-2", moved))
    assert path.get("d").count("M") == 3
    assert "Z" not in path.get("d")


def test_a_segment_of_another_color_stands_apart():
    data = svg('<path id="a" d="M0 0H9V9Z" stroke="red"/>')
    loaded = read_svg(data, "x").design
    blue = replace(loaded["a-2"], style=Style("#0000ff", 1.0))
    paths = written(loaded.with_shape("a-2", blue))
    assert [path.get("stroke") for path in paths] == ["#ff0000", "#0000ff", "#ff0000"]
    assert len({path.get("id") for path in paths}) == 3


def test_caps_dashes_and_opacities_are_kept():
    data = svg(
        '<path d="M0 0H9" stroke="red" stroke-width="2" stroke-linecap="round" opacity=".5"',
        ' stroke-linejoin="bevel" stroke-dasharray="3 1" stroke-opacity="25%"/>',
        attributes='viewBox="0 0 10 10" width="20" height="20"',
    )
    (path,) = paths_of(rewritten(data))
    kept = ["stroke-width", "stroke-linecap", "stroke-linejoin", "stroke-dasharray"]
    assert [path.get(name) for name in kept] == ["2", "round", "bevel", "3 1"]
    assert (path.get("opacity"), path.get("stroke-opacity")) == ("0.5", "0.25")


def test_shapes_without_a_curve_are_left_out_and_it_is_said():
    sail, knee = Shape(a_surface(), "sail"), Shape(a_mesh(), "knee")
    what = Design({"sail": sail, "bow": Shape(bezier(), "bow"), "jib": sail, "knee": knee})
    data = write_svg(what)
    assert len(paths_of(data)) == 1
    assert left_out(what) == ("Left out: 2 surfaces and 1 mesh, as a drawing has curves alone.",)
    assert left_out(what)[0] in data.decode()


def test_space_curves_are_seen_from_above_and_it_is_said():
    space = np.column_stack([POINTS, np.arange(5.0)])
    what = design(bow=bezier(space))
    assert "from above" in left_out(what)[0]
    flat = bezier(POINTS)
    flat = replace(flat, lines=flat.lines.with_directions(bezier(space).directions[:, :2]))
    assert_allclose(chain_of(bezier(space))[0], chain_of(flat)[0], atol=1e-12)


def test_an_empty_design_is_an_empty_drawing():
    assert not written(Design())


@pytest.mark.parametrize(
    "extra",
    [
        {"svg": 5},
        {"svg": {"viewBox": "x", "width": 7}},
        {"svg": {"viewBox": [0, 0, 0, 0]}},
        {"svg": {"viewBox": [0, 0, "1", None]}},
    ],
)
def test_a_frame_that_is_none_does_no_harm(extra):
    assert len(written(replace(design(bow=bezier()), extra=extra))) == 1


@pytest.mark.parametrize(
    "extra",
    [
        {"svg": 1, "style": 2},
        {"svg": {"path": "a", "at": "x", "of": None}},
        {"style": {"fill": ["red"], "dashes": ["x", 3], "opacity": None}},
    ],
)
def test_keys_of_a_shape_that_say_nothing_do_no_harm(extra):
    shape = Shape(bezier(), "bow", extra=extra)
    assert len(written(Design({"bow": shape, "again": shape}))) == 2


@every_file
def test_a_drawing_kept_as_a_design_comes_out_the_same(file):
    drawn = read_svg(file.read_bytes(), "x").design
    if len(drawn) < 500:
        assert write_svg(loads(dumps(drawn), "x").design) == write_svg(drawn)
