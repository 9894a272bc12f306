"""Convex hulls in space."""

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.convex_hull import hull_mesh
from tests.geometry.bodies import outside, volume

RANDOM = np.random.default_rng(3)
SQUARE = np.array([[0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1], [1, 1, 1], [1, 0, 1]], dtype=float)


def assert_closed(mesh):
    """Every edge has one triangle on each side, and the mesh is one ball."""
    a, b, c = mesh.triangles.T
    ways = np.concatenate([np.stack(pair, axis=1) for pair in ((a, b), (b, c), (c, a))])
    assert len(np.unique(ways, axis=0)) == len(ways)
    assert {tuple(way) for way in ways} == {tuple(way[::-1]) for way in ways}
    assert len(mesh.points) - len(ways) // 2 + len(mesh.triangles) == 2


def facets_by_trying(points):
    """Of points in general position every three with all others on one side."""
    found = set()
    for three in combinations(range(len(points)), 3):
        a, b, c = points[list(three)]
        heights = np.delete((points - a) @ np.cross(b - a, c - a), three)
        if (heights < 0.0).all() or (heights > 0.0).all():
            found.add(frozenset(map(tuple, (a, b, c))))
    return found


@pytest.mark.parametrize("seed", range(5))
def test_the_triangles_are_all_those_with_the_points_on_one_side(seed):
    points = np.random.default_rng(seed).normal(size=(14, 3))
    mesh = hull_mesh(points)
    found = {frozenset(map(tuple, mesh.points[triangle])) for triangle in mesh.triangles}
    assert found == facets_by_trying(points)
    assert_closed(mesh)


@given(st.lists(st.tuples(*[st.integers(-3, 3)] * 3), min_size=1, max_size=40))
@settings(max_examples=200, deadline=None)
def test_points_of_a_coarse_grid_however_many_are_in_a_plane(rows):
    points = np.array(rows) / 7.0
    mesh = hull_mesh(points)
    if len(mesh.triangles):
        assert_closed(mesh)
        assert volume(mesh) >= 0.0
        assert outside(mesh, points) < 1e-13
    given_points = {tuple(row) for row in points.tolist()}
    assert {tuple(row) for row in mesh.points.tolist()} <= given_points


@pytest.mark.parametrize("count", [3, 6])
def test_the_hull_of_a_cube_of_points_is_the_cube(count):
    side = np.linspace(-1.0, 1.0, count)
    mesh = hull_mesh(np.stack(np.meshgrid(side, side, side), axis=-1).reshape(-1, 3))
    assert volume(mesh) == pytest.approx(8.0)
    assert_closed(mesh)


def test_every_point_of_a_sphere_is_a_corner():
    points = RANDOM.normal(size=(300, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    mesh = hull_mesh(points)
    assert len(mesh.points) == 300
    assert len(mesh.triangles) == 2 * 300 - 4
    assert_closed(mesh)


@pytest.mark.parametrize("thickness", [1e-3, 1e-9, 1e-12])
def test_a_body_next_to_flat_is_still_closed_and_holds_all_points(thickness):
    points = RANDOM.uniform(size=(500, 3)) * [1.0, 1.0, thickness]
    mesh = hull_mesh(points)
    assert_closed(mesh)
    assert outside(mesh, points) < 1e-13


def test_points_in_a_tilted_plane_have_a_polygon_with_two_sides():
    tilt = np.linalg.qr(RANDOM.normal(size=(3, 3)))[0]
    mesh = hull_mesh(SQUARE @ tilt)
    assert_allclose(np.sort(mesh.points @ tilt.T, axis=0), np.sort(SQUARE[:4], axis=0), atol=1e-12)
    assert len(mesh.triangles) == 4
    assert_closed(mesh)


def test_many_points_in_a_plane_are_looked_at_from_above_alone():
    points = np.column_stack([RANDOM.normal(size=(3000, 2)), np.full(3000, 5.0)])
    mesh = hull_mesh(points)
    assert_closed(mesh)
    angles = np.linspace(0.0, 6.28, 200)
    ways = np.stack([np.cos(angles), np.sin(angles), 0.0 * angles])
    assert_array_equal((mesh.points @ ways).max(axis=0), (points @ ways).max(axis=0))


def test_points_in_a_row_have_two_ends_and_no_triangles():
    mesh = hull_mesh(np.outer([0.3, -1.0, 2.0, 0.0], [1.0, 2.0, -1.0]))
    assert_array_equal(mesh.points, [[-1.0, -2.0, 1.0], [2.0, 4.0, -2.0]])
    assert mesh.triangles.shape == (0, 3)


@pytest.mark.parametrize("count", [0, 1, 5])
def test_one_place_has_at_most_one_point(count):
    mesh = hull_mesh(np.ones((count, 3)))
    assert len(mesh.points) == min(count, 1)
    assert mesh.triangles.shape == (0, 3)


@pytest.mark.parametrize("size", [1e-80, 1e-9, 1e80])
def test_size_and_place_do_not_matter(size):
    points = RANDOM.normal(size=(60, 3))
    expected, found = hull_mesh(points), hull_mesh(size * points)
    assert_array_equal(found.triangles, expected.triangles)
    assert_array_equal(
        hull_mesh(points + np.array([64.0, 0.0, -16.0])).triangles, expected.triangles
    )
