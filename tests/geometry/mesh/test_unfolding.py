"""Faces laid out in the cell of a domain."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.mesh.unfolding import NONE, Unfolding
from tests.geometry.mesh.mesh_surfaces import (
    PILLOW,
    cylinder,
    grid_corners,
    height_field,
    pillow,
    spanned,
    torus,
)

SURFACES = pytest.mark.parametrize("make", [height_field, cylinder, torus, pillow])
CLOSED = pytest.mark.parametrize("make", [torus, pillow])


@SURFACES
def test_the_centers_of_faces_lie_in_the_cell(make):
    unfolding = Unfolding.of(make())
    low, high = unfolding.bounds
    assert (unfolding.centers >= low).all()
    assert (unfolding.centers <= high).all()


@SURFACES
def test_faces_keep_their_form_and_lie_at_an_image_of_their_place(make):
    surface = make()
    unfolding = Unfolding.of(surface)
    there = surface.domain.nearest(unfolding.corners, surface.parameters)
    assert_allclose(
        np.abs(np.diff(there.reshape(-1, 3, 2), axis=1)),
        np.abs(np.diff(unfolding.corners.reshape(-1, 3, 2), axis=1)),
        atol=1e-12,
    )


@CLOSED
def test_it_does_not_matter_at_which_image_the_parameters_are(make):
    surface = make()
    moved = with_parameters(surface, surface.parameters + surface.domain.periods)
    assert_allclose(Unfolding.of(moved).corners, Unfolding.of(surface).corners, atol=1e-12)


@CLOSED
def test_the_faces_and_their_images_cover_the_cell(make):
    surface = make()
    unfolding = Unfolding.of(surface)
    low, high = unfolding.bounds
    places = np.random.default_rng(1).uniform(low, high, (200, 2))
    assert all(unfolding.face_at(place) != NONE for place in places)


@SURFACES
def test_the_face_at_the_center_of_a_face_is_that(make):
    unfolding = Unfolding.of(make())
    found = [unfolding.face_at(center) for center in unfolding.centers]
    assert found == list(range(unfolding.mesh.face_count))


@CLOSED
def test_a_face_is_found_at_its_images_too(make):
    unfolding = Unfolding.of(make())
    images = unfolding.domain.images(1.0)
    for shift, sign in zip(*images, strict=True):
        assert unfolding.face_at(sign * unfolding.centers[5] + shift) == 5


def test_beside_the_faces_there_is_none():
    unfolding = Unfolding.of(height_field())
    assert unfolding.face_at(np.array([3.0, 0.5])) == NONE
    assert unfolding.face_at(np.array([-0.5, -0.5])) == NONE


@SURFACES
def test_a_box_takes_the_faces_whose_centers_it_holds(make):
    unfolding = Unfolding.of(make())
    low, high = unfolding.bounds
    middle = (low + high) / 2.0
    inside = (unfolding.centers >= low) & (unfolding.centers <= middle)
    assert unfolding.faces_within(low, middle).tolist() == np.flatnonzero(inside.all(1)).tolist()


def test_a_box_beyond_the_seam_takes_faces_of_the_other_side():
    unfolding = Unfolding.of(cylinder())
    beyond = unfolding.faces_within(np.array([1.0, -9.0]), np.array([1.2, 9.0]))
    within = unfolding.faces_within(np.array([0.0, -9.0]), np.array([0.2, 9.0]))
    assert len(within)
    assert beyond.tolist() == within.tolist()


def test_what_is_sewn_up_by_the_domain_has_no_rim():
    for surface in (joined(torus()), joined(even_pillow())):
        assert len(Unfolding.of(surface).rims[0]) == 0


def test_the_border_of_the_mesh_is_a_rim():
    starts, ends = Unfolding.of(joined(cylinder())).rims
    assert len(starts) == 2 * 12
    assert (starts[:, 1] == ends[:, 1]).all()


def test_a_tear_of_the_map_is_a_rim():
    surface = joined(cylinder())
    # As if u did not repeat: the first and the last column of faces no longer meet.
    torn = with_parameters(surface, surface.parameters * (0.9, 1.0))
    starts, ends = Unfolding.of(torn).rims
    assert np.count_nonzero(starts[:, 0] == ends[:, 0]) == 2 * 8


def test_the_nearest_vertex_is_found_across_the_seam():
    surface = joined(torus())
    unfolding = Unfolding.of(surface)
    place = surface.parameters[7]
    vertex = surface.mesh.corners[7]
    for shift in ((0.0, 0.0), (1.0, 0.0), (-1.0, 0.7)):
        assert unfolding.vertex_near(place + shift + (1e-3, -1e-3)) == vertex


def joined(surface):
    """The surface with vertices that lie at one place made one."""
    _, numbers = np.unique(np.round(surface.mesh.vertices, 6), axis=0, return_inverse=True)
    numbers = numbers.ravel()
    firsts = np.zeros(numbers.max() + 1, dtype=int)
    firsts[numbers[::-1]] = np.arange(len(numbers))[::-1]
    mesh = type(surface.mesh)(
        surface.mesh.vertices[firsts], numbers[surface.mesh.corners], surface.mesh.starts
    )
    return type(surface)(mesh, surface.domain, surface.parameters)


def with_parameters(surface, parameters):
    return type(surface)(surface.mesh, surface.domain, parameters)


def even_pillow():
    """Both halves of the rim with vertices at the same places."""
    corners = grid_corners(np.linspace(0.0, 2.0 * PILLOW.width, 15), np.linspace(0.0, 0.5, 7))

    def shape(u, v):
        a, b = np.pi * u / PILLOW.width, 2 * np.pi * v
        return np.cos(a), np.cos(b), np.sin(a) * np.sin(b)

    return spanned(PILLOW, corners, shape)
