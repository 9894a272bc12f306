import sys
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.arrays import unit
from plusedit.geometry.mesh import preview_costs, preview_sums
from plusedit.geometry.mesh.domains import CylinderDomain, PlaneDomain
from plusedit.geometry.mesh.evaluation import points_and_normals
from plusedit.geometry.mesh.interpolation import TAPS, weight_polynomials, weights
from plusedit.geometry.mesh.preview import preview
from tests.geometry.mesh.mesh_surfaces import (
    EVERY_KIND,
    PILLOW,
    grid_corners,
    height_field,
    inner_places,
    pillow,
    sizes_of,
    spanned,
    uneven,
)

every_kind = pytest.mark.parametrize("kind", EVERY_KIND, ids=lambda each: each.__name__)
every_smoothness = pytest.mark.parametrize("smoothness", [0.25, 0.5, 0.7, 1.0, 2.0, 4.0, 8.0, 16.0])
NEAR = 1e-5  # of the diagonal


def terrain(count=60, **options):
    """Some seven thousand faces over uneven cells."""
    corners = grid_corners(uneven(0.0, 1.0, count), uneven(0.0, 1.0, count, 4))
    return spanned(PlaneDomain(), corners, hills, **options)


def hills(u, v):
    return u, v, 0.1 * np.sin(9.0 * u) * np.cos(7.0 * v) + 0.002 * np.sin(200.0 * u + 90.0 * v)


def limb(count=50, least=1e-5, **options):
    """A closed surface whose map shrinks its end: radii from a tenth of the least to 0.05."""
    corners = grid_corners(uneven(0.0, 1.0, 2 * count), np.geomspace(least, 1.0, count))

    def shape(u, v):
        around = 2.0 * np.pi * u
        height = np.log(v) / 5.0
        width = 0.3 * (1.0 - 0.5 * np.sin(height))
        return width * np.cos(around), width * np.sin(around), height

    def mapped(each):
        angle, out = 2.0 * np.pi * each[..., 0], each[..., 1]
        return np.stack([out * np.cos(angle), out * np.sin(angle)], axis=-1)

    surface = spanned(PlaneDomain(), corners, shape, **options)
    return replace(surface, parameters=mapped(surface.parameters))


def agrees(surface, places, size=None):
    """The points to 1e-5 of a size, the mesh's diagonal; the normals where there is much surface.

    With a large S a closed surface shrinks to a point, and its normals to what is left by rounding.
    """
    found = preview(surface, places)
    points, normals = points_and_normals(surface, places)
    size = size or surface.mesh.diagonal
    away = np.linalg.norm(found.points - points, axis=1)
    assert away.max() < NEAR * size
    _, by_u, by_v = surface.derivatives(places)
    area = np.linalg.norm(np.cross(by_u, by_v), axis=1) * sizes_of(surface).prod()
    large = area > 1e-2 * size**2
    turned = 1.0 - (found.normals * normals).sum(axis=1)
    assert not large.any() or np.quantile(turned[large], 0.99) < 1e-5


@pytest.mark.parametrize("kind", [terrain, limb], ids=lambda each: each.__name__)
@every_smoothness
def test_the_preview_is_as_near_as_promised(kind, smoothness):
    surface = kind(smoothness=smoothness)
    places = np.random.default_rng(1).choice(surface.vertex_places, 600, axis=0)
    agrees(surface, places)


@every_kind
@every_smoothness
def test_the_preview_of_coarse_meshes_of_every_domain_is_near(kind, smoothness):
    agrees(kind(smoothness=smoothness), inner_places(kind(), 200))


@pytest.mark.parametrize("kind", [terrain, limb, pillow], ids=lambda each: each.__name__)
@pytest.mark.parametrize("smoothness", [1.0, 4.0])
def test_grids_alone_are_as_near(kind, smoothness, monkeypatch):
    monkeypatch.setattr(preview_costs, "PER_PAIR", 1e9)
    monkeypatch.setattr(preview_costs, "LEAST", 0.0)
    surface = kind(smoothness=smoothness)
    agrees(surface, np.random.default_rng(1).choice(surface.vertex_places, 600, axis=0))


