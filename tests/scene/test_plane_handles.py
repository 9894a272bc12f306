from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.control_planes import control_plane_items
from plusedit.scene.items import Markers, Polygon
from plusedit.scene.plane_handles import LEAST, SIDE, plane_handles
from plusedit.scene.space_camera import SpaceCamera
from tests.geometry.surfaces import a_surface, surfaces

SIZE = (800.0, 600.0)
CAMERAS = [
    PlaneCamera(SIZE, (1.5, 2.0), 60.0),
    PlaneCamera(SIZE, (1.5, 0.0), 60.0, "front"),
    PlaneCamera(SIZE, (2.0, 0.0), 60.0, "right"),
    SpaceCamera(SIZE, (1.5, 2.0, 0.0), 6.0),
    SpaceCamera(SIZE, (1.5, 2.0, 0.0), 6.0, perspective=False),
]

every_camera = pytest.mark.parametrize("camera", CAMERAS, ids=str)


def flat_plane(by_u, by_v, camera):
    """The handles of a surface whose first plane has those directions."""
    points = np.array([[[0.0, 0.0, 0.0], [0.0, 9.0, 0.0]], [[9.0, 0.0, 0.0], [9.0, 9.0, 0.0]]])
    rows_u, rows_v = ([[way, None], [None, None]] for way in (by_u, by_v))
    planes = ControlPlanes.of(points, rows_u, rows_v)
    return plane_handles(PlusSurface(BSpline(2, 2), BSpline(2, 2), planes, 1.0), camera)


def seen_sides(at, camera):
    corners = camera.to_screen(at.corners.reshape(-1, 3)).reshape(-1, 4, 2)
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)


@every_camera
def test_squares_look_alike_at_any_zoom(camera):
    from_above = replace(camera, pitch=np.pi / 2) if isinstance(camera, SpaceCamera) else camera
    if getattr(camera, "projection", "top") == "top":
        at = flat_plane([1.0, 0.0, 0.0], [0.0, 3.0, 0.0], from_above)
        assert_allclose(seen_sides(at, from_above)[0], SIDE, rtol=0.05)


@given(surfaces())
def test_squares_are_square_and_lie_in_the_plane_of_both_directions(surface):
    at = plane_handles(surface, CAMERAS[3])
    across = np.einsum("nij,nkj->nik", at.frames, at.frames)
    assert_allclose(across, np.broadcast_to(np.eye(3), across.shape), atol=1e-9)
    normal = at.frames[:, 2]
    lengths = np.linalg.norm(surface.vectors, axis=2)
    off = np.abs(np.einsum("knd,nd->kn", surface.vectors, normal)) / np.where(lengths, lengths, 1.0)
    assert (off[:, at.flat] < 1e-6).all()


@given(surfaces())
def test_the_normal_is_that_of_d_u_and_d_v(surface):
    at = plane_handles(surface, CAMERAS[3])
    by_u, by_v = surface.vectors
    assert (np.einsum("nd,nd->n", np.cross(by_u, by_v), at.frames[:, 2])[at.flat] > 0.0).all()


@every_camera
def test_grips_stand_where_the_directions_point_and_are_never_lost_in_the_dot(camera):
    surface = a_surface()
    at = plane_handles(surface, camera)
    arms = at.tips_world - surface.planes.control_points
    across = np.linalg.norm(np.cross(arms, surface.vectors), axis=2)
    assert_allclose(across, 0.0, atol=1e-9)
    assert (np.einsum("knd,knd->kn", arms, surface.vectors)[at.drawn] > 0.0).all()
    steep = np.linalg.norm(at.tips - at.points, axis=2)[at.drawn]
    assert (steep > 0.5 * LEAST).all()


@pytest.mark.parametrize(("normal", "front"), [(1.0, True), (-1.0, False)])
def test_a_square_shows_the_eye_its_front_or_its_back(normal, front):
    for camera in CAMERAS[0], SpaceCamera(SIZE, height=20.0):
        at = flat_plane([normal, 0.0, 0.0], [0.0, 1.0, 0.0], camera)
        assert at.front[0] == front


@pytest.mark.parametrize(
    ("by_u", "by_v", "drawn"),
    [
        ([0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [False, True]),
        ([0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [False, False]),
        ([1.0, 1.0, 0.0], [2.0, 2.0, 0.0], [True, True]),
        ([1.0, 1.0, 0.0], [-1.0, -1.0, 0.0], [True, True]),
    ],
)
@every_camera
def test_directions_that_span_no_plane_have_a_square_all_the_same(by_u, by_v, drawn, camera):
    at = flat_plane(by_u, by_v, camera)
    assert not at.flat[0]
    assert np.isfinite(at.corners).all()
    seen = [d and np.ptp(at.tips[way, 0] - at.points[0]) > 1.0 for way, d in enumerate(drawn)]
    assert seen == (drawn if seen.count(True) == drawn.count(True) else seen)
    assert_array_equal(at.tips[:, 0][[not d for d in drawn]], at.points[[0] * drawn.count(False)])
    assert_allclose(np.linalg.norm(at.frames[0], axis=1), 1.0)


@given(st.floats(-0.2, 0.2))
def test_a_direction_that_turns_end_on_goes_through_the_dot_without_a_jump(tilt):
    camera = PlaneCamera(SIZE, scale=60.0)
    tips = [
        flat_plane([np.sin(t), 0.0, np.cos(t)], [0.0, 1.0, 0.0], camera).tips[0, 0]
        for t in (tilt, tilt + 1e-3)
    ]
    assert np.linalg.norm(tips[1] - tips[0]) < 0.5


def test_a_dense_net_shows_the_grips_of_selected_planes_only():
    dense = a_surface(30, 30)
    at = plane_handles(dense, CAMERAS[3])
    assert at.gripped((7,)).sum() == 2
    assert plane_handles(a_surface(), CAMERAS[3]).gripped(()).all()


@every_camera
def test_what_is_drawn_of_planes_is_in_space_and_finite(camera):
    surface = a_surface()
    items = list(control_plane_items(surface, camera, selected=(3, 7), active=7))
    for item in items:
        points = item.points if hasattr(item, "points") else item.starts
        assert points.shape[-1] == 3 and np.isfinite(points).all()
    assert sum(isinstance(item, Polygon) for item in items) == 2
    hollow = [item for item in items if isinstance(item, Markers) and item.fill is None]
    assert sum(len(item.points) for item in hollow) == plane_handles(surface, camera).drawn.sum()


def test_planes_turned_by_hand_are_solid():
    surface = a_surface()
    given = surface.with_net(surface.planes.with_directions(surface.directions))
    items = list(control_plane_items(given, CAMERAS[3]))
    assert sum(isinstance(item, Polygon) for item in items) == 20
    assert not any(isinstance(item, Markers) and item.fill is None for item in items)
