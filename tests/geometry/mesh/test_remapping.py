"""Edited planes of surfaces that get other parameters."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.remapping import remapped
from tests.geometry.mesh.mesh_surfaces import height_field

TURN = np.array([[0.8, -1.1], [0.3, 0.6]])


def bent(places):
    """Parameters that depend on the old ones in a curved way."""
    u, v = places.T
    return np.stack([u + 0.3 * v**2, 0.5 * v - 0.2 * np.sin(u)], axis=1)


def edited():
    surface = height_field().with_plane(4, [1.0, 2.0, 3.0], [0.5, 0.0, 1.0], [0.0, -2.0, 0.3])
    return surface.with_plane(9, gradient_v=[0.0, 1.0, 7.0]).with_plane(11, point=[0.0, 0.0, 5.0])


def corners_on_planes(surface, face):
    """Where the plane of a face has its corners."""
    places = surface.parameters[surface.mesh.owners == face]
    return surface.planes.values(np.full(len(places), face), places)


@pytest.mark.parametrize("move", [lambda q: q @ TURN.T + 3.0, bent])
@pytest.mark.parametrize("face", [4, 9, 11])
def test_the_plane_of_a_triangle_lies_in_space_as_before(move, face):
    before = edited()
    after = remapped(before, PlaneDomain(), move(before.parameters))
    assert_allclose(
        corners_on_planes(after, face), corners_on_planes(before, face), rtol=1e-9, atol=1e-9
    )


def test_polygons_are_turned_by_the_map_that_fits_them_best():
    mesh = PolygonMesh.of([[0, 0, 0], [2, 0, 0], [3, 2, 1], [0, 1, 0]], [(0, 1, 2, 3)])
    flat = np.array([[0.0, 0.0], [1.0, 0.0], [1.2, 0.9], [0.0, 0.5]])
    before = MeshSurface(mesh, PlaneDomain(), flat).with_plane(0, None, [1, 0, 2], [0, 3, 1])
    after = remapped(before, PlaneDomain(), flat @ TURN.T)
    assert_allclose(corners_on_planes(after, 0), corners_on_planes(before, 0), atol=1e-12)


def test_points_and_all_else_stay():
    before = edited().with_smoothness(2.0).with_factors(np.linspace(1, 2, 162))
    after = remapped(before, PlaneDomain(), bent(before.parameters))
    assert_array_equal(after.edited[4].point, [1.0, 2.0, 3.0])
    assert after.edited[9].point is None
    assert after.edited[11].gradient_u is None
    assert after.smoothness == 2.0
    assert_array_equal(after.factors, before.factors)
    assert after.mesh is before.mesh


def test_back_again_everything_is_as_it_was():
    before = edited()
    there = remapped(before, PlaneDomain(), bent(before.parameters))
    back = remapped(there, PlaneDomain(), before.parameters)
    places = before.parameters[::7]
    assert_allclose(back.at(places), before.at(places), rtol=1e-9, atol=1e-9)


def test_parameters_without_extent_are_refused():
    surface = edited()
    with pytest.raises(ValueError, match="no face has any extent"):
        remapped(surface, PlaneDomain(), np.zeros_like(surface.parameters))
