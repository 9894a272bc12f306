"""Curvature combs: as long as the curve is curved, on its outer side, honest at knots."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases import families
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.combs import LONGEST, Measure, comb_items, comb_of
from plusedit.scene.extents import Extent
from plusedit.scene.iso_lines import iso_lines
from plusedit.scene.items import Label, Polyline, Segments
from tests.geometry.curves import KINDS, random_curve
from tests.geometry.surfaces import a_surface

MEASURE = Measure.of(1.0, 1.0, Extent(4.0, 1.0))
SMALL = Measure.of(1e-3, 1.0)


def an_arc():
    """A quarter of the circle of radius 2 about the origin, exactly."""
    points = 2.0 * np.array([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    weights = np.array([1.0, np.sqrt(0.5), 1.0])
    basis = families["bezier"].of_size(3)
    return PlusCurve(basis, ControlLines.of(points, weights=weights), 0.0)


def teeth_of(comb):
    (teeth,) = (item for item in comb.items if isinstance(item, Segments))
    return teeth


def lines_of(comb):
    return [item.points for item in comb.items if isinstance(item, Polyline)]


def test_on_a_circle_all_teeth_are_as_long_and_point_away_from_its_center():
    comb = comb_of(an_arc(), MEASURE)
    teeth = teeth_of(comb)
    assert_allclose(np.linalg.norm(teeth.starts, axis=1), 2.0, rtol=1e-6)
    assert_allclose(teeth.ends, teeth.starts * (1.0 + MEASURE.factor / 4.0), atol=1e-14)
    assert_allclose(comb.largest, 0.5)
    (line,) = lines_of(comb)
    assert_allclose(np.linalg.norm(line, axis=1), 2.0 + MEASURE.factor / 2.0)


@pytest.mark.parametrize("scale", [0.1, 1.0, 3.0])
def test_twice_the_scale_is_twice_the_length(scale):
    curve = an_arc()
    lengths = [
        np.linalg.norm(teeth.ends - teeth.starts, axis=1)
        for teeth in (
            teeth_of(comb_of(curve, Measure.of(k * scale, 1.0, Extent(10.0, 10.0)))) for k in (1, 2)
        )
    ]
    assert_allclose(lengths[1], 2.0 * lengths[0])


def test_twice_the_density_is_twice_as_many_teeth():
    few, many = (len(teeth_of(comb_of(an_arc(), Measure.of(1.0, k))).starts) for k in (1.0, 2.0))
    assert many - 1 == 2 * (few - 1)


@pytest.mark.parametrize("kind", ["bezier", "bspline", "closed", "rag", "uneven rag"])
def test_teeth_are_even_by_length_along_the_curve(kind):
    curve = random_curve(kind)
    starts = teeth_of(comb_of(curve, SMALL)).starts
    fine = curve.at(np.linspace(0.0, 1.0, 100001))
    along = np.r_[0.0, np.linalg.norm(np.diff(fine, axis=0), axis=1).cumsum()]
    even = np.searchsorted(along, np.linspace(0.0, along[-1], len(starts)))
    assert_allclose(starts, fine[np.minimum(even, len(fine) - 1)], atol=1e-3 * along[-1])


def test_where_the_curvature_jumps_the_line_is_broken_and_there_are_two_teeth():
    curve = random_curve("bspline")
    rough = PlusCurve(BSpline(len(curve.lines), 3), curve.lines, curve.s)
    knots = len(rough.basis.breaks) - 2
    comb = comb_of(rough, SMALL)
    starts = teeth_of(comb).starts
    assert len(lines_of(comb)) == knots + 1
    assert sum((np.abs(starts[1:] - starts[:-1]) < 1e-9).all(axis=1)) == knots


def test_where_it_goes_on_evenly_there_is_one():
    curve = random_curve("bspline")
    comb = comb_of(PlusCurve(BSpline(len(curve.lines), 5), curve.lines, curve.s), SMALL)
    gaps = np.linalg.norm(np.diff(teeth_of(comb).starts, axis=0), axis=1)
    assert gaps.min() > 1e-9


def test_teeth_at_a_cusp_are_cut_and_the_line_is_broken():
    points = np.array([[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]])
    comb = comb_of(PlusCurve(families["bezier"].of_size(4), ControlLines.of(points), 0.0), MEASURE)
    teeth = teeth_of(comb)
    assert np.isfinite(teeth.ends).all()
    lengths = np.linalg.norm(teeth.ends - teeth.starts, axis=1)
    assert lengths.max() <= LONGEST * 4.0 * (1.0 + 1e-9)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dimension", [2, 3])
def test_every_tooth_is_the_curvature_vector_the_other_way(kind, dimension):
    curve = random_curve(kind, dimension=dimension)
    comb = comb_of(curve, Measure.of(1e-4, 1.0))
    teeth = teeth_of(comb)
    ways = teeth.ends - teeth.starts
    line = np.concatenate(lines_of(comb))
    assert len(line) > len(ways)
    assert np.isfinite(ways).all()


def test_the_longest_tooth_says_what_it_stands_for_where_it_is_long_enough():
    near, far = PlaneCamera((800.0, 600.0), scale=200.0), PlaneCamera((800.0, 600.0), scale=1.0)
    (label,) = (i for i in comb_items(an_arc(), MEASURE, near) if isinstance(i, Label))
    assert label.text == "κ 0.5"
    assert not any(isinstance(i, Label) for i in comb_items(an_arc(), MEASURE, far))


def test_unchanged_curves_keep_their_very_items():
    curve = an_arc()
    assert comb_of(curve, MEASURE) is comb_of(curve, Measure.of(1.0, 1.0, Extent(4.0, 1.0)))


def test_lines_on_a_surface_run_at_the_nodes_of_selected_planes():
    surface = a_surface(4, 3)
    lines = iso_lines(surface, (0, 4, 11))
    found = {(line.way, round(line.value, 9)) for line in lines}
    nodes_u, nodes_v = (basis.nodes for basis in surface.bases)
    wanted = {("u", nodes_u[0]), ("u", nodes_u[1]), ("u", nodes_u[3])}
    wanted |= {("v", nodes_v[0]), ("v", nodes_v[1]), ("v", nodes_v[2])}
    assert found == {(way, round(value, 9)) for way, value in wanted}


def test_without_selected_planes_there_are_five_each_way_and_they_lie_on_the_surface():
    surface = a_surface(4, 3)
    lines = iso_lines(surface)
    assert [line.way for line in lines] == ["u"] * 5 + ["v"] * 5
    assert iso_lines(surface) == lines
    for line in lines:
        place = [line.value, 0.25] if line.way == "u" else [0.25, line.value]
        assert_allclose(line.curve.at([0.25])[0], surface.derivatives_at([place], highest=0)[0][0])
