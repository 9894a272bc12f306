"""Figures in space: shaded surfaces as one image, and vectors of what is seen over it."""

import re
from dataclasses import replace

import numpy as np
import pytest

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import unit
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.surface_frames import normals
from plusedit.io.files import load
from plusedit.scene.figure import FigureForm
from plusedit.scene.figure_composition import space_figure
from plusedit.scene.items import Markers, Polyline, Segments
from plusedit.views.figure_files import figure_file
from plusedit.views.gl.hidden import depths_of, parted
from plusedit.views.space_figure import drawn_figure
from tests.gui.conftest import example
from tests.scene.test_figure import SPACE

pytestmark = pytest.mark.gl


def wall():
    """A flat square in the plane y = 0, between -1 and 1."""
    from plusedit.geometry.planes import ControlPlanes
    from plusedit.geometry.surface import PlusSurface

    points = [[(x, 0.0, z) for z in (-1.0, 1.0)] for x in (-1.0, 1.0)]
    return PlusSurface(Bernstein(2), Bernstein(2), ControlPlanes.of(points), 0.0)


FRONT = "front"


@pytest.fixture
def depths(gl):
    """Those of the wall as seen from the front, along y."""
    design = Design({ShapeId("wall"): Shape(wall(), "Wall")})
    figure = space_figure(design, FigureForm(height=85.0), view=FRONT)
    return depths_of(gl, figure.space.solids, figure.camera)


def test_points_are_hidden_behind_a_surface_and_nowhere_else(depths):
    points = np.array([[0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0], [1.05, 1.0, 0.0]])
    assert depths.sees(points).tolist() == [True, False, True, True]


@pytest.mark.parametrize("perspective", [True, False])
def test_what_lies_on_the_far_side_is_hidden_however_near_the_eye(gl, perspective):
    design, u = load(example("torus.json")).design, np.linspace(0.0, 1.0, 24)
    (surface,) = (shape.surface for shape in design.shapes.values())
    figure = space_figure(design, FigureForm())
    camera = replace(figure.camera, perspective=perspective)
    depths = depths_of(gl, figure.space.solids, camera)
    points, *ways = (rows.reshape(-1, 3) for rows in surface.derivatives(u, u, highest=1))
    middles = unit(points * [1.0, 1.0, 0.0]) * 2.0
    across = normals(*ways)
    across *= np.sign(((points - middles) * across).sum(axis=1, keepdims=True))
    facing = across @ camera.toward
    assert depths.sees(points[facing > 0.6]).all()
    assert not depths.sees(points[facing < -0.6]).any()


def test_a_line_is_cut_where_it_goes_behind_a_surface(depths):
    line = Polyline(np.array([[-1.05, 0.5, 0.0], [0.0, 0.5, 0.0], [1.05, 0.5, 0.0]]), "line")
    seen, hidden = parted([line], depths)
    assert len(seen) == 2 and len(hidden) == 1
    ends = hidden[0].points[[0, -1], 0]
    np.testing.assert_allclose(ends, (-1.0, 1.0), atol=0.02)
    through = Segments(np.array([[-0.5, -1.0, 0.0]]), np.array([[0.5, 1.0, 0.0]]), "line")
    (before,), (behind,) = parted([through], depths)
    np.testing.assert_allclose(before.starts[0], (-0.5, -1.0, 0.0))
    np.testing.assert_allclose(behind.ends[0], (0.5, 1.0, 0.0))


def test_marks_are_parted_one_by_one(depths):
    marks = Markers(np.array([[0.0, -1.0, 0.0], [0.0, 1.0, 0.0]]), "circle", 5.0, "plus", "plus")
    (seen,), (hidden,) = parted([marks], depths)
    assert seen.points.tolist() == [[0.0, -1.0, 0.0]]
    assert hidden.points.tolist() == [[0.0, 1.0, 0.0]]


def test_a_pdf_of_space_has_one_image_and_lines(qapp):
    figure = space_figure(SPACE, FigureForm())
    data = figure_file(figure, ".pdf", 150.0)
    assert len(re.findall(rb"/Subtype /Image", data)) == 1
    assert b"/DCTDecode" not in data
    text = figure_file(figure, ".svg", 150.0).decode()
    assert text.count("<image") == 1 and text.count("<polyline") > 4


def test_curves_in_space_alone_need_no_image(qapp):
    curve = PlusCurve(Bernstein(3), ControlLines.of([[0, 0, 0], [1, 1, 1], [2, 0, 1.0]]), 1.0)
    figure = space_figure(Design({ShapeId("a"): Shape(curve, "A")}), FigureForm())
    assert drawn_figure(figure, 100.0).shaded is None


def test_a_png_of_space_is_drawn_with_its_lines(qapp):
    figure = space_figure(SPACE, FigureForm())
    drawn = drawn_figure(figure, 100.0, in_pixels=True)
    assert drawn.flat == ()
    width = round(figure.shaded_size[0] * figure.form.pixel / 25.4 * 100.0)
    assert drawn.shaded.width() == width
    data = figure_file(figure, ".png", 100.0)
    size = tuple(int.from_bytes(data[at : at + 4]) for at in (16, 20))
    assert size == figure.pixels(100.0)
