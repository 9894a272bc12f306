"""Blending functions with weights, and where they are not zero."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.blending_functions import curve_functions, row_functions
from plusedit.geometry.iso_curves import iso_curve
from plusedit.geometry.supports import stretches, supports
from tests.geometry.curves import KINDS, bases, random_curve
from tests.geometry.surfaces import PAIRS, random_surface

U = np.linspace(0.0, 1.0, 41)


@pytest.mark.parametrize("contrast", [None, 5.0])
@pytest.mark.parametrize("kind", KINDS)
def test_points_and_directions_times_the_functions_are_the_curve(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    found = curve_functions(curve, U)
    points = found.values @ curve.lines.points + found.reaches @ curve.gradients
    assert_allclose(points, curve.at(U), atol=1e-12)
    assert_allclose(found.values.sum(axis=1), 1.0)


@pytest.mark.parametrize("kinds", PAIRS)
def test_those_of_rows_are_those_of_the_curve_with_the_other_parameter_fixed(kinds):
    surface = random_surface(*kinds, contrast=4.0)
    for way, other in (("u", "v"), ("v", "u")):
        at_other = iso_curve(surface, other, 0.3)
        expected = curve_functions(at_other, U)
        found = row_functions(surface, way, U, 0.3)
        assert_allclose(found.values, expected.values, atol=1e-12)
        assert_allclose(found.reaches, expected.reaches, atol=1e-12)


@pytest.mark.parametrize("size", [2, 3, 8, 12])
@pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "kinks"])
def test_functions_are_zero_outside_of_their_stretches_and_not_inside(kind, size):
    basis = bases(size)[kind]
    u = np.linspace(0.0, 1.0, 997)
    values = basis.values(u)
    for number in range(size):
        inside = np.zeros(len(u), dtype=bool)
        for low, high in stretches(basis, number):
            assert 0.0 <= low < high <= 1.0
            inside |= (u > low) & (u < high)
        assert_allclose(values[(~inside) & (u > 0.0) & (u < 1.0), number], 0.0, atol=1e-14)
        if "spline" in kind or kind.startswith("closed,"):
            assert (values[inside, number] > 0.0).mean() > 0.99  # a closed one may touch zero


def test_supports_of_a_uniform_closed_basis_lie_about_the_nodes():
    basis = bases(8)["closed"]
    low, high = supports(basis)
    assert_allclose((low + high) / 2.0, basis.nodes)
    assert_allclose(high - low, 0.5)
