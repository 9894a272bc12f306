"""Surfaces through all their control points."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.iso_curves import iso_curve
from plusedit.geometry.passing import passing_through
from plusedit.geometry.surface_passing import misses, passed_surface, passing_through_surface
from plusedit.geometry.surface_transforms import transposed
from tests.geometry.surfaces import CORNERS_MET, PAIRS, a_surface, random_surface, surfaces


def matrices(surface):
    """(n, 2 n) what the gradients by u, then by v, add to the surface at the nodes."""
    planes, n = surface.planes, len(surface.planes)
    columns = []
    for number in range(2 * n):
        directions = np.zeros((2 * n, 3))
        directions[number, 0] = 1.0
        probe = planes.with_points(0.0 * planes.points).with_directions(
            directions.reshape(2, *planes.points.shape)
        )
        moved = replace(surface, planes=probe, s=1.0)
        columns.append(moved.at(surface.basis_u.nodes, surface.basis_v.nodes)[..., 0].ravel())
    return np.stack(columns, axis=1)


def least_change(surface):
    """By one large system of equations."""
    at_nodes = surface.at(surface.basis_u.nodes, surface.basis_v.nodes)
    missing = (surface.planes.points - at_nodes).reshape(-1, 3)
    change = np.linalg.lstsq(matrices(surface), missing, rcond=1e-7)[0]
    return change.reshape(surface.directions.shape)


def least_misses(surface):
    """(n_u, n_v) what is missing after that."""
    at_nodes = surface.at(surface.basis_u.nodes, surface.basis_v.nodes)
    moved = matrices(surface) @ least_change(surface).reshape(-1, 3)
    missing = surface.planes.points - at_nodes - moved.reshape(at_nodes.shape)
    return np.linalg.norm(missing, axis=-1)


@given(surfaces(kinds=CORNERS_MET, least=3))
@settings(max_examples=50, deadline=None)
def test_a_sheet_passes_through_its_control_points(surface):
    if surface.s == 0.0:
        return
    made = passed_surface(surface)
    assert made.largest_miss < 1e-10
    assert misses(made.surface).max() == made.largest_miss
    assert_array_equal(made.surface.planes.points, surface.planes.points)


@pytest.mark.parametrize("shape", [(5, 6), (7, 7)])
@pytest.mark.parametrize("kind_v", ["bezier", "kinks", "closed", "closed rag"])
def test_so_does_what_closes_with_an_odd_number_of_planes(kind_v, shape):
    rows, columns = shape if kind_v in CORNERS_MET else (5, 7)
    surface = random_surface("closed, odd order", kind_v, shape=(rows, columns))
    assert passed_surface(surface).largest_miss < 1e-10


@given(surfaces(least=3, most=6))
@settings(max_examples=60, deadline=None)
def test_any_surface_comes_as_close_as_it_can(surface):
    if surface.s == 0.0:
        return
    size = np.abs(surface.planes.points).max() + np.abs(surface.gradients).max()
    found = misses(passing_through_surface(surface))
    assert_allclose(found, least_misses(surface), atol=1e-7 * size)


@pytest.mark.parametrize("kinds", [("bezier", "bspline"), ("closed", "rag"), ("closed", "closed")])
@pytest.mark.parametrize("shape", [(5, 4), (3, 5)])
def test_the_change_is_the_least_of_all_that_do(kinds, shape):
    surface = random_surface(*kinds, shape=shape)
    made = passing_through_surface(surface)
    assert_allclose(made.gradients - surface.gradients, least_change(surface), atol=1e-9)


@pytest.mark.parametrize("kinds", [("bezier", "bspline"), ("closed", "closed")])
def test_with_weights_it_is_the_least_as_well(kinds):
    surface = random_surface(*kinds, shape=(5, 4), contrast=3.0)
    change, least = (
        passing_through_surface(surface).gradients - surface.gradients,
        least_change(surface),
    )
    assert_allclose(change, least, atol=1e-4 * np.abs(least).max())
    assert np.linalg.norm(change) <= np.linalg.norm(least) * (1.0 + 1e-7)


def test_weights_that_are_products_of_one_by_u_and_one_by_v_are_met_at_once():
    surface = random_surface("bezier", "closed", shape=(4, 5), s=1.0)
    weights = np.outer([1.0, 0.5, 0.5, 2.0], [1.0, 0.7, 1.0, 0.7, 1.0])
    surface = surface.with_net(surface.planes.with_weights(weights))
    change = passing_through_surface(surface).gradients - surface.gradients
    assert_allclose(change, least_change(surface), atol=1e-10)


def test_a_torus_of_even_numbers_can_not_pass_through_all():
    surface = random_surface("closed", "closed", shape=(4, 6), s=1.0)
    assert passed_surface(surface).largest_miss > 0.01


@pytest.mark.parametrize("contrast", [None, 3.0])
def test_the_edges_of_a_sheet_pass_as_curves_do(contrast):
    surface = random_surface("bspline", "bezier", shape=(6, 5), s=2.0, contrast=contrast)
    through = passing_through_surface(surface)
    edge = iso_curve(through, "u", 0.0)
    if contrast is None:
        alone = passing_through(iso_curve(surface, "u", 0.0))
        assert_allclose(edge.gradients, alone.gradients, atol=1e-9)
    assert_allclose(edge.at(edge.basis.nodes), edge.lines.points, atol=1e-9)


@pytest.mark.parametrize(("kind_u", "kind_v"), PAIRS)
def test_u_and_v_are_treated_alike(kind_u, kind_v):
    surface = random_surface(kind_u, kind_v, shape=(5, 5), s=1.0)
    one, other = passed_surface(surface), passed_surface(transposed(surface))
    assert_allclose(transposed(other.surface).gradients, one.surface.gradients, atol=1e-7)


def test_what_passes_already_is_left_alone():
    x, y = np.meshgrid(np.linspace(0.0, 1.0, 4), np.linspace(0.0, 1.0, 5), indexing="ij")
    flat = a_surface().with_net(a_surface().planes.with_points(np.stack([x, y, 0 * x], axis=-1)))
    bezier = random_surface("bezier", "bezier", shape=(4, 5), s=1.0)
    plane = replace(bezier, planes=flat.planes)
    made = passing_through_surface(plane)
    assert made.planes.automatic.all()
    assert_array_equal(made.directions, plane.directions)


@pytest.mark.parametrize("contrast", [None, 5.0])
def test_a_hundred_rows_and_columns_are_no_trouble(contrast):
    surface = random_surface("bspline", "bspline", shape=(100, 100), contrast=contrast, s=1.0)
    assert passed_surface(surface).largest_miss < 1e-9


def test_without_s_directions_have_no_effect():
    with pytest.raises(ValueError, match="set s first"):
        passing_through_surface(a_surface(s=0.0))
