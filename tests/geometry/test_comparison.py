import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.comparison import KINDS, curve_fits, even_points, fit_curve
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.nearest import nearest_parameters
from plusedit.geometry.surface_comparison import SampledSurface, fit_surface, surface_fits
from tests.geometry.surfaces import a_surface

every_kind = pytest.mark.parametrize("kind", KINDS)


def a_wave(count=121):
    x = np.linspace(0.0, 6.0, count)
    return np.stack([x, np.sin(2.0 * x)], axis=1)


def a_sheet(count=25):
    x = np.linspace(0.0, 1.0, count)
    points = np.stack(np.meshgrid(x, x, indexing="ij"), axis=2)
    heights = np.sin(5.0 * points[..., :1]) * np.cos(3.0 * points[..., 1:])
    return SampledSurface.even(np.concatenate([points, heights], axis=2))


@every_kind
def test_it_has_so_many_control_elements_and_meets_both_ends(kind):
    points = a_wave()
    fit = fit_curve(points, kind, 7)
    assert fit.elements == 7
    assert_allclose(fit.shape.at([0.0, 1.0]), points[[0, -1]], atol=1e-12)


@every_kind
def test_distances_are_those_of_the_nearest_points_of_the_curve(kind):
    points = a_wave()
    fit = fit_curve(points, kind, 9)
    feet = fit.shape.at(nearest_parameters(fit.shape, points))
    apart = np.linalg.norm(points - feet, axis=1)
    assert_allclose([fit.largest, fit.rms], [apart.max(), np.sqrt(np.mean(apart**2))], rtol=1e-3)


def test_parameters_of_the_points_keep_their_order():
    u = fit_curve(a_wave(), "bspline+", 5).u
    assert (np.diff(u) > 0.0).all()
    assert_allclose(u[[0, -1]], [0.0, 1.0])


@every_kind
def test_more_control_elements_come_nearer(kind):
    fits = list(curve_fits(a_wave(), [5, 8, 12], kinds=[kind]))
    assert fits[0].rms > 3.0 * fits[1].rms
    assert fits[1].rms > 3.0 * fits[2].rms


def test_a_curve_of_the_family_is_found_again():
    lines = ControlLines.of([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0], [6.0, 1.0]])
    curve = PlusCurve(BSpline(5, 4), lines, s=4.0)
    points = even_points(curve, 161)
    assert fit_curve(points, "bspline+", 5).largest < 1e-5
    assert fit_curve(points, "bspline", 5).largest > 1e-3


def test_bezier_lines_draw_what_bezier_points_one_more_draw():
    fits = list(curve_fits(a_wave(), [5, 6], kinds=["bezier", "bezier+"]))
    assert_allclose(fits[1].rms, fits[2].rms, rtol=0.05)


def test_lines_come_nearer_than_as_many_points_and_take_about_twice_the_numbers():
    by_kind = {fit.kind: fit for fit in curve_fits(a_wave(), [8])}
    assert by_kind["bspline+"].rms < 0.2 * by_kind["bspline"].rms
    assert by_kind["bspline+"].numbers == 2 * by_kind["bspline"].numbers + 1


@every_kind
def test_a_straight_line_is_drawn_by_any_number(kind):
    points = np.linspace([0.0, 0.0], [3.0, 1.0], 30)
    assert fit_curve(points, kind, 5).largest < 1e-9


def test_points_of_space_are_come_near_to_as_well():
    t = np.linspace(0.0, 6.0, 90)
    helix = np.stack([np.cos(t), np.sin(t), 0.2 * t], axis=1)
    assert fit_curve(helix, "bspline+", 8).largest < 1e-3


def test_work_ends_where_the_check_raises():
    class EndError(Exception):
        pass

    def end():
        raise EndError

    with pytest.raises(EndError):
        fit_curve(a_wave(), "bspline+", 8, check=end)


def test_even_points_are_even_in_the_length():
    curve = PlusCurve(BSpline(6, 4), ControlLines.of(np.random.default_rng(0).random((6, 2))), 0.3)
    steps = np.linalg.norm(np.diff(even_points(curve, 400), axis=0), axis=1)
    assert_allclose(steps, steps.mean(), rtol=0.02)


@every_kind
def test_surfaces_have_so_many_elements_each_way(kind):
    fit = fit_surface(a_sheet(), kind, 5)
    assert fit.elements == 25
    assert fit.rms <= fit.largest


@every_kind
def test_no_change_of_a_fitted_surface_comes_nearer(kind):
    sampled = a_sheet(15)
    fit = fit_surface(sampled, kind, 4)
    random = np.random.default_rng(1)
    for _ in range(5):
        net = fit.shape.net
        moved = net.with_control_points(net.control_points + 1e-3 * random.normal(size=(16, 3)))
        other = fit.shape.with_net(moved).at(sampled.u, sampled.v) - sampled.points
        # As near as can be but for some percent, so that control planes stay where they are.
        assert 1.02 * np.sqrt(np.mean((other**2).sum(axis=2))) >= fit.rms


def test_a_plus_surface_of_the_family_is_found_again():
    surface = a_surface(6, 6, s=2.0)
    u = np.linspace(0.0, 1.0, 21)
    sampled = SampledSurface(surface.at(u, u), u, u)
    assert fit_surface(sampled, "bspline+", 6).largest < 1e-9
    assert fit_surface(sampled, "bspline", 6).largest > 1e-3


def test_planes_come_nearer_than_as_many_points_and_take_three_times_the_numbers():
    by_kind = {fit.kind: fit for fit in surface_fits(a_sheet(), [6])}
    assert by_kind["bspline+"].rms < 0.3 * by_kind["bspline"].rms
    assert by_kind["bspline+"].numbers == 3 * by_kind["bspline"].numbers + 1
