import numpy as np
from numpy.testing import assert_array_equal

from plusedit.geometry.comparison import Fit, basis_of
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.scene.fit_plots import COLORS, fit_plot, nearest_fits
from plusedit.scene.theme import THEMES


def a_fit(kind, size, rms):
    points = np.random.default_rng(size).random((size, 2))
    lines = ControlLines.of(points, points) if kind.endswith("+") else ControlLines.of(points)
    curve = PlusCurve(basis_of(kind, size, 4), lines, float(kind.endswith("+")))
    return Fit(kind, curve, 2.0 * rms, rms)


FITS = [
    a_fit("bspline", 8, 0.01),
    a_fit("bspline", 4, 0.5),
    a_fit("bspline+", 4, 0.2),
    a_fit("bspline+", 8, 0.0),
]


def test_there_is_a_line_for_each_family_in_the_order_of_sizes():
    points, lines = fit_plot(FITS, "elements", "rms").lines
    assert_array_equal(points.x, [4.0, 8.0])
    assert_array_equal(points.y, [0.5, 0.01])
    assert (points.dash, lines.dash) == ("dash", "solid")


def test_over_numbers_stored_a_line_counts_twice_a_point():
    points, lines = fit_plot(FITS, "numbers", "largest").lines
    assert_array_equal(points.x, [8.0, 16.0])
    assert_array_equal(lines.x, [17.0, 33.0])
    assert_array_equal(points.y, [1.0, 0.02])


def test_distances_are_logarithmic_and_none_is_zero():
    plot = fit_plot(FITS, "elements", "rms")
    assert plot.y.is_logarithmic
    assert all((line.y > 0.0).all() for line in plot.lines)


def test_without_fits_the_plot_is_empty():
    assert fit_plot([], "elements", "rms").lines == ()


def test_the_nearest_of_each_family_are_those_at_the_cursor():
    found = nearest_fits(FITS, "elements", 7.0)
    assert {kind: fit.elements for kind, fit in found.items()} == {"bspline": 8, "bspline+": 8}
    by_numbers = nearest_fits(FITS, "numbers", 16.0)
    assert {kind: fit.elements for kind, fit in by_numbers.items()} == {"bspline": 8, "bspline+": 4}


def test_colors_are_in_every_theme():
    for theme in THEMES.values():
        assert all(theme.color(role).startswith("#") for role in COLORS.values())
