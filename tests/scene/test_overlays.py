"""What single overlays show, beyond what all of them keep."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.shape import Shape
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.hulls import convex_hull
from plusedit.geometry.lines import ControlLines
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Label, Markers, Polygon, Polyline
from plusedit.scene.overlays import Seen, overlays
from tests.geometry.curves import random_curve

CAMERA = PlaneCamera((800.0, 600.0), scale=200.0)


def drawn(name, curve, kind):
    items = overlays[name].draw(Shape(curve, "(a)"), curve, Seen(CAMERA))
    return [item for item in items if isinstance(item, kind)]


def test_the_classical_curve_is_that_of_the_points_alone():
    curve = random_curve("bspline", s=2.0)
    (line,) = drawn("classical", curve, Polyline)
    assert_allclose(line.points[[0, -1]], curve.lines.points[[0, -1]])


def test_the_classical_curve_is_not_drawn_where_it_is_the_curve_itself():
    assert not drawn("classical", random_curve("bspline", s=0.0), Polyline)


@pytest.mark.parametrize(("given", "count"), [(None, 0), ([[0.0, 1.0], [0.0, 1.0]], 1)])
def test_a_straight_stroke_has_no_classical_curve_beside_it(given, count):
    lines = ControlLines.of([[0.0, 0.0], [2.0, 1.0]], given)
    assert len(drawn("classical", PlusCurve(Bernstein(2), lines, 1.0), Polyline)) == count


@pytest.mark.parametrize(("kind", "count"), [("bspline", 8), ("closed", 9)])
def test_the_polygon_of_a_closed_curve_is_closed(kind, count):
    (line,) = drawn("polygon", random_curve(kind), Polyline)
    assert len(line.points) == count
    assert (line.points[0] == line.points[-1]).all() == (kind == "closed")


def test_hulls_are_two_pink_ones_on_a_blue_one_that_holds_the_curve():
    curve = random_curve("bezier", size=4)
    hulls = drawn("hulls", curve, Polygon)
    assert [hull.fill for hull in hulls] == ["union", "parent", "parent"]
    samples = curve.at(np.linspace(0.0, 1.0, 200))
    assert_array_equal(convex_hull(np.vstack([hulls[0].points, samples])), hulls[0].points)
    assert len(drawn("hulls", curve, Polyline)) == 2


def test_a_closed_curve_has_a_hull_for_every_span():
    assert len(drawn("hulls", random_curve("closed"), Polygon)) == 8


def test_the_elevated_hull_holds_the_curve():
    curve = random_curve("bspline")
    (hull,) = drawn("elevated_hull", curve, Polygon)
    samples = curve.at(np.linspace(0.0, 1.0, 200))
    assert len(convex_hull(np.vstack([hull.points, samples]))) == len(hull.points)


def test_curves_without_a_standard_form_have_no_elevated_hull():
    assert not drawn("elevated_hull", random_curve("rag"), Polygon)


def test_nodes_are_where_the_curve_is_at_the_nodes():
    curve = random_curve("uneven rag")
    (marks,) = drawn("nodes", curve, Markers)
    assert_allclose(marks.points, curve.at(curve.basis.nodes))


def test_a_name_stands_centred_below_its_shape():
    curve = random_curve("bspline")
    (label,) = drawn("names", curve, Label)
    points = curve.lines.points
    assert label.text == "(a)"
    assert label.anchor == "center"
    assert label.at[1] <= points[:, 1].min()
    lifted = replace(curve, lines=curve.lines.with_points(points + np.array([5.0, 0.0])))
    assert_allclose(drawn("names", lifted, Label)[0].at - label.at, [5.0, 0.0, 0.0], atol=1e-9)
