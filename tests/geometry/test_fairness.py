"""Fairness numbers of shapes that have them in closed form."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.fairness import fairness, fairness_of_triangles, known_fairness
from plusedit.geometry.making.primitives import sheet, sphere
from tests.geometry.surfaces import a_surface
from tests.geometry.test_surface_frames import cylinder, torus
from tests.geometry.test_surface_frames import sphere as exact_ball

LARGE, SMALL = 2.0, 0.6


@pytest.mark.parametrize("radius", [0.1, 1.0, 40.0])
def test_a_sphere_of_any_size_bends_as_much(radius):
    found = fairness(exact_ball(radius))
    assert_allclose(found.area, 4.0 * np.pi * radius**2, rtol=1e-6)
    assert_allclose(found.bending, 8.0 * np.pi, rtol=1e-6)
    assert_allclose(found.variation * radius**2, 0.0, atol=1e-6)


def test_a_flat_sheet_does_not_bend():
    found = fairness(sheet(size=(3.0, 2.0)))
    assert found.area == pytest.approx(6.0)
    assert_allclose([found.bending, found.variation], 0.0, atol=1e-12)


def test_a_cylinder_bends_by_its_height_over_its_radius():
    found = fairness(cylinder(0.5, height=3.0))
    assert_allclose(found.bending, 2.0 * np.pi * 3.0 / 0.5, rtol=1e-6)
    assert_allclose(found.variation, 0.0, atol=1e-6)


def around_the_tube():
    """Angles, areas, both curvatures and the slope of H along the tube of the torus."""
    angle = (np.arange(4000) + 0.5) / 4000 * 2.0 * np.pi
    out = LARGE + SMALL * np.cos(angle)
    area = 2.0 * np.pi * out * SMALL * 2.0 * np.pi / 4000
    one, other = 1.0 / SMALL, np.cos(angle) / out
    slope = -np.sin(angle) * LARGE / out**2 / 2.0 / SMALL
    return area, one, other, slope


def test_a_torus_bends_and_varies_as_its_integrals_say():
    area, one, other, slope = around_the_tube()
    found = fairness(torus(LARGE, SMALL))
    assert_allclose(found.area, area.sum(), rtol=1e-6)
    assert_allclose(found.bending, (area * (one**2 + other**2)).sum(), rtol=1e-6)
    assert_allclose(found.variation, (area * slope**2).sum(), rtol=1e-4)


def test_triangles_come_near_the_same():
    surface = torus(LARGE, SMALL)
    n = 120
    u = np.arange(n) / n
    points = surface.at(u, u).reshape(-1, 3)
    i, j = (each.ravel() for each in np.indices((n, n)))
    quads = [
        (i * n + j),
        ((i + 1) % n * n + j),
        ((i + 1) % n * n + (j + 1) % n),
        (i * n + (j + 1) % n),
    ]
    triangles = np.concatenate(
        [np.stack([quads[k] for k in rows], axis=1) for rows in ((0, 1, 2), (0, 2, 3))]
    )
    out = np.hypot(points[:, 0], points[:, 1])
    largest, smallest = -(out - LARGE) / SMALL / out, np.full(n * n, -1.0 / SMALL)
    found, wanted = fairness_of_triangles(points, triangles, largest, smallest), fairness(surface)
    assert_allclose(found.area, wanted.area, rtol=5e-3)
    assert_allclose(found.bending, wanted.bending, rtol=5e-3)
    assert_allclose(found.variation, wanted.variation, rtol=2e-2)


def test_dents_make_a_surface_less_fair():
    ball = sphere()
    points = ball.planes.points.copy()
    points[3, 3] *= 1.2
    dented = replace(ball, planes=ball.planes.with_points(points))
    assert fairness(dented).bending > fairness(ball).bending
    assert fairness(dented).variation > fairness(ball).variation


def test_it_is_worked_out_once():
    surface = a_surface()
    assert known_fairness(surface) is None
    assert fairness(surface) is fairness(surface) is known_fairness(surface)
