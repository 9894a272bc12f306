"""Plus surfaces in standard form."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bernstein import bernstein
from plusedit.geometry.elevation import elevated
from plusedit.geometry.iso_curves import iso_curve
from plusedit.geometry.surface_elevation import elevated_surface
from tests.geometry.curves import KINDS
from tests.geometry.surfaces import a_surface, random_surface, surfaces

PIECEWISE = tuple(kind for kind in KINDS if "rag" not in kind and kind != "staircase")
OFF_THE_KNOTS = np.linspace(0.00137, 0.9981, 23)


def extent(surface):
    """The size of the numbers that the form is made of."""
    return np.abs(surface.planes.points).max() + np.abs(surface.gradients).max()


@given(surfaces(kinds=PIECEWISE))
@settings(max_examples=80, deadline=None)
def test_the_standard_form_is_the_same_surface(surface):
    u = v = np.linspace(0.0, 1.0, 29)
    assert_allclose(
        elevated_surface(surface).at(u, v), surface.at(u, v), rtol=0, atol=1e-13 * extent(surface)
    )


@given(surfaces(kinds=PIECEWISE))
@settings(max_examples=40, deadline=None)
def test_it_has_the_same_derivatives(surface):
    of_surface = surface.derivatives(OFF_THE_KNOTS, OFF_THE_KNOTS)
    of_form = elevated_surface(surface).derivatives(OFF_THE_KNOTS, OFF_THE_KNOTS)
    for found, expected in zip(of_form, of_surface, strict=True):
        assert_allclose(found, expected, rtol=0, atol=3e-11 * (1.0 + np.abs(expected).max()))


@pytest.mark.parametrize("contrast", [None, 10.0])
def test_many_planes_lose_nothing_to_rounding(contrast):
    surface = random_surface("bspline", "closed", shape=(60, 45), contrast=contrast)
    u, v = np.linspace(0.0, 1.0, 83), np.linspace(0.0, 1.0, 71)
    assert_allclose(
        elevated_surface(surface).at(u, v), surface.at(u, v), rtol=0, atol=1e-13 * extent(surface)
    )


def test_both_degrees_rise_by_one():
    form = elevated_surface(random_surface("bezier", "closed, odd order", shape=(6, 5)))
    assert form.degrees == (6, 3)


def test_the_edge_of_the_form_is_the_form_of_the_edge():
    surface = random_surface("bspline", "kinks", shape=(6, 8), contrast=4.0)
    edge, form = elevated(iso_curve(surface, "u", 0.0)), elevated_surface(surface)
    assert_allclose(form.points[0], edge.points, atol=1e-14)
    assert_allclose(form.weights[0], edge.weights, rtol=1e-14)


def test_a_torus_ends_where_it_begins():
    form = elevated_surface(random_surface("closed", "closed, odd order"))
    assert_allclose(form.points[0], form.points[-1], atol=1e-14)
    assert_allclose(form.points[:, 0], form.points[:, -1], atol=1e-14)


@given(surfaces(kinds=PIECEWISE))
@settings(max_examples=40, deadline=None)
def test_the_bezier_patches_together_are_the_surface(surface):
    form = elevated_surface(surface)
    patches = form.bezier_patches()
    at = np.array([0.0, 0.3, 0.8125])
    by_u, by_v = (bernstein(at, degree) for degree in form.degrees)
    weights = patches.weights
    if weights is None:
        weights = np.ones(patches.points.shape[:-1])
    tops = np.einsum("ar,bq,ijrq,ijrqd->iajbd", by_u, by_v, weights, patches.points)
    found = tops / np.einsum("ar,bq,ijrq->iajb", by_u, by_v, weights)[..., None]
    u, v = (
        (breaks[:-1, None] + np.diff(breaks)[:, None] * at).ravel()
        for breaks in (patches.breaks_u, patches.breaks_v)
    )
    expected = surface.at(u, v)
    assert_allclose(found.reshape(expected.shape), expected, atol=1e-12 * extent(surface))


def test_neighboring_patches_touch_exactly():
    points = elevated_surface(random_surface(shape=(9, 7), contrast=3.0)).bezier_patches().points
    wide = elevated_surface(random_surface("closed", "closed")).bezier_patches().points
    for patches in (points, wide):
        assert_array_equal(patches[1:, :, 0], patches[:-1, :, -1])
        assert_array_equal(patches[:, 1:, :, 0], patches[:, :-1, :, -1])


def test_scaled_weights_scale_the_weights_of_the_form_and_nothing_else():
    surface = random_surface(contrast=5.0)
    scaled = replace(surface, planes=surface.planes.with_weights(1e90 * surface.planes.weights))
    assert_allclose(elevated_surface(scaled).points, elevated_surface(surface).points, rtol=1e-13)
    assert_allclose(
        elevated_surface(scaled).weights, 1e90 * elevated_surface(surface).weights, rtol=1e-14
    )


def test_a_gaussian_surface_has_no_standard_form():
    with pytest.raises(ValueError, match="not piecewise polynomial"):
        elevated_surface(random_surface("bezier", "rag"))


def test_without_weights_the_form_has_none():
    assert elevated_surface(a_surface()).weights is None
