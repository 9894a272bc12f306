"""SVG drawings as designs: what is drawn, where, and how it looks."""

from itertools import groupby

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.shape import Style
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.io.svg_cubics import chain_of
from plusedit.io.svg_frames import UPWARDS, frame_in
from plusedit.io.svg_lengths import IDENTITY, joined, length
from plusedit.io.svg_reading import read_svg
from tests.io.svg_drawings import (
    curves_of,
    every_file,
    path_svg,
    samples,
    segments_by_another_reader,
    svg,
)

T = np.linspace(0.0, 1.0, 33)
F = np.linspace(0.0, 1.0, 5)


def read(*lines, **options):
    return read_svg(svg(*lines), "drawing.svg", **options)


def shapes(*lines, **options):
    return list(read(*lines, **options).design.shapes.values())


def only(*lines, **options):
    (shape,) = shapes(*lines, **options)
    return shape


def ends(shape):
    """Start and end in the units of the drawing, y down."""
    return (shape.curve.at([0.0, 1.0]) * (1.0, -1.0)).tolist()


LINE = '<line x1="1" y1="2" x2="3" y2="5" stroke="red"/>'


def to_pixels(frame):
    """The map from the world to pixels of the drawing at its own size."""
    if frame.view_box is None:
        return UPWARDS
    box = frame.view_box
    sides = length(frame.width, box.width), length(frame.height, box.height)
    return joined(box.fitted(*sides, frame.aspect), UPWARDS)


@every_file
def test_every_segment_of_a_real_file_is_where_another_reader_sees_it(file):
    data = file.read_bytes()
    design = read_svg(data, file.name).design
    matrix = to_pixels(frame_in(design.extra))
    theirs = [s for path in segments_by_another_reader(data) for s in path]
    theirs = [(samples(s, 5), type(s).__name__ == "Arc") for s in theirs]
    # The other reader takes a millimeter for 3.7795296 pixels: 5e-7 too many.
    close = 1e-6 * np.ptp(np.vstack([points for points, _ in theirs]), axis=0).max()
    ours = [c.at(F) @ matrix[:, :2].T + matrix[:, 2] for c in curves_of(design)]
    for points, is_arc in theirs:
        found = [ours.pop(0)]
        while np.abs(found[-1][-1] - points[-1]).max() > close:
            found.append(ours.pop(0))
        assert_allclose(found[0][0], points[0], atol=close)
        if not is_arc:
            assert_allclose(found[0], points, atol=close)
    assert not ours


@every_file
def test_a_whole_path_of_a_real_file_is_the_chain_of_its_segments(file):
    data = file.read_bytes()
    segments = read_svg(data, "x").design.shapes.values()
    paths = read_svg(data, "x", "paths").design.shapes.values()
    chains = [list(group) for _, group in groupby(segments, key=outline)]
    for shape, parts in zip(paths, chains, strict=True):
        if shape.curve.lines.weights is not None:
            continue
        chain = [piece for part in parts for piece in chain_of(part.curve)]
        close = 1e-12 * np.abs(np.vstack(chain)).max()
        for piece, segment in zip(chain_of(shape.curve), chain, strict=True):
            assert_allclose(piece, segment, atol=close)


def outline(shape):
    """What the shapes of one outline have in common."""
    place = shape.extra["svg"]
    return place["path"], place["part"]


def test_the_y_axis_points_upwards_in_a_design():
    assert_allclose(only(LINE).curve.at([0.0, 1.0]), [[1.0, -2.0], [3.0, -5.0]])


@pytest.mark.parametrize(
    ("data", "count"),
    [("M 0 0 L 9 3", 2), ("M 0 0 Q 5 9 9 0", 2), ("M 0 0 C 1 9 8 9 9 0", 3)],
)
def test_a_segment_of_degree_n_has_n_control_lines_a_line_two(data, count):
    shape = only(f'<path d="{data}"/>')
    assert shape.curve.basis == Bernstein(count)
    assert shape.curve.lines.weights is None


