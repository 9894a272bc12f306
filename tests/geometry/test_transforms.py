"""Curves transformed as wholes, and reversed."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.transforms import reversed_curve, reversed_rows, transformed
from tests.geometry.curves import KINDS, random_curve

every_kind = pytest.mark.parametrize("kind", KINDS)
U = np.linspace(-0.3, 1.3, 97)
OFFSET = np.array([7.0, -2.0])


def turned(angle, scale=1.0):
    c, s = scale * np.cos(angle), scale * np.sin(angle)
    return np.array([[c, -s], [s, c]])


@every_kind
@pytest.mark.parametrize("contrast", [None, 20.0])
@pytest.mark.parametrize(
    "matrix",
    [turned(0.7), turned(2.0, 30.0), turned(1.0) @ np.diag([1.0, -1.0]), [[1.0, 5.0], [0.1, 0.0]]],
    ids=["turn", "turn and scale", "mirror", "shear"],
)
def test_the_image_of_the_lines_draws_the_image_of_the_curve(kind, contrast, matrix):
    curve = random_curve(kind, contrast=contrast)
    image = transformed(curve, matrix, OFFSET)
    assert_allclose(image.at(U), curve.at(U) @ np.transpose(matrix) + OFFSET, atol=1e-12)


@given(st.lists(st.floats(-1e3, 1e3), min_size=6, max_size=6))
@settings(max_examples=30, deadline=None)
def test_any_affine_map_is_exact(numbers):
    matrix, offset = np.reshape(numbers[:4], (2, 2)), np.array(numbers[4:])
    curve = random_curve("bspline", s=2.0)
    image = transformed(curve, matrix, offset)
    expected = curve.at(U) @ matrix.T + offset
    assert_allclose(image.at(U), expected, atol=1e-12 * (1.0 + np.abs(numbers).max()))


def test_automatic_directions_stay_automatic_where_all_lengths_scale_alike():
    curve = random_curve("bspline", s=2.0)
    image = transformed(curve, turned(0.4, 10.0))
    assert_array_equal(image.lines.automatic, curve.lines.automatic)
    assert image.s == pytest.approx(20.0)


def test_a_shear_makes_every_direction_a_given_one_and_leaves_s():
    curve = random_curve("bspline", s=2.0)
    image = transformed(curve, [[1.0, 0.5], [0.0, 1.0]])
    assert not image.lines.automatic.any()
    assert image.s == 2.0


def test_a_plane_curve_can_be_put_into_space():
    curve = random_curve("bezier")
    image = transformed(curve, [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]], [0.0, 0.0, 5.0])
    assert_allclose(image.at(U), np.column_stack([curve.at(U), np.full(len(U), 5.0)]))


def test_a_curve_can_be_pressed_onto_a_point():
    assert_allclose(transformed(random_curve("rag"), np.zeros((2, 2)), OFFSET).at(U), [OFFSET] * 97)


def test_a_matrix_for_another_dimension_is_refused():
    with pytest.raises(ValueError, match="matrix: expected shape"):
        transformed(random_curve("rag"), np.eye(3))


@every_kind
@pytest.mark.parametrize("contrast", [None, 20.0])
def test_the_reversed_curve_runs_the_other_way(kind, contrast):
    curve = random_curve(kind, contrast=contrast)
    assert_allclose(reversed_curve(curve).at(U), curve.at(1.0 - U), atol=1e-11)


@pytest.mark.parametrize("first", [0.0, 0.03])
def test_a_closed_curve_with_nodes_of_its_own_runs_the_other_way(first):
    curve = random_curve("closed rag", size=4)
    nodes = (first, 0.2, 0.6, 0.9)
    curve = replace(curve, basis=RationalGaussian(4, (0.1, 0.2, 0.15, 0.3), True, nodes))
    assert_allclose(reversed_curve(curve).at(U), curve.at(1.0 - U), atol=1e-12)


@every_kind
def test_automatic_directions_stay_automatic_in_reverse(kind):
    curve = random_curve(kind)
    there = reversed_curve(curve)
    assert_array_equal(there.lines.automatic, curve.lines.automatic[reversed_rows(curve.basis)])


@every_kind
def test_reversed_twice_the_lines_are_the_same(kind):
    curve = random_curve(kind, contrast=2.0)
    back = reversed_curve(reversed_curve(curve)).lines
    for name in ("points", "given", "automatic", "weights"):
        assert_array_equal(getattr(back, name), getattr(curve.lines, name))
