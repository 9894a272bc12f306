"""Chords against the curve, sampled densely: the slow obvious check."""

from dataclasses import replace

import numpy as np
import pytest

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.tessellate import MOST, is_fine, tessellation
from tests.geometry.curves import KINDS, random_curve

every_kind = pytest.mark.parametrize("kind", KINDS)


def strays(curve, grid, axes=(0, 1), window=None, count=20001):
    """The farthest that the curve lies from the chord over it, inside the window.

    The parameters are even, and besides closer and closer to every parameter of the grid.
    """
    u = grid.parameters
    inside = np.concatenate([u[:-1, None] + np.diff(u)[:, None] * np.linspace(0, 1, 9)])
    dense = np.unique(np.concatenate([np.linspace(0.0, 1.0, count), inside.ravel()]))
    points = curve.at(dense)
    ends = curve.at(u)
    if axes is not None:
        if curve.dimension == 2:
            points = np.column_stack([points, np.zeros(len(points))])
            ends = np.column_stack([ends, np.zeros(len(ends))])
        points, ends = points[:, axes], ends[:, axes]
    piece = np.clip(np.searchsorted(u, dense, side="right") - 1, 0, len(u) - 2)
    a, b = ends[piece], ends[piece + 1]
    along = ((points - a) * (b - a)).sum(axis=1)
    length = ((b - a) ** 2).sum(axis=1)
    t = np.clip(np.divide(along, length, out=np.zeros_like(along), where=length > 0), 0, 1)
    distance = np.linalg.norm(points - a - t[:, None] * (b - a), axis=1)
    if window is not None:
        distance = distance[((points >= window[0]) & (points <= window[1])).all(axis=1)]
    return distance.max(initial=0.0)


def plane(points, *, basis=None, directions=None, weights=None, s=1.0):
    """A plane curve through a few points given in the test."""
    lines = ControlLines.of(np.array(points, dtype=float), directions, weights)
    return PlusCurve(basis or Bernstein(len(points)), lines, s)


@every_kind
@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("tolerance", [0.1, 1e-3])
def test_chords_stay_within_the_tolerance(kind, seed, tolerance):
    curve = random_curve(kind, seed=seed)
    assert strays(curve, tessellation(curve, tolerance)) <= tolerance


@every_kind
@pytest.mark.parametrize("contrast", [10.0, 1e4, 1e8])
def test_very_unequal_weights_change_nothing_of_that(kind, contrast):
    for seed in range(3):
        curve = random_curve(kind, seed=seed, contrast=contrast)
        assert strays(curve, tessellation(curve, 1e-3)) <= 1e-3


@pytest.mark.parametrize("size", [2, 3, 20, 60, 200])
@pytest.mark.parametrize("kind", ["bezier", "bspline", "high order", "rag", "closed"])
def test_few_lines_and_many(kind, size):
    curve = random_curve(kind, size=size, seed=size)
    assert strays(curve, tessellation(curve, 1e-2), count=2001) <= 1e-2


@every_kind
def test_the_parameters_increase_from_0_to_1_and_hold_the_knots(kind):
    curve = random_curve(kind)
    u = tessellation(curve, 1e-2).parameters
    assert u[0] == 0.0
    assert u[-1] == 1.0
    assert (np.diff(u) > 0.0).all()
    if isinstance(curve.basis, BSpline):
        assert np.isin(curve.basis.breaks, u).all()


@every_kind
def test_a_thousandth_of_the_tolerance_needs_about_thirty_times_as_many(kind):
    curve = random_curve(kind, seed=2)
    coarse, fine = (len(tessellation(curve, t)) for t in (1e-3, 1e-6))
    assert fine < 80 * coarse


@pytest.mark.parametrize("scale", [1e-150, 1e-9, 1.0, 1e9, 1e90])
def test_the_size_of_the_coordinates_does_not_matter(scale):
    curve = random_curve("bspline", seed=3)
    lines = replace(curve.lines, points=scale * curve.lines.points, given=scale * curve.lines.given)
    scaled = PlusCurve(curve.basis, ControlLines.of(lines.points, lines.given), curve.s)
    same = PlusCurve(curve.basis, ControlLines.of(curve.lines.points, curve.lines.given), curve.s)
    assert len(tessellation(scaled, 1e-3 * scale)) == len(tessellation(same, 1e-3))


def test_a_tolerance_below_rounding_ends_soon():
    curve = plane([(1e9, 1e9), (1e9 + 1e-6, 1e9), (1e9 + 1e-6, 1e9 + 1e-6)], s=1e-6)
    assert len(tessellation(curve, 1e-12)) < 200


def test_no_tolerance_asks_for_more_than_the_most():
    assert len(tessellation(random_curve("bezier"), 1e-14)) <= MOST
    assert len(tessellation(random_curve("closed rag", size=60), 1e-12)) <= MOST


def test_a_straight_curve_keeps_to_its_pieces():
    curve = plane([(0, 0), (1, 0), (2, 0), (3, 0), (4, 0)], basis=BSpline(5, 4), s=2.0)
    assert len(tessellation(curve, 1e-6)) == 3


def test_points_all_in_one_place_make_no_work():
    assert len(tessellation(plane([(2, 3)] * 5, s=0.0), 1e-9)) < 10


