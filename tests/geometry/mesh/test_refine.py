"""Large and thin faces split before a mesh gets parameters."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.refine import edge_wanted, needs_refining, refined
from plusedit.geometry.mesh.repair import repaired
from tests.geometry.mesh.bodies import (
    cube,
    cylinder,
    every_real_mesh,
    real_mesh,
    sheet,
    together,
    torus,
    volume,
)

UNEVEN = {"beetle_nonmanifold.obj", "mountain_irregular_sheet.obj", "tm_cylinder.stl"}


def with_a_big_face(rows=70):
    """A fine sheet of unit quads beside one quad that is as long as the sheet and 20 wide."""
    fine = sheet(rows, rows)
    points = np.concatenate([fine.vertices, [(0, -20, 0), (rows, -20, 0)]])
    count = fine.vertex_count
    return PolygonMesh.of(points, [*fine.faces, (count, count + 1, *range(rows, -1, -1))])


def longest_edge(mesh):
    return mesh.topology.edge_lengths.max()


def assert_same_shape(result, mesh):
    """The split mesh covers the faces of the mesh, each by its own, and hangs together alike."""
    split = result.mesh
    assert_allclose(
        np.bincount(result.parents, split.areas, minlength=mesh.face_count),
        PolygonMesh.of(mesh.vertices, mesh.triangles()[0]).areas
        @ (mesh.triangles()[1][:, None] == np.arange(mesh.face_count)),
        rtol=1e-6,
        atol=1e-12 * mesh.areas.sum(),
    )
    assert [(part.boundaries, part.handles) for part in split.topology.components] == [
        (part.boundaries, part.handles) for part in mesh.topology.components
    ]
    assert_array_equal(split.vertices[: mesh.vertex_count], mesh.vertices)
    assert (np.diff(result.parents) >= 0).all()
    assert_goes_along(result, mesh)


def assert_goes_along(result, mesh):
    """Positions taken as values by corner are the positions of the new corners."""
    along = result.along(mesh.vertices[mesh.corners])
    there = result.mesh.vertices[result.mesh.corners]
    assert_allclose(along, there, atol=1e-13 * np.abs(there).max())
    assert_array_equal(mesh.owners[result.sources[:, 0]], result.parents[result.mesh.owners])
    assert_allclose(result.shares.sum(axis=1), 1.0)
    assert result.shares.min() >= 0.0


@pytest.mark.parametrize("mesh", [cube(), sheet(4, 4), torus(9, 7)], ids=["cube", "sheet", "torus"])
def test_even_meshes_stay_as_they_are(mesh):
    assert not needs_refining(mesh)
    result = refined(mesh)
    assert result.mesh is mesh
    assert result.notes == ()
    assert_goes_along(result, mesh)


def test_large_and_thin_faces_are_found():
    uneven = needs_refining(
        together(sheet(9, 9), sheet(1, 1).with_vertices(9.0 * sheet(1, 1).vertices))
    )
    assert np.flatnonzero(uneven.large).tolist() == [81]
    assert uneven.why == "1 large face"
    assert needs_refining(cylinder(24, 12.0)).thin.sum() == 48
    assert needs_refining(cylinder(24, 12.0)).why == "48 thin faces"


def test_slim_faces_count_as_thin_where_they_are_more_than_a_few():
    slim = sheet(1, 1).with_vertices(sheet(1, 1).vertices * [15.0, 1.0, 1.0])
    assert needs_refining(together(sheet(9, 9), slim, apart=20.0)).thin.sum() == 1
    assert needs_refining(cylinder(24, 2.0)).thin.sum() == 48
    assert not needs_refining(together(sheet(20, 20), slim, apart=30.0)).thin.any()


def test_a_small_sliver_is_left_alone():
    sliver = PolygonMesh.of([(0, 0, 0), (1, 0, 0), (0.5, 0.01, 0)], [(0, 1, 2)])
    assert not needs_refining(together(sheet(9, 9), sliver))


def test_radii_are_compared_with_the_median_and_lengths_with_even_triangles():
    assert edge_wanted(sheet(4, 4), 16) == 1.5
    assert edge_wanted(sheet(4, 4), 64) == 0.75


def test_only_a_big_face_and_what_has_to_be_beside_it_are_split():
    mesh = with_a_big_face()
    result = refined(mesh)
    counts = np.bincount(result.parents)
    assert counts[-1] > 500
    assert (counts[:-1] == 1).all()
    assert set(result.mesh.sizes[result.parents < 4900].tolist()) == {4}
    assert_same_shape(result, mesh)
    assert not needs_refining(result.mesh)
    (note,) = result.notes
    assert note == f"4901 faces were split into {result.mesh.face_count} because of 1 large face"


def test_neighbors_of_a_split_face_are_split_with_it():
    long = sheet(1, 1).with_vertices(sheet(1, 1).vertices * [60.0, 2.0, 1.0])
    assert_same_shape(refined(long, wanted=200), long)
    assert longest_edge(refined(long, wanted=200).mesh) < 60.0 / 8.0


@pytest.mark.parametrize("height", [6.0, 12.0, 100.0])
def test_a_coarse_cylinder_becomes_a_fine_one(height):
    mesh = cylinder(24, height)
    result = refined(mesh, wanted=4000)
    assert_same_shape(result, mesh)
    assert volume(result.mesh) == pytest.approx(volume(mesh))
    assert not needs_refining(result.mesh).large.any()
    assert longest_edge(result.mesh) <= 1.4 * edge_wanted(mesh, 4000)
    assert 2000 < result.mesh.face_count < 16000


@pytest.mark.parametrize("wanted", [100, 1000, 10000])
def test_the_faces_wanted_are_about_those_that_come(wanted):
    mesh = torus(8, 5)
    count = refined(mesh, wanted=wanted).mesh.face_count
    assert 0.7 * wanted < count < 2.5 * wanted


def test_fewer_faces_wanted_than_there_are_change_nothing_even():
    mesh = torus(9, 7)
    assert refined(mesh, wanted=20).mesh is mesh


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=25, deadline=None)
def test_any_triangles_keep_their_shape(seed):
    random = np.random.default_rng(seed)
    points = random.normal(size=(12, 3)) * 10.0 ** random.uniform(-2.0, 2.0, 3)
    faces = [random.choice(12, 3, replace=False) for _ in range(8)]
    mesh = max(repaired(PolygonMesh.of(points, faces)).parts, key=lambda part: len(part.faces)).mesh
    assert_same_shape(refined(mesh, wanted=300), mesh)


def test_flat_triangles_come_to_an_end():
    line = PolygonMesh.of([(0, 0, 0), (9, 0, 0), (4, 0, 0)], [(0, 1, 2)])
    both = together(sheet(3, 3), line)
    assert_goes_along(refined(both, wanted=500), both)
    point = PolygonMesh.of(np.zeros((3, 3)), [(0, 1, 2)])
    assert refined(point, wanted=500).mesh is point


def test_needles_are_not_split_without_end():
    needle = PolygonMesh.of([(0, 0, 0), (0, 0, 1), (0, 1e-5, 0)], [(0, 1, 2)])
    needles = [needle] * 400
    result = refined(together(*needles), wanted=1000)
    assert result.mesh.face_count < 20_000
    assert "so thin" in result.notes[-1]


def test_an_empty_mesh_needs_nothing():
    empty = PolygonMesh.of(np.zeros((0, 3)), [])
    assert not needs_refining(empty)
    assert refined(empty).mesh is empty


@every_real_mesh
def test_real_meshes_are_split_where_they_are_uneven_and_keep_their_shape(name):
    mesh = repaired(real_mesh(name)).parts[0].mesh
    result = refined(mesh)
    assert bool(result.notes) == bool(needs_refining(mesh)) == (name in UNEVEN)
    assert_goes_along(result, mesh)
    assert result.mesh.topology.components[0].euler == mesh.topology.components[0].euler
    assert_allclose(result.mesh.areas.sum(), mesh.areas.sum())
    assert not needs_refining(result.mesh).large.any()