def test_a_cubic_segment_is_exact():
    curve = only('<path d="M 0 0 C 1 9 8 7 9 0"/>').curve
    q = np.array([[0, 0], [1, -9], [8, -7], [9, 0]])
    b = np.stack([(1 - T) ** 3, 3 * T * (1 - T) ** 2, 3 * T**2 * (1 - T), T**3], axis=1)
    assert_allclose(curve.at(T), b @ q, atol=1e-14)


@pytest.mark.parametrize("how", ["segments", "paths"])
def test_a_circle_is_exact(how):
    found = shapes('<circle cx="50" cy="40" r="30"/>', how=how)
    points = np.vstack([shape.curve.at(T) for shape in found])
    assert_allclose(np.linalg.norm(points - (50.0, -40.0), axis=1), 30.0, rtol=1e-14)
    assert len(found) == (4 if how == "segments" else 1)


def test_a_rounded_rectangle_is_one_exact_curve_when_asked_for():
    found = only('<rect x="10" y="10" width="60" height="40" rx="10"/>', how="paths")
    corner = found.curve.at(np.linspace(0.0, 1.0, 801)) * (1.0, -1.0)
    corner = corner[(corner[:, 0] > 60.0) & (corner[:, 1] < 20.0)]
    assert_allclose(np.linalg.norm(corner - (60.0, 20.0), axis=1), 10.0, rtol=1e-12)
    assert found.curve.lines.weights is not None


def test_arcs_beside_cubics_become_cubics_within_what_the_notes_say():
    data = '<path d="M 0 0 C 5 9 9 9 10 0 A 20 20 0 0 1 40 0"/>'
    loaded = read(data, how="paths")
    exact = shapes(data)[1].curve.at(T)
    fine = curves_of(loaded.design)[0].at(np.linspace(0.0, 1.0, 20001))
    gaps = np.linalg.norm(exact[:, None] - fine, axis=2).min(axis=1)
    assert gaps.max() < 2e-3  # of samples that are 4e-3 apart
    assert any("1e-07" in note for note in loaded.notes)


def test_a_whole_path_keeps_its_corners_exactly():
    data = "M 0 0 L 10 0 C 12 5 15 5 20 0 Q 25 9 30 0 Z"
    pieces = shapes(f'<path d="{data}"/>')
    whole = only(f'<path d="{data}"/>', how="paths").curve
    knots = np.unique(whole.basis.knots)
    assert len(knots) == len(pieces) + 1
    for piece, a, b in zip(pieces, knots[:-1], knots[1:], strict=True):
        assert_allclose(whole.at(a + (b - a) * T), piece.curve.at(T), atol=1e-12)


def test_transforms_of_groups_come_before_those_of_their_elements():
    found = only(f'<g transform="translate(10 20)"><g transform="scale(2, 3)">{LINE}</g></g>')
    assert_allclose(ends(found), [[12.0, 26.0], [16.0, 35.0]])


@pytest.mark.parametrize(
    ("transform", "end"),
    [
        ("matrix(1 2 3 4 5 6)", [23.0, 32.0]),
        ("rotate(90)", [-5.0, 3.0]),
        ("rotate(90, 1, 2)", [-2.0, 4.0]),
        ("translate(5)", [8.0, 5.0]),
        ("scale(-1,2)", [-3.0, 10.0]),
        ("skewX(45)", [8.0, 5.0]),
        ("skewY(45)", [3.0, 8.0]),
        ("translate(1,1) scale(2),rotate(180)", [-5.0, -9.0]),
        ("", [3.0, 5.0]),
    ],
)
def test_every_kind_of_transform_is_known(transform, end):
    found = only(f'<g transform="{transform}">{LINE}</g>')
    assert_allclose(ends(found)[1], end, atol=1e-12)


