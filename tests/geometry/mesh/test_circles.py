from itertools import combinations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.mesh.circles import enclosing_radii

RANDOM = np.random.default_rng(11)


def slow_radius(points):
    """The least over all circles through two or three points that contain all points."""
    circles = [(0.5 * (p + q), 0.5 * np.linalg.norm(p - q)) for p, q in combinations(points, 2)]
    for p, q, r in combinations(points, 3):
        rows = 2.0 * np.array([q - p, r - p])
        if abs(np.linalg.det(rows)) > 1e-12:
            right = [q @ q - p @ p, r @ r - p @ p]
            center = np.linalg.solve(rows, right)
            circles.append((center, np.linalg.norm(center - p)))
    return min(
        radius
        for center, radius in circles
        if (np.linalg.norm(points - center, axis=1) <= radius + 1e-12).all()
    )


@pytest.mark.parametrize("size", [3, 4, 5, 6, 7, 12])
def test_the_radius_is_that_of_the_smallest_circle_of_all(size):
    polygons = RANDOM.normal(size=(40, size, 2))
    assert_allclose(enclosing_radii(polygons), [slow_radius(each) for each in polygons])


def test_an_obtuse_triangle_has_half_its_longest_side():
    assert_allclose(enclosing_radii(np.array([[[0.0, 0.0], [4.0, 0.0], [1.0, 0.1]]])), 2.0)


def test_a_regular_polygon_has_the_radius_of_its_circumcircle():
    for size in (3, 4, 5, 6, 30):
        angles = 2.0 * np.pi * np.arange(size) / size
        polygon = 3.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        assert_allclose(enclosing_radii(polygon[None]), 3.0)


@pytest.mark.parametrize("size", [3, 4, 9])
def test_points_on_a_line_have_half_their_extent(size):
    steps = np.linspace(0.0, 1.0, size)
    line = np.stack([steps, 2.0 * steps], axis=1)
    assert_allclose(enclosing_radii(line[None]), 0.5 * np.sqrt(5.0))


@pytest.mark.parametrize("size", [3, 4, 9])
def test_points_that_coincide_have_radius_zero(size):
    assert_allclose(enclosing_radii(np.full((1, size, 2), 0.3)), 0.0)


@pytest.mark.parametrize("size", [3, 4, 8])
def test_tiny_polygons_are_as_exact_as_large_ones(size):
    polygons = RANDOM.normal(size=(20, size, 2))
    assert_allclose(enclosing_radii(1e-200 * polygons), 1e-200 * enclosing_radii(polygons))
