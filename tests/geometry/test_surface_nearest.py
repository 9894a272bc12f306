"""Nearest places and hits of rays against dense samples and closed forms."""

import gc
from dataclasses import replace
from weakref import ref

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.geometry.making.primitives import exact_sphere, sheet, torus, tube
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_cells import cells_of
from plusedit.geometry.surface_cells import from_triangles as from_cells
from plusedit.geometry.surface_nearest import (
    hit_by_ray,
    nearest_on_surface,
    nearest_places,
    nearest_to_ray,
)
from plusedit.geometry.surface_transforms import transposed
from tests.geometry.surfaces import PAIRS, a_surface, random_surface, surfaces
from tests.geometry.triangles import from_triangles

every_pair = pytest.mark.parametrize("pair", PAIRS, ids="/".join)

UP = np.array([0.0, 0.0, 1.0])


def at(surface, place):
    return surface.at(place[0], place[1])[0, 0]


def samples(surface, count=301):
    """(count^2, 3) points of the surface, the corners of the domain among them."""
    u = np.linspace(0.0, 1.0, count)
    return surface.at(u, u).reshape(-1, 3)


def away_from_ray(points, origin, heading):
    """(m,) distances of points from a ray along a unit vector."""
    ahead = np.maximum((points - origin) @ heading, 0.0)
    return np.linalg.norm(points - origin - ahead[:, None] * heading, axis=1)


def rays(count, seed=0):
    """Origins about the unit cube, and unit vectors roughly toward it."""
    random = np.random.default_rng(seed)
    origins = 3.0 * random.normal(size=(count, 3))
    ways = random.uniform(-1.0, 1.0, (count, 3)) - origins
    return list(zip(origins, ways / np.linalg.norm(ways, axis=1)[:, None], strict=True))


def flat(points, s=0.0):
    """A surface in a plane, or in less, of 3 x 3 given points."""
    basis = a_surface(3, 3).basis_u
    return PlusSurface(basis, basis, ControlPlanes.of(np.array(points, dtype=float)), s)


# The nearest point


@every_pair
@pytest.mark.parametrize("contrast", [None, 10.0])
def test_no_sample_is_nearer_than_the_nearest_point(pair, contrast):
    surface = random_surface(*pair, contrast=contrast)
    points = samples(surface)
    random = np.random.default_rng(1)
    near = points[random.integers(0, len(points), 5)] + 0.05 * random.normal(size=(5, 3))
    for point in [*near, *random.uniform(-3.0, 3.0, (5, 3))]:
        found = np.linalg.norm(at(surface, nearest_on_surface(surface, point)) - point)
        assert found <= np.linalg.norm(points - point, axis=1).min() + 1e-12


@given(surfaces(least=4), st.integers(0, 10**6))
def test_of_many_points_none_has_a_sample_nearer_than_its_place(surface, seed):
    random = np.random.default_rng(seed)
    points = 10.0 ** random.uniform(-1.0, 1.5, (30, 1)) * random.normal(size=(30, 3))
    found = surface.derivatives_at(nearest_places(surface, points), highest=0)[0]
    distances = np.linalg.norm(found - points, axis=1)
    everywhere = samples(surface, 101)
    least = [np.linalg.norm(everywhere - point, axis=1).min() for point in points]
    assert (distances <= np.array(least) * (1.0 + 1e-9) + 1e-12).all()


@given(surfaces(least=4), st.integers(0, 10**6))
def test_many_points_are_as_near_as_each_alone(surface, seed):
    points = np.random.default_rng(seed).normal(0.0, 2.0, (5, 3))
    together = surface.derivatives_at(nearest_places(surface, points), highest=0)[0]
    for point, found in zip(points, together, strict=True):
        alone = np.linalg.norm(at(surface, nearest_on_surface(surface, point)) - point)
        assert_allclose(np.linalg.norm(found - point), alone, rtol=1e-9)


@pytest.mark.parametrize("seed", range(8))
def test_where_a_surface_turns_back_on_itself_nothing_is_missed(seed):
    surface = random_surface("bezier", "closed", shape=(2, 2), s=0.0, seed=seed)
    points = np.random.default_rng(seed).normal(0.0, 0.5, (50, 3))
    found = surface.derivatives_at(nearest_places(surface, points), highest=0)[0]
    everywhere = samples(surface, 101)
    least = [np.linalg.norm(everywhere - point, axis=1).min() for point in points]
    assert (np.linalg.norm(found - points, axis=1) <= np.array(least) * (1.0 + 1e-9)).all()


def test_no_points_have_no_places():
    assert nearest_places(a_surface(), np.zeros((0, 3))).shape == (0, 2)


@every_pair
def test_a_point_of_the_surface_is_its_own_nearest(pair):
    surface = random_surface(*pair, seed=2)
    for place in [(0.0, 0.0), (0.213, 0.71), (0.5, 0.0), (1.0, 0.33), (1.0, 1.0)]:
        point = at(surface, place)
        assert_allclose(at(surface, nearest_on_surface(surface, point)), point, atol=1e-7)


