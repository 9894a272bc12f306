"""Flat triangles against the surface, sampled densely: the slow obvious check."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases import is_local
from plusedit.geometry.making.primitives import exact_sphere, sheet, sphere, torus, tube
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_tessellate import (
    affordable_tessellation,
    surface_size,
    surface_tessellation,
)
from plusedit.geometry.surface_transforms import transposed
from tests.geometry.surfaces import PAIRS, a_surface, random_surface
from tests.geometry.triangles import from_triangles

every_pair = pytest.mark.parametrize("pair", PAIRS, ids="/".join)

HALVES = {"one way": [(0, 1, 2), (0, 2, 3)], "the other way": [(0, 1, 3), (1, 2, 3)]}
every_cut = pytest.mark.parametrize("cut", HALVES)


def strays(surface, grids, cut="one way", count=6):
    """The farthest that the surface lies from the triangles below it."""
    u, v = (grid.parameters for grid in grids)
    points = surface.at(u, v)
    corners = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    shares = np.linspace(0.0, 1.0, count)
    dense = [(p[:-1, None] + np.diff(p)[:, None] * shares).ravel() for p in (u, v)]
    inside = surface.at(*dense).reshape(len(u) - 1, count, len(v) - 1, count, 3)
    inside = inside.swapaxes(1, 2).reshape(len(u) - 1, len(v) - 1, -1, 3)
    halves = [
        from_triangles(inside, *(corners[i][:, :, None] for i in half)) for half in HALVES[cut]
    ]
    return np.minimum(*halves).max()


def flat_and_uneven():
    """A trapezoid in space whose parameters run ever faster."""
    points = np.zeros((3, 3, 3))
    points[..., 0] = np.array([0.0, 0.1, 3.0])[:, None]
    points[..., 1] = np.array([0.0, 0.2, 2.0]) * (1.0 + points[:, :1, 0])
    points[..., 2] = points[..., 0]
    basis = a_surface(3, 3).basis_u
    return PlusSurface(basis, basis, ControlPlanes.of(points), 0.0)


def scaled(surface, factor):
    planes = surface.planes.with_points(factor * surface.planes.points)
    return replace(surface, planes=planes, s=factor * surface.s)


@every_pair
@every_cut
def test_triangles_stay_within_the_tolerance(pair, cut):
    surface = random_surface(*pair)
    tolerance = 5e-3 * surface_size(surface)
    assert strays(surface, surface_tessellation(surface, tolerance), cut) <= tolerance


@every_pair
def test_very_unequal_weights_change_nothing_of_that(pair):
    surface = random_surface(*pair, contrast=1e2)
    tolerance = 2e-2 * surface_size(surface)
    assert strays(surface, surface_tessellation(surface, tolerance), count=4) <= tolerance


@pytest.mark.parametrize("made", [sphere, exact_sphere, torus, tube])
def test_round_bodies_take_about_as_many_triangles_as_they_have_to(made):
    surface = made()
    tolerance = 1e-3
    by_u, by_v = surface_tessellation(surface, tolerance)
    assert strays(surface, (by_u, by_v)) <= tolerance
    # A chord over the angle a strays 1 - cos(a / 2). Chords along u and v share the tolerance, and
    # of intervals of one round each gets a whole number of parts.
    chords = 2.0 * np.pi / (2.0 * np.arccos(1.0 - tolerance))
    assert len(by_u) <= 3.0 * chords
    assert len(by_v) <= 3.0 * chords


@every_pair
def test_the_parameters_increase_from_0_to_1_and_hold_the_knots(pair):
    surface = random_surface(*pair)
    for grid, basis in zip(surface_tessellation(surface, 0.1), surface.bases, strict=True):
        u = grid.parameters
        assert u[0] == 0.0
        assert u[-1] == 1.0
        assert (np.diff(u) > 0.0).all()
        if is_local(basis):
            assert np.isin(basis.breaks, u).all()


def test_a_hundredth_of_the_tolerance_needs_about_a_hundred_times_as_many():
    surface = random_surface()
    coarse, fine = (
        np.prod([len(grid) for grid in surface_tessellation(surface, tolerance)])
        for tolerance in (1e-1, 1e-3)
    )
    assert 30 * coarse < fine < 200 * coarse


def test_exchanging_the_parameters_exchanges_the_grids():
    surface = random_surface("bspline", "rag", seed=3)
    by_u, by_v = surface_tessellation(surface, 1e-2)
    assert surface_tessellation(transposed(surface), 1e-2) == (by_v, by_u)


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1e9, 1e90])
def test_the_size_of_the_coordinates_does_not_matter(scale):
    surface = random_surface(given=0.0, s=1.0)
    factor = 2.0 ** round(np.log2(scale))
    wanted = surface_tessellation(surface, 1e-2)
    assert surface_tessellation(scaled(surface, factor), factor * 1e-2) == wanted


def test_a_flat_surface_keeps_to_its_pieces():
    assert [len(grid) for grid in surface_tessellation(sheet(), 1e-9)] == [2, 2]
    flat = flat_and_uneven()
    assert [len(grid) for grid in surface_tessellation(flat, 1e-9)] == [2, 2]


def test_what_bends_one_way_only_is_cut_that_way():
    by_u, by_v = surface_tessellation(tube(), 1e-4)
    assert len(by_u) > 50
    assert len(by_v) == 2


def test_a_twisted_square_is_cut_although_all_its_lines_are_straight():
    points = np.array([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]], dtype=float)
    basis = a_surface(2, 2).basis_u
    surface = PlusSurface(basis, basis, ControlPlanes.of(points), 0.0)
    for cut in HALVES:
        assert strays(surface, surface_tessellation(surface, 1e-3), cut) <= 1e-3


@pytest.mark.parametrize("most", [10, 100, 3000, 100_000])
def test_no_tolerance_asks_for_more_than_the_most(most):
    surface = random_surface("bspline", "closed rag")
    by_u, by_v = surface_tessellation(surface, 1e-12, most)
    knots = len(surface.basis_u.breaks) * (surface.planes.shape[1] + 1)
    assert len(by_u) * len(by_v) <= max(most, knots)


def test_what_is_allowed_is_used_where_it_counts():
    surface = random_surface(s=1.0)
    found = [strays(surface, surface_tessellation(surface, 1e-9, most)) for most in (300, 6000)]
    assert found[1] < found[0] / 8.0


@pytest.mark.parametrize("most", [300, 6000])
def test_the_tolerance_that_is_told_is_about_the_one_kept(most):
    surface = random_surface(s=1.0)
    made = affordable_tessellation(surface, 1e-9, most)
    farthest = strays(surface, (made.by_u, made.by_v))
    assert made.tolerance / 4.0 < farthest < 1.5 * made.tolerance
    assert affordable_tessellation(surface, 0.05, 100_000).tolerance == 0.05


def test_a_tolerance_below_rounding_ends_soon():
    surface = a_surface()
    far = replace(surface, planes=surface.planes.with_points(surface.planes.points * 1e-6 + 1e9))
    far = replace(far, s=1e-6)
    assert np.prod([len(grid) for grid in surface_tessellation(far, 1e-13)]) < 1000


def test_points_all_in_one_place_make_no_work():
    for s in (0.0, 1.0):
        planes = ControlPlanes.of(np.full((5, 4, 3), 2.0))
        surface = PlusSurface(*a_surface(5, 4).bases, planes, s)
        assert max(len(grid) for grid in surface_tessellation(surface, 1e-9)) < 10
        assert surface_size(surface) == 0.0


def test_a_surface_drawn_together_to_a_line_is_cut_as_a_line():
    surface = a_surface(6, 4)
    points = np.repeat(surface.planes.points[:, :1], 4, axis=1)
    line = replace(surface, planes=ControlPlanes.of(points))
    by_u, by_v = surface_tessellation(line, 1e-4)
    assert strays(line, (by_u, by_v)) <= 1e-4
    assert len(by_v) == 2


@pytest.mark.parametrize("tolerance", [0.0, -1.0, np.nan])
def test_a_tolerance_that_is_not_positive_is_refused(tolerance):
    with pytest.raises(ValueError, match="tolerance: must be positive"):
        surface_tessellation(a_surface(), tolerance)


def test_the_size_is_the_diagonal_of_the_box():
    assert_allclose(surface_size(sheet(size=(3.0, 4.0))), 5.0)
    assert_allclose(surface_size(exact_sphere(2.0)), np.sqrt(48.0), rtol=1e-3)
