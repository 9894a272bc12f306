"""Second derivatives of surfaces of meshes, and the curvature that follows from them."""

import sys

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.surface_frames import gaussian_curvature, mean_curvature
from tests.geometry.mesh.mesh_surfaces import (
    EVERY_KIND,
    definition,
    height_field,
    inner_places,
    pillow,
    sizes_of,
)

every_kind = pytest.mark.parametrize("kind", EVERY_KIND, ids=lambda each: each.__name__)


def differences(surface, places, h):
    """S_uu, S_uv and S_vv as differences of the tangents of the definition."""
    along = [np.array([h, 0.0]), np.array([0.0, h])]
    ahead = [definition(surface, places + step) for step in along]
    behind = [definition(surface, places - step) for step in along]
    by_u, by_v = (
        [(one - other) / (2.0 * h) for one, other in zip(a[1:], b[1:], strict=True)]
        for a, b in zip(ahead, behind, strict=True)
    )
    return by_u[0], by_u[1], by_v[1]


@every_kind
@pytest.mark.parametrize("smoothness", [0.5, 0.9, 2.0])
def test_second_derivatives_are_the_limits_of_differences(kind, smoothness):
    surface = kind(smoothness=smoothness, s=0.8)
    places = inner_places(surface)
    h = 1e-3 * surface.sigmas.min()
    found = surface.derivatives(places, highest=2)[3:]
    size = max(np.abs(each).max() for each in found)
    for each, wanted in zip(found, differences(surface, places, h), strict=True):
        assert_allclose(each, wanted, atol=1e-5 * size)


@every_kind
def test_the_first_derivatives_are_the_same_with_the_second(kind):
    surface = kind()
    places = inner_places(surface)
    both = zip(surface.derivatives(places), surface.derivatives(places, highest=2)[:3], strict=True)
    for alone, together in both:
        assert_allclose(together, alone, atol=1e-12 * max(1.0, np.abs(alone).max()))


@every_kind
@pytest.mark.parametrize("smoothness", [0.1, 0.7, 4.0])
def test_without_compiled_loops_they_are_the_same(kind, smoothness, monkeypatch):
    surface = kind(smoothness=smoothness)
    places = np.concatenate([inner_places(surface), 3.0 * sizes_of(surface)[None]])
    fast = surface.derivatives(places, highest=2)
    monkeypatch.setitem(sys.modules, "plusedit.geometry.mesh.full_kernels", None)
    for found, wanted in zip(surface.derivatives(places, highest=2), fast, strict=True):
        assert_allclose(found, wanted, atol=1e-9 * max(1.0, np.abs(wanted).max()))


def test_they_take_no_notice_of_how_far_off_the_mesh_is():
    surface = height_field()
    far = surface.transformed(np.eye(3), [1e6, -1e6, 1e6])
    places = inner_places(surface)
    for here, there in zip(
        surface.derivatives(places, highest=2)[1:],
        far.derivatives(places, highest=2)[1:],
        strict=True,
    ):
        assert_allclose(there, here, atol=1e-6 * np.abs(here).max())


def test_images_that_turn_have_the_same_curvature():
    surface = pillow()
    places = inner_places(surface)
    for measure in (gaussian_curvature, mean_curvature):
        here, there = (measure(surface.derivatives(each, highest=2)) for each in (places, -places))
        assert_allclose(there, here, rtol=1e-6, atol=1e-6)


def test_a_height_field_has_the_curvature_of_its_graph():
    surface = height_field(smoothness=1.0)
    found = surface.derivatives(inner_places(surface), highest=2)
    _, by_u, by_v, by_uu, by_uv, by_vv = (each[:, 2] for each in found)
    steep = 1.0 + by_u**2 + by_v**2
    assert_allclose(gaussian_curvature(found), (by_uu * by_vv - by_uv**2) / steep**2, rtol=1e-8)
