import numpy as np
import pytest

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline, uniform_knots
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevated
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.storage import StandardForm, Storage, storage
from plusedit.geometry.surface_elevation import elevated_surface
from tests.geometry.surfaces import a_surface, random_surface
from tests.scene.meshes import a_hill

POINTS = np.random.default_rng(5).random((5, 2))


def stored(basis, directions=None, weights=None, s=1.0):
    return storage(PlusCurve(basis, ControlLines.of(POINTS, directions, weights), s))


def test_a_classical_curve_is_its_points():
    assert stored(BSpline(5, 4), s=0.0).numbers == 10


def test_automatic_directions_cost_nothing_but_s():
    assert stored(BSpline(5, 4)).numbers == 11


def test_given_directions_cost_as_much_as_points():
    assert stored(BSpline(5, 4), [None, [1.0, 0.0], None, [0.0, 1.0], None]).numbers == 15


def test_weights_cost_one_number_each():
    assert stored(BSpline(5, 4), weights=np.ones(5)).numbers == 16


def test_knots_cost_something_where_they_are_given():
    knots = tuple(uniform_knots(5, 4).tolist())
    assert stored(BSpline(5, 4, knots=knots)).numbers == 11 + 9


@pytest.mark.parametrize(("sigma", "numbers"), [(0.1, 12), ((0.1,) * 5, 16)])
def test_widths_of_gaussians_cost_something(sigma, numbers):
    found = stored(RationalGaussian(5, sigma))
    assert found == Storage(None, 5, numbers, None)


def test_the_standard_form_of_five_lines_is_a_bezier_curve_of_six_points():
    found = stored(Bernstein(5))
    assert (found.degrees, found.elements) == ((4,), 5)
    assert found.form == StandardForm((5,), 6, 12)


def test_that_of_a_b_spline_has_every_knot_once_more():
    found = stored(BSpline(5, 3))
    form = elevated(PlusCurve(BSpline(5, 3), ControlLines.of(POINTS), 1.0))
    assert found.form == StandardForm((3,), len(form.points), form.points.size + len(form.knots))


def test_planes_have_two_directions():
    surface = random_surface("bezier", "bezier", shape=(4, 5), given=2.0)
    found = storage(surface)
    assert (found.degrees, found.elements) == ((3, 4), 20)
    assert found.numbers == 3 * 3 * 20 + 1
    assert found.form == StandardForm((4, 5), 30, 90)


def test_a_surface_of_b_splines_counts_its_form_both_ways():
    surface = a_surface(6, 7)
    form = elevated_surface(surface)
    found = storage(surface)
    assert found.numbers == 6 * 7 * 3 + 1
    numbers = form.points.size + len(form.knots_u) + len(form.knots_v)
    assert found.form == StandardForm((4, 4), form.points.shape[0] * form.points.shape[1], numbers)


def test_a_mesh_is_its_vertices_and_the_parameters_of_its_corners():
    hill = a_hill()
    found = storage(hill)
    assert found.elements == hill.mesh.face_count
    assert found.numbers == hill.mesh.vertices.size + hill.parameters.size + 2
    assert storage(hill.with_plane(0, point=[0.0, 0.0, 1.0])).numbers == found.numbers + 3
