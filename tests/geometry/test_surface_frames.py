"""Normals and curvatures against shapes that have them in closed form."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_frames import (
    first_form,
    frame_at,
    gaussian_curvature,
    mean_curvature,
    normals,
    principal_curvatures,
    second_form,
)
from tests.geometry.surfaces import PAIRS, random_surface

U, V = np.linspace(0.03, 0.97, 9), np.linspace(0.06, 0.94, 7)
HALF = np.sqrt(0.5)
CORNERS = np.array(
    [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], dtype=float
)
CIRCLE_KNOTS = (0.0,) * 3 + (0.25, 0.25, 0.5, 0.5, 0.75, 0.75) + (1.0,) * 3
CIRCLE_WEIGHTS = np.array([1.0, HALF] * 4 + [1.0])
CIRCLE = BSpline(9, 3, knots=CIRCLE_KNOTS)


def surface_of(basis_u, basis_v, points, weights=None):
    """The classical surface: no direction counts."""
    points = np.asarray(points, dtype=float)
    planes = ControlPlanes.of(points, weights=weights)
    return PlusSurface(basis_u, basis_v, planes.with_directions(np.zeros((2, *points.shape))))


def torus(large, small):
    """By u around the z axis, by v around the tube; normals point outward."""
    points = [
        [(x * (large + small * a), y * (large + small * a), small * b) for a, b in CORNERS]
        for x, y in CORNERS
    ]
    return surface_of(CIRCLE, CIRCLE, points, np.outer(CIRCLE_WEIGHTS, CIRCLE_WEIGHTS))


def sphere(radius):
    """By u around the z axis, by v from pole to pole; normals point outward."""
    arc, weights = CORNERS[[6, 7, 0, 1, 2]], np.array([1.0, HALF, 1.0, HALF, 1.0])
    points = [[(radius * x * a, radius * y * a, radius * b) for a, b in arc] for x, y in CORNERS]
    half = BSpline(5, 3, knots=(0.0,) * 3 + (0.5, 0.5) + (1.0,) * 3)
    return surface_of(CIRCLE, half, points, np.outer(CIRCLE_WEIGHTS, weights))


def cylinder(radius, height=3.0):
    points = [[(radius * x, radius * y, z) for z in (0.0, height)] for x, y in CORNERS]
    return surface_of(CIRCLE, Bernstein(2), points, np.outer(CIRCLE_WEIGHTS, [1.0, 1.0]))


@pytest.mark.parametrize("radius", [1e-90, 0.5, 3.0, 1e90])
def test_a_sphere_bends_away_from_its_normal_by_one_over_its_radius(radius):
    found = sphere(radius).derivatives(U, V)
    assert_allclose(normals(*found[1:3]), found[0] / radius, atol=1e-13)
    assert_allclose(gaussian_curvature(found) * radius**2, 1.0, rtol=1e-11)
    assert_allclose(mean_curvature(found) * radius, -1.0, rtol=1e-12)
    both = principal_curvatures(found)
    assert_allclose([both.largest * radius, both.smallest * radius], -1.0, rtol=1e-7)


def test_a_cylinder_is_straight_one_way_and_round_the_other():
    found = cylinder(2.0).derivatives(U, V)
    assert_allclose(gaussian_curvature(found), 0.0, atol=1e-14)
    both = principal_curvatures(found)
    assert_allclose(both.largest, 0.0, atol=1e-14)
    assert_allclose(both.smallest, -0.5, rtol=1e-13)
    assert_allclose(np.abs(both.along_largest[..., 2]), 1.0)
    assert_allclose(both.along_smallest[..., 2], 0.0, atol=1e-13)


def test_a_torus_is_a_dome_outside_and_a_saddle_inside():
    large, small = 3.0, 1.25
    found = torus(large, small).derivatives(U, V)
    x, y, _ = np.moveaxis(found[0], -1, 0)
    cosine = (np.hypot(x, y) - large) / small
    around = -cosine / np.hypot(x, y)
    assert_allclose(gaussian_curvature(found), around * -1.0 / small, atol=1e-12)
    assert_allclose(mean_curvature(found), (around - 1.0 / small) / 2.0, rtol=1e-12)
    both = principal_curvatures(found)
    assert_allclose(both.largest, around, atol=1e-12)
    assert_allclose(both.smallest, -1.0 / small, rtol=1e-12)


def test_a_saddle_has_the_curvatures_of_the_books_however_it_is_drawn():
    # z = x y over skew parameters; at the origin the principal directions are the diagonals.
    u, v = np.meshgrid([-1.0, 0.0, 1.0], [-1.0, 0.0, 1.0], indexing="ij")
    x, y = 2.0 * u + v, u - v
    z = (2.0 * u + v) * (u - v)
    z[0], z[1], z[2] = blossom(-1.0), blossom(0.0), blossom(1.0)
    surface = surface_of(Bernstein(3), Bernstein(3), np.stack([x, y, z], axis=-1))
    found = surface.derivatives([0.5], [0.5])
    assert_allclose(found[0], 0.0, atol=1e-15)
    both = principal_curvatures(found)
    assert_allclose([both.largest, both.smallest], [[[1.0]], [[-1.0]]], rtol=1e-13)
    assert_allclose(np.abs(both.along_largest), [[[HALF, HALF, 0.0]]], atol=1e-13)
    assert_allclose(gaussian_curvature(found), -1.0, rtol=1e-13)


def blossom(row):
    """Bezier ordinates in v of 2 u^2 - u v - v^2 where the blossom of u^2 at (a, a) is `row`."""
    square = [1.0, -1.0, 1.0]
    of_u = {-1.0: 1.0, 0.0: -1.0, 1.0: 1.0}[row]
    return [2.0 * of_u - row * v - square[j] for j, v in enumerate((-1.0, 0.0, 1.0))]


@pytest.mark.parametrize("pair", PAIRS)
def test_the_forms_give_the_curvatures_of_the_books(pair):
    found = random_surface(*pair, seed=2).derivatives(U, V)
    E, F, G = np.moveaxis(first_form(found), -1, 0)
    L, M, N = np.moveaxis(second_form(found), -1, 0)
    area = E * G - F**2
    plain = np.sqrt(area) > 1e-3 * E * G / np.maximum(E, G)
    gauss, mean = (L * N - M**2) / area, (E * N - 2.0 * F * M + G * L) / (2.0 * area)
    assert_allclose(gaussian_curvature(found)[plain], gauss[plain], rtol=1e-6, atol=1e-7)
    assert_allclose(mean_curvature(found)[plain], mean[plain], rtol=1e-6, atol=1e-7)


@pytest.mark.parametrize("pair", PAIRS)
def test_principal_directions_stand_at_right_angles_in_the_tangent_plane(pair):
    found = random_surface(*pair, seed=3).derivatives(U, V)
    normal, both = normals(*found[1:3]), principal_curvatures(found)
    first, second = both.along_largest, both.along_smallest
    assert_allclose(np.cross(first, second), normal, atol=1e-9)
    assert_allclose((first**2).sum(axis=-1), 1.0)
    assert (both.largest >= both.smallest).all()


def test_exchanging_u_and_v_turns_the_normal_and_the_sign_of_the_mean_curvature():
    surface = random_surface(contrast=3.0)
    planes = surface.planes
    across = ControlPlanes(
        planes.points.swapaxes(0, 1),
        planes.given.swapaxes(1, 2)[::-1],
        planes.automatic.swapaxes(1, 2)[::-1],
        planes.weights.T,
    )
    turned = replace(surface, basis_u=surface.basis_v, basis_v=surface.basis_u, planes=across)
    here, there = frame_at(surface, 0.3, 0.7), frame_at(turned, 0.7, 0.3)
    assert_allclose(there.point, here.point)
    assert_allclose(there.normal, -here.normal)
    assert_allclose(there.mean, -here.mean)
    assert_allclose(there.gaussian, here.gaussian)


def test_a_pole_has_no_normal_and_no_curvature():
    found = sphere(1.0).derivatives([0.1, 0.5], [0.0, 0.5, 1.0])
    for value in (normals(*found[1:3])[..., 0], gaussian_curvature(found), mean_curvature(found)):
        assert np.isnan(value[:, [0, 2]]).all()
        assert np.isfinite(value[:, 1]).all()


def test_a_surface_that_is_a_line_has_no_normal():
    points = np.zeros((2, 2, 3))
    points[..., 0] = [[0.0, 1.0], [2.0, 3.0]]
    assert np.isnan(frame_at(surface_of(Bernstein(2), Bernstein(2), points), 0.5, 0.5).normal).all()


def test_a_plane_has_curvature_zero_both_ways():
    x, y = np.meshgrid(np.arange(4.0), np.arange(3.0), indexing="ij")
    flat = surface_of(BSpline(4, 3), Bernstein(3), np.stack([x, y, x + y], axis=-1))
    frame = frame_at(flat, 0.4, 0.6)
    assert_allclose(frame.normal, np.array([-1.0, -1.0, 1.0]) / np.sqrt(3.0))
    assert_allclose([frame.gaussian, frame.mean], 0.0, atol=1e-14)