@pytest.mark.parametrize("kind", [terrain, limb, pillow], ids=lambda each: each.__name__)
@pytest.mark.parametrize("smoothness", [1.0, 4.0])
def test_without_any_grid_it_is_nearer_still(kind, smoothness, monkeypatch):
    monkeypatch.setattr(preview_costs, "PER_PAIR", 0.0)
    monkeypatch.setattr(preview_costs, "PER_VISIT", 0.0)
    surface = kind(smoothness=smoothness)
    agrees(surface, np.random.default_rng(1).choice(surface.vertex_places, 600, axis=0))


@pytest.mark.parametrize("smoothness", [0.25, 1.0, 4.0, 16.0])
def test_a_height_field_gives_its_parameters_back_nearly(smoothness):
    surface = terrain(smoothness=smoothness)
    found = preview(surface, surface.vertex_places).points
    assert_allclose(found[:, :2], surface.vertex_places, atol=NEAR)


def edited(surface):
    """Four planes far off and turned."""
    for face in (0, 10, 77, 100):
        point = surface.planes.points[face] + 0.3 * surface.mesh.diagonal
        turned = 3.0 * surface.planes.gradients_v[face]
        surface = surface.with_plane(face, point=point, gradient_u=turned)
    return surface


def partly_smoother(surface):
    return surface.with_factors(np.where(np.arange(surface.mesh.face_count) < 99, 4.0, 1.0))


def randomly_smooth(surface):
    count = surface.mesh.face_count
    return surface.with_factors(4.0 ** np.random.default_rng(2).uniform(-1.0, 1.0, count))


CHANGES = {
    "none of the gradients": lambda surface: surface.with_s(0.0),
    "turned gradients": lambda surface: surface.with_s(-1.5),
    "three times the gradients": lambda surface: surface.with_s(3.0),
    "area weights": lambda surface: replace(surface, area_weights=True),
    "edited planes": edited,
    "partly smoother": partly_smoother,
    "randomly smooth": randomly_smooth,
    "all at once": lambda surface: edited(randomly_smooth(replace(surface, area_weights=True))),
}


@pytest.mark.parametrize("kind", [terrain, limb, pillow], ids=lambda each: each.__name__)
@pytest.mark.parametrize("change", CHANGES.values(), ids=list(CHANGES))
def test_all_that_shapes_a_surface_counts(kind, change):
    for smoothness in (0.5, 2.0, 4.0):
        surface = change(kind(smoothness=smoothness))
        agrees(surface, np.random.default_rng(1).choice(surface.vertex_places, 300, axis=0))


def test_an_edit_is_undone_without_a_trace():
    surface = terrain(smoothness=2.0)
    before = preview(surface, surface.vertex_places).points
    preview(edited(surface), surface.vertex_places)
    assert_array_equal(preview(surface, surface.vertex_places).points, before)


@pytest.mark.parametrize("smoothness", [0.25, 0.7, 4.0])
def test_places_where_no_plane_is_near_are_evaluated_all_the_same(smoothness):
    surface = terrain(smoothness=smoothness)
    places = np.array([[0.5, 0.5], [3.0, 0.2], [-50.0, 1e4], [1.0 + 1e-3, 1.0]])
    agrees(surface, places, size=1e4)
    assert_allclose(preview(surface, places).points[0], surface.at(places[:1])[0], atol=NEAR)


@pytest.mark.parametrize("count", [8, 600])
def test_the_end_of_a_long_limb_is_near_whatever_else_is_asked_for(count):
    surface = limb(least=1e-11)
    for smoothness in (0.25, 1.0, 4.0):
        places = np.random.default_rng(1).choice(surface.vertex_places, count)
        agrees(surface.with_smoothness(smoothness), places)


def test_radii_as_different_as_in_the_map_of_a_thin_limb():
    steps = np.concatenate([[0.0], np.geomspace(1e-11, 1.0, 60)])
    corners = grid_corners(steps, steps)

    def shape(u, v):
        return np.log10(u + 1e-11), np.log10(v + 1e-11), np.sin(np.log10(u + v + 1e-11))

    for smoothness in (0.5, 2.0, 8.0):
        surface = spanned(PlaneDomain(), corners, shape, smoothness=smoothness)
        places = surface.vertex_places[::7]
        # Planes of cells as thin as these are so steep that the surface overshoots its mesh.
        agrees(surface, places, size=np.linalg.norm(np.ptp(surface.at(places), axis=0)))


