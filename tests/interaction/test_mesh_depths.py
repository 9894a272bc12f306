"""Which points the surface of a mesh hides, looked at all at once."""

import numpy as np
import pytest

from plusedit.interaction.facets import hidden
from plusedit.interaction.mesh_depths import depth_map
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.space_camera import SpaceCamera
from tests.scene.meshes import a_hill, a_landscape

HILLSIDE = a_hill(15)
SIZE = (400.0, 300.0)


@pytest.mark.parametrize("perspective", [True, False])
@pytest.mark.parametrize("pitch", [-0.4, 0.1, 0.8])
def test_many_points_are_hidden_as_each_of_them_alone_is(pitch, perspective):
    camera = SpaceCamera(
        (1000.0, 800.0), (0.5, 0.5, 0.2), 1.3, pitch=pitch, perspective=perspective
    )
    drawing_of(HILLSIDE)
    design, points = a_landscape(HILLSIDE), np.random.default_rng(5).random((400, 3)) - (0, 0, 0.2)
    together = hidden(points, design, camera)
    alone = [hidden(point[None], design, camera)[0] for point in points]
    assert np.mean(np.array(together) == alone) > 0.97
    assert 0.05 < np.mean(alone) < 0.95


def test_a_triangle_hides_what_lies_behind_it_and_nothing_beside():
    corners = np.array([[[50.0, 50.0], [350.0, 50.0], [200.0, 280.0]]])
    map_ = depth_map(corners, np.array([[10.0, 20.0, 15.0]]), SIZE)
    places = np.array([[200.0, 120.0], [200.0, 120.0], [20.0, 250.0], [900.0, 120.0]])
    depths, pixel = np.array([30.0, 14.0, 30.0, 30.0]), np.full(4, 0.1)
    assert map_.hides(places, depths, pixel).tolist() == [True, False, False, False]


def test_the_nearer_of_two_triangles_counts_whichever_comes_first():
    corners = np.array([[[0.0, 0.0], [400.0, 0.0], [0.0, 300.0]]] * 2)
    depths = np.array([[1.0] * 3, [9.0] * 3])
    for order in ([0, 1], [1, 0]):
        map_ = depth_map(corners[order], depths[order], SIZE)
        assert map_.hides(np.array([[40.0, 40.0]]), np.array([5.0]), np.array([0.1])).all()


@pytest.mark.parametrize("odd", [np.nan, np.inf])
def test_triangles_behind_the_eye_hide_nothing(odd):
    corners = np.array([[[50.0, 50.0], [350.0, 50.0], [odd, odd]]])
    map_ = depth_map(corners, np.ones((1, 3)), SIZE)
    places = np.array([[200.0, 80.0], [odd, 1.0]])
    assert not map_.hides(places, np.full(2, 9.0), np.ones(2)).any()