def test_a_straight_curve_that_turns_back_is_drawn_to_its_tip():
    for tip in np.linspace(1.0, 3.0, 41):
        curve = plane([(0, 0), (tip, 0), (0.1, 0)], s=0.0)
        assert strays(curve, tessellation(curve, 1e-4)) <= 1e-4


def test_a_cusp_is_drawn_to_its_tip():
    # The classical cubic with crossing legs, here with a true cusp.
    curve = plane([(0, 0), (1, 1), (0, 1), (1, 0)], s=0.0)
    assert strays(curve, tessellation(curve, 1e-5)) <= 1e-5


def test_symmetry_hides_nothing():
    # An S and a W, both with their middle on the chord.
    for heights in ([0, 1, 0, -1, 0], [0, 3, -4, 0, 4, -3, 0], [0, 5, -8, 6, 6, -8, 5, 0]):
        curve = plane(list(enumerate(heights)), s=0.0)
        assert strays(curve, tessellation(curve, 1e-4)) <= 1e-4


def test_a_staircase_shows_every_step():
    for sigma in (0.05, 1e-3, 1e-6, 1e-12):
        points = [(i, i % 2) for i in range(9)]
        curve = plane(points, basis=RationalGaussian(9, sigma), directions=[(1, 3)] * 9, s=1.0)
        grid = tessellation(curve, 1e-3)
        assert strays(curve, grid) <= 1e-3
        assert len(grid) < 2000


@every_kind
@pytest.mark.parametrize("zoom", [10.0, 1e3, 1e6])
def test_a_deep_zoom_is_fine_inside_the_window_and_coarse_outside(kind, zoom):
    curve = random_curve(kind, seed=1)
    center = curve.at(0.437)[0]
    window = (center - 1.0 / zoom, center + 1.0 / zoom)
    tolerance = 1e-3 / zoom
    grid = tessellation(curve, tolerance, window=window)
    assert strays(curve, grid, window=window) <= tolerance
    assert is_fine(curve, grid, tolerance, window)
    assert len(grid) < 2000


def test_what_is_seen_from_the_front_is_measured_there():
    curve = random_curve("bspline", dimension=3, seed=4)
    flat = PlusCurve(curve.basis, curve.lines.with_points(curve.lines.points * (1, 50, 1)), curve.s)
    front = tessellation(flat, 1e-2, axes=(0, 2))
    assert strays(flat, front, axes=(0, 2)) <= 1e-2
    assert len(front) < len(tessellation(flat, 1e-2, axes=(0, 1)))


def test_a_plane_curve_seen_from_the_front_is_a_line():
    curve = random_curve("bezier")
    assert strays(curve, tessellation(curve, 1e-3, axes=(0, 2)), axes=(0, 2)) <= 1e-3


@every_kind
@pytest.mark.parametrize("tolerance", [0.1, 1e-3])
def test_measured_in_space_chords_stay_within_the_tolerance_in_space(kind, tolerance):
    curve = random_curve(kind, dimension=3, seed=3, contrast=10.0)
    grid = tessellation(curve, tolerance, axes=None)
    assert strays(curve, grid, axes=None) <= tolerance
    assert is_fine(curve, grid, tolerance, axes=None)
    assert not is_fine(curve, grid, tolerance / 100.0, axes=None)


def test_measured_in_space_a_plane_curve_is_what_it_is_seen_from_above():
    curve = random_curve("bspline")
    assert tessellation(curve, 1e-3, axes=None) == tessellation(curve, 1e-3)


def test_a_window_in_space_is_a_box():
    curve = random_curve("bspline", dimension=3, seed=1)
    center = curve.at(0.437)[0]
    window = (center - 1e-3, center + 1e-3)
    grid = tessellation(curve, 1e-6, axes=None, window=window)
    assert strays(curve, grid, axes=None, window=window) <= 1e-6
    assert len(grid) < 200


@every_kind
def test_a_grid_is_fine_for_its_own_curve_but_not_for_a_hundredth_of_the_tolerance(kind):
    curve = random_curve(kind, seed=6)
    grid = tessellation(curve, 1e-3)
    assert is_fine(curve, grid, 1e-3)
    assert not is_fine(curve, grid, 1e-5)


def test_a_grid_is_fine_where_it_was_made_for_and_not_elsewhere():
    curve = random_curve("bspline", seed=1)
    here, there = curve.at([0.4, 0.9])
    grid = tessellation(curve, 1e-6, window=(here - 1e-3, here + 1e-3))
    assert is_fine(curve, grid, 1e-6, (here - 1e-3, here + 1e-3))
    assert not is_fine(curve, grid, 1e-6, (there - 1e-3, there + 1e-3))


def test_a_grid_without_the_knots_is_not_fine():
    curve = random_curve("polygon", seed=6)
    assert not is_fine(curve, Grid.uniform(5000), 1.0)
    assert is_fine(curve, Grid(np.union1d(np.linspace(0, 1, 500), curve.basis.breaks)), 1e-2)


@pytest.mark.parametrize("tolerance", [0.0, -1.0, np.nan])
def test_a_tolerance_that_is_not_positive_is_refused(tolerance):
    with pytest.raises(ValueError, match="tolerance: must be positive"):
        tessellation(random_curve("bezier"), tolerance)


def test_a_closed_curve_of_high_order_is_smooth_and_takes_few_parameters():
    square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
    curve = plane(square, basis=BSpline(4, 60, closed=True))
    grid = tessellation(curve, 1e-4)
    assert strays(curve, grid) <= 1e-4
    assert len(grid) < 200
