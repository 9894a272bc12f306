import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.scene.graduation import APART, graduation

zooms = st.floats(-8.0, 8.0).map(lambda power: 10.0**power)


@given(zooms)
def test_major_lines_stand_apart_but_not_much_more(pixel):
    spacing = graduation(pixel).major / pixel
    assert APART * (1.0 - 1e-6) <= spacing <= 2.5 * APART * (1.0 + 1e-6)


@given(zooms)
def test_steps_begin_with_1_2_or_5(pixel):
    marks = graduation(pixel)
    for step in (marks.major, marks.minor):
        digits = f"{step:.3e}"
        assert digits[:5] in ("1.000", "2.000", "5.000")


@given(zooms, st.floats(-100.0, 100.0))
def test_all_lines_in_sight_are_there_once(pixel, center):
    marks = graduation(pixel)
    low, high = center - 300.0 * pixel, center + 300.0 * pixel
    lines = np.sort(np.concatenate(marks.between(low, high)))
    assert lines[0] <= low + 1e-9 * abs(low)
    assert lines[-1] >= high - 1e-9 * abs(high)
    assert_allclose(np.diff(lines), marks.minor, rtol=1e-3)


@pytest.mark.parametrize(
    ("pixel", "value", "text"),
    [
        (0.01, 3.0, "3"),
        (0.01, -3.0, "\N{MINUS SIGN}3"),
        (0.001, 0.3, "0.3"),
        (0.001, 3.0, "3.0"),
        (0.01, -1e-17, "0"),
        (1e-4, 0.25, "0.25"),
        (1e7, 2e9, "2e+09"),
    ],
)
def test_numbers_have_the_digits_that_the_step_asks_for(pixel, value, text):
    assert graduation(pixel).text(value) == text


@given(zooms)
def test_neighboring_numbers_differ(pixel):
    marks = graduation(pixel)
    majors, _ = marks.between(-500.0 * pixel, 500.0 * pixel)
    texts = [marks.text(value) for value in majors]
    assert len(set(texts)) == len(texts)