def test_the_normal_of_a_cone_point_is_the_mean_of_those_around():
    angles = np.linspace(0.0, 2.0 * np.pi, 16, endpoint=False)
    ring = 1e-4 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    width = PILLOW.width
    cones = np.array([[0.0, 0.0], [0.0, 0.5], [width, 0.5], [width, 0.0], [0.0, -1.0]])
    for smoothness in (0.3, 0.7, 3.0):
        surface = pillow(smoothness=smoothness)
        _, by_u, by_v = surface.derivatives((cones[:, None] + ring).reshape(-1, 2))
        around = unit(np.cross(by_u, by_v).reshape(-1, len(ring), 3).sum(axis=1))
        assert_allclose(points_and_normals(surface, cones)[1], around, atol=1e-3)
        assert_allclose(preview(surface, cones).normals, around, atol=1e-3)


def test_the_same_places_are_put_in_order_once(monkeypatch):
    calls = []
    real = preview_sums.ordered
    monkeypatch.setattr(preview_sums, "ordered", lambda of: calls.append(of) or real(of))
    surface = height_field()
    for smoothness in (0.5, 2.0):
        preview(surface.with_smoothness(smoothness), surface.vertex_places)
    assert len(calls) == 1


def test_places_that_can_change_are_looked_at_again():
    surface = height_field()
    places = surface.vertex_places.copy()
    before = preview(surface, places).points
    places[:] = places[::-1].copy()
    assert_allclose(preview(surface, places).points, before[::-1], atol=1e-6)


def test_no_places_give_no_points():
    points, normals = preview(height_field(), np.zeros((0, 2)))
    assert points.shape == normals.shape == (0, 3)


def test_places_that_are_not_finite_are_refused():
    with pytest.raises(ValueError, match="places: has a value that is not finite"):
        preview(height_field(), np.array([[np.nan, 0.0]]))


def test_one_thread_gives_what_two_give(monkeypatch):
    surface = limb(smoothness=4.0)
    both = preview(surface, surface.vertex_places).points
    monkeypatch.setattr(preview_sums, "cpu_count", lambda: 1)
    assert_allclose(preview(surface, surface.vertex_places).points, both, atol=1e-6)


def test_without_compiled_loops_the_preview_is_the_surface(monkeypatch):
    for name in ("preview_kernels", "full_kernels"):
        monkeypatch.setitem(sys.modules, f"plusedit.geometry.mesh.{name}", None)
    surface = height_field()
    places = inner_places(surface)
    found = preview(surface, places)
    monkeypatch.undo()
    assert_allclose(found.points, surface.at(places), atol=1e-6)
    assert_allclose(found.normals, points_and_normals(surface, places)[1], atol=1e-6)


def test_a_single_cell_between_seams_is_near():
    corners = grid_corners(np.linspace(0.0, 1.0, 4), np.array([0.0, 1.0]))
    surface = spanned(
        CylinderDomain(), corners, lambda u, v: (np.cos(6.28 * u), np.sin(6.28 * u), v)
    )
    for smoothness in (0.25, 2.0, 16.0, 1e3):
        agrees(surface.with_smoothness(smoothness), inner_places(surface))


@pytest.mark.parametrize("share", [0.0, 0.2, 0.5, 0.9])
def test_the_weights_are_exact_for_polynomials_of_the_fifth_degree(share):
    nodes = np.arange(TAPS) - 3.0
    for degree in range(6):
        assert_allclose(weights(share, 0.5) @ nodes**degree, share**degree, atol=1e-9)


def test_the_weights_as_polynomials_are_the_weights():
    rows = weight_polynomials(0.5).reshape(-1, TAPS)
    for share in (0.0, 0.1, 0.5, 1.0):
        assert_allclose(np.polyval(rows, share), weights(share, 0.5), atol=2e-7)


def test_at_a_node_its_own_value_is_taken():
    assert_array_equal(np.round(weights(0.0, 0.5), 9), np.eye(TAPS)[3])
