"""Areas against closed forms and against many small triangles."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.length import arc_length
from plusedit.geometry.making.extrusion import extruded
from plusedit.geometry.making.primitives import exact_sphere, sheet
from plusedit.geometry.making.revolution import revolved
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.standard import elliptic_arc
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_area import area
from plusedit.geometry.surface_insertion import insert_column, insert_row
from plusedit.geometry.surface_transforms import (
    reversed_surface,
    transformed_surface,
    transposed,
)
from tests.geometry.curves import random_curve
from tests.geometry.surfaces import PAIRS, a_surface, random_surface

QUICK = [pair for pair in PAIRS if not any("rag" in kind or "stair" in kind for kind in pair)]


def of_triangles(surface, count):
    """The area of the triangles between that many points each way."""
    u = np.linspace(0.0, 1.0, count)
    points = surface.at(u, u)
    along, across = np.diff(points, axis=0), np.diff(points, axis=1)
    first = np.cross(along[:, :-1], across[:-1])
    second = np.cross(along[:, 1:], across[1:])
    return (np.linalg.norm(first, axis=2) + np.linalg.norm(second, axis=2)).sum() / 2.0


def extrapolated(surface, count=300):
    """The same for no end of triangles: the error falls with the square of their size."""
    coarse, fine = (of_triangles(surface, n) for n in (count + 1, 2 * count + 1))
    return (4.0 * fine - coarse) / 3.0


@pytest.mark.parametrize("radius", [1e-100, 0.1, 1.0, 30.0, 1e90])
def test_of_a_sphere(radius):
    assert_allclose(area(exact_sphere(radius)), 4.0 * np.pi * radius**2, rtol=1e-13)


def test_of_a_rectangle():
    assert_allclose(area(sheet(5, 4, size=(3.0, 2.0))), 6.0, rtol=1e-13)


def test_of_a_torus_by_the_theorem_of_pappus():
    ring = elliptic_arc((2.0, 0.0, 0.0), (0.5, 0.0, 0.0), (0.0, 0.0, 0.5))
    for angle in (2.0 * np.pi, 1.0):
        made = revolved(ring, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0), angle)
        assert_allclose(area(made), 2.0 * angle * np.pi, rtol=1e-12)


def test_of_a_curve_drawn_straight_out_of_its_plane_it_is_length_times_height():
    curve = random_curve("bspline", seed=2)
    assert isinstance(curve, PlusCurve)
    assert_allclose(area(extruded(curve, (0.0, 0.0, 3.0))), 3.0 * arc_length(curve), rtol=1e-9)


@pytest.mark.parametrize("pair", QUICK, ids="/".join)
def test_it_is_that_of_many_small_triangles(pair):
    surface = random_surface(*pair)
    assert_allclose(area(surface), extrapolated(surface), rtol=2e-4)


def test_of_a_gentle_surface_it_is_that_to_many_digits():
    surface = a_surface()
    assert_allclose(area(surface), extrapolated(surface, 400), rtol=1e-9)


def test_moving_turning_and_other_parameters_do_not_change_it():
    surface = replace(a_surface(6, 5), s=1.5)
    turn, _ = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))
    same = [
        transformed_surface(surface, turn, (5.0, -2.0, 1.0)),
        transposed(surface),
        reversed_surface(surface, "u"),
        insert_row(surface, 0.3)[0],
        insert_column(surface, 0.7)[0],
    ]
    for other in same:
        assert_allclose(area(other), area(surface), rtol=1e-12)


def test_it_grows_with_the_square_of_the_size():
    surface = random_surface()
    twice = transformed_surface(surface, 2.0 * np.eye(3), np.zeros(3))
    assert_allclose(area(twice), 4.0 * area(surface), rtol=1e-12)


def test_a_fold_counts_both_layers():
    points = np.zeros((3, 2, 3))
    points[:, :, 0] = np.array([0.0, 2.0, 0.0])[:, None]
    points[:, 1, 1] = 1.0
    basis_u, basis_v = a_surface(3, 2).bases
    # x = 4 u (1 - u) goes to 1 and back.
    surface = PlusSurface(basis_u, basis_v, ControlPlanes.of(points), 0.0)
    assert_allclose(area(surface), 2.0, rtol=1e-5)


def test_what_is_drawn_together_has_none():
    basis = a_surface(4, 4).basis_u
    for shape in ((1, 1), (4, 1), (1, 4)):
        points = np.broadcast_to(np.random.default_rng(0).normal(size=(*shape, 3)), (4, 4, 3))
        surface = PlusSurface(basis, basis, ControlPlanes.of(points), 0.0)
        assert area(surface) == pytest.approx(0.0, abs=1e-12)
