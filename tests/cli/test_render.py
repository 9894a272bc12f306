"""`plusedit render` as a person runs it: another process, no display."""

import os
import re
import subprocess
import sys

import numpy as np
import pytest
from PySide6.QtGui import QImage

from plusedit.__main__ import main
from plusedit.resources import example_files
from plusedit.views.gl.functions import OpenGLError

FLAT = example_files()[0]


@pytest.fixture(autouse=True)
def application(qapp):
    """Pictures take the application there is: one without widgets would be in the way later."""


def rendered(*words):
    """The process: without a display, and without a hint that there is none."""
    hidden = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    environment = {key: value for key, value in os.environ.items() if key not in hidden}
    command = [sys.executable, "-m", "plusedit", "render", *map(str, words)]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False)


def test_a_png_picture_needs_no_display(document, tmp_path):
    out = tmp_path / "bow.png"
    run = rendered(document, out, "--size", "320x200", "--theme", "dark")
    assert (run.returncode, run.stdout, run.stderr) == (0, "", "")
    data = out.read_bytes()
    assert data.startswith(b"\x89PNG")
    assert (int.from_bytes(data[16:20]), int.from_bytes(data[20:24])) == (320, 200)


def colors(data):
    """(height, width, 4) red, green, blue and opacity of a PNG file."""
    image = QImage.fromData(data).convertToFormat(QImage.Format.Format_RGBA8888)
    rows = np.frombuffer(image.constBits(), np.uint8)
    return rows.reshape(image.height(), image.width(), 4).astype(int)


@pytest.mark.parametrize("view", ["design", "front", "bottom", "iso"])
def test_a_surface_is_shaded_without_a_display(document, tmp_path, view):
    out = tmp_path / "sail.png"
    run = rendered(document, out, "--view", view, "--size", "320x200", "--transparent")
    assert (run.returncode, run.stdout, run.stderr) == (0, "", "")
    seen = colors(out.read_bytes())
    assert (seen[0, 0] == 0).all()
    shades = {tuple(pixel) for pixel in seen[seen[..., 3] == 255].tolist()}
    assert len(shades) > 50


def test_in_the_plane_a_surface_is_drawn_as_lines(document, tmp_path):
    pictures = [tmp_path / f"{view}.svg" for view in ("2d", "top", "iso")]
    for picture in pictures:
        assert main(["render", str(document), str(picture), "--view", picture.stem]) == 0
    flat, top, iso = (picture.read_bytes() for picture in pictures)
    assert len({flat, top, iso}) == 3
    assert all(b"<polyline" in picture for picture in (flat, top, iso))


def test_a_flat_design_is_seen_from_above_unless_it_is_looked_at_otherwise(tmp_path):
    by_itself, top, front, iso = (tmp_path / f"{name}.svg" for name in "abcd")
    assert main(["render", str(FLAT), str(by_itself)]) == 0
    for picture, view in ((top, "top"), (front, "front"), (iso, "iso")):
        assert main(["render", str(FLAT), str(picture), "--view", view]) == 0
    assert top.read_bytes() == by_itself.read_bytes()
    assert len({front.read_bytes(), iso.read_bytes(), top.read_bytes()}) == 3


def test_without_opengl_a_sentence_says_what_helps(document, tmp_path, capsys, monkeypatch):
    def none(*_arguments, **_options):
        raise OpenGLError("EGL finds no driver")

    monkeypatch.setattr("plusedit.views.space_picture.space_image_of", none)
    out = tmp_path / "sail.png"
    assert main(["render", str(document), str(out)]) == 2
    told = capsys.readouterr().err
    assert "EGL finds no driver" in told
    assert "bash assets/run.sh" in told
    assert told.count("\n") == 1
    assert not out.exists()


def test_an_svg_picture_needs_no_qt(document, tmp_path):
    out = tmp_path / "bow.svg"
    program = (
        "import sys; sys.modules['PySide6'] = None\n"
        "from plusedit.__main__ import main\n"
        f"sys.exit(main(['render', {str(document)!r}, {str(out)!r}, '--transparent']))"
    )
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False
    )
    assert (run.returncode, run.stderr.count("\n")) == (0, 1)
    assert "surfaces are drawn as lines" in run.stderr
    assert b'width="1200" height="800"' in out.read_bytes()


def test_an_svg_file_can_be_what_is_drawn(tmp_path):
    source, out = tmp_path / "line.svg", tmp_path / "again.svg"
    source.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 C 1 2 3 2 4 0"/></svg>'
    )
    assert main(["render", str(source), str(out)]) == 0
    assert b"<polyline" in out.read_bytes()


@pytest.fixture
def hill(tmp_path):
    """A file with a mesh of 8 x 8 quads, one vertex of which stands out."""
    rows = [f"v {x} {y} {2 * (x == y == 4)}" for x in range(9) for y in range(9)]
    for x in range(8):
        first = [9 * x + y + 1 for y in range(8)]
        rows += [f"f {a} {a + 9} {a + 10} {a + 1}" for a in first]
    path = tmp_path / "hill.obj"
    path.write_text("\n".join(rows))
    return path


def test_the_file_of_a_mesh_can_be_what_is_drawn(hill, tmp_path):
    plain, finer = tmp_path / "plain.svg", tmp_path / "mesh.svg"
    assert main(["render", str(hill), str(plain)]) == 0
    assert main(["render", str(hill), str(finer), "--overlay", "mesh"]) == 0
    assert b"<p" in plain.read_bytes()
    assert finer.stat().st_size > plain.stat().st_size