@pytest.mark.parametrize("transform", ["matrix(1 2)", "matrix(1e999 0 0 1 0 0)", "rotate(" * 9999])
def test_a_transform_that_is_none_is_left_out_with_a_note(transform):
    loaded = read(f'<g id="bad" transform="{transform}">{LINE}</g>')
    assert ends(*loaded.design.shapes.values())[1] == [3.0, 5.0]
    assert any("bad: a transform" in note for note in loaded.notes)


def test_units_and_percentages_are_lengths_in_user_units():
    found = only('<line x1="1in" y1="10%" x2="50%" y2="72pt" stroke="red"/>')
    assert_allclose(ends(found), [[96.0, 10.0], [50.0, 96.0]])


def test_what_is_used_is_drawn_where_it_is_used():
    found = shapes(
        f'<defs><g id="a" transform="scale(2)">{LINE}</g></defs>',
        '<use href="#a" x="10"/><use xlink:href="#a" transform="translate(0 1)"/>',
    )
    assert [ends(shape)[0] for shape in found] == [[12.0, 4.0], [2.0, 5.0]]


def test_a_symbol_fills_the_size_that_its_use_asks_for():
    found = only(
        f'<symbol id="a" viewBox="0 0 10 10">{LINE}</symbol>',
        '<use href="#a" x="20" y="30" width="50" height="50"/>',
    )
    assert_allclose(ends(found), [[25.0, 40.0], [35.0, 55.0]])


def test_a_drawing_inside_a_drawing_has_a_frame_of_its_own():
    found = only(f'<svg x="20" width="50" height="100" viewBox="0 0 10 10">{LINE}</svg>')
    assert_allclose(ends(found), [[25.0, 35.0], [35.0, 50.0]])


@pytest.mark.parametrize("tag", ["defs", "symbol", "clipPath", "mask", "pattern", "marker"])
def test_what_only_serves_others_is_not_drawn(tag):
    assert len(shapes(LINE, f"<{tag}>{LINE}</{tag}>")) == 1


@pytest.mark.parametrize(
    "attribute",
    ['display="none"', 'style="display:none"', 'opacity="0"', 'visibility="hidden"'],
)
def test_what_does_not_show_is_read_as_hidden(attribute):
    loaded = read(f"<g {attribute}>{LINE}</g>")
    (shape,) = loaded.design.shapes.values()
    assert not shape.visible
    assert any("hidden" in note for note in loaded.notes)


def test_what_is_made_visible_again_inside_shows():
    line = LINE.replace("/>", ' visibility="visible"/>')
    assert only(f'<g visibility="hidden">{line}</g>').visible


def test_what_is_neither_filled_nor_stroked_is_hidden():
    assert not only('<path d="M 0 0 L 1 1" fill="none"/>').visible


def test_color_and_width_of_the_stroke_are_kept():
    shape = only('<path d="M 0 0 L 1 1" stroke="#1a2b3c" stroke-width="2.5"/>')
    assert shape.style == Style("#1a2b3c", 2.5)


@pytest.mark.parametrize(
    ("color", "kept"),
    [("red", "#ff0000"), ("rgb(10, 20,30)", "#0a141e"), ("#abc", "#aabbcc")],
)
def test_colors_are_written_in_one_way(color, kept):
    assert only(LINE.replace("red", color)).style.color == kept


def test_a_color_left_to_whoever_shows_the_drawing_is_the_theme_s():
    assert only(LINE.replace("red", "currentColor")).style == Style(None, 1.0)


def test_a_current_color_that_is_given_is_taken():
    line = LINE.replace("red", "currentColor")
    assert only(f'<g color="blue">{line}</g>').style.color == "#0000ff"


def test_strokes_grow_with_transforms_unless_they_do_not_scale():
    line = LINE.replace("/>", ' stroke-width="2"/>')
    fixed = line.replace("/>", ' vector-effect="non-scaling-stroke"/>')
    grown, same = shapes(f'<g transform="scale(2, 8)">{line}{fixed}</g>')
    assert grown.style.width == pytest.approx(8.0)
    assert same.style.width == 2.0


