"""Files that are no drawings, or mean harm: one sentence, and soon."""

import tracemalloc

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plusedit.io import svg_figures, svg_paths
from plusedit.io.formats import FormatError, formats
from plusedit.io.svg_reading import LARGEST_FILE, read_svg
from plusedit.io.svg_tree import DEEPEST
from plusedit.io.svg_writing import write_svg
from tests.io.svg_drawings import FOLDER, path_svg, svg

LINE = '<path id="a" d="M 0 0 L 1 1" stroke="red"/>'
BILLION = "".join(f'<!ENTITY e{i} "{f"&e{i - 1};" * 10}">' for i in range(1, 12))


def refusal(data):
    """The sentence that a file is refused with."""
    with pytest.raises(FormatError) as caught:
        read_svg(data, "bad.svg")
    sentence = str(caught.value)
    assert sentence.startswith("bad.svg: ")
    assert "\n" not in sentence
    return sentence


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"", "is not whole XML"),
        (b"\x89PNG\r\n\x1a\n", "is not whole XML"),
        (b"<svg", "is not whole XML"),
        (svg(LINE)[:-3], "is not whole XML"),
        (b"\xff\xfe\xfd" + svg(LINE), "is not whole XML"),
        (svg('<path d="M 0 0 L 1 1" id="\xe9"/>').replace(b"\xc3", b""), "is not whole XML"),
        (b"<html><body/></html>", "not an SVG drawing"),
        (b"<?xml version='1.0' encoding='x-nonsense'?>" + svg(LINE), "XML"),
        (svg(), "holds no path or basic shape"),
        (svg("<text>only words</text>"), "holds no path or basic shape"),
        (path_svg("L 1 1"), "a path begins with M"),
        (
            svg('<g transform="scale(1e200)"><g transform="scale(1e200)">' + LINE + "</g></g>"),
            "path",
        ),
        (b"<!DOCTYPE svg [<!ENTITY e0 'ha'>" + BILLION.encode() + b"]>" + svg("&e11;"), "entity"),
    ],
)
def test_what_is_no_drawing_is_refused_in_a_sentence(data, says):
    assert says in refusal(data)


def test_an_entity_of_another_file_is_not_opened(tmp_path):
    secret = tmp_path / "secret"
    secret.write_text("M 0 0 L 77 77")
    head = f"<!DOCTYPE svg [<!ENTITY x SYSTEM '{secret.as_uri()}'>]>".encode()
    assert "XML" in refusal(head + svg("<title>&x;</title>", LINE, "<path d='&x;'/>"))


def test_short_entities_are_followed_as_drawing_programs_write_them():
    head = b"<!DOCTYPE svg [<!ENTITY ns 'http://www.w3.org/2000/svg'>]>"
    data = head + b"<svg xmlns='&ns;'>" + LINE.encode() + b"</svg>"
    assert len(read_svg(data, "x").design) == 1


def test_elements_nested_too_deep_are_refused():
    assert "nested deeper" in refusal(svg("<g>" * DEEPEST, LINE, "</g>" * DEEPEST))


def test_a_million_brackets_are_refused_soon():
    assert refusal(b"<" * 1_000_000)
    assert "nested deeper" in refusal(svg("<g>" * 1_000_000))


def test_a_file_too_large_is_refused_unread():
    tracemalloc.start()
    assert "larger than" in refusal(bytes(LARGEST_FILE + 1))
    assert tracemalloc.get_traced_memory()[1] < 2 * LARGEST_FILE
    tracemalloc.stop()


def test_uses_that_run_in_a_circle_end():
    circle = (
        '<g id="g"><use href="#h"/></g><g id="h"><use href="#g"/></g><use href="#self" id="self"/>'
    )
    loaded = read_svg(svg(circle, LINE), "x")
    assert len(loaded.design) == 1
    assert any("use" in note for note in loaded.notes)


def test_uses_that_double_twenty_times_over_are_refused(monkeypatch):
    assert svg_figures.MOST_VISITS < 2**20
    monkeypatch.setattr(svg_figures, "MOST_VISITS", 2000)
    uses = "".join(
        f'<g id="g{i}"><use href="#g{i - 1}"/><use href="#g{i - 1}"/></g>' for i in range(1, 21)
    )
    assert "draws more than" in refusal(
        svg(f'<defs><g id="g0">{LINE}</g>{uses}</defs><use href="#g20"/>')
    )


def test_long_styles_and_colors_are_read_soon():
    long = "x" * 200_000
    data = svg(f"<style>{long}</style><style>{'{' * 100_000}</style>", LINE.replace("red", long))
    assert read_svg(data, "x").design["a"].style.color == "#000000"


def test_coordinates_too_large_to_calculate_with_are_left_out_with_a_note():
    far = f'<g transform="scale(1e200)"><g transform="scale(1e200)">{LINE}</g></g>'
    loaded = read_svg(svg(far, LINE), "x")
    assert len(loaded.design) == 1
    assert any("large" in note or "beyond" in note or "finite" in note for note in loaded.notes)


@pytest.mark.parametrize(
    "name", ["svg_bad_numbers.svg", "svg_no_paths.svg", "svg_truncated.svg", "png_renamed.obj"]
)
def test_the_broken_files_are_refused_in_a_sentence(name):
    file = FOLDER / "broken" / name
    if not file.is_file():
        pytest.skip("no real files here")
    refusal(file.read_bytes())


@settings(max_examples=50, deadline=None)
@given(
    st.text(alphabet="MLCQAZmlcqaz0123456789.-e, ", max_size=60),
    st.text(alphabet="matrixscle(),-0123456789. ", max_size=30),
    st.text(alphabet="rgb#url(0,123%) -e", max_size=20),
)
def test_whatever_stands_in_a_path_it_is_read_and_written_or_refused(data, transform, paint):
    drawing = path_svg(data, f'transform="{transform}" stroke="{paint}" stroke-width="{paint}"')
    try:
        loaded = read_svg(drawing, "x.svg")
    except FormatError:
        return
    assert read_svg(write_svg(loaded.design), "y.svg").design


@settings(max_examples=50, deadline=None)
@given(st.data())
def test_a_drawing_with_a_few_bytes_changed_is_read_or_refused(data):
    good = bytearray(svg(LINE, '<g transform="rotate(30)"><circle r="5" fill="url(#a)"/></g>'))
    for _ in range(data.draw(st.integers(1, 4))):
        good[data.draw(st.integers(0, len(good) - 1))] = data.draw(st.integers(0, 255))
    try:
        read_svg(bytes(good), "x.svg")
    except FormatError as error:
        assert str(error).startswith("x.svg: ")


def test_the_format_is_on_the_shelf():
    assert formats["svg"].suffixes == (".svg",)
    assert not formats["svg"].keeps_all
    loaded = formats["svg"].read(svg(LINE), "x.svg")
    assert b"<path" in formats["svg"].write(loaded.design)


@pytest.mark.parametrize(
    "data",
    [
        path_svg("M0 0" + "h1" * 2001),
        path_svg("M0 0 h" + "1 " * 2001),
        path_svg("M0 0" * 2001),
        svg(f'<polyline points="{"1 " * 4002}"/>'),
        svg('<rect width="1" height="1"/>' * 501),
    ],
    ids=["commands", "numbers", "moves", "points", "shapes"],
)
def test_drawings_of_too_many_lines_are_refused(data, monkeypatch):
    monkeypatch.setattr(svg_paths, "MOST_PIECES", 2000)
    monkeypatch.setattr(svg_figures, "MOST_PIECES", 2000)
    assert "draws more than" in refusal(data)
