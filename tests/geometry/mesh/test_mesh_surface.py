import sys
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.mesh_surface import EditedPlane, MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from tests.geometry.mesh.mesh_surfaces import (
    EVERY_KIND,
    PILLOW,
    TORUS,
    cylinder,
    definition,
    grid_corners,
    height_field,
    inner_places,
    pillow,
    sizes_of,
    spanned,
    torus,
)

every_kind = pytest.mark.parametrize("kind", EVERY_KIND, ids=lambda each: each.__name__)
every_smoothness = pytest.mark.parametrize("smoothness", [0.02, 0.25, 0.7, 2.0, 6.0])


@every_kind
@every_smoothness
def test_points_and_derivatives_agree_with_the_definition(kind, smoothness):
    surface = kind(smoothness=smoothness)
    places = inner_places(surface)
    expected = definition(surface, places, around=9 if smoothness > 1.0 else 2)
    sigma = surface.sigmas.min()
    assert_allclose(surface.at(places), expected[0], atol=1e-12)
    for found, wanted in zip(surface.derivatives(places), expected, strict=True):
        assert_allclose(found, wanted, rtol=1e-10, atol=1e-11 * max(1.0, 1.0 / sigma))


@every_kind
@pytest.mark.parametrize("options", [{"s": 0.0}, {"s": -2.5}, {"area_weights": True}], ids=str)
def test_magnitude_and_area_weights_agree_with_the_definition(kind, options):
    surface = kind(smoothness=0.8, **options)
    places = inner_places(surface)
    for found, wanted in zip(surface.derivatives(places), definition(surface, places), strict=True):
        assert_allclose(found, wanted, atol=1e-10)


@pytest.mark.parametrize("smoothness", [0.01, 0.25, 0.7, 3.0, 40.0, 1e6])
def test_a_height_field_gives_its_parameters_back(smoothness):
    surface = height_field(smoothness=smoothness)
    places = np.concatenate([surface.vertex_places, inner_places(surface)])
    assert_allclose(surface.at(places)[:, :2], places, atol=1e-15, rtol=0.0)


@pytest.mark.parametrize("smoothness", [0.25, 0.7, 8.0])
def test_the_tangents_of_a_height_field_are_those_of_its_parameters(smoothness):
    _, by_u, by_v = height_field(smoothness=smoothness).derivatives([[0.3, 0.6], [0.0, 1.0]])
    assert_allclose(by_u[:, :2], [[1.0, 0.0]] * 2, atol=1e-12)
    assert_allclose(by_v[:, :2], [[0.0, 1.0]] * 2, atol=1e-12)


def seam_pairs(kind):
    """Places and their images on the other side of a seam, with the sign of the motion."""
    t = np.linspace(0.0, 1.0, 7)
    zero = np.zeros(7)
    if kind is cylinder:
        return [(np.stack([zero, t], axis=1), np.stack([zero + 1.0, t], axis=1), 1.0)]
    if kind is torus:
        top = np.full(7, TORUS.height)
        return [
            (np.stack([zero, t], axis=1), np.stack([zero + 1.0, t], axis=1), 1.0),
            (np.stack([t, zero], axis=1), np.stack([t, top], axis=1), 1.0),
        ]
    low, high = np.stack([t, zero], axis=1), np.stack([t, zero + 0.5], axis=1)
    side, around = np.stack([zero, t], axis=1), np.array([[2.0 * PILLOW.width, 0.0]])
    return [
        (low, around - low, -1.0),
        (high, around + np.array([[0.0, 1.0]]) - high, -1.0),
        (side, around + side, 1.0),
        (side, -side, -1.0),
    ]


@pytest.mark.parametrize("kind", [cylinder, torus, pillow], ids=lambda each: each.__name__)
def test_which_image_of_a_face_its_parameters_are_makes_no_difference(kind):
    surface = kind()
    generator = np.random.default_rng(4)
    shifts, signs = surface.domain.images(2.0)
    chosen = np.repeat(generator.integers(0, len(signs), surface.mesh.face_count), 3)
    moved = replace(surface, parameters=signs[chosen, None] * surface.parameters + shifts[chosen])
    places = inner_places(surface)
    for found, wanted in zip(moved.derivatives(places), surface.derivatives(places), strict=True):
        assert_allclose(found, wanted, atol=1e-11)


@pytest.mark.parametrize("kind", [cylinder, torus, pillow], ids=lambda each: each.__name__)
@pytest.mark.parametrize("smoothness", [0.3, 0.7, 2.0, 12.0])
def test_both_sides_of_a_seam_agree(kind, smoothness):
    surface = kind(smoothness=smoothness)
    for places, images, sign in seam_pairs(kind):
        here, there = surface.derivatives(places), surface.derivatives(images)
        scale = max(1.0, np.abs(here[1]).max(), np.abs(here[2]).max())
        assert_allclose(here[0], there[0], atol=2e-15, rtol=0.0)
        assert_allclose(here[1], sign * there[1], atol=2e-14 * scale, rtol=0.0)
        assert_allclose(here[2], sign * there[2], atol=2e-14 * scale, rtol=0.0)


