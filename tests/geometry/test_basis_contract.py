"""What every basis of every family promises, here or on the shelf."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases import Basis, LocalBasis, families, is_local
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from tests.geometry.curves import bases

BASES = {
    f"{name} of_size {size}": family.of_size(size)
    for name, family in families.items()
    for size in (2, 3, 4, 9)
}
BASES |= {f"{kind} {size}": b for size in (2, 3, 8, 200) for kind, b in bases(size).items()}
BASES |= {
    "closed, order above size": BSpline(2, 6, closed=True),
    "closed polygon": BSpline(5, 2, closed=True),
    "given nodes": RationalGaussian(4, 0.2, given_nodes=(0.1, 0.2, 0.25, 0.9)),
    "closed given nodes": RationalGaussian(3, 0.3, True, (0.1, 0.2, 0.7)),
    "wide": RationalGaussian(5, 50.0),
    "closed, wide": RationalGaussian(5, (0.1, 3.0, 70.0, 0.5, 1.0), True),
}


def those(fits):
    """The bases for which `fits` holds, as a parameter of a test."""
    chosen = {name: basis for name, basis in BASES.items() if fits(basis)}
    return pytest.mark.parametrize("basis", chosen.values(), ids=chosen)


every_basis = those(lambda basis: True)
open_basis = those(lambda basis: not basis.closed)
local_basis = those(is_local)
open_local_basis = those(lambda basis: is_local(basis) and not basis.closed)
every_derivative = pytest.mark.parametrize("derivative", [0, 1, 2])


def inner(basis):
    """Irregular parameters inside (0, 1), none of them a knot or near to one."""
    u = np.sort(np.random.default_rng(11).uniform(0.001, 0.999, 60))
    if not is_local(basis):
        return u
    return u[np.abs(u[:, None] - basis.breaks).min(axis=1) > 1e-5]


def scale(basis):
    """How many times a function may change from nothing to one over [0, 1]."""
    if isinstance(basis, RationalGaussian):
        gap = np.diff(basis.nodes).max()
        return np.max(gap / np.square(basis.sigma) + 1.0 / np.asarray(basis.sigma)) + 1.0
    knots = basis.breaks if is_local(basis) else np.array([0.0, 1.0])
    return basis.size / np.diff(knots).min()


@every_basis
def test_it_keeps_the_protocol(basis):
    assert isinstance(basis, Basis)
    assert isinstance(basis, LocalBasis) == is_local(basis)


@every_basis
def test_the_functions_sum_to_one_and_are_never_negative(basis):
    values = basis.values(np.linspace(0.0, 1.0, 301))
    assert_allclose(values.sum(axis=1), 1.0, rtol=1e-13)
    assert values.min() >= 0.0


@every_basis
def test_derivatives_of_a_constant_are_zero(basis):
    for derivative in (1, 2):
        slopes = basis.values(inner(basis), derivative=derivative)
        largest = np.abs(slopes).max(axis=1)
        assert_allclose(slopes.sum(axis=1), 0.0, atol=1e-11 * (1.0 + largest.max()))


@every_basis
@pytest.mark.parametrize("name", ["values", "reaches"])
@pytest.mark.parametrize("derivative", [1, 2])
def test_a_derivative_is_the_limit_of_differences(basis, name, derivative):
    functions = getattr(basis, name)
    u, h = inner(basis), 1e-4 / scale(basis)
    after = functions(u + h, derivative=derivative - 1)
    before = functions(u - h, derivative=derivative - 1)
    rate = scale(basis) ** derivative
    found = functions(u, derivative=derivative)
    assert_allclose(found / rate, (after - before) / (2.0 * h) / rate, atol=2e-6)


@every_basis
def test_nodes_rise_and_lie_in_the_domain(basis):
    nodes = basis.nodes
    assert nodes.shape == (basis.size,)
    assert (np.diff(nodes) > 0.0).all()
    assert nodes[0] >= 0.0
    assert nodes[-1] < 1.0 if basis.closed else nodes[-1] <= 1.0


@every_basis
def test_equal_bases_are_equal_keys(basis):
    other = type(basis)(**vars_of(basis))
    assert other == basis
    assert hash(other) == hash(basis)
    assert other != families["bezier"].of_size(77)


def vars_of(basis):
    return {name: getattr(basis, name) for name in basis.__dataclass_fields__}


@open_basis
@every_derivative
def test_reaches_are_distances_times_functions_by_the_product_rule(basis, derivative):
    u = inner(basis)
    expected = (u[:, None] - basis.nodes) * basis.values(u, derivative=derivative)
    if derivative:
        expected += derivative * basis.values(u, derivative=derivative - 1)
    size = 1.0 + np.abs(basis.values(u, derivative=derivative)).max()
    assert_allclose(basis.reaches(u, derivative=derivative), expected, atol=1e-12 * size)


@every_basis
@every_derivative
@pytest.mark.parametrize("name", ["values", "reaches"])
def test_outside_the_domain_open_functions_stop_and_closed_ones_come_again(basis, name, derivative):
    functions, u = getattr(basis, name), inner(basis)
    if basis.closed:
        here = functions(u, derivative=derivative)
        for turns in (-3.0, -1.0, 1.0, 5.0):
            there = functions(u + turns, derivative=derivative)
            assert_allclose(there, here, atol=1e-9 * (1.0 + np.abs(here).max()))
    else:
        ends = functions(np.array([0.0, 1.0]), derivative=derivative)
        beyond = functions(np.array([-7.0, -1e-300, 1.0 + 1e-15, 9.0]), derivative=derivative)
        assert_array_equal(beyond, ends[[0, 0, 1, 1]])


@local_basis
@every_derivative
def test_without_its_zeros_a_matrix_is_the_same(basis, derivative):
    u = np.linspace(-0.2, 1.2, 71)
    values, reaches = basis.banded(u, derivative=derivative)
    assert_allclose(values.dense(), basis.values(u, derivative=derivative), rtol=1e-15)
    assert_allclose(reaches.dense(), basis.reaches(u, derivative=derivative), rtol=1e-15)
    assert values.entries.shape == values.columns.shape == (71, basis.order)
    rows = np.random.default_rng(1).normal(size=(basis.size, 3))
    size = 1e-14 * np.abs(values.entries).max()
    assert_allclose(values @ rows, values.dense() @ rows, atol=20 * size)
    assert_allclose(values @ rows[:, 0], values.dense() @ rows[:, 0], atol=20 * size)


@local_basis
@every_derivative
def test_at_a_knot_a_derivative_is_that_of_the_span_to_the_right(basis, derivative):
    knots = basis.breaks[:-1]
    step = 1e-9 * np.diff(basis.breaks)
    at, beside = (basis.values(u, derivative=derivative) for u in (knots, knots + step))
    assert_allclose(at, beside, atol=1e-6 * scale(basis) ** derivative)


@open_local_basis
@every_derivative
def test_at_the_end_a_derivative_is_that_of_the_last_span(basis, derivative):
    step = 1e-9 * np.diff(basis.breaks)[-1]
    at, before = (basis.values(np.array([u]), derivative=derivative) for u in (1.0, 1.0 - step))
    assert_allclose(at, before, atol=1e-6 * scale(basis) ** derivative)


@every_basis
def test_no_parameters_make_empty_matrices(basis):
    assert basis.values(np.empty(0)).shape == (0, basis.size)
    assert basis.reaches(np.empty(0)).shape == (0, basis.size)
