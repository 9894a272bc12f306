import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases import families
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.sizes import (
    basis_of,
    closed_basis,
    family_of,
    longer_basis,
    ordered_basis,
    with_end_line,
    with_family,
    without_lines,
)
from tests.geometry.curves import KINDS, random_curve

every_kind = pytest.mark.parametrize("kind", KINDS)


@every_kind
@pytest.mark.parametrize("rows", [(0,), (7,), (3, 4), (1, 2, 3, 4, 5, 6)])
def test_without_some_lines_the_others_are_as_they_were(kind, rows):
    curve = random_curve(kind, contrast=3.0)
    fewer = without_lines(curve, rows)
    kept = np.setdiff1d(np.arange(8), rows)
    assert_array_equal(fewer.lines.points, curve.lines.points[kept])
    assert_array_equal(fewer.lines.weights, curve.lines.weights[kept])
    assert_array_equal(fewer.lines.automatic, curve.lines.automatic[kept])
    assert (family_of(fewer.basis), fewer.closed) == (family_of(curve.basis), curve.closed)
    assert np.isfinite(fewer.at(np.linspace(0.0, 1.0, 9))).all()


@every_kind
def test_fewer_than_two_lines_are_no_curve(kind):
    with pytest.raises(ValueError, match="at least 2"):
        without_lines(random_curve(kind), tuple(range(7)))


@every_kind
@pytest.mark.parametrize("at_end", [True, False])
def test_with_a_line_at_an_end_the_others_are_as_they_were(kind, at_end):
    curve = random_curve(kind, contrast=3.0)
    longer = with_end_line(curve, np.array([5.0, 6.0]), at_end=at_end)
    old = slice(0, 8) if at_end else slice(1, 9)
    assert_array_equal(longer.lines.points[old], curve.lines.points)
    assert_array_equal(longer.lines.points[8 if at_end else 0], [5.0, 6.0])
    assert longer.lines.automatic[8 if at_end else 0]
    assert (family_of(longer.basis), longer.closed) == (family_of(curve.basis), curve.closed)
    assert np.isfinite(longer.at(np.linspace(0.0, 1.0, 9))).all()


@pytest.mark.parametrize("at_end", [True, False])
def test_given_nodes_keep_their_ratios_when_one_more_comes(at_end):
    nodes = (0.0, 0.1, 0.6, 1.0)
    longer = longer_basis(RationalGaussian(4, 0.2, given_nodes=nodes), at_end, None)
    gaps = np.diff(longer.given_nodes)
    old = gaps[:-1] if at_end else gaps[1:]
    assert_allclose(old / old[0], np.diff(nodes) / 0.1)
    assert_allclose(longer.sigma / old[0], 0.2 / 0.1)


@pytest.mark.parametrize("family", list(families))
@pytest.mark.parametrize("size", [2, 3, 4, 9])
def test_every_family_has_a_usual_basis_of_any_size(family, size):
    basis = basis_of(family, size)
    assert basis.size == size and family_of(basis) == family and not basis.closed
    if family != "bezier":
        assert basis_of(family, size, closed=True).closed


def test_a_bezier_basis_is_never_closed():
    with pytest.raises(ValueError, match="closed smoothly"):
        basis_of("bezier", 4, closed=True)
    with pytest.raises(ValueError, match="closed smoothly"):
        closed_basis(basis_of("bezier", 4), True)
    assert closed_basis(basis_of("bezier", 4), False) == basis_of("bezier", 4)


@pytest.mark.parametrize("family", list(families))
@every_kind
def test_another_family_has_the_same_size(kind, family):
    basis = random_curve(kind).basis
    if family == "bezier" and basis.closed:
        return
    other = with_family(basis, family)
    assert other.size == basis.size and other.closed == basis.closed


def test_only_splines_have_an_order():
    assert ordered_basis(BSpline(5, 4), 9) == BSpline(5, 5)
    with pytest.raises(ValueError, match="only B-splines"):
        ordered_basis(basis_of("rag", 5), 3)
