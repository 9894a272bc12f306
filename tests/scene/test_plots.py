"""Plots as data: axes, and the plots of blending functions and of what s does."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.magnitude_profile import magnitude_profile
from plusedit.geometry.natural import best_s_of, natural_length_of
from plusedit.scene.blending_plots import MOST_FAINT, curve_plots, surface_plots
from plusedit.scene.magnitude_plots import curvature_plot, distance_plot, energy_plot, ratios
from plusedit.scene.plots import Axis, axis_for, written
from plusedit.scene.theme import THEMES
from tests.geometry.curves import KINDS, random_curve
from tests.geometry.surfaces import PAIRS, a_surface, random_surface


@pytest.mark.parametrize("axis", [Axis(-2.0, 3.0), Axis(0.01, 100.0, is_logarithmic=True)])
def test_shares_and_values_are_each_other_s_inverse(axis):
    for share in (0.0, 0.3, 1.0):
        assert axis.share(axis.value(share)) == pytest.approx(share)


@pytest.mark.parametrize("length", [20.0, 100.0, 400.0])
@pytest.mark.parametrize(
    "axis",
    [Axis(0.0, 1.0), Axis(-0.031, 0.52), Axis(0.02, 4e5, is_logarithmic=True), Axis(1e-9, 2e-9)],
)
def test_ticks_are_on_the_axis_and_apart(axis, length):
    ticks = [value for value, _ in axis.ticks(length)]
    pixels = [axis.share(value) * length for value in ticks]
    assert all(-1e-6 <= pixel <= length + 1e-6 for pixel in pixels)
    assert all(b - a >= 8.0 for a, b in pairwise(pixels))


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (0.02, "0.02"), (5.0, "5"), (2000.0, "2000"), (1e5, "1e5"), (2e-5, "2e-5")],
)
def test_round_numbers_are_short(value, text):
    assert written(value) == text.replace("-", "\N{MINUS SIGN}")


def test_values_that_differ_much_get_a_logarithmic_axis():
    values = np.array([0.1, 1.0, 1000.0, np.inf, np.nan])
    assert axis_for(values, even=False).is_logarithmic
    assert not axis_for(values[:2], even=False).is_logarithmic
    assert not axis_for(values, from_zero=True).is_logarithmic


@pytest.mark.parametrize("rows", [np.zeros(3), np.full(3, -2.0), np.full(3, np.nan), np.zeros(0)])
def test_an_axis_has_a_length_whatever_the_values(rows):
    axis = axis_for(rows, from_zero=True)
    assert axis.high > axis.low


def colored(plot):
    return [line for line in plot.lines if line.name]


@pytest.mark.parametrize("kind", KINDS)
def test_functions_of_chosen_lines_stand_out_and_all_are_there(kind):
    (plots,) = curve_plots(random_curve(kind, contrast=3.0), (1, 4))
    for plot in (plots.values, plots.reaches):
        assert [line.name for line in colored(plot)] == ["2", "5"]
        assert len(plot.lines) == 8
    values = np.array([np.nan_to_num(line.y) for line in plots.values.lines])
    assert_allclose(values.sum(axis=0), 1.0)


def test_closed_functions_are_shown_beyond_their_period():
    (plots,) = curve_plots(random_curve("closed"), ())
    assert plots.values.inside == (0.0, 1.0)
    assert plots.values.x.low < 0.0 < 1.0 < plots.values.x.high
    nodes = [mark.x for mark in plots.values.marks if mark.is_tick]
    assert min(nodes) < 0.0 < 1.0 < max(nodes)


def test_of_very_many_functions_some_are_left_out_but_not_the_chosen_ones():
    (plots,) = curve_plots(random_curve("bspline", size=500), (123,))
    assert len(plots.values.lines) <= MOST_FAINT + 1
    assert [line.name for line in colored(plots.values)] == ["124"]


@pytest.mark.parametrize("kinds", PAIRS)
def test_a_surface_has_functions_by_u_and_by_v(kinds):
    surface = random_surface(*kinds, contrast=3.0)
    rows, columns = surface.planes.shape
    by_u, by_v = surface_plots(surface, (columns + 2,), (0.3, 0.6))
    assert (by_u.way, by_v.way) == ("u", "v")
    assert (by_u.chosen, by_v.chosen) == ((1,), (2,))
    assert (len(by_u.values.lines), len(by_v.values.lines)) == (rows, columns)


@pytest.mark.parametrize("shape", [random_curve("bspline"), a_surface()], ids=["curve", "surface"])
def test_what_s_does_is_plotted_with_the_best_s(shape):
    length = natural_length_of(shape)
    profile = magnitude_profile(shape, length * ratios())
    best = best_s_of(shape) / length
    plots = [
        distance_plot(profile.distances, best),
        energy_plot(profile, best, is_curve=True),
        curvature_plot(profile, best),
    ]
    for plot in plots:
        assert {mark.text for mark in plot.marks} <= {"s*"}
        for line in plot.lines:
            assert len(line.x) == len(line.y) == len(ratios())
            for theme in THEMES.values():
                assert theme.color(line.color)


def test_a_best_s_beyond_the_axis_has_no_mark():
    shape = replace(random_curve("bspline"), s=1.0)
    profile = magnitude_profile(shape, ratios())
    assert not distance_plot(profile.distances, 2.5).marks
    assert not distance_plot(profile.distances, None).marks
