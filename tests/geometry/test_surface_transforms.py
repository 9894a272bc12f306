"""Surfaces transformed as wholes, reversed and transposed."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.surface_transforms import (
    reversed_numbers,
    reversed_surface,
    transformed_surface,
    transposed,
    transposed_numbers,
)
from tests.geometry.surfaces import PAIRS, a_surface, random_surface, surfaces

every_pair = pytest.mark.parametrize(("kind_u", "kind_v"), PAIRS)
every_way = pytest.mark.parametrize("way", ["u", "v"])
U, V = np.linspace(-0.3, 1.3, 23), np.linspace(-0.2, 1.4, 19)
OFFSET = np.array([7.0, -2.0, 3.0])


def turned(angle, scale=1.0):
    c, s = np.cos(angle), np.sin(angle)
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
    return scale * about_x @ np.roll(about_x, (1, 1), (0, 1))


def assert_same_planes(first, second):
    for name in ("points", "given", "automatic", "weights"):
        assert_array_equal(getattr(first, name), getattr(second, name))


@every_pair
@pytest.mark.parametrize("contrast", [None, 20.0])
@pytest.mark.parametrize(
    "matrix",
    [turned(0.7), turned(2.0, 30.0), np.diag([1.0, 1.0, -1.0]), turned(1.0) + np.eye(3, k=1)],
    ids=["turn", "turn and scale", "mirror", "shear"],
)
def test_the_image_of_the_planes_draws_the_image_of_the_surface(kind_u, kind_v, contrast, matrix):
    surface = random_surface(kind_u, kind_v, contrast=contrast)
    image = transformed_surface(surface, matrix, OFFSET)
    assert_allclose(image.at(U, V), surface.at(U, V) @ matrix.T + OFFSET, atol=1e-11)


@given(surfaces(), st.lists(st.floats(-1e3, 1e3), min_size=12, max_size=12))
@settings(max_examples=30, deadline=None)
def test_any_affine_map_is_exact(surface, numbers):
    matrix, offset = np.reshape(numbers[:9], (3, 3)), np.array(numbers[9:])
    image = transformed_surface(surface, matrix, offset)
    expected = surface.at(U, V) @ matrix.T + offset
    assert_allclose(image.at(U, V), expected, atol=1e-11 * (1.0 + np.abs(numbers).max()))


def test_automatic_directions_stay_automatic_where_all_lengths_scale_alike():
    surface = a_surface(s=2.0)
    image = transformed_surface(surface, turned(0.4, 10.0))
    assert image.planes.automatic.all()
    assert image.s == pytest.approx(20.0)


def test_a_shear_makes_every_direction_a_given_one_and_leaves_s():
    image = transformed_surface(a_surface(s=2.0), np.eye(3) + np.eye(3, k=1))
    assert not image.planes.automatic.any()
    assert image.s == 2.0


def test_a_matrix_for_another_dimension_is_refused():
    with pytest.raises(ValueError, match="matrix: expected shape"):
        transformed_surface(a_surface(), np.eye(2))


@given(surfaces())
@settings(max_examples=50, deadline=None)
def test_the_transposed_surface_has_its_parameters_swapped(surface):
    swapped = transposed(surface)
    assert_allclose(swapped.at(V, U), np.swapaxes(surface.at(U, V), 0, 1), atol=1e-12)
    assert_same_planes(transposed(swapped).planes, surface.planes)
    assert transposed(swapped).bases == surface.bases


@given(surfaces())
@settings(max_examples=50, deadline=None)
def test_the_reversed_surface_runs_the_other_way(surface):
    by_u, by_v = reversed_surface(surface, "u"), reversed_surface(surface, "v")
    assert_allclose(by_u.at(U, V), surface.at(1.0 - U, V), atol=1e-10)
    assert_allclose(by_v.at(U, V), surface.at(U, 1.0 - V), atol=1e-10)


@every_pair
@every_way
def test_reversed_twice_the_planes_are_the_same(kind_u, kind_v, way):
    surface = random_surface(kind_u, kind_v, contrast=2.0)
    back = reversed_surface(reversed_surface(surface, way), way)
    assert_same_planes(back.planes, surface.planes)


@every_pair
@every_way
def test_the_numbers_say_which_plane_went_where(kind_u, kind_v, way):
    surface = random_surface(kind_u, kind_v)
    old = surface.planes
    for made, numbers in (
        (reversed_surface(surface, way), reversed_numbers(surface, way)),
        (transposed(surface), transposed_numbers(surface)),
    ):
        assert_array_equal(made.planes.control_points, old.control_points[numbers])
