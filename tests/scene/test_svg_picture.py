"""Pictures of items as SVG, parsed again."""

from xml.etree import ElementTree

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Label, Legend, Markers, Polygon, Polyline, Segments
from plusedit.scene.svg_picture import svg_of
from plusedit.scene.theme import DARK, LIGHT

CAMERA = PlaneCamera(size=(400.0, 300.0), center=(0.0, 0.0), scale=50.0)
SVG = "{http://www.w3.org/2000/svg}"


def picture(*items, theme=LIGHT, **options):
    return ElementTree.fromstring(svg_of(items, CAMERA, theme, **options))


def only(root, tag):
    (element,) = root.iter(SVG + tag)
    return element


def test_a_picture_is_as_large_as_the_view():
    root = picture()
    assert (root.get("width"), root.get("height")) == ("400", "300")
    assert root.get("viewBox") == "0 0 400 300"


def test_the_canvas_of_the_theme_lies_behind_all():
    assert only(picture(theme=DARK), "rect").get("fill") == DARK.color("canvas")


def test_a_transparent_picture_has_no_canvas():
    assert not list(picture(transparent=True).iter(SVG + "rect"))


def test_points_of_the_world_become_pixels_with_y_down():
    line = Polyline(np.array([[0.0, 0.0], [1.0, 2.0]]), "plus", 2.0)
    assert only(picture(line), "polyline").get("points") == "200,150 250,50"


def test_colors_come_from_the_theme_and_opacity_stands_apart():
    line = Polyline(np.array([[0.0, 0.0], [1.0, 2.0]]), "#11223380", 2.0)
    drawn = only(picture(line), "polyline")
    assert drawn.get("stroke") == "#112233"
    assert float(drawn.get("stroke-opacity")) == pytest.approx(0x80 / 255, abs=1e-3)
    assert drawn.get("stroke-width") == "2"


@pytest.mark.parametrize("dash", ["dash", "dot"])
def test_dashes_have_gaps_and_solid_lines_have_none(dash):
    points = np.array([[0.0, 0.0], [1.0, 2.0]])
    assert only(picture(Polyline(points, "line", dash=dash)), "polyline").get("stroke-dasharray")
    assert not only(picture(Polyline(points, "line")), "polyline").get("stroke-dasharray")


def test_an_area_is_filled_and_has_no_outline_of_itself():
    area = Polygon(np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), "union")
    drawn = only(picture(area), "polygon")
    assert drawn.get("fill") == LIGHT.color("union")[:7]
    assert drawn.get("stroke") is None


def test_segments_are_drawn_each_by_itself():
    ends = Segments(np.zeros((3, 2)), np.eye(3)[:, :2], "x")
    assert only(picture(ends), "path").get("d").count("M") == 3


@pytest.mark.parametrize(
    ("mark", "tag"), [("circle", "circle"), ("ring", "circle"), ("square", "polygon")]
)
def test_every_marker_is_drawn(mark, tag):
    marks = Markers(np.array([[0.0, 0.0], [1.0, 1.0]]), mark, 8.0, None, "line")
    assert len(list(picture(marks).iter(SVG + tag))) == 2


def test_a_ring_is_empty_and_a_hollow_circle_filled_with_the_canvas():
    at = np.zeros((1, 2))
    assert only(picture(Markers(at, "ring", 8.0, None, "line")), "g").get("fill") is None
    hollow = only(picture(Markers(at, "circle", 8.0, None, "line")), "g")
    assert hollow.get("fill") == LIGHT.color("canvas")


def test_a_marker_is_as_wide_as_it_says_with_its_outline():
    drawn = only(picture(Markers(np.zeros((1, 2)), "circle", 9.0, None, "line", 2.0)), "circle")
    assert 2.0 * float(drawn.get("r")) + 2.0 == 9.0


def test_a_text_stands_as_it_is_whatever_it_says():
    said = '<b>&"x"</b> \x01é'
    drawn = only(picture(Label(np.zeros(2), said, "text", anchor="center")), "text")
    assert drawn.text == '<b>&"x"</b> é'
    assert drawn.get("text-anchor") == "middle"


def test_a_line_that_runs_far_out_of_view_is_cut_to_sane_numbers():
    far = Polyline(np.array([[-1e12, 0.0], [1e12, 1.0]]), "line")
    points = only(picture(far), "polyline").get("points").split()
    numbers = np.array([[float(c) for c in point.split(",")] for point in points])
    assert np.abs(numbers).max() < 1e4
    assert_allclose(numbers[:, 1], 150.0, atol=30.0)


def test_what_lies_out_of_view_leaves_nothing():
    far = np.array([[1e9, 1e9], [2e9, 2e9]])
    items = [
        Polyline(far, "line"),
        Polygon(np.vstack([far, [[1e9, 2e9]]]), "union"),
        Segments(far[:1], far[1:], "line"),
        Markers(far, "circle", 8.0, None, "line"),
        Label(far[0], "far", "text"),
    ]
    assert not len(picture(*items, transparent=True))


def test_a_legend_has_its_colors_words_and_ticks():
    ticks = ((0.0, "0"), (0.5, "1"), (1.0, "2"))
    legend = Legend("Deviation <a>", "%", ("#102030", "#405060", "#F0E0D0"), ticks, (False, True))
    root = picture(legend)
    assert [text.text for text in root.iter(SVG + "text")] == ["Deviation <a>", "%", "0", "1", "2"]
    stops = [stop.get("stop-color") for stop in root.iter(SVG + "stop")]
    assert stops == list(legend.colors)
    assert only(root, "path").get("d").count("M") == 3
    assert only(root, "polygon").get("fill") == "#F0E0D0"
