"""Curves against their definition, and the facts that follow from it."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.blend import Grid, blend
from plusedit.geometry.curve import PlusCurve, terms
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.tessellate import tessellation
from tests.geometry.curves import KINDS, bases, random_curve
from tests.geometry.definition import definition

OPEN = tuple(kind for kind in KINDS if not kind.startswith("closed"))
CLOSED = tuple(kind for kind in KINDS if kind.startswith("closed"))
POLYNOMIAL = tuple(k for k in KINDS if "rag" not in k and k != "staircase")
ENDS_MET = ("bezier", "bspline", "polygon", "high order", "kinks")
every_kind = pytest.mark.parametrize("kind", KINDS)
U = np.linspace(0.0, 1.0, 101)


def rate(basis):
    """How fast narrow Gaussians hand over from one to the next; 1 for the others."""
    is_gaussian = isinstance(basis, RationalGaussian)
    return 1.0 / basis.size / np.min(basis.sigma) ** 2 if is_gaussian else 1.0


def agrees(curve, u):
    """Whether the curve and both derivatives are what the definition says, to 1e-12."""
    exact = np.array([definition(curve, x) for x in u], dtype=np.float64)
    reach = np.abs(curve.lines.points).max() + np.abs(curve.gradients).max() * curve.spacing
    for r, found in enumerate(curve.derivatives(u)):
        size = max(np.abs(exact[:, r]).max(), reach * rate(curve.basis) ** r)
        assert_allclose(found, exact[:, r], rtol=0, atol=1e-12 * size)


@pytest.mark.parametrize("contrast", [None, 30.0])
@pytest.mark.parametrize(("size", "kind"), [(n, kind) for n in (2, 3, 8) for kind in bases(n)])
def test_a_curve_is_what_its_definition_says(kind, size, contrast):
    curve = random_curve(kind, size=size, contrast=contrast, dimension=2 + (size == 3))
    agrees(curve, [0.0, 0.09, 0.25, 0.5, 0.6180339887, 0.75, 0.97, 1.0][curve.closed :])


@every_kind
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_a_curve_of_two_hundred_lines_is_what_its_definition_says(kind, contrast):
    curve = random_curve(kind, size=200, contrast=contrast, dimension=3)
    agrees(curve, [0.0, 0.3333, 0.91238])


@pytest.mark.parametrize("order", [2, 3, 4, 6])
def test_a_closed_curve_may_have_fewer_lines_than_its_order(order):
    lines = ControlLines.of([[0.0, 1.0], [2.0, 0.0]], [[1.0, 3.0], None])
    agrees(PlusCurve(BSpline(2, order, closed=True), lines, 1.5), [0.0, 0.123, 0.5, 0.77])


@every_kind
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_a_grid_gives_the_same_points_as_its_parameters(kind, contrast):
    for size in (8, 300):
        curve = random_curve(kind, size=size, contrast=contrast)
        assert_allclose(curve.sample(Grid(U)), curve.at(U), atol=1e-13)
        assert_allclose(
            curve.sample(Grid.uniform(500)), curve.at(np.linspace(0, 1, 500)), atol=1e-13
        )


@pytest.mark.parametrize("kind", ["bspline", "closed", "rag"])
def test_many_parameters_are_taken_in_pieces_with_the_same_result(kind, monkeypatch):
    curve = random_curve(kind)
    whole = curve.derivatives(U)
    monkeypatch.setattr("plusedit.geometry.curve.BLOCK", 64)
    for expected, found in zip(whole, curve.derivatives(U), strict=True):
        assert_array_equal(found, expected)


@pytest.mark.parametrize("kind", OPEN)
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_lines_of_one_straight_motion_draw_it(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    start, way = np.array([3.0, -1.0]), np.array([0.5, 4.0])
    points = start + curve.basis.nodes[:, None] * way
    lines = ControlLines.of(points, [way] * 8, curve.lines.weights)
    drawn = replace(curve, lines=lines, s=1.0).at(U)
    assert_allclose(drawn, start + U[:, None] * way, atol=1e-13)


@every_kind
def test_lines_within_one_straight_line_draw_within_it(kind):
    curve = random_curve(kind, contrast=3.0)
    way = np.array([2.0, -1.0])
    random = np.random.default_rng(2)
    points, directions = (random.normal(size=(8, 1)) * way for _ in range(2))
    lines = ControlLines.of(points, list(directions), curve.lines.weights)
    assert_allclose(replace(curve, lines=lines).at(U) @ [1.0, 2.0], 0.0, atol=1e-12)


@pytest.mark.parametrize("kind", ENDS_MET)
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_bezier_and_clamped_b_spline_curves_meet_their_first_and_last_point(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    assert_allclose(curve.at([0.0, 1.0]), curve.lines.points[[0, -1]], rtol=1e-15)


@pytest.mark.parametrize("kind", POLYNOMIAL)
def test_one_vector_added_to_all_gradients_changes_nothing(kind):
    curve = random_curve(kind)
    directions = curve.directions + np.array([7.0, -11.0])
    shifted = replace(curve, lines=curve.lines.with_directions(directions))
    assert_allclose(shifted.at(U), curve.at(U), atol=1e-12)


@pytest.mark.parametrize("kind", CLOSED)
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_a_closed_curve_comes_again_with_every_turn(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    for turns in (-2.0, 1.0, 3.0):
        for here, there in zip(curve.derivatives(U), curve.derivatives(U + turns), strict=True):
            assert_allclose(there, here, atol=1e-10 * (1.0 + np.abs(here).max()))


@pytest.mark.parametrize("kind", OPEN)
def test_an_open_curve_stays_at_its_ends_outside_the_domain(kind):
    curve = random_curve(kind)
    assert_array_equal(curve.at([-1.0, 2.0]), curve.at([0.0, 1.0]))


@pytest.mark.parametrize("order", [3, 4])
@pytest.mark.parametrize("size", [3, 5, 8, 50])
def test_a_closed_regular_polygon_is_met_in_every_corner(size, order):
    angle = 2.0 * np.pi * np.arange(size) / size
    corners = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    length = 2.0 * size * np.sin(np.pi / size)
    s = length / (2.0 * np.cos(np.pi / size))
    curve = PlusCurve(BSpline(size, order, closed=True), ControlLines.of(corners), s)
    assert_allclose(curve.at(curve.basis.nodes), corners, atol=1e-13)


@pytest.mark.parametrize("basis", [Bernstein(5), BSpline(9, 3), BSpline(9, 4), BSpline(7, 7)])
def test_points_on_a_parabola_with_half_its_velocity_draw_it(basis):
    def parabola(u):
        return np.stack([3.0 * u - 1.0, 2.0 * u**2 - u + 5.0], axis=-1)

    nodes = basis.nodes
    velocity = np.stack([np.full_like(nodes, 3.0), 4.0 * nodes - 1.0], axis=1)
    curve = PlusCurve(basis, ControlLines.of(parabola(nodes), list(velocity / 2.0)), 1.0)
    assert_allclose(curve.at(U), parabola(U), atol=1e-14)


@every_kind
def test_s_zero_is_the_classical_curve(kind):
    curve = random_curve(kind, s=3.0)
    values = blend(curve.basis, Grid(U)).values
    assert_allclose(curve.classical.at(U), values @ curve.lines.points, atol=1e-14)


@every_kind
@pytest.mark.parametrize("contrast", [None, 30.0])
def test_the_curve_is_affine_in_s(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    zero, one, two = (replace(curve, s=s).sample(Grid(U)) for s in (0.0, 1.0, -2.5))
    assert_allclose(two, zero - 2.5 * (one - zero), atol=1e-12)


def test_at_its_node_a_gradient_moves_no_point_but_changes_the_velocity():
    curve = random_curve("bspline", size=12)
    node, by = curve.basis.nodes[5], np.array([4.0, 1.0])
    turned = replace(curve, lines=curve.lines.with_direction(5, curve.directions[5] + by))
    share = curve.basis.values(np.array([node]))[0, 5]
    (at, velocity, _), (at_turned, velocity_turned, _) = (
        c.derivatives([node]) for c in (curve, turned)
    )
    assert_allclose(at_turned, at, atol=1e-14)
    assert_allclose(velocity_turned - velocity, [share * curve.s * by], atol=1e-12)


@every_kind
@pytest.mark.parametrize("factor", [1e-90, 1e-3, 1e90])
def test_only_the_ratios_of_weights_count(kind, factor):
    curve = random_curve(kind, contrast=30.0)
    scaled = replace(curve, lines=curve.lines.with_weights(factor * curve.lines.weights))
    assert_allclose(scaled.at(U), curve.at(U), atol=1e-12)


@every_kind
def test_weights_whose_ratio_is_no_double_leave_a_curve(kind):
    curve = random_curve(kind)
    weights = np.array([1e-300, 1.0, 1e100, 1e-100, 1.0, 1.0, 1e90, 1e-300])
    unequal = replace(curve, lines=curve.lines.with_weights(weights))
    assert np.isfinite(unequal.at(U)).all()
    assert len(tessellation(unequal, 0.01)) > 1


def test_three_weighted_points_draw_a_quarter_circle():
    points = np.array([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    lines = ControlLines.of(points, np.zeros((3, 2)), [1.0, np.sqrt(0.5), 1.0])
    arc = PlusCurve(Bernstein(3), lines).at(U)
    assert_allclose(np.linalg.norm(arc, axis=1), 1.0, atol=1e-15)


@pytest.mark.parametrize("sigma", [1e-4, 1e-30])
def test_a_tiny_sigma_draws_a_piece_of_each_line(sigma):
    lines = random_curve("bezier", size=3).lines
    curve = PlusCurve(RationalGaussian(3, sigma), lines, 2.0)
    u = np.array([0.1, 0.3, 0.6, 0.9])
    rows = [0, 1, 1, 2]
    expected = lines.points[rows] + (u - [0.0, 0.5, 0.5, 1.0])[:, None] * curve.gradients[rows]
    assert_allclose(curve.at(u), expected, atol=1e-14)


@pytest.mark.parametrize("sigma", [10.0, 1e12])
def test_a_huge_sigma_shrinks_a_closed_curve_to_its_mean_point(sigma):
    lines = random_curve("bezier", size=5).lines
    curve = PlusCurve(RationalGaussian(5, sigma, closed=True), lines, 1.0)
    assert_allclose(curve.at(U), [lines.points.mean(axis=0)] * len(U), atol=1e-12)


@given(st.floats(1e-12, 1e12), st.floats(-1e6, 1e6))
@settings(max_examples=30, deadline=None)
def test_the_unit_and_the_origin_of_the_points_do_not_matter(unit, origin):
    curve = random_curve("bspline", s=1.5)
    lines = curve.lines.with_points(unit * curve.lines.points + origin)
    moved = replace(curve, lines=lines.with_directions(curve.directions), s=1.5 * unit)
    expected = unit * curve.at(U) + origin
    assert_allclose(moved.at(U), expected, rtol=0, atol=1e-14 * (3.0 * unit + abs(origin)))


def test_a_basis_of_another_size_is_refused():
    with pytest.raises(ValueError, match="points: 8 control lines for a basis of 5"):
        PlusCurve(Bernstein(5), random_curve("bezier").lines)


@pytest.mark.parametrize("s", [np.nan, np.inf, -1e101])
def test_an_s_that_is_no_number_or_too_large_is_refused(s):
    with pytest.raises(ValueError, match="s: must be a finite number"):
        random_curve("bezier", s=s)


@pytest.mark.parametrize(
    ("u", "message"),
    [(np.nan, "not finite"), ([[0.0]], "expected one row"), (np.inf, "not finite")],
)
def test_parameters_that_are_no_row_of_numbers_are_refused(u, message):
    with pytest.raises(ValueError, match=f"u: .*{message}"):
        random_curve("bezier").at(u)


@pytest.mark.parametrize(("u", "message"), [([np.nan], "not finite"), ([[0.0]], "one row")])
def test_a_grid_is_one_row_of_numbers(u, message):
    with pytest.raises(ValueError, match=message):
        Grid(np.array(u))


def test_equal_grids_are_one_key():
    assert Grid(U) == Grid(U.copy())
    assert hash(Grid(U)) == hash(Grid(U.copy()))
    assert Grid(U) != Grid(U[:-1])


def test_changing_s_computes_no_product_again():
    curve, grid = random_curve("bspline"), Grid(U)
    stronger = replace(curve, s=5.0)
    assert terms(stronger.basis, stronger.lines, grid) is terms(curve.basis, curve.lines, grid)


def test_moving_a_point_computes_no_matrix_again():
    curve, grid = random_curve("closed"), Grid(U)
    before = blend(curve.basis, grid)
    replace(curve, lines=curve.lines.with_points(curve.lines.points + 1.0)).sample(grid)
    assert blend(replace(curve.basis), Grid(U.copy())) is before
