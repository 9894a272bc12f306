"""Curves in one basis: the same curves where a basis holds them all, near ones where not."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.making.compatible import compatible, in_space, of_one_magnitude, unweighted
from plusedit.geometry.making.refining import finer, opened, raised, with_knots
from tests.geometry.curves import random_curve

U = np.linspace(0.0, 1.0, 97)
OPEN = ("bezier", "bspline", "polygon", "high order", "kinks")
CLOSED = ("closed", "closed, odd order")
CONTRASTS = (None, 5.0)


def same(one, other, accuracy=1e-12):
    assert_allclose(other.at(U), one.at(U), rtol=0.0, atol=accuracy)


@pytest.mark.parametrize("contrast", CONTRASTS)
@pytest.mark.parametrize("kind", OPEN)
def test_raising_the_order_changes_nothing(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    higher = raised(curve)
    same(curve, higher)
    assert higher.basis != curve.basis
    same(curve, raised(higher))


@pytest.mark.parametrize("contrast", CONTRASTS)
@pytest.mark.parametrize("size", [2, 3, 8])
@pytest.mark.parametrize("kind", CLOSED)
def test_cutting_a_closed_curve_open_changes_nothing(kind, size, contrast):
    curve = random_curve(kind, size=size, contrast=contrast)
    cut = opened(curve)
    assert not cut.closed
    same(curve, cut)
    assert_allclose(cut.lines.points[0], cut.lines.points[-1], atol=1e-12)


@pytest.mark.parametrize("contrast", CONTRASTS)
@pytest.mark.parametrize("factor", [1, 2, 3, 5])
def test_a_closed_curve_of_more_lines_is_the_same(factor, contrast):
    curve = random_curve("closed", size=5, contrast=contrast)
    assert finer(curve, factor).basis.size == 5 * factor
    same(curve, finer(curve, factor))


def test_a_closed_curve_of_odd_order_has_no_knots_at_its_nodes():
    curve = random_curve("closed, odd order", size=5)
    same(curve, finer(curve, 3))
    with pytest.raises(ValueError, match="no knots in between"):
        finer(curve, 2)


@pytest.mark.parametrize(
    ("make", "kind"), [(raised, "closed"), (raised, "rag"), (opened, "closed rag")]
)
def test_what_has_no_exact_form_says_so(make, kind):
    with pytest.raises(ValueError, match="exactly"):
        make(random_curve(kind))


def test_lines_that_only_change_their_numbers_stay_automatic():
    curve = random_curve("bspline", size=8)
    knots = np.sort(np.append(curve.basis.knot_vector, 0.95))
    finer_end = with_knots(curve, knots)
    same(curve, finer_end)
    kept = np.flatnonzero(curve.lines.automatic[:3])
    assert finer_end.lines.automatic[kept].all()


@pytest.mark.parametrize("contrast", CONTRASTS)
@pytest.mark.parametrize("kinds", list(combinations((*OPEN, *CLOSED), 2)), ids=" and ".join)
def test_polynomial_curves_stay_exactly_what_they_are(kinds, contrast):
    if kinds == CLOSED:
        pytest.skip("closed curves of several orders have no closed basis in common")
    curves = [
        random_curve(kind, seed=seed, dimension=3, contrast=contrast)
        for seed, kind in enumerate(kinds)
    ]
    made = compatible(curves)
    assert made.largest_miss == 0.0
    assert len({curve.basis for curve in made.curves}) == 1
    assert len({curve.s for curve in made.curves}) == 1
    for old, new in zip(curves, made.curves, strict=True):
        same(old, new, 1e-11)


def test_bezier_curves_stay_bezier_curves():
    made = compatible([random_curve("bezier", size=3), random_curve("bezier", size=6)])
    assert made.curves[0].basis == Bernstein(6)


def test_closed_curves_stay_closed():
    few, many = random_curve("closed", size=4), random_curve("closed", size=6)
    made = compatible([few, many])
    assert made.curves[0].basis == BSpline(12, 4, closed=True)
    same(in_space(few), made.curves[0])


def test_curves_in_one_basis_stay_the_very_same():
    curves = [random_curve("rag", dimension=3, s=2.0, seed=seed) for seed in range(3)]
    for old, new in zip(curves, compatible(curves).curves, strict=True):
        assert new is old


@pytest.mark.parametrize("kind", ["rag", "closed rag", "uneven rag"])
@pytest.mark.parametrize("other", ["bspline", "closed, odd order", "kinks"])
def test_rational_gaussians_are_fitted_within_the_tolerance(kind, other):
    curves = [random_curve(kind, s=1.0), random_curve(other, s=1.0)]
    made = compatible(curves, tolerance=1e-3)
    assert 0.0 < made.largest_miss <= 1e-3
    for old, new in zip(curves, made.curves, strict=True):
        same(in_space(old), new, 2e-3)
    assert made.curves[0].closed == all(curve.closed for curve in curves)


def test_curves_with_weights_are_fitted_where_none_are_wanted():
    arcs = [random_curve("bspline", contrast=2.0, seed=seed) for seed in range(2)]
    made = unweighted(arcs, tolerance=1e-3)
    for old, new in zip(arcs, made.curves, strict=True):
        assert new.lines.weights is None
        same(in_space(old), new, 2e-3)


def test_a_curve_that_no_spline_follows_ends_in_a_miss_that_is_told():
    made = compatible([random_curve("staircase"), random_curve("bezier")])
    assert made.largest_miss > 0.01
    assert made.curves[0].basis.size <= 160


def test_curves_of_several_magnitudes_get_one():
    curves = [random_curve("bspline", s=s, seed=2) for s in (0.0, -3.0, 2.0)]
    made = of_one_magnitude(curves)
    assert [curve.s for curve in made] == [-3.0] * 3
    for old, new in zip(curves, made, strict=True):
        same(old, new)


def test_a_plane_curve_lies_in_z_0_and_keeps_its_automatic_directions():
    curve = random_curve("bspline")
    lifted = in_space(curve)
    assert_array_equal(lifted.at(U)[:, 2], 0.0)
    same(curve, replace(lifted, lines=replace_points(lifted.lines)))
    assert_array_equal(lifted.lines.automatic, curve.lines.automatic)


def replace_points(lines):
    """The lines without their third coordinate."""
    return replace(lines, points=lines.points[:, :2], given=lines.given[:, :2])
