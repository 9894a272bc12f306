"""Which surfaces of meshes have parameters that fill a rectangle."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.mapping import mapped
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.rectangle import rectangle
from tests.geometry.mesh.bodies import cube, sheet, torus
from tests.geometry.mesh.mapped_bodies import tube


def smooth(mesh, **wishes):
    found = mapped(mesh, **wishes)
    return MeshSurface(mesh, found.domain, found.parameters)


def test_a_sheet_seen_from_above_fills_its_box():
    found = rectangle(smooth(sheet(3, 6)))
    assert (found.low, found.high) == ((0.0, 0.0), (1.0, 0.5))
    assert found.closed == (False, False)
    assert not found.is_mirrored


def test_a_tube_is_closed_one_way_and_a_ring_both_ways():
    assert rectangle(smooth(tube(12, 8))).closed == (True, False)
    ring = rectangle(smooth(torus(12, 8)))
    assert ring.closed == (True, True)
    assert ring.low == (0.0, 0.0)


def test_a_closed_body_a_disk_and_a_triangle_fill_none():
    assert rectangle(smooth(cube().subdivided(2).mesh)) is None
    assert rectangle(smooth(sheet(6, 6), wish="circle")) is None
    triangle = PolygonMesh.of([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    places = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    assert rectangle(MeshSurface(triangle, PlaneDomain(), places)) is None


@pytest.mark.parametrize("shift", [0.0, 1e6])
def test_a_mirrored_map_is_known(shift):
    mesh = sheet(4, 4)
    places = mesh.vertices[mesh.corners, :2] * [-1.0, 1.0] + shift
    found = rectangle(MeshSurface(mesh, PlaneDomain(), places))
    assert found.is_mirrored
    assert_allclose(found.sizes, 4.0)


@pytest.mark.parametrize("count", [1, 50, 4000, 10**6])
def test_cells_are_about_square_and_about_as_many_as_wished(count):
    found = rectangle(smooth(sheet(3, 6)))
    along, across = found.cells(count)
    assert min(along, across) >= 2
    if count > 10:
        assert 0.8 < along * across / count < 1.25
        assert 1.6 < along / across < 2.5


def test_lines_reach_from_side_to_side():
    found = rectangle(smooth(sheet(3, 6)))
    u, v = found.lines((4, 5))
    assert (len(u), len(v)) == (5, 6)
    assert (u[0], v[0], u[-1], v[-1]) == (*found.low, *found.high)
