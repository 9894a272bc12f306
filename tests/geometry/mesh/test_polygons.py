"""Polygon meshes: their faces, numbers and checks."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.polygons import PolygonMesh
from tests.geometry.mesh.bodies import cube, sheet, volume

TENT = PolygonMesh.of(
    [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (1, 1, 1), (9, 9, 9)],
    [(0, 1, 4), (1, 2, 4), (2, 3, 0, 4)],
)


def test_faces_come_back_as_they_were_given():
    assert TENT.faces == [(0, 1, 4), (1, 2, 4), (2, 3, 0, 4)]
    assert_array_equal(TENT.sizes, [3, 3, 4])
    assert_array_equal(TENT.owners, [0, 0, 0, 1, 1, 1, 2, 2, 2, 2])


def test_following_and_preceding_run_around_each_face_both_ways():
    assert_array_equal(TENT.following, [1, 2, 0, 4, 5, 3, 7, 8, 9, 6])
    assert_array_equal(TENT.preceding[TENT.following], np.arange(10))


def test_the_box_is_that_of_the_faces_not_of_stray_vertices():
    assert_array_equal(TENT.bounds, [(0, 0, 0), (2, 2, 1)])
    assert TENT.diagonal == 3.0


def test_area_vectors_of_a_closed_mesh_cancel():
    assert_allclose(cube().area_vectors.sum(axis=0), 0.0, atol=1e-15)
    assert_allclose(cube().areas, 1.0)
    assert volume(cube()) == pytest.approx(1.0)


def test_areas_are_as_good_far_from_the_origin():
    far = cube().with_vertices(cube().vertices + 1e9)
    assert_array_equal(far.areas, cube().areas)


def test_taking_faces_leaves_vertices_out_and_tells_all_numbers():
    taken = TENT.taken([2, 0])
    assert taken.mesh.faces == [(2, 3, 0, 4), (0, 1, 4)]
    assert_array_equal(taken.vertex_numbers, [0, 1, 2, 3, 4])
    assert_array_equal(taken.corner_numbers, [6, 7, 8, 9, 0, 1, 2])
    one = TENT.taken([1])
    assert one.mesh.faces == [(0, 1, 2)]
    assert_array_equal(one.vertex_numbers, [1, 2, 4])


def test_a_mesh_can_be_empty():
    empty = PolygonMesh.of(np.zeros((0, 3)), [])
    assert (empty.face_count, empty.vertex_count, empty.diagonal) == (0, 0, 0.0)
    assert len(empty.areas) == len(empty.following) == len(empty.triangles()[0]) == 0
    assert empty.topology.components == ()
    assert empty.subdivided(1).mesh.face_count == 0


def test_nothing_of_a_mesh_can_be_written_to():
    for array in (TENT.vertices, TENT.corners, TENT.starts, TENT.centers, TENT.triangles()[0]):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


@pytest.mark.parametrize(
    ("faces", "words"),
    [
        ([(0, 1)], "face 0: has 2 corners, a polygon has three or more"),
        ([(0, 1, 2), (0, 1, 3)], "face 1: names vertex 3, there are vertices 0 to 2"),
        ([(0, -1, 2)], "face 0: names vertex -1, there are vertices 0 to 2"),
        ([(0, 1, 2**40)], "corners: has a number beyond 2147483647"),
    ],
)
def test_wrong_faces_are_refused_in_words(faces, words):
    with pytest.raises(ValueError, match=words):
        PolygonMesh.of(np.eye(3), faces)


def test_wrong_arrays_are_refused_in_words():
    numbers = np.arange(3, dtype=np.int32)
    with pytest.raises(ValueError, match="vertices: has a value that is not finite"):
        PolygonMesh.of(np.full((3, 3), np.nan), [(0, 1, 2)])
    with pytest.raises(ValueError, match="starts: must lead from 0 to the number of corners, 3"):
        PolygonMesh(np.eye(3), numbers, np.array([0, 2], dtype=np.int32))
    with pytest.raises(ValueError, match="corners: expected a row of whole numbers"):
        PolygonMesh(np.eye(3), np.array([0.0, 1.0, 2.0]), np.array([0, 3]))
    with pytest.raises(ValueError, match="names vertex 0, there are no vertices"):
        PolygonMesh.of(np.zeros((0, 3)), [(0, 0, 0)])


def test_a_subdivided_sheet_is_a_finer_sheet():
    finer = sheet(2, 3).subdivided(2).mesh
    assert finer.face_count == 6 * 16
    assert_allclose(finer.areas, 1.0 / 16.0)
    assert finer.topology.components[0].euler == 1
    assert_array_equal(finer.vertices[:12], sheet(2, 3).vertices)


def test_values_by_corner_go_along_when_faces_are_subdivided():
    split = TENT.subdivided(3)
    assert_allclose(
        split.along(TENT.vertices[TENT.corners]), split.mesh.vertices[split.mesh.corners]
    )
    assert_array_equal(np.bincount(split.parents), [64, 64, 64])
    shares = np.bincount(split.parents, split.mesh.areas)[:2]
    assert_allclose(shares, TENT.areas[:2])
    assert (np.diff(split.parents) >= 0).all()


def test_subdividing_is_refused_where_there_would_be_too_many_faces():
    with pytest.raises(ValueError, match="3 faces split 99 times are too many"):
        TENT.subdivided(99)
    with pytest.raises(ValueError, match="expected 0 or more times, got -1"):
        TENT.subdivided(-1)
    assert TENT.subdivided(0).mesh is TENT
