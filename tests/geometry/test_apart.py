from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.apart import SurfacePoints, curve_gap, feet_on_surface, surface_gap
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.standard import elliptic_arc
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_area import area
from tests.geometry.curves import KINDS, random_curve
from tests.geometry.surfaces import a_surface, random_surface


def a_circle(radius):
    return elliptic_arc([0.0, 0.0], [radius, 0.0], [0.0, radius])


def a_plate(height, rows=3):
    x = np.linspace(0.0, 2.0, rows)
    points = np.stack([*np.meshgrid(x, x, indexing="ij"), np.full((rows, rows), height)], axis=2)
    return PlusSurface(Bernstein(rows), Bernstein(rows), ControlPlanes.of(points), 0.0)


def gap_of(first, second):
    grid = SurfacePoints.of(first)
    return surface_gap(grid.points.reshape(-1, 3), grid.shares, second)


def test_circles_in_each_other_are_apart_by_their_radii_everywhere():
    for first, second in ((1.0, 1.5), (1.5, 1.0)):
        gap = curve_gap(a_circle(first), a_circle(second))
        assert_allclose(gap.distances, 0.5, rtol=1e-9)
        assert_allclose([gap.largest, gap.rms], 0.5, rtol=1e-9)


def test_a_part_is_at_no_distance_from_the_whole_but_the_whole_is_from_the_part():
    whole = PlusCurve(Bernstein(2), ControlLines.of([[0.0, 0.0], [3.0, 0.0]]), 0.0)
    part = PlusCurve(Bernstein(2), ControlLines.of([[0.0, 0.0], [1.0, 0.0]]), 0.0)
    assert curve_gap(part, whole).largest < 1e-12
    back = curve_gap(whole, part)
    assert_allclose(back.largest, 2.0)
    # Over 3, the mean of x^2 along 2 of the length.
    assert_allclose(back.rms, np.sqrt(2.0**3 / 3.0 / 3.0), rtol=1e-3)


@pytest.mark.parametrize("kind", KINDS)
def test_no_curve_is_apart_from_itself(kind):
    curve = random_curve(kind)
    assert curve_gap(curve, replace(curve)).largest < 1e-9


def test_slow_stretches_of_a_curve_count_no_more_than_others():
    ends = [[0.0, 0.0], [1.0, 0.0], [3.0, 0.0]]
    uneven = PlusCurve(Bernstein(3), ControlLines.of(ends), 0.0)
    even = PlusCurve(Bernstein(2), ControlLines.of([ends[0], ends[-1]]), 0.0)
    to = PlusCurve(Bernstein(2), ControlLines.of([[0.0, 1.0], [3.0, 2.0]]), 0.0)
    assert_allclose(curve_gap(uneven, to).rms, curve_gap(even, to).rms, rtol=1e-4)


def test_plates_one_above_the_other_are_apart_by_their_heights():
    gap = gap_of(a_plate(0.0), a_plate(0.7))
    assert_allclose(gap.distances, 0.7)
    assert_allclose(gap.rms, 0.7)


@pytest.mark.parametrize("folded", [False, True])
def test_feet_are_the_nearest_points_of_the_surface(folded):
    surface = random_surface("closed", "bspline", s=1.0) if folded else a_surface(5, 6, s=1.0)
    points = np.random.default_rng(4).uniform([-0.5, -0.5, -1.0], [3.5, 4.5, 1.0], (40, 3))
    apart = np.linalg.norm(points - feet_on_surface(surface, points), axis=1)
    even = np.linspace(0.0, 1.0, 301)
    samples = surface.at(even, even).reshape(-1, 3)
    looked_at = np.array([np.linalg.norm(samples - point, axis=1).min() for point in points])
    assert (apart <= looked_at * (1.0 + 1e-12)).all()
    assert_allclose(apart, looked_at, atol=1e-2)


def test_parts_of_the_area_are_those_around_the_points():
    surface = a_surface(5, 5, s=0.5)
    grid = SurfacePoints.of(surface)
    assert_allclose(grid.shares.sum(), 1.0)
    heights = grid.points[..., 2].ravel()
    fine = np.linspace(0.0, 1.0, 401)
    at, du, dv = surface.derivatives(fine, fine, highest=1)
    areas = np.linalg.norm(np.cross(du, dv), axis=2)
    assert_allclose(areas.mean(), area(surface), rtol=1e-2)
    mean = (areas * at[..., 2]).sum() / areas.sum()
    assert_allclose(grid.shares @ heights, mean, atol=2e-3)
