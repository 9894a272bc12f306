"""Figures as files: PDF of vectors on a page of the right size, PNG that knows its size."""

import re
import zlib
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.scene.figure import FigureForm
from plusedit.scene.figure_composition import plane_figure
from plusedit.scene.items import Markers
from plusedit.views.figure_files import check_resolution, figure_file
from tests.scene.test_figure import PLANE

pytestmark = pytest.mark.gui


def points_of(data):
    """Width and height of the page of a PDF file, in millimeters."""
    (box,) = re.findall(rb"/MediaBox \[0 0 ([0-9.]+) ([0-9.]+) *\]", data)
    return [float(side) * 25.4 / 72.0 for side in box]


def streams_of(data):
    """What the streams of a PDF file hold, unpacked where they can be."""
    for stream in re.findall(rb"stream\r?\n(.*?)endstream", data, re.DOTALL):
        try:
            yield zlib.decompress(stream)
        except zlib.error:
            yield stream


@pytest.mark.parametrize("width", [60.0, 85.0, 123.4])
def test_a_pdf_is_one_page_as_large_as_the_figure(qapp, width):
    figure = plane_figure(PLANE, FigureForm(width))
    data = figure_file(figure, ".pdf", 300.0, "Arc")
    assert data.startswith(b"%PDF-") and data.rstrip().endswith(b"%%EOF")
    assert len(re.findall(rb"/Type /Page\b", data)) == 1
    assert_allclose(points_of(data), figure.size, atol=0.1)
    assert points_of(data)[0] == pytest.approx(width, abs=0.1)


def test_square_marks_of_a_pdf_are_areas(qapp):
    """Points with square caps have no direction, and are nothing in a PDF."""
    square = Markers(np.array([[0.5, 0.5]]), "square", 9.0, "line", "canvas", 1.0)
    figure = plane_figure(PLANE, FigureForm())
    squares, none = (
        [*streams_of(figure_file(replace(figure, flat=flat), ".pdf", 300.0))]
        for flat in ((square,), ())
    )
    assert sum(stream.count(b"2 J") for stream in squares) == sum(
        stream.count(b"2 J") for stream in none
    )
    assert sum(map(len, squares)) > sum(map(len, none))


def test_the_places_of_objects_in_a_pdf_are_right(qapp):
    data = figure_file(plane_figure(PLANE, FigureForm()), ".pdf", 300.0)
    start = int(re.findall(rb"startxref\s+(\d+)", data)[-1])
    assert data[start : start + 4] == b"xref"
    places = re.findall(rb"^(\d{10}) 00000 n", data[start:], re.MULTILINE)
    for number, place in enumerate(places, 1):
        assert data[int(place) :].startswith(f"{number} 0 obj".encode())


def test_a_pdf_of_the_plane_is_vectors_and_embedded_fonts(qapp):
    data = figure_file(plane_figure(PLANE, FigureForm()), ".pdf", 300.0)
    assert not re.search(rb"/Subtype\s*/Image", data)
    assert b"/FontFile" in data
    assert any(b" Tj" in stream or b" TJ" in stream for stream in streams_of(data))


def test_a_png_knows_how_large_it_is_in_print(qapp):
    figure = plane_figure(PLANE, FigureForm())
    data = figure_file(figure, ".png", 600.0)
    width, height = (int.from_bytes(data[at : at + 4]) for at in (16, 20))
    assert (width, height) == tuple(round(side / 25.4 * 600.0) for side in figure.size)
    at = data.index(b"pHYs") + 4
    across, down = (int.from_bytes(data[at + i : at + i + 4]) for i in (0, 4))
    assert data[at + 8] == 1  # to a metre
    assert_allclose((across, down), 600.0 / 0.0254, atol=1.0)


def test_a_figure_of_too_many_pixels_is_refused_in_a_sentence(qapp):
    figure = plane_figure(PLANE, FigureForm(2000.0))
    with pytest.raises(ValueError, match=r"million are the most\.$"):
        check_resolution(2000.0, 2400.0, 1500.0)
    with pytest.raises(ValueError, match=r"pixels to an inch\.$"):
        figure_file(figure, ".png", 1.0)
