"""Meshes as they are found made into proper surfaces."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_array_equal

from plusedit.geometry.mesh.cleaning import cleaned
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.repair import Repairs, repaired
from tests.geometry.mesh.bodies import (
    FACTS,
    cube,
    cylinder,
    every_real_mesh,
    real_mesh,
    ribbon,
    sheet,
    together,
    torus,
    turned,
    volume,
    with_faces,
)


def soup(mesh):
    """The same faces, each with vertices of its own."""
    return PolygonMesh(
        mesh.vertices[mesh.corners], np.arange(len(mesh.corners), dtype=np.int32), mesh.starts
    )


def the_part(mesh):
    """The only part of a repaired mesh."""
    (part,) = repaired(mesh).parts
    return part


def assert_proper(mesh):
    """Every edge has one face or two opposed ones, every vertex one umbrella, in one part."""
    topology = mesh.topology
    directed = np.stack([mesh.corners, mesh.corners[mesh.following]], axis=1)
    assert len(np.unique(directed, axis=0)) == len(directed)
    assert len(np.unique(np.sort(directed, axis=1), axis=0)) == len(topology.edges)
    assert len(topology.components) == 1
    assert topology.components[0].vertices == mesh.vertex_count
    assert mesh.used.all()
    if topology.components[0].closed:
        assert volume(mesh) > 0.0


def assert_from(part, mesh):
    """The numbers of a part lead back to the faces, corners and vertices of the mesh."""
    assert_array_equal(part.mesh.vertices, mesh.vertices[part.vertices])
    assert_array_equal(
        part.mesh.vertices[part.mesh.corners], mesh.vertices[mesh.corners[part.corners]]
    )
    assert_array_equal(mesh.owners[part.corners], part.faces[part.mesh.owners])
    assert (np.diff(part.faces) > 0).all()
    assert (np.diff(part.vertices) >= 0).all()


@every_real_mesh
def test_real_meshes_have_the_parts_that_are_known_of_them(name):
    result, facts = repaired(real_mesh(name)), FACTS[name]
    assert len(result.parts) == facts["components"]
    assert result.repairs.opened == facts["nonmanifold_edges"]
    assert result.repairs.turned == facts["reoriented"]
    found = [
        (int((part.mesh.sizes - 2).sum()), surface.boundaries, surface.handles)
        for part in result.parts
        for surface in part.mesh.topology.components
    ]
    known = [(row["triangles"], row["boundary_loops"], row["genus"]) for row in facts["largest"]]
    assert sorted(known, reverse=True) == sorted(found, reverse=True)[: len(known)]


@every_real_mesh
def test_parts_of_real_meshes_are_proper_and_know_where_they_come_from(name):
    mesh = real_mesh(name)
    for part in repaired(mesh).parts:
        assert_proper(part.mesh)
        assert_from(part, mesh)


@pytest.mark.parametrize("mesh", [cube(), sheet(3, 4), torus(5, 6)], ids=["cube", "sheet", "torus"])
def test_a_proper_mesh_comes_back_as_it_is_without_a_word(mesh):
    result = repaired(mesh)
    assert result.parts[0].mesh.faces == mesh.faces
    assert_array_equal(result.parts[0].mesh.vertices, mesh.vertices)
    assert result.repairs == Repairs()
    assert result.notes == ()


def test_faces_with_vertices_of_their_own_are_joined():
    result = repaired(soup(torus(6, 5)))
    assert result.repairs == Repairs(joined=90)
    assert result.parts[0].mesh.topology.components[0].handles == 1
    assert result.notes == ("90 vertices at the same places as others were joined with them",)


def test_zero_and_minus_zero_are_the_same_place():
    square = [(0.0, 0.0, 0.0), (1, 0, 0), (0, 1, 0), (-0.0, 0.0, -0.0), (0, 1, 0), (-1, 0, 0)]
    part = the_part(PolygonMesh.of(square, [(0, 1, 2), (3, 4, 5)]))
    assert part.mesh.vertex_count == 4


def test_places_that_differ_in_the_last_bit_stay_apart():
    near = np.nextafter(1.0, 2.0)
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 0), (near, 0, 0), (0, -1, 0)]
    result = repaired(PolygonMesh.of(points, [(0, 1, 2), (3, 5, 4)]))
    assert len(result.parts) == 2
    assert (result.repairs.joined, result.repairs.split) == (1, 1)


def test_copies_of_a_face_are_left_out_wherever_they_begin():
    result = repaired(with_faces(sheet(1, 2), [(1, 4, 3, 0), (4, 3, 0, 1), (1, 2, 5, 4)]))
    assert result.repairs == Repairs(copies=3)
    assert_array_equal(result.parts[0].faces, [0, 1])
    assert result.notes == ("3 copies of faces were left out",)


def test_of_a_double_sided_sheet_one_side_is_left():
    result = repaired(with_faces(sheet(3, 3), turned(sheet(3, 3), range(9)).faces))
    assert result.repairs == Repairs(backs=9)
    assert_array_equal(result.parts[0].faces, np.arange(9))


def test_a_single_face_with_a_back_keeps_it():
    result = repaired(together(cube(), PolygonMesh.of(np.eye(3), [(0, 1, 2), (2, 1, 0)])))
    assert [part.mesh.face_count for part in result.parts] == [6, 2]
    assert result.notes == ()


def test_a_quad_with_the_same_corners_in_another_order_is_no_copy():
    _, counts = cleaned(with_faces(sheet(1, 1), [(0, 3, 1, 2)]))
    assert counts["copies"] == counts["backs"] == 0


def test_faces_with_fewer_than_three_different_corners_are_left_out():
    bad = [(0, 0, 1), (1, 1, 1), (0, 1, 0, 1), (2, 3, 2, 3, 2)]
    result = repaired(with_faces(sheet(1, 1), bad))
    assert result.repairs == Repairs(degenerate=4)
    assert result.notes == ("4 faces with fewer than three different corners were left out",)


def test_a_corner_that_comes_twice_in_a_row_is_kept_once():
    result = repaired(PolygonMesh.of(sheet(1, 1).vertices, [(0, 0, 1, 3, 3, 2, 0)]))
    assert result.repairs == Repairs(repeated=1)
    assert result.parts[0].mesh.sizes.tolist() == [4]


@pytest.mark.parametrize("turns", [1, 3])
def test_a_moebius_strip_is_refused_by_its_name(turns):
    with pytest.raises(ValueError, match="one-sided like a Moebius strip: no side of it can be"):
        repaired(ribbon(turns))


def test_a_moebius_strip_beside_other_parts_is_left_out():
    result = repaired(together(ribbon(1), cube()))
    assert [part.mesh.face_count for part in result.parts] == [6]
    assert result.notes == ("1 part is one-sided like a Moebius strip and was left out",)


def test_neighbors_are_made_to_face_the_same_way():
    result = repaired(turned(sheet(4, 4), [0, 5, 9]))
    assert result.repairs == Repairs(turned=3)
    assert_proper(result.parts[0].mesh)
    assert (result.parts[0].mesh.area_vectors[:, 2] == 1.0).all()


def test_most_faces_of_an_open_part_stay_as_they_are():
    assert repaired(turned(sheet(4, 4), range(13))).repairs.turned == 3


@given(st.sets(st.integers(0, 29)))
@settings(max_examples=40, deadline=None)
def test_a_closed_part_faces_outward_however_its_faces_are_turned(numbers):
    mesh = turned(torus(6, 5), numbers)
    part = the_part(mesh)
    assert_proper(part.mesh)
    assert_from(part, mesh)


def test_closed_parts_that_are_inside_out_are_told_apart_from_single_faces():
    result = repaired(together(turned(cube(), range(6)), turned(cylinder(8, 1.0), [3])))
    assert (result.repairs.inside_out, result.repairs.turned) == (1, 1)
    assert all(volume(part.mesh) > 0.0 for part in result.parts)


def test_values_by_corner_follow_faces_that_are_turned():
    mesh = turned(cube(), [1, 4])
    part = the_part(mesh)
    assert_array_equal(
        mesh.vertices[mesh.corners][part.corners], part.mesh.vertices[part.mesh.corners]
    )


def test_three_faces_at_an_edge_are_cut_apart():
    book = PolygonMesh.of(
        [(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0)],
        [(0, 1, 2), (0, 1, 3), (0, 1, 4)],
    )
    result = repaired(book)
    assert len(result.parts) == 3
    assert result.repairs == Repairs(opened=1)
    assert result.notes == ("1 edge with more than two faces was cut open",)


def test_cubes_that_share_an_edge_become_two_bodies():
    other = cube().with_vertices(cube().vertices + np.array([0.0, 1.0, 0.0]))
    result = repaired(together(cube(), other, apart=1.0))
    assert [part.mesh.face_count for part in result.parts] == [6, 6]
    assert result.repairs == Repairs(joined=2, opened=1)
    for part in result.parts:
        assert_proper(part.mesh)


def test_a_bow_tie_is_split_at_its_knot():
    bow = PolygonMesh.of(
        [(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)], [(0, 1, 2), (0, 3, 4)]
    )
    result = repaired(bow)
    assert [part.vertices.tolist() for part in result.parts] == [[0, 1, 2], [0, 3, 4]]
    assert result.notes == ("1 vertex where faces only touched was split",)


def test_a_sheet_that_touches_itself_gets_its_vertex_twice():
    faces = [i for i in range(9) if i not in (4, 8)]
    pinched = sheet(3, 3).taken([i for i in range(9) if i not in (2, 4, 6, 8)]).mesh
    assert repaired(sheet(3, 3).taken(faces).mesh).repairs == Repairs(split=1)
    assert repaired(pinched).repairs == Repairs(split=3)


def test_the_part_with_most_faces_comes_first():
    result = repaired(together(sheet(1, 1), cube(), sheet(2, 2), torus(4, 4)))
    assert [part.mesh.face_count for part in result.parts] == [16, 6, 4, 1]
    assert result.parts[3].faces.tolist() == [0]


def test_parts_without_area_are_left_out():
    line = PolygonMesh.of([(0, 0, 0), (1, 2, 3), (2, 4, 6)], [(0, 1, 2)])
    assert repaired(together(line, cube())).notes == ("1 part without any area was left out",)
    with pytest.raises(ValueError, match="the faces have no area"):
        repaired(line)


def test_of_nothing_nothing_is_made():
    with pytest.raises(ValueError, match="there are no faces"):
        repaired(PolygonMesh.of(np.zeros((3, 3)), []))
    with pytest.raises(ValueError, match="no face has three different corners"):
        repaired(PolygonMesh.of(np.zeros((3, 3)), [(0, 1, 2)]))


def test_many_small_parts():
    parts = repaired(together(*[sheet(1, 2)] * 500)).parts
    assert [part.faces.tolist() for part in parts] == [[i, i + 1] for i in range(0, 1000, 2)]


@given(st.lists(st.lists(st.integers(0, 8), min_size=3, max_size=5), min_size=1, max_size=14))
@settings(max_examples=150, deadline=None)
def test_whatever_is_left_of_any_faces_is_proper(faces):
    points = np.random.default_rng(1).normal(size=(9, 3))
    mesh = PolygonMesh.of(points, faces)
    try:
        parts = repaired(mesh).parts
    except ValueError as problem:
        assert str(problem)
        return
    for part in parts:
        assert_from(part, mesh)
        topology = part.mesh.topology
        assert len(topology.components) == 1
        assert topology.components[0].vertices == part.mesh.vertex_count
