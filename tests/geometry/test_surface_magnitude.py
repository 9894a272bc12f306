"""The natural unit of a surface's s, its best value, and directions that one s suits."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_magnitude import (
    balanced,
    best_surface_s,
    natural_length,
    natural_lengths,
)
from plusedit.geometry.surface_transforms import transposed
from tests.geometry.surfaces import a_surface, surfaces


def rectangle(width, height, *, rows=4, columns=5):
    """A flat one, all directions automatic."""
    x, y = np.linspace(0.0, width, rows), np.linspace(0.0, height, columns)
    points = np.stack([*np.meshgrid(x, y, indexing="ij"), np.zeros((rows, columns))], axis=-1)
    return PlusSurface(BSpline(rows, 4), BSpline(columns, 4), ControlPlanes.of(points))


def missed(surface):
    """The sum of squares that the best s makes least."""
    at = surface.at(surface.basis_u.nodes, surface.basis_v.nodes)
    return ((at - surface.planes.points) ** 2).sum()


def test_of_a_rectangle_the_natural_lengths_are_its_sides():
    assert_allclose(natural_lengths(rectangle(3.0, 8.0)), (3.0, 8.0))
    assert natural_length(rectangle(3.0, 8.0)) == pytest.approx(5.5)


def test_of_a_tube_the_closing_edges_count():
    square = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])
    points = square[:, None] + np.linspace(0.0, 5.0, 3)[None, :, None] * [0.0, 0.0, 1.0]
    tube = PlusSurface(BSpline(4, 4, True), BSpline(3, 3), ControlPlanes.of(points))
    assert_allclose(natural_lengths(tube), (4.0, 5.0))
    assert_allclose(natural_lengths(transposed(tube)), (5.0, 4.0))


@given(surfaces())
@settings(max_examples=50, deadline=None)
def test_no_other_s_comes_closer_to_the_control_points(surface):
    best = best_surface_s(surface)
    if best is None:
        return
    least = missed(replace(surface, s=best))
    for factor in (0.9, 0.999, 1.001, 1.1):
        assert least <= missed(replace(surface, s=best * factor)) * (1.0 + 1e-9) + 1e-20


def test_a_surface_of_the_second_degree_has_its_tangents_halved_for_the_best_s():
    x, y = np.meshgrid(*[BSpline(n, 4).nodes for n in (5, 6)], indexing="ij")
    points = np.stack([x, y, x * x - x * y + 2.0 * y * y], axis=-1)
    by_u = np.stack([np.ones_like(x), 0.0 * x, 2.0 * x - y], axis=-1)
    by_v = np.stack([0.0 * x, np.ones_like(x), 4.0 * y - x], axis=-1)
    surface = PlusSurface(BSpline(5, 4), BSpline(6, 4), ControlPlanes.of(points, by_u, by_v))
    assert best_surface_s(surface) == pytest.approx(0.5)


def test_without_directions_no_s_is_the_best():
    still = np.zeros((2, 4, 5, 3))
    surface = a_surface()
    assert best_surface_s(replace(surface, planes=surface.planes.with_directions(still))) is None


def test_balanced_directions_of_length_one_are_as_long_as_their_rows_are_beside_the_mean():
    lengths = np.linalg.norm(balanced(rectangle(2.0, 6.0)).directions, axis=-1)
    assert_allclose(lengths[0], 0.5)
    assert_allclose(lengths[1], 1.5)


def test_after_balancing_the_natural_length_is_that_of_the_rows_both_ways():
    long = balanced(rectangle(1.0, 100.0))
    by_u, by_v = np.linalg.norm(natural_length(long) * long.directions, axis=-1)
    assert_allclose(by_u, 1.0)
    assert_allclose(by_v, 100.0)


@given(surfaces())
@settings(max_examples=30, deadline=None)
def test_balanced_twice_is_balanced(surface):
    once = balanced(surface)
    assert_allclose(balanced(once).directions, once.directions, rtol=1e-12)


@given(surfaces())
@settings(max_examples=30, deadline=None)
def test_balancing_only_stretches_all_directions_of_a_way_alike(surface):
    before, after = surface.directions, balanced(surface).directions
    for old, new in zip(before, after, strict=True):
        factor = np.linalg.norm(new) / np.linalg.norm(old)
        assert_allclose(new, factor * old, atol=1e-12)


def test_a_surface_without_extent_along_u_stays_as_it_is():
    line = rectangle(0.0, 4.0)
    assert balanced(line) is line
