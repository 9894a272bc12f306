"""Half-edges, borders, parts and handles."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.repair import repaired
from plusedit.geometry.mesh.topology import Topology
from tests.geometry.mesh.bodies import (
    cube,
    cylinder,
    every_real_mesh,
    real_mesh,
    ribbon,
    sheet,
    together,
    torus,
)

SURFACES = {
    "ball": (cube(), 0, 0),
    "cylinder": (cylinder(7, 2.0), 0, 0),
    "disk": (sheet(3, 4), 1, 0),
    "tube": (ribbon(0), 2, 0),
    "tube with a full twist": (ribbon(2), 2, 0),
    "torus": (torus(7, 5), 0, 1),
    "torus with a hole": (torus(7, 5).taken(range(34)).mesh, 1, 1),
    "disk with two holes": (
        sheet(5, 5).taken([i for i in range(25) if i not in (6, 18)]).mesh,
        3,
        0,
    ),
}
every_surface = pytest.mark.parametrize(
    ("mesh", "boundaries", "handles"), SURFACES.values(), ids=SURFACES
)


def assert_consistent(mesh):
    """What holds for every topology, whatever the mesh."""
    topology = Topology.of(mesh)
    opposite, following = topology.opposite, mesh.following
    inner = np.flatnonzero(opposite >= 0)
    assert_array_equal(opposite[opposite[inner]], inner)
    assert_array_equal(mesh.corners[opposite[inner]], mesh.corners[following[inner]])
    assert_array_equal(mesh.corners[following[opposite[inner]]], mesh.corners[inner])
    assert_array_equal(topology.edge_of[opposite[inner]], topology.edge_of[inner])
    assert_array_equal(np.sort(topology.edges[topology.edge_of], axis=1), sides(mesh))
    around = np.concatenate([np.zeros(0, int), *(loop.corners for loop in topology.loops)])
    assert_array_equal(np.sort(around), topology.border)
    for loop in topology.loops:
        assert_array_equal(mesh.corners[following[loop.corners]], np.roll(loop.vertices, -1))
    for number, part in enumerate(topology.components):
        assert part.euler == 2 - 2 * part.handles - part.boundaries
        assert part.boundaries == len(topology.loops_of(number))
        assert part.faces == np.count_nonzero(topology.component_of == number)


def sides(mesh):
    """(c, 2) the vertices of every half-edge, ascending."""
    return np.sort(np.stack([mesh.corners, mesh.corners[mesh.following]], axis=1), axis=1)


@every_surface
def test_boundaries_and_handles_of_well_known_surfaces(mesh, boundaries, handles):
    (part,) = mesh.topology.components
    assert (part.boundaries, part.handles) == (boundaries, handles)
    assert part.vertices == mesh.vertex_count
    assert part.closed == (boundaries == 0)
    assert_consistent(mesh)


@every_surface
def test_subdividing_changes_neither_boundaries_nor_handles(mesh, boundaries, handles):
    (part,) = mesh.subdivided(1).mesh.topology.components
    assert (part.boundaries, part.handles) == (boundaries, handles)


@every_surface
def test_triangles_of_a_surface_have_its_topology(mesh, boundaries, handles):
    (part,) = PolygonMesh.of(mesh.vertices, mesh.triangles()[0]).topology.components
    assert (part.boundaries, part.handles) == (boundaries, handles)


def test_the_topology_of_a_mesh_is_worked_out_once():
    mesh = cube()
    assert Topology.of(mesh) is Topology.of(mesh)


def test_a_loop_runs_around_with_the_faces_on_its_left():
    (loop,) = sheet(1, 2).topology.loops
    assert loop.vertices.tolist() == [0, 1, 2, 5, 4, 3]
    assert loop.length == 6.0


def test_loops_come_part_by_part_the_longest_first():
    ring = sheet(5, 5).taken([i for i in range(25) if i != 12]).mesh
    loops = together(sheet(1, 1), ring).topology.loops
    assert [(loop.component, loop.length) for loop in loops] == [(0, 4.0), (1, 20.0), (1, 4.0)]


def test_edges_and_neighbors_of_two_quads():
    topology = sheet(1, 2).topology
    assert len(topology.edges) == 7
    assert_allclose(topology.edge_lengths, 1.0)
    assert topology.neighbors.tolist() == [-1, 1, -1, -1, -1, -1, -1, 0]


def test_faces_at_a_vertex():
    topology = sheet(2, 2).topology
    assert topology.faces_at(4).tolist() == [0, 1, 2, 3]
    assert topology.faces_at(0).tolist() == [0]
    corners, starts = topology.corners_by_vertex
    assert_array_equal(np.diff(starts), [1, 2, 1, 2, 4, 2, 1, 2, 1])
    assert_array_equal(topology.mesh.corners[corners], np.repeat(np.arange(9), np.diff(starts)))


def test_a_bow_tie_has_two_umbrellas_at_its_knot():
    bow = PolygonMesh.of(np.eye(5)[:, :3], [(0, 1, 2), (0, 3, 4)])
    assert len(bow.topology.components) == 2
    assert bow.topology.umbrella_of.tolist() == [0, 1, 2, 3, 4, 5]


def test_faces_that_do_not_face_the_same_way_are_not_glued():
    flipped = PolygonMesh.of(np.eye(4)[:, :3], [(0, 1, 2), (1, 2, 3)])
    assert (flipped.topology.opposite == -1).all()
    glued = PolygonMesh.of(np.eye(4)[:, :3], [(0, 1, 2), (2, 1, 3)])
    assert glued.topology.opposite.tolist() == [-1, 3, -1, 1, -1, -1]


def test_an_edge_of_three_faces_is_border_of_all():
    book = PolygonMesh.of(np.eye(5)[:, :3], [(0, 1, 2), (1, 0, 3), (0, 1, 4)])
    assert len(book.topology.border) == 9
    assert_consistent(book)


def test_a_border_with_many_faces_around_one_vertex():
    fan = PolygonMesh.of(np.zeros((2000, 3)), [(0, i, i + 1) for i in range(1, 1999)])
    (loop,) = fan.topology.loops
    assert len(loop.vertices) == 2000


@every_real_mesh
def test_real_meshes_are_consistent_before_and_after_repair(name):
    mesh = real_mesh(name)
    assert_consistent(mesh)
    for part in repaired(mesh).parts:
        assert_consistent(part.mesh)
