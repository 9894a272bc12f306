"""Sums typed into number fields."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plusedit.views.arithmetic import calculated, compact, written


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2*3+1", 7.0),
        (" 1,5 ", 1.5),
        ("-(2 - 5) / 2", 1.5),
        ("2^3", 8.0),
        ("sqrt(2)/2", math.sqrt(2.0) / 2.0),
        ("sin(30)", 0.5),
        ("−1e-3", -1e-3),
        ("tau/2", math.pi),
    ],
)
def test_sums_come_to_a_number(text, value):
    assert calculated(text) == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize(
    "text",
    ["", "abc", "1 2", "__import__('os')", "x.y", "[1]", "True", "1/0", "1e999", "9**9**9**9",
     "sqrt(-1)", "(-8)^0.5", "(" * 150, "1" * 500, "lambda: 1", "sin(1, 2)", "1 if 2 else 3"],
)  # fmt: skip
def test_anything_else_is_refused_with_a_reason(text):
    with pytest.raises(ValueError, match=r"\w+ \w+"):
        calculated(text)


@given(st.text(max_size=30))
def test_no_text_does_worse_than_being_refused(text):
    try:
        assert math.isfinite(calculated(text))
    except ValueError as refusal:
        assert str(refusal)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_what_is_written_in_full_reads_back_as_the_same_number(value):
    assert calculated(written(value, 17)) == value


def test_no_number_is_written_as_minus_zero():
    assert written(-0.0) == "0"
    assert written(-1e-300, 3) == "-1e-300"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (-0.087921, "−0.0879"),
        (0.087921, "0.08792"),
        (-12345.6, "−12346"),
        (-0.00012345, "−0.0001"),
        (0.000012345, "1.2e−5"),
        (1.5e6, "1.5e6"),
        (-1.23456e12, "−1.2e12"),
        (0.0, "0"),
        (-12.0, "−12"),
    ],
)
def test_a_number_that_would_be_too_long_has_fewer_digits(value, text):
    assert compact(value, 7) == text


@pytest.mark.parametrize("power", range(-99, 100))
def test_a_compact_number_is_short_and_read_as_about_the_same(power):
    for digits in (1.0, -1.2345, 9.996, -9.5):
        value = digits * 10.0**power
        text = compact(value, 7)
        assert len(text) <= 7
        assert calculated(text) == pytest.approx(value, rel=0.25)
