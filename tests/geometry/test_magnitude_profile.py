"""How shapes change with s: against the slow ways of the same numbers."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bending import bending_energy
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.frames import space_curvature
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.magnitude_profile import distances_to_points, magnitude_profile
from plusedit.geometry.natural import best_s_of
from tests.geometry.curves import KINDS, random_curve
from tests.geometry.surfaces import PAIRS, random_surface

S = np.linspace(-1.0, 3.0, 9)


def apart(shape):
    """(n,) how far the shape at its nodes is from its control points."""
    if isinstance(shape, PlusCurve):
        at = shape.sample(Grid(shape.basis.nodes))
    else:
        at = shape.sample(*(Grid(basis.nodes) for basis in shape.bases)).reshape(-1, 3)
    return np.linalg.norm(at - shape.net.control_points, axis=1)


def assert_distances(shape):
    found = distances_to_points(shape, S)
    each = np.array([apart(replace(shape, s=float(s))) for s in S])
    assert_allclose(found.mean, np.sqrt((each**2).mean(axis=1)), atol=1e-12)
    assert_allclose(found.largest, each.max(axis=1), atol=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_distances_are_those_of_the_curves_with_each_s(kind):
    assert_distances(random_curve(kind, contrast=4.0))


@pytest.mark.parametrize("kinds", PAIRS)
def test_distances_are_those_of_the_surfaces_with_each_s(kinds):
    assert_distances(random_surface(*kinds, contrast=4.0))


@pytest.mark.parametrize("kind", ["bezier", "bspline", "closed", "rag", "high order"])
def test_the_mean_distance_is_least_at_the_best_s(kind):
    curve = random_curve(kind)
    best = best_s_of(curve)
    near = distances_to_points(curve, np.array([best - 0.01, best, best + 0.01])).mean
    assert near[1] < near[0]
    assert near[1] < near[2]


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("kind", ["bezier", "bspline", "closed", "rag", "closed rag"])
def test_energies_are_the_bending_energies_of_the_curves_with_each_s(kind, dimension):
    curve = random_curve(kind, dimension=dimension, contrast=2.0)
    found = magnitude_profile(curve, S).energy
    expected = np.array([bending_energy(replace(curve, s=float(s))) for s in S])
    known = np.isfinite(expected)  # near a cusp there may be no number
    assert known.sum() > 6
    assert_allclose(found[known], expected[known], rtol=0.01)


def test_the_largest_curvature_is_that_of_very_many_samples():
    curve = random_curve("bezier", size=5)
    found = magnitude_profile(curve, S).curvature
    u = np.linspace(0.0, 1.0, 20001)
    for s, curvature in zip(S, found, strict=True):
        _, velocity, acceleration = replace(curve, s=float(s)).derivatives(u)
        assert_allclose(curvature, space_curvature(velocity, acceleration).max(), rtol=0.02)


def test_a_circle_has_the_energy_and_the_curvature_of_a_circle():
    points = np.array([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    quarter = PlusCurve(
        Bernstein(3), ControlLines.of(points, weights=np.array([1.0, np.sqrt(0.5), 1.0])), 0.0
    )
    found = magnitude_profile(quarter, np.zeros(1))
    assert_allclose(found.energy, np.pi / 2.0, rtol=1e-6)
    assert_allclose(found.curvature, 1.0, rtol=1e-6)


def test_a_curve_that_stands_still_has_no_curvature():
    still = PlusCurve(BSpline(4), ControlLines.of(np.ones((4, 2))))
    found = magnitude_profile(still, S)
    assert not np.isfinite(found.curvature).any()
    assert found.best is None


def test_what_lies_in_a_plane_has_no_mean_curvature():
    surface = random_surface("bezier", "bezier")
    planes = surface.planes
    flat = replace(
        surface,
        planes=type(planes).of(
            planes.points * (1.0, 1.0, 0.0), *(surface.directions * (1.0, 1.0, 0.0))
        ),
    )
    found = magnitude_profile(flat, S)
    assert_allclose(found.energy, 0.0, atol=1e-12)
    assert_allclose(found.curvature, 0.0, atol=1e-8)
