from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.departure import (
    curve_departures,
    departure,
    surface_departure,
    surface_departures,
)
from plusedit.geometry.lines import ControlLines
from tests.geometry.curves import KINDS, random_curve
from tests.geometry.surfaces import PAIRS, random_surface


@pytest.mark.parametrize("kind", KINDS)
def test_a_curve_departs_by_the_distance_from_its_classical_one(kind):
    curve, u = random_curve(kind, contrast=4.0), Grid.uniform(57)
    apart = np.linalg.norm(curve.sample(u) - curve.classical.sample(u), axis=1)
    assert_allclose(curve_departures(curve, u), apart, atol=1e-12)


@pytest.mark.parametrize("kinds", PAIRS)
def test_so_does_a_surface(kinds):
    surface = random_surface(*kinds, contrast=4.0)
    u, v = Grid.uniform(9), Grid.uniform(7)
    apart = np.linalg.norm(surface.sample(u, v) - surface.classical.sample(u, v), axis=2)
    assert_allclose(surface_departures(surface, u, v), apart, atol=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_no_point_departs_farther_than_the_largest_says(kind):
    curve = random_curve(kind)
    found = departure(curve)
    everywhere = curve_departures(curve, Grid.uniform(20_001))
    assert_allclose(found.largest, everywhere.max(), rtol=1e-4)
    there = np.linalg.norm(curve.at(found.at) - curve.classical.at(found.at))
    assert_allclose(there, found.largest, rtol=1e-3)


def test_two_lines_that_turn_against_each_other_depart_as_their_parabola_does():
    # C - base = u (1 - u) (g_0 - g_1), largest in the middle; its rms is |g_0 - g_1| / sqrt(30).
    lines = ControlLines.of([[0.0, 0.0], [1.0, 0.0]], [[0.0, 1.0], [0.0, -1.0]])
    found = departure(PlusCurve(Bernstein(2), lines, s=3.0))
    assert_allclose(found.largest, 6.0 / 4.0)
    assert_allclose(found.rms, 6.0 / np.sqrt(30.0), rtol=1e-2)
    assert_allclose(found.at, [0.5])


def test_without_s_nothing_departs():
    assert departure(random_curve("bspline").classical).largest == 0.0
    assert surface_departure(replace(random_surface("bspline", "bezier"), s=0.0)).largest == 0.0


def test_one_direction_for_all_lines_does_not_take_a_curve_away():
    points = np.random.default_rng(3).random((6, 2))
    lines = ControlLines.of(points, np.tile([3.0, -1.0], (6, 1)))
    assert departure(PlusCurve(Bernstein(6), lines, s=5.0)).largest == 0.0
