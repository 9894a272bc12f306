"""One control line more."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.insertion import insert_line, with_basis
from plusedit.geometry.lines import ControlLines
from tests.geometry.curves import KINDS, random_curve

EXACT = ("bezier", "bspline", "polygon", "high order", "kinks")
PLACES = (0.0, 0.2, 0.25, 0.5, 0.803, 1.0)
every_kind = pytest.mark.parametrize("kind", KINDS)
U = np.linspace(0.0, 1.0, 401)


def regular(size, basis, s):
    """A regular polygon in the unit circle, directions automatic."""
    angle = 2.0 * np.pi * np.arange(size) / size
    return PlusCurve(basis, ControlLines.of(np.stack([np.cos(angle), np.sin(angle)], axis=1)), s)


def distance(points, others):
    """The largest distance of a point from the nearest of the others."""
    apart = np.linalg.norm(points[:, None] - others, axis=2)
    return apart.min(axis=1).max()


@every_kind
@pytest.mark.parametrize("u", PLACES)
def test_there_is_one_line_more_of_the_same_family(kind, u):
    curve = random_curve(kind)
    longer, index = insert_line(curve, u)
    assert type(longer.basis) is type(curve.basis)
    assert len(longer.lines) == longer.basis.size == 9
    assert longer.s == curve.s
    assert 0 <= index < 9


@pytest.mark.parametrize("kind", EXACT)
@pytest.mark.parametrize("contrast", [None, 9.0])
@pytest.mark.parametrize("u", PLACES)
def test_bezier_and_open_b_spline_curves_stay_exactly_as_they_are(kind, contrast, u):
    curve = random_curve(kind, contrast=contrast, dimension=3, s=1.5)
    assert_allclose(insert_line(curve, u)[0].at(U), curve.at(U), atol=1e-14)


@pytest.mark.parametrize("size", [2, 60, 199])
@pytest.mark.parametrize("family", [Bernstein, BSpline.of_size])
def test_short_and_long_curves_stay_as_they_are(family, size):
    curve = replace(random_curve("bezier", size=size), basis=family(size))
    assert_allclose(insert_line(curve, 0.6)[0].at(U), curve.at(U), atol=1e-13)


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind not in EXACT])
@pytest.mark.parametrize("contrast", [None, 3.0])
def test_other_curves_change_by_little(kind, contrast):
    curve = random_curve(kind, contrast=contrast, s=1.0)
    points = insert_line(curve, 0.3)[0].at(U)
    assert distance(points, curve.at(np.linspace(0.0, 1.0, 2001))) < 0.03


@pytest.mark.parametrize("order", [3, 4, 5])
def test_a_round_closed_curve_stays_round(order):
    curve = regular(8, BSpline(8, order, closed=True), 3.3)
    radius = np.linalg.norm(curve.at(U), axis=1)
    found = np.linalg.norm(insert_line(curve, 0.4)[0].at(U), axis=1)
    assert_allclose(found, radius.mean(), atol=5e-3)


@pytest.mark.parametrize("u", [0.0, 0.3, 0.99])
def test_on_a_closed_b_spline_the_new_line_stands_where_it_was_wanted(u):
    curve = regular(8, BSpline(8, 4, closed=True), 3.3)
    longer, index = insert_line(curve, u)
    assert distance(longer.lines.points[[index]], curve.at([u])) < 0.02


@pytest.mark.parametrize("closed", [False, True])
def test_gaussians_far_from_the_new_one_keep_their_lines_and_nodes(closed):
    curve = replace(
        random_curve("bezier", size=30), basis=RationalGaussian(30, 0.6 / 29, closed=closed)
    )
    longer, index = insert_line(curve, 0.53)
    assert longer.basis.nodes[index] == 0.53
    assert_array_equal(np.delete(longer.basis.nodes, index), curve.basis.nodes)
    assert_array_equal(longer.lines.points[:8], curve.lines.points[:8])
    assert_array_equal(longer.lines.automatic[1:8], curve.lines.automatic[1:8])


@pytest.mark.parametrize("u", [0.0, 0.3, 1.0])
def test_every_gaussian_keeps_its_own_width(u):
    curve = random_curve("uneven rag")
    longer, index = insert_line(curve, u)
    assert longer.basis.sigma[:index] + longer.basis.sigma[index + 1 :] == curve.basis.sigma


def test_a_knot_in_the_middle_of_an_even_span_leaves_the_knots_uniform():
    curve = random_curve("bspline", size=4)
    assert insert_line(curve, 0.5)[0].basis == BSpline(5, 4)


def test_lines_out_of_reach_of_a_new_knot_stay_to_the_last_bit():
    curve = random_curve("bspline", size=20, contrast=4.0)
    longer, _ = insert_line(curve, 0.05)
    for name in ("points", "given", "automatic", "weights"):
        old, new = getattr(curve.lines, name), getattr(longer.lines, name)
        assert_array_equal(new[6:], old[5:])


def test_the_classical_curve_stays_classical():
    curve = random_curve("bspline", s=0.0)
    longer, _ = insert_line(curve, 0.3)
    assert_allclose(longer.at(U), curve.at(U), atol=1e-14)
    assert np.abs(longer.directions).max() <= np.abs(curve.directions).max()


def test_lines_that_all_coincide_can_get_company():
    still = PlusCurve(BSpline(5, 4, closed=True), ControlLines.of(np.ones((5, 2))), 0.0)
    assert_allclose(insert_line(still, 0.5)[0].at(U), 1.0)


def test_a_closed_curve_of_many_lines_is_done_about_the_new_one():
    curve = regular(700, RationalGaussian(700, 0.6 / 700, closed=True), 3.2)
    assert distance(insert_line(curve, 0.5)[0].at(U), curve.at(np.linspace(0, 1, 4001))) < 1e-3


@every_kind
@pytest.mark.parametrize("u", [-0.4, 1.7])
def test_a_place_outside_the_domain_is_brought_inside(kind, u):
    curve = random_curve(kind)
    inside = u % 1.0 if curve.closed else np.clip(u, 0.0, 1.0)
    (there, index), (here, expected) = insert_line(curve, u), insert_line(curve, inside)
    assert index == expected
    assert_allclose(there.at(U), here.at(U), atol=1e-9)


@every_kind
def test_no_line_can_be_put_nowhere(kind):
    with pytest.raises(ValueError, match="finite parameter, got nan"):
        insert_line(random_curve(kind), np.nan)


def test_a_line_can_be_put_into_thousands():
    curve = random_curve("bspline", size=3000)
    assert_allclose(insert_line(curve, 0.4)[0].at(U), curve.at(U), atol=1e-13)


@every_kind
def test_with_a_basis_of_the_same_size_the_lines_are_the_same_object(kind):
    curve = random_curve(kind)
    assert with_basis(curve, Bernstein(8)).lines is curve.lines


@pytest.mark.parametrize("size", [3, 5, 8, 20])
def test_lines_of_one_straight_motion_still_are_with_another_number(size):
    nodes, way = np.linspace(0.0, 1.0, 8), np.array([3.0, -1.0])
    curve = PlusCurve(Bernstein(8), ControlLines.of(nodes[:, None] * way, [way] * 8), 1.0)
    other = with_basis(curve, RationalGaussian.of_size(size))
    assert_allclose(other.at(U), U[:, None] * way, atol=1e-14)


@pytest.mark.parametrize("u", [-1e-45, 1.0 - 1e-16])
def test_next_to_the_seam_a_closed_curve_gets_a_line_there(u):
    curve = random_curve("closed", size=5)
    larger, index = insert_line(curve, u)
    assert len(larger.lines) == 6
    assert 0 <= index < 6
