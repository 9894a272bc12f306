"""Distances of points from curves, against very many samples."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.geometry.residual import residual
from plusedit.geometry.transforms import transformed
from tests.geometry.curves import KINDS, random_curve


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "staircase"])
@pytest.mark.parametrize("dimension", [2, 3])
def test_no_sample_is_nearer_than_the_foot(kind, dimension):
    curve = random_curve(kind, dimension=dimension, seed=4, s=1.5)
    points = np.random.default_rng(1).uniform(-2.0, 2.0, (40, dimension))
    found = residual(curve, points)
    samples = curve.at(np.linspace(0.0, 1.0, 6001))
    nearest = np.linalg.norm(points[:, None] - samples, axis=2).min(axis=1)
    assert (found.distances <= nearest * (1.0 + 1e-9)).all()
    assert_allclose(found.distances, nearest, atol=2e-2)


@given(st.sampled_from(KINDS), st.integers(0, 10**6), st.floats(-1e6, 1e6))
def test_feet_are_as_near_wherever_the_curve_lies(kind, seed, far):
    curve = random_curve(kind, seed=seed)
    shift = np.array([far, -far])
    points = np.random.default_rng(seed).normal(size=(20, 2))
    near = residual(curve, points).distances
    moved = residual(transformed(curve, np.eye(2), shift), points + shift)
    assert_allclose(moved.distances, near, atol=1e-8)


def test_points_of_the_curve_are_at_no_distance():
    curve = random_curve("bspline", s=1.0)
    found = residual(curve, curve.at(np.linspace(0.0, 1.0, 33)))
    assert found.largest < 1e-14
    assert found.rms <= found.largest


@pytest.mark.parametrize("kind", KINDS)
def test_points_of_a_tangled_curve_are_their_own_feet(kind):
    curve = random_curve(kind, seed=7)
    points = curve.at(np.linspace(0.0, 1.0, 301))
    assert residual(curve, points).largest < 1e-13
