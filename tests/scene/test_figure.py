"""Figures: as wide as asked for, fitted to what they show, words and lines in points."""

import re
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.figure import FigureForm, bands, cropped
from plusedit.scene.figure_composition import plane_figure, space_figure
from plusedit.scene.figure_svg import svg_figure
from plusedit.scene.framing import extent_of
from plusedit.scene.items import Caption, Legend, Polyline, Row
from plusedit.scene.space_camera import SpaceCamera
from tests.designs import a_curve
from tests.geometry.surfaces import a_surface

POINT = 25.4 / 72.0
ARC, SHEET = ShapeId("arc"), ShapeId("sheet")
PLANE = Design({ARC: Shape(a_curve(), "Arc")}, view={"overlays": ["names", "polygon"]})
SPACE = Design({SHEET: Shape(a_surface(s=1.0), "Sheet")}, view={"overlays": ["names"]})
LEGEND = Legend("Curvature", "1 / unit", ("#000000", "#FFFFFF"), ((0.0, "0"), (1.0, "1")))


@pytest.mark.parametrize("width", [40.0, 85.0, 170.0])
@pytest.mark.parametrize("line", [0.5, 1.0, 2.0])
def test_a_figure_is_as_wide_as_asked_for(width, line):
    figure = plane_figure(PLANE, FigureForm(width, line=line))
    assert_allclose(figure.size[0], width)
    assert_allclose(figure.frame[2] * figure.form.pixel, width)


def test_curves_and_words_have_their_sizes_in_points():
    form = FigureForm(text=9.0, line=0.75)
    figure = plane_figure(PLANE, form)
    (curve,) = (item for item in figure.flat if isinstance(item, Polyline) and item.color == "plus")
    assert_allclose(curve.width * form.pixel / POINT, 0.75)
    (name,) = figure.labels
    # Usual words are 12 pixels high, those of names 13.
    assert_allclose(name.size * form.words * form.pixel / POINT, 9.0 * 13.0 / 12.0)


def test_a_fitted_figure_is_as_high_as_what_it_shows():
    form = FigureForm()
    figure = plane_figure(PLANE, form)
    items = (*figure.flat, *figure.labels)
    seen = figure.camera.to_screen(extent_of(items, figure.camera, form.words))
    _, top, _, height = figure.frame
    assert_allclose((seen[:, 1].min() - top, top + height - seen[:, 1].max()), 8.0, atol=0.5)
    assert seen[:, 0].min() >= 7.0 and seen[:, 0].max() <= figure.frame[2] - 7.0


def test_a_figure_of_a_given_height_has_it():
    for made in (plane_figure(PLANE, FigureForm(height=40.0)),
                 space_figure(SPACE, FigureForm(height=40.0))):  # fmt: skip
        assert_allclose(made.size, (85.0, 40.0))


def test_a_figure_as_seen_shows_what_the_view_shows():
    camera = PlaneCamera((800.0, 600.0), (2.0, 1.0), 90.0)
    figure = plane_figure(PLANE, FigureForm(), camera=camera)
    assert_allclose(figure.camera.window, camera.window)
    assert_allclose(figure.size, (85.0, 85.0 * 0.75))
    space = SpaceCamera((800.0, 600.0), (0.5, 0.5, 0.0), 3.0, 0.3, 0.4)
    figure = space_figure(SPACE, FigureForm(), camera=space)
    points = np.random.default_rng(1).random((9, 3))
    share = figure.camera.to_screen(points) / figure.camera.size
    assert_allclose(share, space.to_screen(points) / space.size)


def test_a_fitted_figure_in_space_shows_all_of_it():
    figure = space_figure(SPACE, FigureForm())
    t = np.linspace(0.0, 1.0, 20)
    points = SPACE[SHEET].surface.at(t, t).reshape(-1, 3)
    left, top, width, height = figure.frame
    seen = figure.camera.to_screen(points)
    assert (seen > (left, top)).all() and (seen < (left + width, top + height)).all()


def test_what_is_selected_is_not_seen():
    for design, shape, make in ((PLANE, ARC, plane_figure), (SPACE, SHEET, space_figure)):
        figure = make(design, FigureForm(), selection=Selection(lines=(LineId(shape, 1),)))
        items = figure.flat if figure.space is None else figure.space
        colors = {getattr(item, "color", "") for item in items}
        assert not any(color.startswith("selected") for color in colors)


def test_legends_get_room_on_the_right_and_captions_below():
    form = FigureForm()
    right, below = bands([LEGEND], form)
    assert right > 50.0 and below == 0.0
    right, below = bands([Caption("Length", (Row("Arc", "3"),))], form)
    assert right == 0.0 and below > 20.0


def test_a_legend_stands_below_where_it_would_take_too_much_of_the_width():
    form = FigureForm(width=40.0)
    right, below = bands([LEGEND], form)
    assert right == 0.0 and below > 50.0
    # Where that would take too much of a given height, it stands before the shapes.
    assert bands([LEGEND], replace(form, height=30.0)) == (0.0, 0.0)


def test_of_nothing_the_whole_view_is_shown():
    assert cropped((100.0, 60.0), 5.0, 20.0, np.zeros((0, 2)), 8.0) == (0.0, 0.0, 120.0, 65.0)
    figure = plane_figure(Design(), FigureForm())
    assert figure.flat == () and figure.labels == ()


@pytest.mark.parametrize("name", ["width", "height", "text", "line"])
@pytest.mark.parametrize("value", [0.0, -1.0, 1e9, float("nan")])
def test_sizes_that_make_no_sense_are_refused_in_a_sentence(name, value):
    with pytest.raises(ValueError, match=rf"^The {name} of a figure is .*\.$"):
        FigureForm(**{name: value})


def test_light_figures_are_on_white_paper():
    assert FigureForm().colors.color("canvas") == "#FFFFFF"
    assert FigureForm(theme="dark").colors.color("canvas") != "#FFFFFF"


def test_an_svg_figure_tells_its_width_in_millimeters():
    figure = plane_figure(PLANE, FigureForm())
    text = svg_figure(figure, figure.flat).decode()
    assert 'width="85mm"' in text
    (height,) = re.findall(r'height="([0-9.]+)mm"', text)
    assert_allclose(float(height), figure.size[1], atol=1e-3)
    assert '<rect width="481.8898"' in text and 'fill="#FFFFFF"' in text
    assert "<image" not in text and ">Arc</text>" in text
    bare = plane_figure(PLANE, FigureForm(transparent=True))
    assert "<rect" not in svg_figure(bare, bare.flat).decode()


def test_an_svg_figure_has_its_surfaces_in_one_image():
    figure = space_figure(SPACE, FigureForm())
    text = svg_figure(figure, figure.space.lines, b"\x89PNG").decode()
    assert text.count("<image") == 1
    assert text.index("<image") < text.index("<polyline")
