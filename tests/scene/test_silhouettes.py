"""Where a surface turns away from the eye."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.making.primitives import sphere, torus
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.silhouettes import silhouette
from plusedit.scene.space_camera import STANDARD, SpaceCamera
from tests.geometry.surfaces import PAIRS, a_surface, random_surface

SIZE = (800.0, 600.0)
CAMERA = SpaceCamera(SIZE, height=4.0)
CAMERAS = [CAMERA, PlaneCamera(SIZE), PlaneCamera(SIZE, projection="front")]


def lines_of(surface, camera):
    return silhouette(surface, camera, surface_grids(surface, camera))


def test_a_sphere_is_outlined_by_a_circle():
    ball = sphere(radius=1.0)
    for name in ("front", "iso"):
        camera = replace(CAMERA, perspective=False).looking(name)
        lines = [points for points in lines_of(ball, camera) if len(points) > 8]
        off = [camera.to_screen(points) - np.array(SIZE) / 2.0 for points in lines]
        radii = np.hypot(*np.concatenate(off).T)
        outer = radii[radii > 0.8 * radii.max()]
        assert len(outer) > 40
        assert_allclose(outer, outer.mean(), rtol=0.06)


@pytest.mark.parametrize("view", list(STANDARD))
def test_lines_of_a_torus_run_round_and_come_back(view):
    ring = torus()
    camera = SpaceCamera(SIZE, height=8.0).looking(view)
    lines = lines_of(ring, camera)
    assert lines
    low, high = (np.concatenate(lines).min(axis=0), np.concatenate(lines).max(axis=0))
    assert np.linalg.norm(high - low) > 1.0
    for points in lines:
        steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
        assert steps.max() < 0.5


@pytest.mark.parametrize("kinds", PAIRS)
@pytest.mark.parametrize(
    "camera", [CAMERA, PlaneCamera(SIZE), PlaneCamera(SIZE, projection="front")]
)
def test_every_surface_has_finite_lines(kinds, camera):
    for points in lines_of(random_surface(*kinds), camera):
        assert len(points) > 1
        assert np.isfinite(points).all()


def test_a_gentle_sheet_seen_from_above_has_none():
    assert not lines_of(a_surface(s=0.0), PlaneCamera(SIZE, (1.5, 2.0)))


def test_panning_and_zooming_the_plane_keep_the_lines():
    ring = torus()
    grids = surface_grids(ring, PlaneCamera(SIZE))
    first = silhouette(ring, PlaneCamera(SIZE), grids)
    assert silhouette(ring, PlaneCamera(SIZE, (3.0, 1.0), 250.0), grids) is first


def test_lines_in_space_stand_before_the_surface_at_the_same_pixels():
    ring = torus()
    parallel = replace(CAMERA, perspective=False, yaw=0.0, pitch=np.pi / 2.0)
    grids = surface_grids(ring, parallel)
    lifted, flat = (
        np.concatenate(silhouette(ring, camera, grids))[:, :2]
        for camera in (parallel, PlaneCamera(SIZE))
    )
    assert_allclose(lifted, flat, atol=1e-6)
