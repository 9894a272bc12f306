"""Curves of one constant parameter on a surface."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.iso_curves import boundary_curves, iso_curve
from tests.geometry.surfaces import a_surface, random_surface, surfaces

ALONG = np.linspace(-0.2, 1.3, 41)


@given(surfaces(), st.floats(-0.5, 1.5))
@settings(max_examples=100, deadline=None)
def test_an_iso_curve_is_the_surface_with_one_parameter_fixed(surface, value):
    by_u, by_v = iso_curve(surface, "u", value), iso_curve(surface, "v", value)
    size = np.abs(surface.at(ALONG, ALONG)).max()
    assert_allclose(by_u.at(ALONG), surface.at([value], ALONG)[0], atol=1e-12 * size)
    assert_allclose(by_v.at(ALONG), surface.at(ALONG, [value])[:, 0], atol=1e-12 * size)


@given(surfaces(), st.floats(0.0, 1.0))
@settings(max_examples=50, deadline=None)
def test_it_has_the_tangents_of_the_surface_and_its_basis_and_s(surface, value):
    curve = iso_curve(surface, "u", value)
    u = np.linspace(0.013, 0.987, 17)
    expected = surface.derivatives([value], u)
    for found, wanted in zip(
        curve.derivatives(u), (expected[0], expected[2], expected[5]), strict=True
    ):
        assert_allclose(found, wanted[0], atol=1e-10 * (1.0 + np.abs(wanted).max()))
    assert curve.basis == surface.basis_v and curve.s == surface.s


def test_the_edge_of_a_sheet_is_the_curve_of_its_row_with_automatic_directions():
    surface = a_surface()
    edge = iso_curve(surface, "v", 1.0)
    assert_array_equal(edge.lines.points, surface.planes.points[:, -1])
    assert edge.lines.automatic.all()


def test_a_row_of_equal_weights_needs_none():
    surface = a_surface()
    weights = np.ones((4, 5))
    weights[0] = 3.0
    weighted = surface.with_net(surface.planes.with_weights(weights))
    assert iso_curve(weighted, "u", 0.0).lines.weights is None
    assert iso_curve(weighted, "v", 0.0).lines.weights is not None


@pytest.mark.parametrize(
    ("kind_u", "kind_v", "count"),
    [
        ("bspline", "rag", 4),
        ("closed", "bezier", 2),
        ("rag", "closed rag", 2),
        ("closed",) * 2 + (0,),
    ],
)
def test_only_open_sides_have_boundary_curves(kind_u, kind_v, count):
    surface = random_surface(kind_u, kind_v, contrast=3.0)
    curves = boundary_curves(surface)
    assert len(curves) == count
    fixed = [(0, way, end) for way in (0, 1) if not surface.closed[way] for end in (0.0, 1.0)]
    for curve, (_, way, end) in zip(curves, fixed, strict=True):
        args = ([end], ALONG) if way == 0 else (ALONG, [end])
        assert_allclose(curve.at(ALONG), surface.at(*args).reshape(-1, 3), atol=1e-12)


def test_a_parameter_that_is_not_finite_is_refused():
    with pytest.raises(ValueError, match="not finite"):
        iso_curve(a_surface(), "u", np.nan)
