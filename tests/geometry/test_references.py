import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.references import REFERENCES, airfoil, sampled, sampled_mesh
from plusedit.geometry.surface_comparison import SampledSurface
from tests.geometry.curves import random_curve
from tests.geometry.surfaces import a_surface
from tests.scene.meshes import a_hill


@pytest.mark.parametrize("name", REFERENCES)
def test_points_are_finite_and_of_about_unit_size(name):
    found = REFERENCES[name]()
    points = found.points.reshape(-1, 3) if isinstance(found, SampledSurface) else found
    assert np.isfinite(points).all()
    assert 0.5 < np.ptp(points, axis=0).max() < 10.0


def test_points_of_the_airfoil_begin_and_end_at_its_trailing_edge():
    points = airfoil()
    assert_allclose(points[[0, -1]], [[1.0, 0.0], [1.0, 0.0]], atol=1e-3)
    # NACA 2412: at most 12 % thick, the camber 2 % at 40 % of the chord.
    assert_allclose(points[:, 1].max() - points[:, 1].min(), 0.12, atol=0.02)


def test_a_curve_is_sampled_from_its_beginning_to_its_end():
    curve = random_curve("bspline")
    assert_allclose(sampled(curve)[[0, -1]], curve.at([0.0, 1.0]), atol=1e-12)


def test_a_surface_is_sampled_at_its_parameters():
    surface = a_surface()
    found = sampled(surface)
    assert_allclose(found.points, surface.at(found.u, found.v))


def test_a_height_field_of_a_mesh_is_sampled_all_over():
    hill = a_hill()
    found = sampled_mesh(hill, 11)
    assert found.points.shape == (11, 11, 3)
    low, high = hill.parameters.min(axis=0), hill.parameters.max(axis=0)
    assert_allclose(found.points[[0, -1], [0, -1]], hill.at([low, high]), atol=1e-12)