@pytest.mark.parametrize("smoothness", [0.3, 0.7, 3.0])
def test_a_pillow_has_no_tangents_at_its_cone_points(smoothness):
    width = PILLOW.width
    _, by_u, by_v = pillow(smoothness=smoothness).derivatives(
        [[0.0, 0.0], [0.0, 0.5], [width, 0.5], [width, 0.0]]
    )
    assert_allclose(by_u, 0.0, atol=1e-12)
    assert_allclose(by_v, 0.0, atol=1e-12)


@every_kind
@pytest.mark.parametrize("smoothness", [0.4, 0.7, 3.0])
def test_derivatives_are_limits_of_differences(kind, smoothness):
    surface = kind(smoothness=smoothness)
    places, h = inner_places(surface), 1e-5 * surface.sigmas.min()
    _, *slopes = surface.derivatives(places)
    for slope, step in zip(slopes, ([h, 0.0], [0.0, h]), strict=True):
        difference = (surface.at(places + step) - surface.at(places - step)) / (2.0 * h)
        assert_allclose(slope, difference, atol=1e-5 * max(1.0, np.abs(slope).max()))


@every_kind
def test_the_surface_of_a_transformed_mesh_is_the_transformed_surface(kind):
    surface = kind().with_plane(3, point=[1.0, 2.0, 0.5], gradient_v=[0.3, 0.2, -1.0])
    matrix = np.array([[2.0, 0.3, 0.0], [0.0, -1.0, 0.5], [0.1, 0.0, 0.7]])
    offset = np.array([5.0, -3.0, 1.0])
    places = inner_places(surface)
    found = surface.transformed(matrix, offset).at(places)
    assert_allclose(found, surface.at(places) @ matrix.T + offset, atol=1e-12)


@every_kind
def test_the_surface_is_affine_in_the_magnitude(kind):
    surface = kind()
    places = inner_places(surface)
    none, one, more = (surface.with_s(s).at(places) for s in (0.0, 1.0, 3.5))
    assert_allclose(more, none + 3.5 * (one - none), atol=1e-12)


@pytest.mark.parametrize("smoothness", [1e-3, 0.7, 1e3])
def test_a_single_face_is_its_plane_everywhere(smoothness):
    mesh = PolygonMesh.of([[0.0, 0.0, 1.0], [1.0, 0.0, 2.0], [0.0, 1.0, 3.0]], [[0, 1, 2]])
    surface = MeshSurface(
        mesh, PlaneDomain(), mesh.vertices[mesh.corners][:, :2], smoothness=smoothness
    )
    places = np.array([[0.2, 0.1], [-3.0, 7.0], [1e6, 0.0]])
    u, v = places.T
    assert_allclose(
        surface.at(places), np.stack([u, v, 1.0 + u + 2.0 * v], axis=1), rtol=1e-12, atol=1e-12
    )


def test_a_place_far_outside_belongs_to_the_plane_nearest_in_units_of_its_sigma():
    surface = height_field(smoothness=0.3)
    for place in ([50.0, -20.0], [1e7, 1e7], [-1e12, 0.0]):
        distances = np.linalg.norm(place - surface.planes.centers, axis=1) / surface.sigmas
        nearest = np.argsort(distances)[:1]
        expected = surface.planes.values(nearest, np.array([place]))
        assert_allclose(surface.at([place]), expected, rtol=1e-9)


@pytest.mark.parametrize("smoothness", [1e-300, 1e-12, 1e-4])
def test_with_next_to_no_smoothness_every_place_lies_on_the_plane_of_some_face(smoothness):
    surface = height_field(smoothness=smoothness)
    places = inner_places(surface)
    away = np.linalg.norm(places[:, None] - surface.planes.centers, axis=2) / surface.planes.radii
    expected = surface.planes.values(away.argmin(axis=1), places)
    assert_allclose(surface.at(places), expected, atol=1e-12)


@every_kind
def test_with_endless_smoothness_the_surface_is_the_mean_of_its_planes(kind):
    surface = kind(smoothness=1e300, s=0.0)
    weights = surface.planes.radii**2 if surface.domain.turns or kind in (cylinder, torus) else None
    if kind is cylinder:
        weights = surface.planes.radii
    mean = np.average(surface.planes.points, axis=0, weights=weights)
    found = surface.at(inner_places(surface))
    assert_allclose(found, np.broadcast_to(mean, found.shape), atol=1e-12)


@pytest.mark.parametrize("smoothness", [0.3, 0.7, 4.0])
def test_radii_may_differ_by_nine_orders_of_magnitude(smoothness):
    steps = np.concatenate([[0.0], np.geomspace(1e-9, 1.0, 40)])
    surface = spanned(
        PlaneDomain(),
        grid_corners(steps, steps),
        lambda u, v: (u, v, np.sin(np.log10(u + v + 1e-12))),
        smoothness=smoothness,
    )
    places = np.random.default_rng(2).choice(surface.vertex_places, 200, axis=0)
    for found, wanted in zip(surface.derivatives(places), definition(surface, places), strict=True):
        assert_allclose(found, wanted, atol=1e-10 * max(1.0, np.abs(wanted).max()))


