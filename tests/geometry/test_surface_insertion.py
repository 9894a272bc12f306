"""Rows and columns of control planes that come and go."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.insertion import insert_line
from plusedit.geometry.iso_curves import iso_curve
from plusedit.geometry.sizes import family_of
from plusedit.geometry.surface_insertion import (
    insert_column,
    insert_row,
    without_columns,
    without_rows,
)
from plusedit.geometry.surface_transforms import transposed
from tests.geometry.curves import KINDS
from tests.geometry.surfaces import PAIRS, a_surface, random_surface, surfaces

EXACT = ("bezier", "bspline", "polygon", "high order", "kinks")
OTHERS = tuple(kind for kind in KINDS if kind not in EXACT)
every_pair = pytest.mark.parametrize(("kind_u", "kind_v"), PAIRS)
U, V = np.linspace(0.0, 1.0, 61), np.linspace(0.0, 1.0, 23)


def smooth_torus(rows=9, columns=7, contrast=None):
    """Round, of closed B-splines both ways."""
    surface = random_surface(
        "closed", "closed", shape=(rows, columns), contrast=contrast, given=0.0
    )
    a, b = np.meshgrid(*(2.0 * np.pi * np.arange(n) / n for n in (rows, columns)), indexing="ij")
    ring = 3.0 + np.cos(b)
    points = np.stack([ring * np.cos(a), ring * np.sin(a), np.sin(b)], axis=-1)
    return surface.with_net(surface.planes.with_points(points))


@given(surfaces(), st.sampled_from(EXACT), st.floats(0.0, 1.0), st.integers(2, 7))
@settings(max_examples=100, deadline=None)
def test_polynomial_surfaces_stay_exactly_as_they_are(other, kind, u, rows):
    weights = other.planes.weights
    surface = random_surface(
        kind, "closed rag", shape=(rows, 4), s=other.s, contrast=None if weights is None else 9.0
    )
    larger, index = insert_row(surface, u)
    assert larger.planes.shape == (rows + 1, 4) and 0 < index < rows
    assert_allclose(larger.at(U, V), surface.at(U, V), atol=1e-12 * (1.0 + abs(surface.s)))


def test_a_column_is_a_row_of_the_transposed_surface():
    surface = random_surface("closed", "bspline", contrast=4.0)
    column, index = insert_column(surface, 0.3)
    row, expected = insert_row(transposed(surface), 0.3)
    assert index == expected
    assert_array_equal(column.planes.points, transposed(row).planes.points)


def test_the_edge_of_the_larger_surface_is_the_larger_edge():
    surface = random_surface("bspline", "bezier", contrast=4.0)
    larger, index = insert_row(surface, 0.4)
    edge, expected = insert_line(iso_curve(surface, "v", 0.0), 0.4)
    assert index == expected
    assert_allclose(larger.planes.points[:, 0], edge.lines.points, atol=1e-13)
    assert_allclose(larger.planes.weights[:, 0], edge.lines.weights, rtol=1e-13)


def test_rows_away_from_the_new_one_stay_to_the_last_bit():
    surface = random_surface("bspline", "bezier", shape=(12, 4), contrast=3.0)
    larger, _ = insert_row(surface, 0.5)
    old, new = surface.planes, larger.planes
    for rows in (slice(0, 3), slice(-3, None)):
        assert_array_equal(new.points[rows], old.points[rows])
        assert_array_equal(new.given[:, rows], old.given[:, rows])
        assert_allclose(new.weights[rows], old.weights[rows], rtol=1e-15)
    assert_array_equal(new.automatic[1, :3], old.automatic[1, :3])


@pytest.mark.parametrize("contrast", [None, 1.5])
@pytest.mark.parametrize("u", [0.03, 0.4, 0.99])
def test_a_smooth_torus_changes_little(contrast, u):
    torus = smooth_torus(contrast=contrast)
    larger, index = insert_row(torus, u)
    begun = u - larger.basis_u.nodes[index]
    assert_allclose(larger.at(U, V), torus.at(U + begun, V), atol=0.03)


@pytest.mark.parametrize("contrast", [None, 1.5])
def test_a_gaussian_sheet_changes_little(contrast):
    sheet = a_surface(7, 6)
    weighted = random_surface("rag", "rag", shape=(7, 6), contrast=contrast, s=1.0)
    surface = weighted.with_net(sheet.planes.with_weights(weighted.planes.weights))
    larger, index = insert_row(surface, 0.4)
    assert larger.basis_u.nodes[index] == pytest.approx(0.4)
    assert_allclose(larger.at(U, V), surface.at(U, V), atol=0.03)


@pytest.mark.parametrize("kind", OTHERS)
@pytest.mark.parametrize("contrast", [None, 20.0])
def test_any_other_surface_gets_a_row_and_stays_about_where_it_was(kind, contrast):
    surface = random_surface(kind, "bspline", shape=(8, 5), s=0.5, contrast=contrast)
    larger, index = insert_row(surface, 0.55)
    assert larger.planes.shape == (9, 5)
    assert 0 <= index < 9
    assert family_of(larger.basis_u) == family_of(surface.basis_u)
    assert larger.closed == surface.closed
    assert np.abs(larger.at(U, V)).max() <= 2.0 * np.abs(surface.at(U, V)).max()


@given(surfaces(), st.floats(-0.5, 1.5))
@settings(max_examples=50, deadline=None)
def test_weights_stay_positive_and_numbers_finite(surface, u):
    larger, _ = insert_row(surface, u)
    assert (larger.planes.weights is None) == (surface.planes.weights is None)
    assert np.isfinite(larger.at(U, V)).all()


def test_weights_that_are_products_of_one_by_u_and_one_by_v_stay_such_products():
    by_u, by_v = np.linspace(1.0, 2.0, 9), np.array([1.0, 0.7, 1.0, 0.7, 1.0, 0.7, 1.0])
    torus = smooth_torus()
    torus = torus.with_net(torus.planes.with_weights(np.outer(by_u, by_v)))
    larger, _ = insert_row(torus, 0.3)
    weights = larger.planes.weights
    assert_allclose(weights / weights[:, :1], np.tile(by_v, (10, 1)), rtol=1e-12)


@pytest.mark.parametrize("u", [np.nan, np.inf])
def test_a_parameter_that_is_not_finite_is_refused(u):
    with pytest.raises(ValueError, match="finite parameter"):
        insert_row(a_surface(), u)


@every_pair
@pytest.mark.parametrize("rows", [(0,), (5,), (2, 3), (1, 2, 3, 4)])
def test_without_some_rows_the_others_are_as_they_were(kind_u, kind_v, rows):
    surface = random_surface(kind_u, kind_v, shape=(6, 6), contrast=3.0)
    kept = np.setdiff1d(np.arange(6), rows)
    fewer, narrower = without_rows(surface, rows), without_columns(surface, rows)
    assert_array_equal(fewer.planes.points, surface.planes.points[kept])
    assert_array_equal(fewer.planes.weights, surface.planes.weights[kept])
    assert_array_equal(narrower.planes.points, surface.planes.points[:, kept])
    assert_array_equal(narrower.planes.given, surface.planes.given[:, :, kept])
    assert fewer.closed == narrower.closed == surface.closed
    assert np.isfinite(fewer.at(U, V)).all() and np.isfinite(narrower.at(U, V)).all()


def test_fewer_than_two_rows_are_no_surface():
    with pytest.raises(ValueError, match="1 rows would stay"):
        without_rows(a_surface(4, 5), (0, 1, 2))
    with pytest.raises(ValueError, match="at least 2 x 2"):
        without_columns(a_surface(4, 5), (0, 1, 2, 3))
