import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_array_equal

from plusedit.interaction.snapping import along_axis, along_longer, decimals, to_grid


def test_snapped_coordinates_are_short_decimals():
    assert_array_equal(to_grid(np.array([0.31, 0.69, -1.1001]), 0.1), [0.3, 0.7, -1.1])


@settings(max_examples=50)
@given(st.floats(-1e6, 1e6), st.sampled_from([0.001, 0.25, 0.1, 1.0, 5.0, 0.3]))
def test_the_nearest_multiple_is_no_farther_than_half_a_step(value, step):
    (snapped,) = to_grid(np.array([value]), step)
    assert abs(snapped - value) <= step / 2 * (1 + 1e-6)
    assert abs(snapped / step - round(snapped / step)) < 1e-6


def test_snapping_gives_no_negative_zero():
    assert not np.signbit(to_grid(np.array([-0.01, -0.2]), 1.0)).any()


def test_an_axis_keeps_one_component():
    vector = np.array([1.0, -2.0, 3.0])
    assert_array_equal(along_axis(vector, "y"), [0.0, -2.0, 0.0])
    assert_array_equal(along_axis(vector, None), vector)
    assert_array_equal(along_axis(vector[:2], "z"), [0.0, 0.0])
    assert_array_equal(along_longer(vector), [0.0, 0.0, 3.0])


@pytest.mark.parametrize("pixel, places", [(0.01, 2), (0.02, 2), (0.005, 3), (1.0, 0), (50.0, 0)])
def test_as_many_decimals_as_tell_pixels_apart(pixel, places):
    assert decimals(pixel) == places