def test_faces_without_extent_in_the_parameters_do_not_count():
    surface = height_field()
    mesh = surface.mesh
    more = PolygonMesh(
        mesh.vertices,
        np.append(mesh.corners, [0, 1, 2]),
        np.append(mesh.starts, len(mesh.corners) + 3),
    )
    parameters = np.concatenate([surface.parameters, np.full((3, 2), 0.5)])
    places = inner_places(surface)
    assert_allclose(
        MeshSurface(more, PlaneDomain(), parameters).at(places), surface.at(places), atol=1e-15
    )


def test_a_mesh_without_any_extent_in_the_parameters_is_refused():
    surface = height_field()
    flat = replace(surface, parameters=np.zeros_like(surface.parameters))
    with pytest.raises(ValueError, match="no face has any extent"):
        flat.at([[0.0, 0.0]])


def test_an_edited_plane_is_what_it_was_given_and_else_that_of_the_face():
    surface = height_field()
    edited = surface.with_plane(7, point=[1.0, 2.0, 3.0]).with_plane(7, gradient_u=[0.0, 0.0, 1.0])
    assert_array_equal(edited.planes.points[7], [1.0, 2.0, 3.0])
    assert_array_equal(edited.planes.gradients_u[7], [0.0, 0.0, 1.0])
    assert_array_equal(edited.planes.gradients_v[7], surface.planes.gradients_v[7])
    assert_array_equal(
        np.delete(edited.planes.points, 7, axis=0), np.delete(surface.planes.points, 7, axis=0)
    )


def test_edited_planes_agree_with_the_definition():
    surface = pillow().with_edited({5: EditedPlane(point=np.array([0.0, 0.0, 3.0]))})
    places = inner_places(surface)
    assert_allclose(surface.at(places), definition(surface, places)[0], atol=1e-12)


def test_local_factors_change_the_widths_of_their_faces_alone():
    surface = height_field()
    factors = np.ones(surface.mesh.face_count)
    factors[10:30] = 3.0
    local = surface.with_factors(factors)
    assert_allclose(local.sigmas, factors * surface.sigmas)
    places = inner_places(surface)
    assert_allclose(local.at(places), definition(local, places)[0], atol=1e-12)
    assert_array_equal(local.with_factors(None).at(places), surface.at(places))


def test_other_smoothness_magnitude_and_edits_share_the_foundation():
    surface = height_field()
    for other in (surface.with_smoothness(3.0), surface.with_s(0.5), surface.with_plane(0)):
        assert other.foundation is surface.foundation
    assert surface.with_factors(np.ones(surface.mesh.face_count)).foundation.planes is (
        surface.foundation.planes
    )
    assert replace(surface, area_weights=True).foundation is not surface.foundation


def test_vertices_have_the_place_of_their_first_corner():
    mesh = PolygonMesh.of(np.eye(4, 3), [[2, 0, 1], [1, 3, 2]])
    parameters = np.arange(12.0).reshape(6, 2)
    surface = MeshSurface(mesh, PlaneDomain(), parameters)
    assert_array_equal(surface.vertex_places, parameters[[1, 2, 0, 4]])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"smoothness": 0.0}, "smoothness: must be positive"),
        ({"smoothness": np.nan}, "smoothness: must be positive"),
        ({"s": np.inf}, "s: must be finite"),
        ({"edited": {1000: EditedPlane()}}, "planes: there is no face 1000, only 0 to 161"),
        ({"factors": np.ones(3)}, r"factors: expected shape \(162,\), got \(3,\)"),
        ({"factors": np.zeros(162)}, "factors: must be positive"),
    ],
)
def test_what_does_not_fit_is_refused(options, message):
    with pytest.raises(ValueError, match=message):
        height_field(**options)


def test_places_that_are_not_finite_are_refused():
    with pytest.raises(ValueError, match="places: has a value that is not finite"):
        height_field().at([[0.0, np.nan]])


def test_no_places_give_no_points():
    assert height_field().at(np.zeros((0, 2))).shape == (0, 3)


@every_kind
@pytest.mark.parametrize("smoothness", [0.1, 0.7, 4.0])
def test_without_compiled_loops_the_result_is_the_same(kind, smoothness, monkeypatch):
    surface = kind(smoothness=smoothness)
    places = np.concatenate([inner_places(surface), 30.0 * sizes_of(surface)[None]])
    fast = surface.derivatives(places)
    monkeypatch.setitem(sys.modules, "plusedit.geometry.mesh.full_kernels", None)
    for found, wanted in zip(surface.derivatives(places), fast, strict=True):
        assert_allclose(found, wanted, atol=1e-9 * max(1.0, np.abs(wanted).max()))
