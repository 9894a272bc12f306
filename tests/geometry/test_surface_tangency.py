"""Corners that are tangent to the control net or to a plane."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.surface_tangency import (
    CORNERS,
    tangent_at_corners,
    tangent_to_plane,
    tangent_to_planes,
)
from tests.geometry.surfaces import a_surface, random_surface

KINDS = [("bezier", "bspline"), ("kinks", "high order"), ("polygon", "bezier")]
every_kind = pytest.mark.parametrize("kinds", KINDS)
every_corner = pytest.mark.parametrize("corner", CORNERS)
weighted_or_not = pytest.mark.parametrize("contrast", [None, 5.0])


def surface_of(kinds, contrast=None, shape=(7, 6), seed=0):
    return random_surface(*kinds, shape=shape, s=1.3, contrast=contrast, seed=seed)


def tangents(surface, corner):
    """S_u and S_v at a corner."""
    _, by_u, by_v = surface.derivatives([corner[0]], [corner[1]], highest=1)
    return by_u[0, 0], by_v[0, 0]


def edges(surface, corner):
    """The edges of the control net at a corner, in the sense of u and of v."""
    points = surface.planes.points[:: 1 - 2 * corner[0], :: 1 - 2 * corner[1]]
    to_u, to_v = points[1, 0] - points[0, 0], points[0, 1] - points[0, 0]
    return to_u * (1 - 2 * corner[0]), to_v * (1 - 2 * corner[1])


def assert_along(vector, edge):
    """In one direction, forwards."""
    size = np.linalg.norm(vector) * np.linalg.norm(edge)
    assert_allclose(np.cross(vector, edge), 0.0, atol=1e-10 * size)
    assert vector @ edge > 0.0


@every_kind
@weighted_or_not
def test_at_every_corner_the_surface_leaves_along_its_net(kinds, contrast):
    for seed in range(5):
        surface = tangent_at_corners(surface_of(kinds, contrast, seed=seed))
        for corner in CORNERS:
            for tangent, edge in zip(
                tangents(surface, corner), edges(surface, corner), strict=True
            ):
                assert_along(tangent, edge)


@every_corner
@pytest.mark.parametrize("way", ["u", "v"])
def test_one_corner_and_one_way_turn_one_gradient(corner, way):
    surface = surface_of(("bezier", "bspline"), contrast=3.0)
    made = tangent_at_corners(surface, [corner], [way])
    changed = (made.directions != surface.directions).any(axis=-1)
    assert changed.sum() == 1
    assert changed[0 if way == "u" else 1].sum() == 1
    by = 0 if way == "u" else 1
    assert_along(tangents(made, corner)[by], edges(made, corner)[by])
    assert_array_equal(made.planes.points, surface.planes.points)


@every_corner
def test_no_smaller_change_makes_it_tangent(corner):
    surface = a_surface(5, 5, s=1.5)
    made = tangent_at_corners(surface, [corner], ["u"])
    change = (made.gradients - surface.gradients).reshape(-1, 3)
    (changed,) = change[np.abs(change).max(axis=1) > 0.0]
    assert abs(changed @ edges(surface, corner)[0]) < 1e-12


def test_a_corner_that_would_run_backwards_is_slowed_down_instead():
    surface = a_surface(5, 5, s=1.0)
    directions = surface.directions.copy()
    directions[0, 1, 0] = 50.0 * edges(surface, (0, 0))[0]
    wild = surface.with_net(surface.planes.with_directions(directions))
    tangent = tangents(tangent_at_corners(wild), (0, 0))[0]
    edge = edges(wild, (0, 0))[0]
    assert_along(tangent, edge)
    classical = np.linalg.norm(tangents(wild.classical, (0, 0))[0])
    assert np.linalg.norm(tangent) == pytest.approx(0.1 * classical)


@every_kind
@weighted_or_not
@every_corner
def test_the_surface_touches_the_plane_given_at_a_corner(kinds, contrast, corner):
    surface = surface_of(kinds, contrast)
    normal = np.array([3.0, -4.0, 12.0])
    made = tangent_to_plane(surface, corner, normal)
    for tangent in tangents(made, corner):
        assert abs(tangent @ normal) < 1e-10 * np.linalg.norm(tangent) * 13.0
    change = (made.gradients - surface.gradients).reshape(-1, 3)
    changed = change[np.abs(change).max(axis=1) > 0.0]
    assert len(changed) == 2
    assert_allclose(np.cross(changed, normal), 0.0, atol=1e-9)


@every_corner
def test_without_a_normal_it_is_the_control_plane_of_the_corner(corner):
    surface = surface_of(("bezier", "bezier"), shape=(4, 4))
    made = tangent_to_plane(surface, corner)
    i, j = -corner[0], -corner[1]
    plane = np.cross(*surface.directions[:, i, j])
    for tangent in tangents(made, corner):
        assert abs(tangent @ plane) < 1e-10 * np.linalg.norm(tangent)


@weighted_or_not
def test_with_3_x_3_planes_each_middle_one_serves_two_corners(contrast):
    surface = surface_of(("bezier", "bspline"), contrast, shape=(3, 3))
    normals = dict(zip(CORNERS, np.random.default_rng(1).normal(size=(4, 3)), strict=True))
    made = tangent_to_planes(surface, normals)
    for corner, normal in normals.items():
        for tangent in tangents(made, corner):
            assert abs(tangent @ normal) < 1e-10 * np.linalg.norm(tangent) * np.linalg.norm(normal)
    assert_array_equal(made.gradients[:, 1, 1], surface.gradients[:, 1, 1])


def test_one_plane_for_two_corners_is_met_where_both_ask_for_the_same():
    flat = a_surface(3, 3, s=1.0)
    flat = flat.with_net(flat.planes.with_points(flat.planes.points * [1.0, 1.0, 0.0]))
    up, down = (0.0, 0.0, 1.0), (0.0, 0.0, -2.0)
    made = tangent_to_planes(flat, {(0, 0): up, (1, 0): down})
    assert_allclose(made.directions, flat.directions)
    bent = flat.planes.points.copy()
    bent[2, 0, 2] = 1.0
    with pytest.raises(ValueError, match="share the middle one"):
        tangent_to_planes(flat.with_net(flat.planes.with_points(bent)), {(0, 0): up, (1, 0): down})


def test_a_plane_square_to_the_surface_is_refused():
    surface = a_surface(4, 4, s=1.0)
    across = tangents(surface, (0, 0))[0]
    with pytest.raises(ValueError, match="would stand still"):
        tangent_to_plane(surface, (0, 0), across)


@pytest.mark.parametrize("make", [tangent_at_corners, lambda s: tangent_to_plane(s, (0, 0))])
@pytest.mark.parametrize(
    ("surface", "sentence"),
    [
        (random_surface("closed", "bezier"), "closes along u has no corners"),
        (random_surface("bezier", "closed rag"), "closes along v has no corners"),
        (random_surface("bezier", "rag"), "Along v the surface is rational Gaussian"),
        (a_surface(4, 4, s=0.0), "With s = 0"),
        (a_surface(2, 4), "at least 3 control planes along u"),
    ],
)
def test_surfaces_without_such_corners_are_refused_in_a_sentence(make, surface, sentence):
    with pytest.raises(ValueError, match=sentence):
        make(surface)


@weighted_or_not
@pytest.mark.parametrize("straight", [False, True])
def test_of_3_x_3_planes_with_automatic_directions_each_middle_one_serves_two_corners(
    contrast, straight
):
    surface = surface_of(("bezier", "bspline"), contrast, shape=(3, 3))
    sheet = a_surface(3, 3)
    points = sheet.planes.points * [1.0, 1.0, 0.0 if straight else 1.0]
    surface = surface.with_net(sheet.planes.with_points(points))
    made = tangent_at_corners(surface)
    for corner in CORNERS:
        for tangent, edge in zip(tangents(made, corner), edges(made, corner), strict=True):
            assert_along(tangent, edge)


def test_of_3_planes_the_middle_one_can_not_serve_any_two_corners():
    surface = surface_of(("bezier", "bspline"), shape=(3, 5))
    with pytest.raises(ValueError, match="share the middle one"):
        tangent_at_corners(surface)
    made = tangent_at_corners(surface, [(0, 0), (0, 1)])
    assert_along(tangents(made, (0, 1))[0], edges(made, (0, 1))[0])


def test_a_net_without_an_edge_is_refused():
    surface = a_surface(4, 4)
    points = surface.planes.points.copy()
    points[1, 0] = points[0, 0]
    with pytest.raises(ValueError, match="no edge"):
        tangent_at_corners(surface.with_net(surface.planes.with_points(points)))


def test_a_normal_that_is_zero_is_refused():
    with pytest.raises(ValueError, match="normal: "):
        tangent_to_plane(a_surface(), (0, 0), (0.0, 0.0, 0.0))


def test_directions_without_a_plane_are_refused():
    surface = a_surface()
    directions = surface.directions.copy()
    directions[1, 0, 0] = directions[0, 0, 0]
    flat = replace(surface, planes=surface.planes.with_directions(directions))
    with pytest.raises(ValueError, match="has no normal"):
        tangent_to_plane(flat, (0, 0))