def test_inside_the_way_to_the_nearest_point_is_along_the_normal():
    surface = a_surface(7, 6)
    for place in [(0.2, 0.3), (0.61, 0.42), (0.5, 0.77)]:
        point, du, dv = (each[0] for each in surface.derivatives_at([place], highest=1))
        normal = np.cross(du, dv)
        found = nearest_on_surface(surface, point + 0.05 * normal / np.linalg.norm(normal))
        assert_allclose(found, place, atol=1e-9)


def test_beyond_a_border_it_lies_on_the_border():
    surface = sheet(size=(2.0, 2.0))
    assert nearest_on_surface(surface, (5.0, 0.0, 1.0)) == (1.0, pytest.approx(0.5))
    assert nearest_on_surface(surface, (0.0, -5.0, 1.0)) == (pytest.approx(0.5), 0.0)
    assert nearest_on_surface(surface, (5.0, 7.0, 0.0)) == (1.0, 1.0)
    assert nearest_on_surface(surface, (-5.0, 7.0, 0.0)) == (0.0, 1.0)


def test_from_outside_a_sphere_it_lies_toward_the_center():
    surface = exact_sphere(2.0, center=(1.0, 2.0, 3.0))
    for _, way in rays(10):
        for reach in (0.3, 1.9, 5.0, 1e4):
            point = at(
                surface, nearest_on_surface(surface, np.array([1.0, 2.0, 3.0]) + reach * way)
            )
            assert_allclose(point, np.array([1.0, 2.0, 3.0]) + 2.0 * way, atol=1e-7)


def test_the_center_of_a_sphere_has_some_nearest_point():
    point = at(exact_sphere(), nearest_on_surface(exact_sphere(), np.zeros(3)))
    assert_allclose(np.linalg.norm(point), 1.0)


def test_where_a_surface_closes_the_seam_is_at_zero():
    surface = tube()
    u, v = nearest_on_surface(surface, 1.5 * at(surface, (0.0, 0.3)))
    assert min(u, 1.0 - u) < 1e-9
    assert u < 1.0
    assert 0.0 < v < 1.0


@pytest.mark.parametrize("factor", [1e-9, 1e-3, 1e6])
def test_size_and_place_do_not_matter(factor):
    surface, point = a_surface(6, 5), np.array([1.7, 2.1, 1.4])
    planes = surface.planes.with_points(factor * (surface.planes.points + 10.0))
    other = replace(surface, planes=planes, s=factor * surface.s)
    wanted = nearest_on_surface(surface, point)
    assert_allclose(nearest_on_surface(other, factor * (point + 10.0)), wanted, atol=1e-6)


@pytest.mark.parametrize(
    "points",
    [
        np.full((3, 3, 3), 1.0),
        [[[x, 0, 0]] * 3 for x in range(3)],
        [[[x, y * x, 0] for y in range(3)] for x in range(3)],
    ],
    ids=["a point", "a line", "a triangle"],
)
def test_degenerate_surfaces_have_a_nearest_point(points):
    surface = flat(points)
    dense = samples(surface, 51)
    for point in np.random.default_rng(0).uniform(-3.0, 3.0, (10, 3)):
        found = np.linalg.norm(at(surface, nearest_on_surface(surface, point)) - point)
        assert found <= np.linalg.norm(dense - point, axis=1).min() + 1e-9


def test_a_point_that_is_not_finite_is_refused():
    with pytest.raises(ValueError, match="point"):
        nearest_on_surface(a_surface(), (0.0, np.nan, 0.0))


# Hits


@every_pair
def test_a_hit_lies_on_the_ray_and_on_the_surface(pair):
    surface = random_surface(*pair, seed=4)
    hits = 0
    for origin, way in rays(25):
        hit = hit_by_ray(surface, origin, 2.5 * way)
        if hit is not None:
            hits += 1
            assert_allclose(hit.point, origin + hit.distance * way, atol=1e-12)
            assert_allclose(at(surface, (hit.u, hit.v)), hit.point, atol=1e-2)
    assert hits > 5


def test_hits_are_exact_inside():
    surface = a_surface(20, 20)
    for place in np.random.default_rng(0).uniform(0.01, 0.99, (30, 2)):
        point = at(surface, place)
        hit = hit_by_ray(surface, point + 7.0 * UP, -UP)
        assert_allclose((hit.u, hit.v), place, atol=1e-12)
        assert_allclose(hit.point, point, atol=1e-12)
        assert hit.distance == pytest.approx(7.0, abs=1e-12)


def test_of_several_layers_the_first_in_front_is_hit():
    body = exact_sphere()
    way = np.array([0.6, 0.0, 0.8])
    beside = np.array([0.1, 0.2, 0.3])
    for start, sign in [(-5.0, -1.0), (0.0, 1.0)]:
        hit = hit_by_ray(body, start * way + beside, way)
        across = beside - (beside @ way) * way
        along = sign * np.sqrt(1.0 - across @ across)
        assert_allclose(hit.point, across + along * way, atol=1e-12)
    assert hit_by_ray(body, 5.0 * way + beside, way) is None


