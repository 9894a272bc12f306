"""The nearest point against looking at very many."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.frames import curvature
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.nearest import nearest_parameter, nearest_parameters, nearest_to_ray
from plusedit.geometry.standard import elliptic_arc
from tests.geometry.curves import KINDS, random_curve


def missed(curve, u, points):
    """Distances of the points from the curve at u."""
    return np.linalg.norm(curve.at(u) - points, axis=1)


def by_looking(curve, points, count=20001):
    """The least distances among very many points of the curve."""
    there = curve.at(np.linspace(0.0, 1.0, count))
    return np.array([np.linalg.norm(there - point, axis=1).min() for point in points])


@st.composite
def curves(draw):
    """Plane curves and space curves of every kind, with even weights and very uneven ones."""
    return random_curve(
        draw(st.sampled_from(KINDS)),
        size=draw(st.integers(6, 12)),
        seed=draw(st.integers(0, 10**6)),
        dimension=draw(st.integers(2, 3)),
        contrast=draw(st.sampled_from([None, 10.0, 1000.0])),
    )


def points_for(curve, seed, count=8):
    """Points in and about the curve, some of them far away."""
    random = np.random.default_rng(seed)
    spread = 10.0 ** random.uniform(-1.0, 2.0, (count, 1))
    return spread * random.normal(size=(count, curve.dimension))


@settings(max_examples=100)
@given(curves(), st.integers(0, 10**6))
def test_no_other_point_of_a_curve_is_nearer(curve, seed):
    points = points_for(curve, seed)
    found = missed(curve, nearest_parameters(curve, points), points)
    assert (found <= by_looking(curve, points, 4001) * (1.0 + 1e-9)).all()


@settings(max_examples=100)
@given(curves(), st.floats(0.0, 1.0), st.floats(-0.5, 0.5))
def test_from_beside_a_curve_it_is_never_farther_than_the_way_back(curve, u, share):
    if curve.dimension == 3:
        return
    at, velocity, acceleration = curve.derivatives([u])
    speed = np.linalg.norm(velocity)
    if speed < 1e-6:
        return
    # Up to half the radius of curvature away, no other point about there is as near.
    distance = share / max(abs(curvature(velocity, acceleration)[0]), 1.0)
    point = at + distance * velocity[:, ::-1] * [-1.0, 1.0] / speed
    found = missed(curve, nearest_parameters(curve, point), point)[0]
    assert found <= abs(distance) * (1.0 + 1e-9) + 1e-13


@given(curves(), st.integers(0, 10**6))
def test_many_points_are_as_near_as_each_alone(curve, seed):
    points = points_for(curve, seed, 20)
    together = missed(curve, nearest_parameters(curve, points), points)
    alone = np.array([nearest_parameter(curve, point) for point in points])
    assert_allclose(together, missed(curve, alone, points), rtol=1e-12)


@given(curves(), st.integers(0, 10**6))
def test_no_other_point_of_a_curve_is_nearer_to_a_ray(curve, seed):
    origin, direction = points_for(random_curve("bezier", dimension=3), seed, 2)
    everywhere = in_space(curve.at(np.linspace(0.0, 1.0, 4001)))
    found = in_space(curve.at(nearest_to_ray(curve, origin, direction)))
    least = from_ray(everywhere, origin, direction).min()
    assert from_ray(found, origin, direction)[0] <= least * (1.0 + 1e-9) + 1e-13


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("contrast", [None, 100.0])
def test_nothing_nearer_is_found_by_looking(kind, dimension, contrast):
    for seed in range(3):
        curve = random_curve(kind, seed=seed, dimension=dimension, contrast=contrast)
        points = np.random.default_rng(seed).normal(0.0, 1.5, (20, dimension))
        found = missed(curve, nearest_parameters(curve, points), points)
        assert (found <= by_looking(curve, points) * (1.0 + 1e-9)).all()


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "staircase"])
def test_a_point_of_the_curve_is_its_own_nearest(kind):
    curve = random_curve(kind, seed=4)
    u = np.random.default_rng(1).uniform(0.0, 1.0, 50)
    points = curve.at(u)
    assert missed(curve, nearest_parameters(curve, points), points).max() < 1e-13


@pytest.mark.parametrize("kind", KINDS)
def test_the_way_there_is_square_to_the_curve(kind):
    curve = random_curve(kind, seed=5)
    points = np.random.default_rng(2).normal(0.0, 1.5, (40, 2))
    u = nearest_parameters(curve, points)
    at, velocity = curve.derivatives(u, highest=1)
    inside = ~np.isin(u, np.append(curve.basis.nodes, [0.0, 1.0]))
    if isinstance(curve.basis, BSpline):
        inside &= np.abs(u[:, None] - curve.basis.breaks).min(axis=1) > 1e-9
    way = at - points
    cosine = (way * velocity).sum(axis=1) / np.linalg.norm(velocity, axis=1)
    assert_allclose(cosine[inside], 0.0, atol=1e-9)


def test_on_a_straight_line_it_is_the_foot_or_an_end():
    lines = ControlLines.of([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)])
    curve = PlusCurve(Bernstein(3), lines, s=2.0)
    u = nearest_parameters(curve, [(0.5, 3.0), (-4.0, 1.0), (9.0, -1.0), (2.0, 0.0)])
    assert_allclose(u, [0.25, 0.0, 1.0, 1.0], atol=1e-15)


def test_at_a_kink_it_is_the_kink():
    curve = PlusCurve(BSpline(3, 2), ControlLines.of([(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)]), s=0.0)
    assert nearest_parameter(curve, (1.0, 5.0)) == 0.5


def test_the_seam_of_a_closed_curve_is_a_place_like_any_other():
    angle = 2.0 * np.pi * np.arange(8) / 8
    points = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    curve = PlusCurve(BSpline(8, 4, closed=True), ControlLines.of(points), s=3.0)
    straight_ahead = nearest_parameter(curve, (5.0, 0.0))
    assert min(straight_ahead, 1.0 - straight_ahead) < 1e-12
    u = nearest_parameters(curve, [(5.0, 1e-3), (5.0, -1e-3)])
    assert 0.0 < u[0] < 0.01
    assert 0.99 < u[1] < 1.0


def test_seen_from_the_front_depth_does_not_count():
    curve = random_curve("bspline", dimension=3, seed=6)
    point = np.array([0.2, 0.3])
    u = nearest_parameter(curve, point, axes=(0, 2))
    flat = PlusCurve(
        curve.basis,
        ControlLines.of(
            curve.lines.points[:, [0, 2]], list(curve.directions[:, [0, 2]]), curve.lines.weights
        ),
        curve.s,
    )
    assert_allclose(u, nearest_parameter(flat, point), atol=1e-12)


def test_a_plane_curve_seen_from_the_front_lies_on_the_axis():
    curve = random_curve("bspline", seed=6)
    u = nearest_parameter(curve, (0.0, 7.0), axes=(0, 2))
    assert_allclose(
        abs(curve.at(u)[0, 0]), np.abs(curve.at(np.linspace(0, 1, 999))[:, 0]).min(), atol=1e-2
    )


def test_at_the_center_of_a_circle_every_point_is_as_near_as_the_others():
    circle = elliptic_arc([1.0, 2.0], [3.0, 0.0], [0.0, 3.0])
    center = np.tile([1.0, 2.0], (50, 1))
    assert_allclose(missed(circle, nearest_parameters(circle, center), center), 3.0, rtol=1e-14)


def test_beyond_the_ends_a_few_steps_do(monkeypatch):
    curve = random_curve("bspline", seed=1)
    points = np.random.default_rng(1).normal(0.0, 10.0, (300, 2))
    steps = []
    derivatives = PlusCurve.derivatives

    def counted(self, u, *, highest=2):
        steps.extend([u] if highest == 2 else [])
        return derivatives(self, u, highest=highest)

    monkeypatch.setattr(PlusCurve, "derivatives", counted)
    u = nearest_parameters(curve, points)
    assert np.isin(u, [0.0, 1.0]).any()
    assert len(steps) < 10


def test_points_all_in_one_place_are_near_at_any_parameter():
    curve = PlusCurve(Bernstein(3), ControlLines.of([(1.0, 1.0)] * 3))
    assert 0.0 <= nearest_parameter(curve, (4.0, 5.0)) <= 1.0


@pytest.mark.parametrize("scale", [1e-120, 1e80])
def test_the_size_does_not_matter(scale):
    curve = random_curve("bezier", seed=7)
    large = PlusCurve(
        curve.basis,
        ControlLines.of(scale * curve.lines.points, list(scale * curve.directions)),
        curve.s,
    )
    point = np.array([0.4, 0.3])
    assert_allclose(nearest_parameter(large, scale * point), nearest_parameter(curve, point))


def test_what_is_too_large_to_be_squared_has_a_parameter_all_the_same():
    curve = random_curve("bspline", seed=3)
    lines = ControlLines.of(1e90 * curve.lines.points, list(1e90 * curve.directions))
    with np.errstate(all="ignore"):
        u = nearest_parameters(PlusCurve(curve.basis, lines, s=1e90), np.eye(2))
    assert ((u >= 0.0) & (u <= 1.0)).all()


def test_no_points_have_no_parameters():
    assert nearest_parameters(random_curve("bezier"), np.zeros((0, 2))).shape == (0,)


@pytest.mark.parametrize("point", [(1.0, 2.0, 3.0), (np.nan, 0.0)])
def test_points_that_do_not_fit_are_refused(point):
    with pytest.raises(ValueError, match="points: "):
        nearest_parameter(random_curve("bezier"), point)


def from_ray(points, origin, direction):
    """Distances of points in space from a ray."""
    heading = np.asarray(direction) / np.linalg.norm(direction)
    ahead = np.maximum((points - origin) @ heading, 0.0)
    return np.linalg.norm(points - origin - ahead[:, None] * heading, axis=1)


def in_space(points):
    return np.pad(points, ((0, 0), (0, 3 - points.shape[1])))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dimension", [2, 3])
def test_nothing_nearer_to_a_ray_is_found_by_looking(kind, dimension):
    curve = random_curve(kind, seed=2, dimension=dimension, contrast=10.0)
    everywhere = in_space(curve.at(np.linspace(0.0, 1.0, 20001)))
    random = np.random.default_rng(4)
    for _ in range(20):
        origin, direction = random.normal(0.0, 1.5, 3), random.normal(size=3)
        found = in_space(curve.at(nearest_to_ray(curve, origin, direction)))
        least = from_ray(everywhere, origin, direction).min()
        assert from_ray(found, origin, direction)[0] <= least * (1.0 + 1e-9) + 1e-15


def test_a_ray_through_a_point_of_the_curve_finds_it():
    curve = random_curve("bspline", dimension=3, seed=3)
    eye = np.array([0.3, -5.0, 8.0])
    for u in (0.0, 0.21, 0.5, 0.987):
        there = curve.at(u)[0]
        assert_allclose(nearest_to_ray(curve, eye, there - eye), u, atol=1e-9)


def test_what_is_behind_the_origin_of_a_ray_is_near_only_to_its_origin():
    curve = PlusCurve(Bernstein(2), ControlLines.of([(-4.0, 0.0, 0.0), (6.0, 0.0, 0.0)]), s=0.0)
    along_x = np.array([1.0, 0.0, 0.0])
    assert nearest_to_ray(curve, (9.0, 0.0, 1.0), along_x) == 1.0
    assert curve.at(nearest_to_ray(curve, (9.0, 0.0, 1.0), -along_x))[0, 0] <= 6.0
    down = nearest_to_ray(curve, (1.0, 3.0, 1.0), (0.0, 1.0, 0.0))
    assert_allclose(curve.at(down)[0], [1.0, 0.0, 0.0], atol=1e-9)


@pytest.mark.parametrize("direction", [(0.0, 0.0, 0.0), (np.nan, 0.0, 1.0)])
def test_a_ray_without_a_direction_is_refused(direction):
    with pytest.raises(ValueError, match="direction: "):
        nearest_to_ray(random_curve("bezier"), (0.0, 0.0, 1.0), direction)
