"""Curvature against circles, helices and finite differences."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.frames import curvature, curvature_at, space_curvature
from tests.geometry.curves import random_curve


def circle(radius, turns=1.0):
    """Velocity and acceleration of radius * (cos, sin)(turns * t), t from 0 to 1."""
    angle = turns * np.linspace(0.0, 1.0, 17)
    velocity = radius * turns * np.stack([-np.sin(angle), np.cos(angle)], axis=1)
    acceleration = -radius * turns**2 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return velocity, acceleration


@pytest.mark.parametrize("radius", [1e-120, 0.01, 1.0, 1000.0, 1e100])
def test_a_circle_has_curvature_one_over_its_radius(radius):
    assert_allclose(curvature(*circle(radius)), 1.0 / radius)
    assert_allclose(space_curvature(*circle(radius)), 1.0 / radius)


def test_a_circle_run_clockwise_has_negative_curvature():
    assert_allclose(curvature(*circle(1.0, turns=-1.0)), -1.0)
    assert_allclose(space_curvature(*circle(1.0, turns=-1.0)), 1.0)


def test_curvature_does_not_depend_on_the_parameter():
    assert_allclose(curvature(*circle(2.0, turns=5.0)), curvature(*circle(2.0)))


def test_curvature_where_the_curve_stands_still_is_nan():
    still, any_acceleration = np.zeros((1, 2)), np.ones((1, 2))
    assert np.isnan(curvature(still, any_acceleration)).all()
    assert np.isnan(space_curvature(still, any_acceleration)).all()


def test_a_straight_piece_has_none():
    velocity = np.array([[1.0, 2.0]])
    assert curvature(velocity, 3.0 * velocity) == 0.0
    assert_allclose(space_curvature(velocity, 3.0 * velocity), 0.0, atol=1e-15)


def test_a_helix_has_the_curvature_of_the_books():
    t, radius, pitch = np.linspace(0.0, 6.0, 20), 2.0, 0.5
    velocity = np.stack([-radius * np.sin(t), radius * np.cos(t), np.full_like(t, pitch)], axis=1)
    acceleration = np.stack([-radius * np.cos(t), -radius * np.sin(t), 0.0 * t], axis=1)
    expected = radius / (radius**2 + pitch**2)
    assert_allclose(space_curvature(velocity, acceleration), expected)


def test_signed_curvature_of_a_space_curve_is_refused_with_the_alternative():
    with pytest.raises(ValueError, match="plane curves"):
        curvature(np.ones((3, 3)), np.ones((3, 3)))


@pytest.mark.parametrize("kind", ["bezier", "bspline", "closed", "rag"])
def test_it_is_the_rate_at_which_the_tangent_turns(kind):
    curve, step = random_curve(kind, seed=5), 1e-6
    u = np.array([0.12, 0.43, 0.77])
    _, velocity, acceleration = curve.derivatives(u)
    before, after = (curve.derivatives(u + by, highest=1)[1] for by in (-step, step))
    turn = np.arctan2(
        before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1)
    )
    way = 2.0 * step * np.linalg.norm(velocity, axis=1)
    assert_allclose(curvature(velocity, acceleration), turn / way, rtol=1e-4)


def test_of_a_plane_curve_it_has_a_sign_and_of_a_space_curve_none():
    plane, space = random_curve("bezier", seed=5), random_curve("bezier", seed=5, dimension=3)
    u = np.linspace(0.0, 1.0, 50)
    assert curvature_at(plane, u).min() < 0.0
    assert curvature_at(space, u).min() >= 0.0
