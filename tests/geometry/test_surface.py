"""Surfaces against their definition, and the facts that follow from it."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface, tangent_terms, terms
from tests.geometry.curves import KINDS
from tests.geometry.definition import surface_definition
from tests.geometry.surfaces import CORNERS_MET, PAIRS, random_surface, surfaces

every_pair = pytest.mark.parametrize("pair", PAIRS)
U, V = np.linspace(0.0, 1.0, 13), np.linspace(0.0, 1.0, 11)
PLACES = [(0.0, 1.0), (0.25, 0.5), (0.6180339887, 0.75), (0.97, 0.09), (0.5, 0.2)]
POLYNOMIAL = tuple(p for p in PAIRS if not any("rag" in k or k == "staircase" for k in p))


def rate(basis):
    """How fast narrow Gaussians hand over from one to the next; 1 for the others."""
    is_gaussian = isinstance(basis, RationalGaussian)
    return 1.0 / basis.size / np.min(basis.sigma) ** 2 if is_gaussian else 1.0


def agrees(surface, places):
    """Whether the surface and its derivatives are what the definition says, to 1e-12."""
    places = [[x % 1.0 if c else x for x, c in zip(p, surface.closed, strict=True)] for p in places]
    exact = np.array([surface_definition(surface, u, v) for u, v in places], dtype=np.float64)
    reach = np.abs(surface.planes.points).max() + np.abs(surface.gradients).max() / 2.0
    fast = max(1.0, *map(rate, surface.bases))
    for i, found in enumerate(surface.derivatives_at(places)):
        order = (0, 1, 1, 2, 2, 2)[i]
        size = max(np.abs(exact[:, i]).max(), reach * fast**order)
        assert_allclose(found, exact[:, i], rtol=0, atol=1e-12 * size)


@pytest.mark.parametrize("contrast", [None, 30.0])
@pytest.mark.parametrize("shape", [(2, 2), (3, 2), (8, 7)])
@every_pair
def test_a_surface_is_what_its_definition_says(pair, shape, contrast):
    agrees(random_surface(*pair, shape=shape, contrast=contrast), PLACES)


@pytest.mark.parametrize("orders", [(2, 5), (3, 4), (6, 2)])
def test_a_torus_may_have_fewer_planes_than_its_orders(orders):
    bases = (BSpline(2, orders[0], closed=True), BSpline(3, orders[1], closed=True))
    planes = random_surface(shape=(2, 3), contrast=5.0).planes
    agrees(PlusSurface(*bases, planes, 1.5), PLACES)


@every_pair
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_pairs_of_parameters_and_scattered_ones_give_the_same(pair, contrast):
    surface = random_surface(*pair, contrast=contrast)
    u, v = np.meshgrid(U, V, indexing="ij")
    scattered = surface.derivatives_at(np.stack([u, v], axis=-1).reshape(-1, 2))
    for here, there in zip(surface.derivatives(U, V), scattered, strict=True):
        assert_allclose(here.reshape(-1, 3), there, atol=1e-12 * (1.0 + np.abs(there).max()))


@every_pair
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_grids_give_the_same_as_their_parameters(pair, contrast):
    surface = random_surface(*pair, contrast=contrast)
    grids = Grid(U), Grid(V)
    assert_allclose(surface.sample(*grids), surface.at(U, V), atol=1e-12)
    found = tangent_terms(*surface.bases, surface.planes, *grids)
    sums = [
        base + surface.s * plus
        for base, plus in (
            (found.base, found.plus),
            (found.base_u, found.plus_u),
            (found.base_v, found.plus_v),
        )
    ]
    for here, there in zip(sums, surface.derivatives(U, V, highest=1), strict=True):
        assert_allclose(here, there, atol=1e-12 * (1.0 + np.abs(there).max()))


def test_many_scattered_places_are_taken_in_parts_with_the_same_result(monkeypatch):
    for pair in (("bspline", "closed"), ("bezier", "bspline"), ("closed", "rag")):
        surface = random_surface(*pair, contrast=3.0)
        places = np.random.default_rng(0).random((40, 2))
        whole = surface.derivatives_at(places)
        monkeypatch.setattr("plusedit.geometry.surface_jets.BLOCK", 3000)
        for here, there in zip(surface.derivatives_at(places), whole, strict=True):
            assert_allclose(here, there, rtol=1e-13, atol=1e-12)
        monkeypatch.undo()


@given(surfaces(kinds=[k for k in KINDS if k not in ("polygon", "kinks", "staircase")]))
@settings(max_examples=30, deadline=None)
def test_derivatives_are_the_limits_of_differences(surface):
    h = 1e-5
    u, v = 0.3217, 0.6113  # not a knot
    at = surface.derivatives_at([(u, v)])
    east, west, north, south = (
        surface.derivatives_at([place], highest=1)
        for place in ((u + h, v), (u - h, v), (u, v + h), (u, v - h))
    )
    size = 1.0 + max(np.abs(each).max() for each in at)
    pairs = [
        (at[1], east[0] - west[0]),
        (at[2], north[0] - south[0]),
        (at[3], east[1] - west[1]),
        (at[4], north[1] - south[1]),
        (at[4], east[2] - west[2]),
        (at[5], north[2] - south[2]),
    ]
    for exact, difference in pairs:
        assert_allclose(exact, difference / (2.0 * h), atol=1e-5 * size)


@given(surfaces())
@settings(max_examples=30, deadline=None)
def test_s_zero_is_the_classical_surface_and_the_surface_is_affine_in_s(surface):
    zero, one, other = (replace(surface, s=s).at(U, V) for s in (0.0, 1.0, -2.5))
    assert_array_equal(surface.classical.at(U, V), zero)
    assert_allclose(other, zero - 2.5 * (one - zero), atol=1e-11)


@given(surfaces(), st.integers(0, 99))
@settings(max_examples=30, deadline=None)
def test_an_affine_map_of_the_planes_maps_the_surface(surface, seed):
    random = np.random.default_rng(seed)
    matrix, offset = random.normal(size=(3, 3)), random.normal(size=3)
    points = surface.planes.points @ matrix.T + offset
    planes = surface.planes.with_points(points).with_directions(surface.directions @ matrix.T)
    mapped = replace(surface, planes=planes)
    assert_allclose(mapped.at(U, V), surface.at(U, V) @ matrix.T + offset, atol=1e-11)


@pytest.mark.parametrize("pair", [p for p in PAIRS if not any("closed" in kind for kind in p)])
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_planes_of_one_flat_motion_draw_it(pair, contrast):
    surface = random_surface(*pair, contrast=contrast)
    start, along_u, along_v = np.array([[3.0, -1.0, 2.0], [0.5, 4.0, 1.0], [-2.0, 0.25, 3.0]])

    def motion(u, v):
        return start + u[:, None, None] * along_u + v[:, None] * along_v

    x, y = (basis.nodes for basis in surface.bases)
    shape = (len(x), len(y), 3)
    ways = [np.broadcast_to(way, shape).tolist() for way in (along_u, along_v)]
    planes = ControlPlanes.of(motion(x, y), *ways, surface.planes.weights)
    drawn = replace(surface, planes=planes, s=1.0).at(U, V)
    assert_allclose(drawn, motion(U, V), atol=1e-12)


@every_pair
def test_planes_within_one_plane_draw_within_it(pair):
    surface = random_surface(*pair, contrast=3.0)
    flat = np.array([1.0, 1.0, 0.0])
    planes = surface.planes.with_points(surface.planes.points * flat)
    planes = planes.with_directions(surface.directions * flat)
    assert_array_equal(replace(surface, planes=planes).at(U, V)[..., 2], 0.0)


@pytest.mark.parametrize("pair", POLYNOMIAL)
def test_one_vector_added_to_all_gradients_of_a_way_changes_nothing(pair):
    surface = random_surface(*pair)
    push = np.array([[7.0, -11.0, 2.0], [3.0, 0.5, -6.0]])[:, None, None]
    pushed = replace(surface, planes=surface.planes.with_directions(surface.directions + push))
    assert_allclose(pushed.at(U, V), surface.at(U, V), atol=1e-11)


@pytest.mark.parametrize("kind_u", CORNERS_MET)
@pytest.mark.parametrize("kind_v", CORNERS_MET)
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_a_sheet_meets_its_corner_points(kind_u, kind_v, contrast):
    surface = random_surface(kind_u, kind_v, contrast=contrast)
    corners = surface.planes.points[np.ix_([0, -1], [0, -1])]
    assert_allclose(surface.at([0.0, 1.0], [0.0, 1.0]), corners, rtol=1e-14)


@pytest.mark.parametrize("basis", [Bernstein(5), BSpline(6, 3)])
def test_the_tangents_at_a_corner_are_those_of_the_books(basis):
    surface = random_surface("bspline", "bezier", shape=(basis.size, 4))
    surface = replace(surface, basis_u=basis)
    points, (along_u, along_v) = surface.planes.points, surface.gradients
    _, by_u, by_v = (each[0] for each in surface.derivatives_at([(0.0, 0.0)], highest=1))
    step_u, step_v = basis.nodes[1], surface.basis_v.nodes[1]
    expected_u = (points[1, 0] - points[0, 0]) / step_u + along_u[0, 0] - along_u[1, 0]
    expected_v = (points[0, 1] - points[0, 0]) / step_v + along_v[0, 0] - along_v[0, 1]
    assert_allclose(by_u, expected_u, atol=1e-12)
    assert_allclose(by_v, expected_v, atol=1e-12)


@pytest.mark.parametrize("contrast", [None, 30.0])
@pytest.mark.parametrize("pair", [p for p in PAIRS if any("closed" in kind for kind in p)])
def test_a_closed_direction_comes_again_with_every_turn(pair, contrast):
    surface = random_surface(*pair, contrast=contrast)
    u, v = np.linspace(0.0137, 0.9791, 11), np.linspace(0.0119, 0.9883, 9)  # between the knots
    for turns in (-2.0, 1.0, 3.0):
        shifted = (u + turns * surface.closed[0], v + turns * surface.closed[1])
        pairs = zip(surface.derivatives(u, v), surface.derivatives(*shifted), strict=True)
        for here, there in pairs:
            assert_allclose(there, here, atol=1e-9 * (1.0 + np.abs(here).max()))


@pytest.mark.parametrize("pair", [("closed", "closed rag"), ("closed, odd order", "closed")])
def test_a_torus_is_as_smooth_at_its_seams_as_elsewhere(pair):
    surface = random_surface(*pair, contrast=3.0)
    h = 1e-9
    before = surface.derivatives([1.0 - h, 0.4], [0.7, 1.0 - h])
    after = surface.derivatives([h, 0.4], [0.7, h])
    for order, here, there in zip((0, 1, 1), before, after, strict=False):
        size = 1.0 + max(np.abs(each).max() for each in surface.derivatives(U, V)[order + 1 :])
        assert_allclose(here, there, atol=10.0 * h * size)


@pytest.mark.parametrize("pair", [p for p in PAIRS if "closed" not in p[0]])
def test_an_open_direction_ends_at_its_ends(pair):
    surface = random_surface(*pair)
    outside, ends = (surface.derivatives(u, V) for u in ([-1.0, 2.0], [0.0, 1.0]))
    for here, there in zip(outside, ends, strict=True):
        assert_array_equal(here, there)


@every_pair
def test_the_borders_of_a_ruled_net_are_curves_of_its_rows(pair):
    surface = random_surface(pair[0], "bezier", shape=(6, 2), s=1.7)
    for j, v in ((0, 0.0), (1, 1.0)):
        lines = ControlLines.of(
            surface.planes.points[:, j], list(surface.directions[0, :, j]), None
        )
        border = PlusCurve(surface.basis_u, lines, surface.s)
        assert_allclose(surface.at(U, [v])[:, 0], border.at(U), atol=1e-13)


@every_pair
@pytest.mark.parametrize("factor", [1e-90, 1e-3, 1e90])
def test_only_the_ratios_of_weights_count(pair, factor):
    surface = random_surface(*pair, contrast=30.0)
    scaled = replace(surface, planes=surface.planes.with_weights(factor * surface.planes.weights))
    assert_allclose(scaled.at(U, V), surface.at(U, V), atol=1e-11)


@every_pair
def test_weights_whose_ratio_is_no_double_leave_a_surface(pair):
    weights = 10.0 ** np.random.default_rng(0).integers(-300, 100, (6, 5)).astype(float)
    surface = random_surface(*pair)
    unequal = replace(surface, planes=surface.planes.with_weights(weights))
    assert all(np.isfinite(each).all() for each in unequal.derivatives(U, V, highest=1))
    assert np.isfinite(unequal.sample(Grid(U), Grid(V))).all()


@every_pair
@pytest.mark.parametrize("scale", [1e-100, 1e100])
def test_the_size_does_not_matter(pair, scale):
    surface = random_surface(*pair, s=0.5)
    largest = max(np.abs(surface.planes.points).max(), 1.0)
    planes = surface.planes.with_points(surface.planes.points / largest * scale)
    large = replace(surface, planes=planes.with_directions(surface.directions), s=0.5 * scale)
    small = replace(
        surface,
        planes=surface.planes.with_points(surface.planes.points / largest).with_directions(
            surface.directions
        ),
    )
    for here, there in zip(large.derivatives(U, V), small.derivatives(U, V), strict=True):
        assert_allclose(here / scale, there, atol=1e-11 * (1.0 + np.abs(there).max()))


@given(surfaces(least=2, most=2))
@settings(max_examples=20, deadline=None)
def test_two_by_two_planes_and_directions_that_are_zero_make_a_surface(surface):
    still = replace(surface, planes=surface.planes.with_directions(np.zeros((2, 2, 2, 3))))
    for each in (surface, still, replace(surface, s=0.0)):
        assert all(np.isfinite(found).all() for found in each.derivatives(U, V))


@given(st.floats(1e-12, 1e12), st.floats(-1e6, 1e6))
@settings(max_examples=30, deadline=None)
def test_the_unit_and_the_origin_of_the_points_do_not_matter(unit, origin):
    surface = random_surface(s=1.5)
    planes = surface.planes.with_points(unit * surface.planes.points + origin)
    moved = replace(surface, planes=planes.with_directions(surface.directions), s=1.5 * unit)
    expected = unit * surface.at(U, V) + origin
    assert_allclose(moved.at(U, V), expected, rtol=0, atol=1e-14 * (5.0 * unit + abs(origin)))


def test_a_net_of_another_size_is_refused():
    with pytest.raises(ValueError, match="points: 6 x 5 control planes for bases of 6 x 4"):
        PlusSurface(Bernstein(6), Bernstein(4), random_surface().planes)


@pytest.mark.parametrize("s", [np.nan, np.inf, -1e101])
def test_an_s_that_is_no_number_or_too_large_is_refused(s):
    with pytest.raises(ValueError, match="s: must be a finite number"):
        random_surface(s=s)


@pytest.mark.parametrize("u", [np.nan, [[0.0]], np.inf])
def test_parameters_that_are_no_row_of_numbers_are_refused(u):
    with pytest.raises(ValueError, match="u: "):
        random_surface().at(u, [0.5])


def test_no_places_have_no_points():
    for pair in PAIRS:
        surface = random_surface(*pair)
        assert surface.at([], [0.5]).shape == (0, 1, 3)
        assert surface.derivatives_at(np.zeros((0, 2)))[5].shape == (0, 3)


def test_changing_s_computes_no_product_again():
    surface, grids = random_surface("bspline", "closed"), (Grid(U), Grid(V))
    stronger = replace(surface, s=5.0)
    first = terms(*surface.bases, surface.planes, *grids)
    assert terms(*stronger.bases, stronger.planes, *grids) is first
