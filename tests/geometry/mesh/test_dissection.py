"""The order in which the vertices of a mesh are eliminated."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from plusedit.geometry.mesh.flattening.dissection import elimination_places
from tests.geometry.mesh.bodies import sheet, torus
from tests.geometry.mesh.mapped_bodies import ball


def neighbors(mesh):
    """The vertices at both ends of every edge."""
    return mesh.topology.edges.T.astype(np.intp)


def filled(count, edges, places):
    """How many pairs of vertices are joined once all have been eliminated in that order."""
    after = [set() for _ in range(count)]
    for a, b in places[edges].T.tolist():
        after[min(a, b)].add(max(a, b))
    for joined in after:
        if joined:
            after[min(joined)] |= joined - {min(joined)}
    return sum(map(len, after))


BODIES = {"sheet": sheet(40, 40), "torus": torus(60, 25), "ball": ball(4)}


@pytest.mark.parametrize("mesh", BODIES.values(), ids=BODIES)
def test_every_vertex_has_a_place_and_few_are_joined(mesh):
    edges, count = neighbors(mesh), mesh.vertex_count
    places = elimination_places(mesh.vertices, *edges)
    assert_array_equal(np.sort(places), np.arange(count))
    # 31/4 n log2 n bound the entries for a grid (George), of which a torus has two layers.
    assert filled(count, edges, places) < 31 / 4 * count * np.log2(count)
    scattered = np.random.default_rng(0).permutation(count)
    assert filled(count, edges, places) < 0.3 * filled(count, edges, scattered)


def test_a_vertex_with_many_neighbors_comes_last():
    mesh = sheet(30, 30)
    hub = mesh.vertex_count
    edges = np.hstack([neighbors(mesh), [np.full(hub, hub), np.arange(hub)]])
    places = elimination_places(np.vstack([mesh.vertices, [(15.0, 15.0, 9.0)]]), *edges)
    assert places[hub] == hub


def test_vertices_at_one_place_are_parted_all_the_same():
    mesh = torus(30, 20)
    places = elimination_places(np.zeros((600, 3)), *neighbors(mesh))
    assert_array_equal(np.sort(places), np.arange(600))


def test_scattered_vertices_have_no_places():
    mesh = torus(80, 50)
    points = np.random.default_rng(1).normal(size=(mesh.vertex_count, 3))
    assert elimination_places(points, *neighbors(mesh)) is None


def test_without_vertices_there_is_nothing_to_place():
    nothing = np.zeros(0, dtype=np.intp)
    assert len(elimination_places(np.zeros((0, 3)), nothing, nothing)) == 0