def test_a_mesh_whose_y_points_up_is_shown_upright(hill, tmp_path):
    lying, upright = tmp_path / "lying.svg", tmp_path / "upright.svg"
    assert main(["render", str(hill), str(lying), "--view", "top"]) == 0
    assert main(["render", str(hill), str(upright), "--view", "front", "--up", "y"]) == 0
    width, height = seen_extent(upright)
    assert (width, height) == pytest.approx(seen_extent(lying), rel=0.02)


def seen_extent(picture):
    """Width and height of what an SVG picture shows."""
    numbers = re.findall(r'points="([^"]*)"', picture.read_text())
    assert numbers
    points = np.array(" ".join(numbers).replace(",", " ").split(), dtype=float).reshape(-1, 2)
    return tuple(np.ptp(points, axis=0))


def test_a_mesh_and_its_surface_at_two_levels_stand_side_by_side(hill, tmp_path):
    out, words = tmp_path / "row.png", ["--size", "301x100", "--view", "iso"]
    assert main(["render", str(hill), str(out), *words, "--smoothness", "mesh,0.5,2"]) == 0
    row = colors(out.read_bytes())
    assert row.shape == (100, 301, 4)
    panels = [row[:, start : start + 100] for start in (0, 100, 200)]
    assert all(len(np.unique(panel.reshape(-1, 4), axis=0)) > 20 for panel in panels)
    assert main(["render", str(hill), str(out), "--size", "100x100", "--smoothness", "0.5"]) == 0
    assert np.abs(colors(out.read_bytes()) - panels[1]).max() <= 1
    assert np.abs(panels[0] - panels[1]).max() > 20 < np.abs(panels[1] - panels[2]).max()


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["{design}", "{folder}/out.gif"], "ends with .png, .svg or .pdf"),
        (["{design}", "{folder}/gone/out.svg"], "no folder"),
        (["{folder}/gone.json", "{folder}/out.svg"], "no such file"),
        (["{design}", "{folder}/out.svg", "--size", "0x5"], "WIDTHxHEIGHT"),
        (["{design}", "{folder}/out.svg", "--size", "99999x99999"], "WIDTHxHEIGHT"),
        (["{design}", "{folder}/out.svg", "--size", "wide"], "WIDTHxHEIGHT"),
        (["{design}", "{folder}/out.svg", "--theme", "pink"], "invalid choice"),
        (["{design}", "{folder}/out.svg", "--view", "behind"], "invalid choice"),
        (["{design}", "{folder}/out.svg", "--overlay", "halo"], "no overlay 'halo'"),
        (["{design}", "{folder}/out.svg", "--no-overlay", "halo"], "there are "),
        (["{design}", "{folder}/out.svg", "--smoothness", "mesh,1"], "side by side"),
        (["{design}", "{folder}/out.png", "--smoothness", "0"], "numbers above 0 or mesh"),
        (["{design}", "{folder}/out.png", "--smoothness", "1,nan"], "numbers above 0 or mesh"),
    ],
)
def test_what_can_not_be_done_is_said_in_one_sentence(document, tmp_path, capsys, words, sentence):
    places = {"design": document, "folder": tmp_path}
    assert main(["render", *(word.format(**places) for word in words)]) == 2
    told = capsys.readouterr().err
    assert sentence in told
    assert told.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == [document.name]


def test_a_picture_does_not_take_the_place_of_its_source(tmp_path, capsys):
    source = tmp_path / "line.svg"
    source.write_text('<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0L4 0"/></svg>')
    before = source.read_bytes()
    assert main(["render", str(source), str(source)]) == 2
    assert source.read_bytes() == before


@pytest.mark.parametrize("kind", ["png", "svg"])
def test_a_picture_too_large_for_memory_is_one_line_and_code_2(
    document, tmp_path, capsys, monkeypatch, kind
):
    def too_much(*_arguments, **_options):
        raise MemoryError("Unable to allocate 9.09 TiB")

    monkeypatch.setattr(f"plusedit.cli.render._{kind}", too_much)
    out = tmp_path / f"out.{kind}"
    assert main(["render", str(document), str(out)]) == 2
    told = capsys.readouterr().err
    assert told == f"{document.name}: its picture takes more memory than there is\n"
    assert not out.exists()


def test_overlays_are_added_to_those_of_the_design_and_taken_away(tmp_path):
    (figure,) = (path for path in example_files() if path.stem == "figure_4")

    def drawn(*words):
        out = tmp_path / "out.svg"
        assert main(["render", str(figure), str(out), *words]) == 0
        return out.read_text()

    own = drawn()
    assert drawn("--overlay", "comb", "--overlay", "extrema").count("<text") > own.count("<text")
    assert drawn("--no-overlay", "hulls").count("<polygon") < own.count("<polygon")
    assert drawn("--overlay", "comb", "--no-overlay", "hulls").count("Curvature comb") == 1


@pytest.mark.parametrize("suffix", ["png", "svg"])
def test_copies_for_several_s_stand_side_by_side(tmp_path, suffix):
    figure = next(path for path in example_files() if path.stem == "figure_5")
    out = tmp_path / f"row.{suffix}"
    words = ["render", str(figure), str(out), "--size", "400x200"]
    assert main([*words, "--multiples", "s=0,0.5L,L"]) == 0
    assert out.stat().st_size > 1000
    if suffix == "svg":
        text = out.read_text(encoding="utf-8")
        assert all(f"(b), s = {s}<" in text for s in ("0", "0.5 L", "L"))


def test_values_of_s_that_make_no_sense_are_refused(document, tmp_path, capsys):
    words = ["render", str(document), str(tmp_path / "row.png"), "--multiples", "0,half"]
    assert main(words) == 2
    assert "0.5L" in capsys.readouterr().err
