"""Simple bodies have the size and the roundness that is said of them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.making.primitives import exact_sphere, sheet, sphere, torus, tube
from plusedit.geometry.surface_magnitude import natural_length

T = np.linspace(0.0, 1.0, 121)
CENTER = np.array([1.0, -2.0, 0.5])

families = pytest.mark.parametrize("family", ["bspline", "rag"])


def from_axis(surface):
    """Distance from the vertical axis and height, both seen from the center."""
    points = surface.at(T, T) - CENTER
    return np.hypot(points[..., 0], points[..., 1]), points[..., 2]


@pytest.mark.parametrize("family", ["bezier", "bspline", "rag"])
def test_a_sheet_is_flat_and_of_its_size(family):
    surface = sheet(4, 5, size=(3.0, 2.0), center=CENTER, families=(family, family))
    on = surface.at(T, T)
    assert_allclose(on[..., 2], 0.5, atol=1e-12)
    assert_allclose(on[..., 0], np.broadcast_to((3.0 * T - 0.5)[:, None], (121, 121)), atol=1e-12)
    assert_allclose(on[..., 1], np.broadcast_to(2.0 * T - 3.0, (121, 121)), atol=1e-12)
    assert surface.planes.shape == (4, 5)


@families
def test_a_tube_is_round_and_passes_through_its_points(family):
    surface = tube(radius=2.0, height=5.0, center=CENTER, families=(family, family))
    radius, height = from_axis(surface)
    assert_allclose(radius, 2.0, rtol=1.4e-3)
    assert_allclose(height, np.broadcast_to(5.0 * (T - 0.5), height.shape), atol=1e-12)
    u, v = (basis.nodes for basis in surface.bases)
    assert_allclose(surface.at(u, v)[:, [0, -1]], surface.planes.points[:, [0, -1]], atol=1e-12)
    assert surface.closed == (True, False)


def test_the_directions_of_sheet_and_tube_are_automatic():
    assert sheet().planes.automatic.all()
    assert tube(radius=3.0).planes.automatic.all()


@families
@pytest.mark.parametrize(("counts", "accuracy"), [((8, 6), 8e-3), ((12, 8), 2e-3)])
def test_a_torus_is_round_both_ways(family, counts, accuracy):
    surface = torus(*counts, radius=3.0, thickness=1.0, center=CENTER, families=(family, family))
    radius, height = from_axis(surface)
    assert_allclose(np.hypot(radius - 3.0, height), 1.0, rtol=1.5 * accuracy)
    u, v = (basis.nodes for basis in surface.bases)
    assert_allclose(surface.at(u, v), surface.planes.points, atol=1e-9)
    assert surface.closed == (True, True)
    assert surface.s == pytest.approx(natural_length(surface) / 2.0)


@pytest.mark.parametrize("counts", [(8, 7), (12, 7), (8, 9)])
def test_a_sphere_is_round(counts):
    radius, height = from_axis(sphere(*counts, radius=2.0, center=CENTER))
    assert_allclose(np.hypot(radius, height), 2.0, rtol=1.3e-3)


def test_a_sphere_is_smooth_at_its_poles():
    surface = sphere(center=CENTER)
    at, _, across = surface.derivatives(T, [0.0, 1.0], highest=1)
    assert_allclose(at - CENTER, np.broadcast_to([[0, 0, -1.0], [0, 0, 1.0]], at.shape), atol=1e-12)
    assert_allclose(across[..., 2], 0.0, atol=1e-12)
    assert np.linalg.norm(across, axis=-1).min() > 1.0


def test_the_normals_of_closed_bodies_point_outwards():
    for surface in (tube(), torus(), sphere(), exact_sphere()):
        at, by_u, by_v = surface.derivatives([0.3], [0.4], highest=1)
        outward = at[0, 0] * [1.0, 1.0, 0.0]
        middle = outward / np.linalg.norm(outward) if surface.closed[1] else np.zeros(3)
        assert np.cross(by_u[0, 0], by_v[0, 0]) @ (at[0, 0] - middle) > 0.0


def test_an_exact_sphere_is_exact():
    radius, height = from_axis(exact_sphere(2.0, CENTER))
    assert_allclose(np.hypot(radius, height), 2.0, rtol=1e-14)


def test_rational_gaussians_have_no_poles():
    with pytest.raises(ValueError, match="poles"):
        sphere(families=("bspline", "rag"))


def test_a_bezier_tube_does_not_close():
    with pytest.raises(ValueError, match="never closed"):
        tube(families=("bezier", "bezier"))


@pytest.mark.parametrize("make", [sheet, tube, torus, sphere])
def test_a_body_somewhere_else_is_the_same_body(make):
    assert_array_equal(make().planes.automatic, make(center=CENTER).planes.automatic)
    assert_allclose(make(center=CENTER).at(T, T), make().at(T, T) + CENTER, atol=1e-12)
