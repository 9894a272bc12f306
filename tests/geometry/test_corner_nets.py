"""What a plus surface cannot leave."""

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.corner_nets import (
    corner_hull,
    corner_nets,
    corner_surfaces,
    elevated_surface_hull,
    support_hull,
)
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from tests.geometry.bodies import outside, volume
from tests.geometry.curves import KINDS
from tests.geometry.surfaces import a_surface, random_surface, surfaces

OPEN = tuple(kind for kind in KINDS if not kind.startswith("closed"))
SPLINES = tuple(kind for kind in KINDS if "rag" not in kind and kind != "staircase")
U, V = np.linspace(0.0, 1.0, 37), np.linspace(0.0, 1.0, 41)


def size(surface):
    return np.abs(surface.planes.points).max() + np.abs(surface.gradients).max()


@given(surfaces(kinds=OPEN))
@settings(max_examples=50, deadline=None)
def test_the_surface_is_the_bilinear_mean_of_its_corner_surfaces(surface):
    first, second, third, fourth = (each.at(U, V) for each in corner_surfaces(surface))
    u, v = U[:, None, None], V[:, None]
    mean = (1 - u) * (1 - v) * first + u * (1 - v) * second + (1 - u) * v * third + u * v * fourth
    assert_allclose(mean, surface.at(U, V), atol=1e-13 * size(surface))


def test_at_its_node_a_plane_is_its_control_point():
    surface = a_surface()
    nets = corner_nets(surface)
    assert_allclose(nets[0, 0, 0], surface.planes.points[0, 0])
    assert_allclose(nets[1, -1, 0], surface.planes.points[-1, 0])
    assert_allclose(nets[2, 0, -1], surface.planes.points[0, -1])
    assert_allclose(nets[3, -1, -1], surface.planes.points[-1, -1])


@given(surfaces(kinds=(*SPLINES, "rag", "staircase")))
@settings(max_examples=60, deadline=None)
def test_the_surface_lies_in_the_hull_of_its_corner_nets(surface):
    points = surface.at(U, V).reshape(-1, 3)
    assert outside(corner_hull(surface), points) < 1e-11 * size(surface)
    assert outside(support_hull(surface), points) < 1e-11 * size(surface)


@given(surfaces(kinds=SPLINES))
@settings(max_examples=60, deadline=None)
def test_the_surface_lies_in_the_hull_of_its_elevated_points(surface):
    hull = elevated_surface_hull(surface)
    assert outside(hull, surface.at(U, V).reshape(-1, 3)) < 1e-11 * size(surface)


@pytest.mark.parametrize("kinds", [("bspline", "kinks"), ("closed", "bspline"), ("closed",) * 2])
def test_one_hull_is_tighter_than_the_other(kinds):
    surface = random_surface(*kinds, shape=(8, 8))
    volumes = [volume(hull(surface)) for hull in (corner_hull, support_hull, elevated_surface_hull)]
    assert volumes[0] >= volumes[1] * (1.0 - 1e-12) > volumes[2] > 0.0


def test_two_of_the_nets_are_not_enough():
    x, y = np.meshgrid(*[[0.0, 0.5, 1.0]] * 2, indexing="ij")
    planes = ControlPlanes.of(np.stack([x, y, 0.0 * x], axis=-1))
    gradients = np.zeros((2, 3, 3, 3))
    gradients[:, 1, 1, 2] = [1.0, -1.0]
    saddle = PlusSurface(Bernstein(3), Bernstein(3), planes.with_directions(gradients))
    points = saddle.at(U, V).reshape(-1, 3)
    for two in ([0, 3], [1, 2]):
        flat = np.ptp(corner_nets(saddle)[two].reshape(-1, 3)[:, 2]) == 0.0
        assert flat == (two == [0, 3])
    assert np.ptp(points[:, 2]) > 0.05


def test_a_flat_surface_has_a_flat_hull():
    surface = a_surface()
    flat = surface.with_net(surface.planes.with_points(surface.planes.points * [1.0, 1.0, 0.0]))
    hull = corner_hull(flat)
    assert volume(hull) == 0.0
    assert outside(hull, flat.at(U, V).reshape(-1, 3)) < 1e-12


def test_a_closed_surface_has_no_corner_nets():
    with pytest.raises(ValueError, match="no corner nets"):
        corner_nets(random_surface("closed", "bezier"))


def test_closed_gaussians_have_no_hull():
    with pytest.raises(ValueError, match="only closed B-splines have hulls"):
        corner_hull(random_surface("bezier", "closed rag"))
