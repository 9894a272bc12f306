"""How far the surface of a mesh is from the mesh."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.deviation import (
    Deviation,
    Spread,
    deviation,
    deviation_of,
    splits_within,
    times_for,
    vertex_places,
)
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.nearest_triangles import distances, distances_by_trying
from plusedit.geometry.mesh.polygons import PolygonMesh


def sheet(count, height=lambda x, y: 0.0 * x):
    """A grid of count x count quads over the unit square."""
    x, y = np.meshgrid(*[np.linspace(0.0, 1.0, count + 1)] * 2, indexing="ij")
    vertices = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
    row = np.arange(count)[:, None] * (count + 1)
    a = (row + np.arange(count)).ravel()
    return PolygonMesh.of_rows(vertices, np.stack([a, a + count + 1, a + count + 2, a + 1], axis=1))


def surface_of(mesh, **more):
    return MeshSurface(mesh, PlaneDomain(), mesh.vertices[mesh.corners, :2], **more)


def nearest_by_trying(point, triangles):
    """The distance of a point from the nearest of many places in triangles (t, 3, 3)."""
    steps = np.linspace(0.0, 1.0, 41)
    shares = np.array([(1.0 - a - b, a, b) for a in steps for b in steps if a + b <= 1.0 + 1e-12])
    places = np.einsum("kc,tcd->tkd", shares, triangles)
    return np.linalg.norm(places - point, axis=-1).min()


def test_a_flat_sheet_has_no_deviation():
    found = deviation(surface_of(sheet(6)))
    assert found.to_surface.largest < 1e-12
    assert found.to_mesh.largest < 1e-12


def test_a_sheet_moved_off_its_plane_is_away_by_as_much_everywhere():
    mesh = sheet(5)
    found = deviation_of(mesh, mesh.vertices + np.array([0.0, 0.0, 0.25]))
    assert_allclose(found.from_mesh, 0.25)
    assert_allclose(found.from_surface, 0.25)
    assert found.to_surface == Spread(0.25, 0.25, 0.25)


def test_a_sheet_moved_along_itself_is_away_at_the_rim_alone():
    mesh = sheet(8)
    found = deviation_of(mesh, mesh.vertices + np.array([0.25, 0.0, 0.0]))
    x = mesh.vertices[:, 0]
    assert_allclose(found.from_mesh, np.maximum(0.25 - x, 0.0), atol=1e-12)
    assert_allclose(found.from_surface, np.maximum(x + 0.25 - 1.0, 0.0), atol=1e-12)
    assert found.to_surface.median == pytest.approx(0.0, abs=1e-12)
    assert found.to_surface.largest == pytest.approx(0.25)


def test_distances_are_those_of_the_nearest_place_of_all_triangles():
    random = np.random.default_rng(4)
    mesh = sheet(4, lambda x, y: 0.3 * np.sin(5.0 * x) * y)
    moved = mesh.vertices + 0.05 * random.normal(size=mesh.vertices.shape)
    found = deviation_of(mesh, moved)
    triangles = moved[mesh.triangulation.triangles]
    tried = [nearest_by_trying(point, triangles) for point in mesh.vertices]
    assert (found.from_mesh <= np.array(tried) + 1e-12).all()
    assert_allclose(found.from_mesh, tried, atol=6e-3)


def test_faces_of_coarse_meshes_are_split_so_that_bulges_between_corners_count():
    mesh = PolygonMesh.of([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    found = deviation(surface_of(mesh, smoothness=2.0))
    assert len(found.by_vertex) == 4
    assert len(found.from_mesh) > 200
    assert found.to_surface.largest > 0.01


def test_a_large_smoothness_leads_away_from_the_mesh():
    mesh = sheet(40, lambda x, y: 0.1 * np.sin(12.0 * x) * np.cos(9.0 * y))
    rms = [deviation(surface_of(mesh, smoothness=s)).to_surface.rms for s in (0.5, 2.0, 8.0)]
    assert rms == sorted(rms)
    assert rms[-1] > 10.0 * rms[0]


def test_vertices_of_no_face_count_nothing():
    mesh = PolygonMesh.of([[9, 9, 9], [0, 0, 0], [1, 0, 0], [0, 1, 0], [7, 7, 7]], [[1, 2, 3]])
    found = deviation_of(mesh, mesh.vertices + np.array([0.0, 0.0, 1.0]))
    assert_allclose(found.by_vertex, [0.0, 1.0, 1.0, 1.0, 0.0])
    assert found.to_surface == Spread(1.0, 1.0, 1.0)
    assert found.diagonal == pytest.approx(np.sqrt(2.0))


def test_triangles_without_area_are_sides_or_points():
    mesh = PolygonMesh.of([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    line = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.5, 0.0, 1.0]])
    assert_allclose(deviation_of(mesh, line).from_mesh, [1.0, 1.0, np.sqrt(2.0)])
    point = np.tile([0.0, 0.0, 2.0], (3, 1))
    assert_allclose(deviation_of(mesh, point).from_mesh, [2.0, np.sqrt(5.0), np.sqrt(5.0)])
    assert_allclose(deviation_of(mesh, point).from_surface, 2.0)


@given(st.floats(-150.0, 140.0))
def test_distances_grow_with_the_unit(exponent):
    mesh, scale = sheet(3, lambda x, y: x * y), 2.0 ** round(exponent)
    small = deviation_of(mesh, 1.1 * mesh.vertices)
    large = deviation_of(mesh.with_vertices(scale * mesh.vertices), 1.1 * scale * mesh.vertices)
    assert_allclose(large.from_mesh / scale, small.from_mesh, atol=1e-9)
    assert large.to_surface.rms / scale == pytest.approx(small.to_surface.rms)


def test_a_spread_is_three_numbers():
    assert Spread.of(np.array([0.0, 3.0, 4.0, 0.0])) == Spread(2.5, 1.5, 4.0)
    assert Spread.of(np.zeros(0)) == Spread(0.0, 0.0, 0.0)


def test_the_box_around_the_mesh_is_the_measure():
    found = deviation(surface_of(sheet(3)))
    assert isinstance(found, Deviation)
    assert found.diagonal == pytest.approx(np.sqrt(2.0))


@pytest.mark.parametrize(("faces", "times"), [(1, 5), (999, 2), (1000, 1), (4000, 0), (10**6, 0)])
def test_meshes_are_split_until_there_are_some_thousand_faces(faces, times):
    mesh = PolygonMesh.of_rows(np.eye(3), np.tile([0, 1, 2], (faces, 1)))
    assert times_for(mesh) == times


@pytest.mark.parametrize(("faces", "times"), [(1, 4), (200, 3), (10_000, 1), (44_000, 0)])
def test_what_lies_between_vertices_is_measured_where_there_is_room(faces, times):
    mesh = PolygonMesh.of_rows(np.eye(3), np.tile([0, 1, 2], (faces, 1)))
    assert splits_within(mesh) == times


def test_places_of_vertices_are_those_of_their_first_corners():
    mesh = PolygonMesh.of(np.zeros((5, 3)), [[1, 2, 3], [3, 2, 0]])
    parameters = np.arange(12.0).reshape(6, 2)
    surface = MeshSurface(mesh, PlaneDomain(), parameters)
    found = vertex_places(mesh, parameters)
    assert_array_equal(found, surface.vertex_places)
    assert_array_equal(found[:4], parameters[[5, 0, 1, 2]])


def a_crumpled_sheet():
    """A mesh whose triangles lie near each other in space and far from each other in the mesh."""
    random = np.random.default_rng(8)
    mesh = sheet(14, lambda x, y: 0.2 * np.sin(9.0 * x) * np.cos(7.0 * y))
    return mesh, mesh.vertices + 0.15 * random.normal(size=mesh.vertices.shape)


def test_the_nearest_of_all_triangles_counts_however_far_it_is_in_the_mesh():
    mesh, moved = a_crumpled_sheet()
    triangles = moved[mesh.triangulation.triangles]
    tried = [nearest_by_trying(point, triangles) for point in mesh.vertices[::6]]
    found = deviation_of(mesh, moved).from_mesh[: mesh.vertex_count : 6]
    assert (found <= np.array(tried) + 1e-12).all()
    assert_allclose(found, tried, atol=0.02)


def test_without_compiled_loops_distances_are_the_same_or_too_large():
    mesh, moved = a_crumpled_sheet()
    corners, own = mesh.triangulation.triangles.astype(np.intp), np.arange(mesh.vertex_count)
    exact = distances(mesh.vertices, moved, corners, own)
    tried = distances_by_trying(mesh.vertices, moved, corners, own)
    assert (tried >= exact - 1e-12).all()
    assert np.median(tried - exact) < 1e-12
