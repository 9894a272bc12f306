import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.geometry.arrays import unit
from plusedit.interaction.following import FLATTEST, Follower
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.space_camera import SpaceCamera

SIZE = (800.0, 600.0)

cameras = st.one_of(
    st.builds(
        lambda yaw, pitch, perspective: SpaceCamera(
            SIZE, height=8.0, yaw=yaw, pitch=pitch, perspective=perspective
        ),
        st.floats(-3.0, 3.0),
        st.floats(-1.57, 1.57),
        st.booleans(),
    ),
    st.sampled_from([PlaneCamera(SIZE, projection=name) for name in ("top", "front", "right")]),
)
points = st.tuples(*[st.floats(-2.0, 2.0)] * 3).map(np.array)
ways = (
    st.tuples(*[st.floats(-1.0, 1.0)] * 3).map(np.array).filter(lambda w: np.linalg.norm(w) > 0.1)
)
pixels = st.tuples(*[st.floats(-400.0, 400.0)] * 2).map(np.array)
bases = st.one_of(
    ways.map(lambda way: unit(way)[None]),
    st.sampled_from([np.eye(3)[[0, 1]], np.eye(3)[[0, 2]], np.eye(3)[[1, 2]]]),
)


def flatness(camera, point, basis):
    """How well the subspace is seen, from 0, end on."""
    toward = -camera.ray(camera.to_screen(point[None])[0])[1]
    across = basis - np.outer(basis @ toward, toward)
    return np.linalg.svd(across, compute_uv=False).min()


@given(cameras, points, bases, st.floats(-0.5, 0.5))
def test_what_is_held_stays_under_the_pointer(camera, point, basis, far):
    assume(flatness(camera, point, basis) > 1.2 * FLATTEST)
    goal = point + far * basis.sum(axis=0)
    pixels = np.diff(camera.to_screen(np.stack([point, goal])), axis=0)[0]
    assert_allclose(point + Follower(camera, point, basis).by(pixels), goal, atol=1e-6)


@given(cameras, points, bases, pixels, st.floats(0.0, 6.3))
def test_small_steps_of_the_pointer_are_small_steps_of_what_it_holds(
    camera, point, basis, at, angle
):
    follower, step = Follower(camera, point, basis), np.array([np.cos(angle), np.sin(angle)])
    moved = np.linalg.norm(follower.by(at + step) - follower.by(at))
    pixel = camera.pixel_at(point[None])[0]
    assert moved <= 8.0 / FLATTEST * pixel


@given(cameras, points, bases)
def test_the_pointer_back_at_the_start_is_no_shift_at_all(camera, point, basis):
    assert not Follower(camera, point, basis).by(np.zeros(2)).any()


@pytest.mark.parametrize("perspective", [True, False])
def test_an_axis_seen_end_on_follows_the_pointer_upwards(perspective):
    camera = SpaceCamera(SIZE, yaw=0.0, pitch=np.pi / 2, perspective=perspective)
    follower = Follower(camera, np.zeros(3), np.array([[0.0, 0.0, 1.0]]))
    assert_allclose(follower.by(np.array([30.0, -12.0])), [0.0, 0.0, 12.0 * camera.pixel])
