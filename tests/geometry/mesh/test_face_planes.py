import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.planes import planes_of
from plusedit.geometry.mesh.polygons import PolygonMesh

RANDOM = np.random.default_rng(8)


def loose(sizes, seed=0):
    """A mesh of separate polygons of those sizes at random, and parameters of its corners."""
    generator = np.random.default_rng(seed)
    count = sum(sizes)
    starts = np.concatenate([[0], np.cumsum(sizes)])
    mesh = PolygonMesh(generator.normal(size=(count, 3)), np.arange(count), starts)
    return mesh, generator.normal(size=(count, 2))


def test_the_plane_of_a_triangle_passes_through_its_vertices():
    mesh, q = loose([3] * 50)
    planes = planes_of(mesh, q)
    found = planes.values(mesh.owners, q)
    assert_allclose(found, mesh.vertices, atol=1e-12)


def test_center_and_point_are_means_of_the_corners():
    mesh, q = loose([3, 5, 4])
    planes = planes_of(mesh, q)
    assert_allclose(planes.centers[1], q[3:8].mean(axis=0))
    assert_allclose(planes.points[1], mesh.vertices[3:8].mean(axis=0))


@pytest.mark.parametrize("size", [3, 4, 7])
def test_the_gradients_are_the_least_squares_fit(size):
    mesh, q = loose([size] * 10)
    planes = planes_of(mesh, q)
    for face, (rows, points) in enumerate(
        zip(q.reshape(-1, size, 2), mesh.vertices.reshape(-1, size, 3), strict=True)
    ):
        expected, *_ = np.linalg.lstsq(
            rows - rows.mean(axis=0), points - points.mean(axis=0), rcond=None
        )
        assert_allclose(planes.gradients_u[face], expected[0], atol=1e-11)
        assert_allclose(planes.gradients_v[face], expected[1], atol=1e-11)


@pytest.mark.parametrize("direction", [(1.0, 0.0), (0.0, 1.0), (0.6, 0.8), (0.1, -3.0)])
def test_where_parameters_lie_on_a_line_the_gradients_have_the_least_norm(direction):
    mesh, _ = loose([4])
    q = np.outer([0.0, 1.0, 2.5, 3.0], direction)
    planes = planes_of(mesh, q)
    expected = np.linalg.pinv(q - q.mean(axis=0)) @ (mesh.vertices - mesh.vertices.mean(axis=0))
    assert_allclose(planes.gradients_u[0], expected[0], atol=1e-13)
    assert_allclose(planes.gradients_v[0], expected[1], atol=1e-13)


def test_a_face_without_extent_in_the_parameters_is_skipped_and_counted():
    mesh, q = loose([3, 4, 3])
    q[3:7] = 0.4
    planes = planes_of(mesh, q)
    assert planes.radii[1] == 0.0
    assert planes.skipped == 1
    assert_array_equal(planes.used, [0, 2])
    assert_array_equal(planes.gradients_u[1], 0.0)


@pytest.mark.parametrize("scale", [1e-11, 1e9])
def test_planes_of_tiny_parameters_are_as_good_as_others(scale):
    mesh, q = loose([3, 4, 5] * 4)
    plain, scaled = planes_of(mesh, q, True), planes_of(mesh, scale * q, True)
    assert_allclose(scaled.radii, scale * plain.radii)
    assert_allclose(scale * scaled.gradients_u, plain.gradients_u, atol=1e-9)
    assert_allclose(scaled.weights, plain.weights)


def test_weights_are_one_unless_areas_are_asked_for():
    mesh, q = loose([3, 4])
    assert_array_equal(planes_of(mesh, q).weights, 1.0)


def test_area_weights_are_areas_over_squared_radii():
    square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]
    sliver = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.01]]
    mesh, _ = loose([4, 3])
    planes = planes_of(mesh, np.array(square + sliver), True)
    assert_allclose(planes.weights, [4.0 / 2.0, 0.01 / 1.0])


def test_parameters_must_be_one_pair_per_corner():
    mesh, q = loose([3, 4])
    with pytest.raises(ValueError, match=r"parameters: expected shape \(7, 2\), got \(6, 2\)"):
        planes_of(mesh, q[:6])
