"""Polygons cut into triangles."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.polygons import PolygonMesh
from tests.geometry.mesh.bodies import every_real_mesh, real_mesh

TILTED = np.linalg.qr(np.array([[1.0, 2.0, 0.5], [-1.0, 0.3, 2.0], [0.2, -1.0, 1.0]]))[0]


def polygon(flat):
    """A mesh of one polygon with corners (m, 2), in a plane that is not one of the axes."""
    points = np.column_stack([flat, np.zeros(len(flat))]) @ TILTED.T
    return PolygonMesh.of(points, [range(len(points))])


def star(count, inner):
    """Corners of a star with so many points."""
    angle = np.arange(2 * count) * np.pi / count
    radius = np.where(np.arange(2 * count) % 2, inner, 1.0)
    return radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def comb(teeth):
    """A polygon that no corner sees all of."""
    top = [(x, 3.0 if x % 2 else 0.5) for x in range(2 * teeth + 1)]
    return np.array([(0.0, 0.0), (2.0 * teeth, 0.0), *top[::-1]])


def signed_areas(mesh):
    """Of the triangles, positive where they face the way their polygon does."""
    triangles, owners = mesh.triangles()
    of_triangles = PolygonMesh.of(mesh.vertices, triangles).area_vectors
    normals = mesh.area_vectors / mesh.areas[:, None]
    return (of_triangles * normals[owners]).sum(axis=1)


def assert_covered(mesh):
    """No triangle is turned over or flat, and together they have the area of the polygon."""
    areas = signed_areas(mesh)
    assert areas.min() > 1e-6 * areas.max()
    assert_allclose(areas.sum(), mesh.areas.sum())


SHAPES = {
    "quad": np.array([(0, 0), (2, 0), (2, 1), (0, 1)]),
    "arrow": np.array([(0, 0), (3, -1), (1, 0), (3, 1)]),
    "arrow from elsewhere": np.array([(3, -1), (1, 0), (3, 1), (0, 0)]),
    "nonagon": star(9, 1.0)[::2],
    "quad with middles": np.array([(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)]),
    "L": np.array([(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]),
    "star": star(7, 0.4),
    "thin star": star(40, 0.05),
    "comb": comb(12),
    "keyhole": np.array(
        [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0), (1, 1), (1, 3), (3, 3), (3, 1), (1, 1)]
    ),
}


@pytest.mark.parametrize("flat", SHAPES.values(), ids=SHAPES)
def test_triangles_cover_a_polygon_and_face_the_way_it_does(flat):
    assert_covered(polygon(flat))
    assert len(polygon(flat).triangles()[0]) == len(flat) - 2


@pytest.mark.parametrize("flat", SHAPES.values(), ids=SHAPES)
def test_a_polygon_turned_over_gives_triangles_turned_over(flat):
    assert_covered(polygon(flat[::-1]))


@given(st.integers(0, 2**32 - 1), st.integers(4, 30))
@settings(max_examples=60, deadline=None)
def test_any_polygon_without_crossings_is_covered(seed, count):
    random = np.random.default_rng(seed)
    angle = np.sort(random.uniform(0.0, 2.0 * np.pi, count))
    gaps = np.diff(angle, append=angle[0] + 2.0 * np.pi)
    radius = random.uniform(0.1, 1.0, count)
    mesh = polygon(radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1))
    assume(gaps.max() < np.pi and gaps.min() > 1e-3)
    areas = signed_areas(mesh)
    assert areas.min() > 0.0
    assert_allclose(areas.sum(), mesh.areas.sum())


def test_the_diagonal_of_a_quad_leaves_the_larger_smallest_angle():
    kite = np.array([(0, 0), (5, -0.1), (10, 0), (5, 20)])
    assert_array_equal(polygon(kite).triangles()[0], [(1, 2, 3), (1, 3, 0)])
    assert_array_equal(polygon(np.roll(kite, 1, axis=0)).triangles()[0], [(0, 1, 2), (0, 2, 3)])


def test_squares_are_all_cut_the_same_way():
    squares = [polygon(SHAPES["quad"] * [0.5, 1.0] + shift / 3.0) for shift in range(9)]
    assert {tuple(square.triangles()[0].ravel()) for square in squares} == {(0, 1, 2, 0, 2, 3)}


def test_triangles_know_their_faces_and_corners():
    mesh = PolygonMesh.of(np.eye(5)[:, :3], [(0, 1, 2), (4, 3, 2, 1, 0), (0, 2, 3)])
    cut = mesh.triangulation
    assert_array_equal(cut.owners, [0, 1, 1, 1, 2])
    assert_array_equal(mesh.corners[cut.corners], cut.triangles)
    assert_array_equal(mesh.owners[cut.corners], np.repeat(cut.owners[:, None], 3, axis=1))


@pytest.mark.parametrize(
    "flat",
    [np.zeros((6, 2)), np.array([(x, 0.0) for x in range(7)]), star(5, 1.0)[::2][[0, 2, 4, 1, 3]]],
    ids=["a point", "a line", "a crossing"],
)
def test_even_of_what_is_no_polygon_there_are_triangles(flat):
    triangles, _ = polygon(flat).triangles()
    assert triangles.shape == (len(flat) - 2, 3)
    assert set(triangles.ravel().tolist()) == set(range(len(flat)))


@every_real_mesh
def test_real_faces_of_k_corners_give_k_minus_two_triangles(name):
    mesh = real_mesh(name)
    assert_array_equal(np.bincount(mesh.triangles()[1], minlength=mesh.face_count), mesh.sizes - 2)