def test_a_ray_goes_through_the_hole_of_a_torus():
    ring = torus(radius=1.0, thickness=0.3)
    assert hit_by_ray(ring, (0.1, 0.0, 5.0), -UP) is None
    assert hit_by_ray(ring, (1.0, 0.0, 5.0), -UP).point[2] == pytest.approx(0.3, abs=2e-2)


def test_a_ray_that_starts_on_the_surface_hits_there_or_further_on():
    body = exact_sphere()
    assert hit_by_ray(body, (0.0, 0.0, -1.0 + 1e-9), UP).point[2] == pytest.approx(1.0)


@pytest.mark.parametrize("distance", [1e2, 1e5, 1e8])
def test_from_far_away_the_same_is_hit(distance):
    surface = a_surface(8, 8)
    point = at(surface, (0.37, 0.61))
    way = np.array([0.2, 0.1, -0.97]) / np.linalg.norm([0.2, 0.1, -0.97])
    hit = hit_by_ray(surface, point - distance * way, way)
    assert_allclose(hit.point, point, atol=1e-14 * distance + 1e-9)


def test_no_ray_slips_through_between_triangles():
    surface = a_surface(10, 10)
    cells = cells_of(surface)
    for row in range(0, len(cells.low), 7):
        inner = cells.corners[row, 2]
        if cells.high[row].max() < 1.0:
            assert hit_by_ray(surface, inner + 5.0 * UP, -UP) is not None


def test_beside_the_surface_nothing_is_hit():
    surface = a_surface()
    low = surface.planes.points.reshape(-1, 3).min(axis=0)
    assert hit_by_ray(surface, low - (1.0, 1.0, 5.0), UP) is None
    assert hit_by_ray(surface, (1.5, 2.0, 9.0), UP) is None


def test_a_line_or_a_point_is_never_hit():
    assert hit_by_ray(flat(np.ones((3, 3, 3))), (1.0, 1.0, 5.0), -UP) is None
    assert hit_by_ray(flat([[[x, 0, 0]] * 3 for x in range(3)]), (1.0, 0.0, 5.0), -UP) is None


def test_exchanging_the_parameters_exchanges_those_of_the_hit():
    surface = random_surface(seed=4)
    for origin, way in rays(10):
        hit, other = (hit_by_ray(each, origin, way) for each in (surface, transposed(surface)))
        assert (hit is None) == (other is None)
        if hit is not None:
            assert_allclose((hit.u, hit.v), (other.v, other.u), atol=1e-9)


@pytest.mark.parametrize("search", [hit_by_ray, nearest_to_ray])
def test_a_ray_without_a_direction_is_refused(search):
    with pytest.raises(ValueError, match="direction"):
        search(a_surface(), np.zeros(3), np.zeros(3))
    with pytest.raises(ValueError, match="origin"):
        search(a_surface(), (np.inf, 0.0, 0.0), UP)


# The nearest point to a ray


@every_pair
def test_no_sample_is_nearer_to_a_ray(pair):
    surface = random_surface(*pair, seed=7)
    points = samples(surface)
    random = np.random.default_rng(3)
    for origin, way in [*rays(4), *rays(4, seed=5)]:
        # Some run away from the surface: then the origin counts.
        aside = way + random.normal(size=3)
        aside /= np.linalg.norm(aside)
        found = at(surface, nearest_to_ray(surface, origin, aside))
        nearest = away_from_ray(points, origin, aside).min()
        assert away_from_ray(found[None], origin, aside)[0] <= nearest + 1e-9


def test_where_a_ray_meets_the_surface_it_is_the_hit():
    surface = a_surface(6, 6)
    hit = hit_by_ray(surface, (1.4, 1.7, 9.0), -UP)
    assert nearest_to_ray(surface, (1.4, 1.7, 9.0), -UP) == (hit.u, hit.v)


# Cells


def test_distances_from_cells_are_those_from_their_triangles():
    corners = np.random.default_rng(0).normal(size=(50, 4, 3))
    for point in np.random.default_rng(1).normal(size=(20, 3)):
        points = np.broadcast_to(point, (50, 3))
        halves = [
            from_triangles(points, *(corners[:, i] for i in h)) for h in ((0, 1, 2), (0, 2, 3))
        ]
        assert_allclose(from_cells(point, corners), np.minimum(*halves), atol=1e-12)


@every_pair
def test_the_balls_of_the_cells_hold_the_surface(pair):
    surface = random_surface(*pair)
    cells = cells_of(surface)
    shares = np.random.default_rng(0).random(cells.low.shape)
    points = surface.derivatives_at(cells.low + shares * (cells.high - cells.low), highest=0)[0]
    assert (np.linalg.norm(points - cells.middles, axis=1) <= cells.radii).all()


def test_cells_live_as_long_as_their_surface():
    surface = a_surface()
    assert cells_of(surface) is cells_of(surface)
    kept = ref(cells_of(surface))
    del surface
    gc.collect()
    assert kept() is None
