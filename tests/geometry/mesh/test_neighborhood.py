from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh import neighborhood
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.evaluation import points_and_normals
from plusedit.geometry.mesh.neighborhood import changed_faces, changed_places
from tests.geometry.mesh.mesh_surfaces import (
    EVERY_KIND,
    grid_corners,
    height_field,
    inner_places,
    pillow,
    spanned,
)

every_kind = pytest.mark.parametrize("kind", EVERY_KIND, ids=lambda each: each.__name__)
every_smoothness = pytest.mark.parametrize("smoothness", [0.25, 0.7, 2.0, 8.0])


def lifted(surface, *faces):
    for face in faces:
        surface = surface.with_plane(face, point=surface.planes.points[face] + [0.0, 0.0, 1.0])
    return surface


def with_factor(surface, factor, *faces):
    factors = np.ones(surface.mesh.face_count)
    factors[list(faces)] = factor
    return surface.with_factors(factors)


def sheet(**options):
    """A plane of 3200 faces."""
    corners = grid_corners(np.linspace(0.0, 1.0, 41), np.linspace(0.0, 1.0, 41))
    return spanned(PlaneDomain(), corners, lambda u, v: (u, v, 0.0 * u), **options)


def agree_elsewhere(old, new, places):
    """All places but those told have the same points and normals; how many were told."""
    rows = changed_places(old, new, places)
    rest = np.setdiff1d(np.arange(len(places)), rows)
    before, after = points_and_normals(old, places[rest]), points_and_normals(new, places[rest])
    assert_allclose(before[0], after[0], rtol=0.0, atol=1e-13)
    assert_allclose(before[1], after[1], rtol=0.0, atol=1e-9)
    return len(rows)


@every_kind
@every_smoothness
def test_an_edited_plane_changes_nothing_elsewhere(kind, smoothness):
    surface = kind(smoothness=smoothness)
    for face in (0, 77):
        agree_elsewhere(surface, lifted(surface, face), inner_places(surface, 400))


@every_kind
@pytest.mark.parametrize("factor", [0.1, 0.5, 3.0])
def test_local_factors_change_nothing_elsewhere(kind, factor):
    for smoothness in (0.25, 0.7):
        surface = kind(smoothness=smoothness)
        agree_elsewhere(surface, with_factor(surface, factor, 5, 6, 90), inner_places(surface, 400))


def test_edits_and_factors_and_their_removal_count_alike():
    surface = height_field()
    both = with_factor(lifted(surface, 3), 2.0, 100)
    places = inner_places(surface, 300)
    forth, back = changed_places(surface, both, places), changed_places(both, surface, places)
    assert forth.tolist() == back.tolist()
    assert changed_faces(surface, both).tolist() == [3, 100]


def test_only_the_neighborhood_is_told():
    surface = sheet(smoothness=0.5)
    places = surface.vertex_places
    assert 0 < agree_elsewhere(surface, lifted(surface, 1700), places) < 0.1 * len(places)


@every_kind
def test_only_the_neighborhood_is_told_in_every_domain(kind):
    surface = kind(smoothness=0.25)
    places = inner_places(surface, 400)
    for face in range(0, surface.mesh.face_count, 40):
        assert len(changed_places(surface, lifted(surface, face), places)) < 0.35 * len(places)


def test_every_place_that_changes_is_told():
    surface = sheet()
    edited = lifted(surface, 900)
    places = surface.vertex_places
    away = np.abs(surface.at(places) - edited.at(places)).max(axis=1)
    assert set(np.flatnonzero(away > 1e-13)) <= set(changed_places(surface, edited, places))


def test_far_from_all_planes_the_nearest_ones_count():
    surface = height_field(smoothness=0.3)
    nearest = int(np.argmax(surface.planes.centers.sum(axis=1)))
    places = np.array([[5.0, 5.0], [-5.0, -5.0]])
    assert changed_places(surface, lifted(surface, nearest), places).tolist() == [0]


def test_images_of_a_plane_change_places_as_well():
    surface = pillow(smoothness=0.4)
    face = int(np.argmin((surface.planes.centers**2).sum(axis=1)))
    beside = surface.planes.centers[face]
    above = np.array([0.0, 1.0])
    places = np.array([beside, -beside, beside + above])
    assert changed_places(surface, lifted(surface, face), places).tolist() == [0, 1, 2]


def test_places_that_do_not_change_are_looked_at_once(monkeypatch):
    from scipy import spatial

    surface = sheet()
    places = surface.vertex_places
    changed_places(surface, lifted(surface, 1), places)
    sizes = []
    real = spatial.KDTree
    monkeypatch.setattr(spatial, "KDTree", lambda of, **more: sizes.append(len(of)) or real(of))
    changed_places(surface, lifted(surface, 2), places)
    assert not sizes


def test_one_by_one_or_by_a_tree_the_same_places_are_found(monkeypatch):
    surface = pillow(smoothness=0.5)
    moved = surface
    for face in range(0, surface.mesh.face_count, 9):
        moved = lifted(moved, face)
    by_tree = changed_places(surface, moved, surface.vertex_places)
    monkeypatch.setattr(neighborhood, "FEW", 10**6)
    assert_array_equal(changed_places(surface, moved, surface.vertex_places), by_tree)


def test_nothing_changes_where_no_plane_does():
    surface = height_field()
    assert not len(changed_places(surface, replace(surface), inner_places(surface)))
    assert not len(changed_places(surface, lifted(surface, 1), np.zeros((0, 2))))


@pytest.mark.parametrize("options", [{"smoothness": 0.8}, {"s": 0.5}, {"area_weights": True}])
def test_what_differs_in_more_than_planes_may_change_anywhere(options):
    surface = height_field()
    assert changed_places(surface, replace(surface, **options), inner_places(surface)) is None


def test_surfaces_of_different_meshes_may_differ_anywhere():
    assert changed_places(height_field(), height_field(), np.zeros((1, 2))) is None