def test_widths_are_those_of_the_drawing_at_its_own_size():
    data = svg(LINE, attributes='viewBox="0 0 10 10" width="40mm" height="40mm"')
    (shape,) = read_svg(data, "x").design.shapes.values()
    assert shape.style.width == pytest.approx(40 / 25.4 * 96 / 10)


def test_styles_win_over_rules_and_rules_over_attributes():
    sheet = "<style>/* a } */ .thin, #b { stroke: lime } line.thin{stroke:blue} g .x{}</style>"
    plain = LINE.replace("<line", '<line class="x thin"')
    styled = plain.replace("<line", '<line style="stroke: #010203 !important"')
    found = shapes(sheet, plain, styled, LINE.replace("<line", '<line id="b"'))
    assert [s.style.color for s in found] == ["#0000ff", "#010203", "#00ff00"]


def test_the_fill_is_kept_beside_the_style():
    shape = only('<path d="M 0 0 L 1 1 0 5Z" fill="#ff8000" fill-rule="evenodd"/>', how="paths")
    assert shape.style == Style()
    assert shape.extra["style"] == {"fill": "#ff8000", "stroke": "none", "fill-rule": "evenodd"}


def test_a_gradient_counts_as_its_first_color():
    gradient = '<linearGradient id="g"><stop stop-color="teal"/><stop/></linearGradient>'
    other = '<radialGradient id="h" xlink:href="#g"/>'
    loaded = read(gradient, other, '<circle r="3" fill="url(#h)"/>', how="paths")
    (shape,) = loaded.design.shapes.values()
    assert shape.extra["style"]["fill"] == "#008080"
    assert "1 gradient or pattern was replaced by one color." in loaded.notes


def test_shapes_are_named_after_the_label_the_title_or_the_id():
    label = 'xmlns:i="http://www.inkscape.org/namespaces/inkscape" i:label="Rim"'
    titled = '<path id="p2" d="M 0 0 L 1 1"><title>The hub</title></path>'
    found = read(
        f'<path {label} d="M 0 0 L 1 1"/>', titled, '<path id="p3" d="M0 0 1 1"/>', LINE, LINE
    ).design
    names = [shape.name for shape in found.shapes.values()]
    assert names == ["Rim", "The hub", "p3", "line 1", "line 2"]
    assert list(found) == ["Rim", "p2", "p3", "line-1", "line-2"]


def test_segments_are_numbered_within_their_path():
    found = read('<path id="bow" d="M 0 0 L 1 1 2 0 Z"/>').design
    names = [shape.name for shape in found.shapes.values()]
    assert names == ["bow · segment 1", "bow · segment 2", "bow · segment 3"]
    assert list(found) == ["bow-1", "bow-2", "bow-3"]


def test_ids_are_unique_even_where_those_of_the_file_are_not():
    twice = '<path id="a" d="M 0 0 L 1 1"/><path id="a" d="M 0 0 L 1 1"/>'
    assert list(read(twice, '<path id="a-2" d="M 0 0 L 1 1"/>').design) == ["a", "a-2", "a-2-2"]


def test_pieces_of_no_length_are_left_out_with_a_note():
    loaded = read('<path d="M 0 0 L 0 0 5 5 C 5 5 5 5 5 5"/>')
    assert len(loaded.design) == 1
    assert any("2 pieces" in note for note in loaded.notes)


def test_texts_and_pictures_are_left_out_with_a_note():
    loaded = read(LINE, "<text>a</text><text>b</text><image/>")
    assert "2 texts were left out." in loaded.notes
    assert "1 picture was left out." in loaded.notes


def test_a_path_with_an_error_is_kept_up_to_it_with_a_note():
    loaded = read('<path id="p" d="M 0 0 L 5 5 L x"/>')
    assert len(loaded.design) == 1
    assert any(note.startswith("p: a number is missing") for note in loaded.notes)


