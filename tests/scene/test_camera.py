import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.scene.camera import AXES, PlaneCamera

numbers = st.floats(-1e4, 1e4)
pixels = st.tuples(st.floats(0.0, 1000.0), st.floats(0.0, 700.0))
cameras = st.builds(
    PlaneCamera,
    st.just((1000.0, 700.0)),
    st.tuples(numbers, numbers),
    st.floats(-6.0, 6.0).map(lambda power: 10.0**power),
    st.sampled_from(sorted(AXES)),
)
PIXEL = 1e-5  # what rounding may make of a pixel this far from the origin


@given(cameras, pixels)
def test_a_pixel_goes_to_the_world_and_back(camera, pixel):
    at = camera.to_world(np.array(pixel), np.zeros(3))
    assert_allclose(camera.to_screen(at[None])[0], pixel, atol=PIXEL)


@given(cameras, pixels)
def test_the_world_point_keeps_the_depth_of_what_it_is_like(camera, pixel):
    like = np.array([7.0, 8.0, 9.0])
    depth = ({0, 1, 2} - set(camera.axes)).pop()
    assert camera.to_world(np.array(pixel), like)[depth] == like[depth]


@given(cameras, pixels, st.floats(0.1, 10.0))
def test_zooming_keeps_the_point_under_the_pointer(camera, pixel, factor):
    held = camera.in_plane(np.array([pixel]))
    zoomed = camera.zoomed(factor, pixel)
    assert_allclose(camera.placed(held), zoomed.placed(held))
    assert_allclose(zoomed.to_screen(zoomed.placed(held))[0], pixel, atol=PIXEL)


@given(cameras, st.tuples(st.floats(-500.0, 500.0), st.floats(-500.0, 500.0)))
def test_panning_shifts_what_is_seen_by_that_many_pixels(camera, by):
    at = camera.placed(np.array([camera.center]))
    shift = camera.panned(by).to_screen(at) - camera.to_screen(at)
    assert_allclose(shift[0], by, atol=PIXEL)


@given(cameras, st.lists(st.tuples(numbers, numbers, numbers), min_size=2, max_size=5))
def test_framing_shows_all_points_inside_the_margin(camera, points):
    at = np.array(points)
    screen = camera.framing(at, margin=50.0).to_screen(at)
    assert (screen >= 50.0 - 1e-3).all()
    assert (screen <= np.array(camera.size) - 50.0 + 1e-3).all()


def test_framing_a_single_point_centers_it_and_keeps_the_scale():
    camera = PlaneCamera((400.0, 300.0), scale=7.0).framing(np.array([[3.0, 4.0]]))
    assert camera.center == (3.0, 4.0)
    assert camera.scale == 7.0


def test_up_in_the_world_is_up_on_the_screen():
    camera = PlaneCamera((400.0, 300.0), scale=10.0)
    assert_array_equal(camera.to_screen(np.array([[1.0, 2.0]])), [[210.0, 130.0]])


@pytest.mark.parametrize(
    ("projection", "seen"), [("top", [1, 2]), ("front", [1, 3]), ("right", [2, 3])]
)
def test_a_projection_sees_two_of_three_coordinates(projection, seen):
    camera = PlaneCamera((400.0, 300.0), projection=projection)
    assert_array_equal(camera.plane(np.array([[1.0, 2.0, 3.0]])), [seen])


def test_a_plane_curve_lies_in_z_0():
    camera = PlaneCamera((400.0, 300.0), projection="front")
    assert_array_equal(camera.plane(np.array([[1.0, 2.0]])), [[1.0, 0.0]])


def test_what_is_placed_is_seen_there():
    for projection in AXES:
        camera = PlaneCamera((400.0, 300.0), projection=projection)
        seen = np.array([[1.0, 2.0], [3.0, 4.0]])
        assert_array_equal(camera.plane(camera.placed(seen)), seen)