def test_the_frame_is_kept_with_the_design():
    data = svg(LINE, attributes='viewBox="-1 2.5 30 40" width="72pt" preserveAspectRatio="none"')
    assert read_svg(data, "x").design.extra["svg"] == {
        "viewBox": [-1.0, 2.5, 30.0, 40.0],
        "width": "72pt",
        "preserveAspectRatio": "none",
    }


def test_a_drawing_without_a_frame_has_user_units_of_pixels():
    data = svg(LINE, attributes="")
    (shape,) = read_svg(data, "x").design.shapes.values()
    assert ends(shape)[1] == [3.0, 5.0]
    assert shape.style.width == 1.0


def test_the_maps_of_a_drawing_do_the_inner_one_first():
    move, grow = np.array([[1.0, 0, 5], [0, 1, 7]]), np.array([[2.0, 0, 0], [0, 3, 0]])
    assert_allclose(joined(move, grow), [[2, 0, 5], [0, 3, 7]])
    assert_allclose(joined(grow, move), [[2, 0, 10], [0, 3, 21]])
    assert_allclose(joined(IDENTITY, move), move)


def test_path_data_of_one_path_can_be_read_alone():
    assert len(read_svg(path_svg("M 0 0 H 5 V 5"), "x").design) == 2


@pytest.mark.parametrize(
    ("data", "closed"),
    [
        ("M 0 0 C 10 30 40 -20 50 0 S 80 30 90 0", False),
        ("M 0 0 A 30 20 0 1 1 60 0 A 30 20 0 1 1 0 0 Z", True),
        ("M 0 0 H 50 V 50 C 40 80 10 80 0 50 Z", False),
    ],
)
def test_a_fitted_path_is_met_within_the_tolerance_and_keeps_its_corners(data, closed):
    loaded = read(f'<path d="{data}"/>', how="fitted", tolerance=1e-3)
    (curve,) = curves_of(loaded.design)
    exact = np.vstack([s.curve.at(T) for s in shapes(f'<path d="{data}"/>')])
    near = curve.at(np.linspace(0.0, 1.0, 8001))
    size = np.ptp(exact, axis=0).max()
    gaps = np.linalg.norm(exact[:, None] - near, axis=2).min(axis=1)
    assert gaps.max() < 1.2e-3 * size
    assert curve.closed is closed
    assert any("fitted within" in note for note in loaded.notes)


@pytest.mark.parametrize(
    "data",
    [
        # After a corner, and fast: the farthest that few samples lie from each other.
        "M 50 40 q 10 20 20 0 t 20 0 Q 10 80 20 60 T 60 60 L 70 90 l -10 0 Z",
        # Its control points reach far beyond the curve.
        "M -50 50 C -20 -80 20 80 50 -50",
    ],
)
def test_a_fitted_curve_does_not_stray_from_its_path(data):
    exact = np.vstack([s.curve.at(np.linspace(0, 1, 9999)) for s in shapes(f'<path d="{data}"/>')])
    (curve,) = curves_of(read(f'<path d="{data}"/>', how="fitted", tolerance=1e-3).design)
    near = curve.at(np.linspace(0.0, 1.0, 1001))
    gaps = np.array([np.linalg.norm(exact - point, axis=1).min() for point in near])
    assert gaps.max() < 1.1e-3 * np.ptp(exact, axis=0).max()


def test_a_looser_fit_needs_fewer_lines():
    data = '<path d="M 0 0 C 10 30 40 -20 50 0 S 80 30 90 0 S 20 90 0 50"/>'
    tight, loose = (only(data, how="fitted", tolerance=t).curve for t in (1e-5, 1e-2))
    assert len(loose.lines) < len(tight.lines)


def test_what_is_missing_is_counted_in_sentences():
    clipped = '<path d="M0 0L5 5l0 0l0 0l3 0" clip-path="url(#c)"/>'
    loaded = read(f'<clipPath id="c"/>{clipped}{clipped}')
    assert "4 pieces of no length were left out." in loaded.notes
    assert "2 clip paths or masks were left out." in loaded.notes
