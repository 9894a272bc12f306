"""Roots between places where the signs of a function differ."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.roots import roots

FUNCTIONS = {
    "a cubic": lambda u: (u - 0.3) * (u**2 + 1.0),
    "flat at its root": lambda u: (u - 0.3) ** 9,
    "steep at an end": lambda u: np.expm1(60.0 * (u - 0.3)),
    "a wave": lambda u: np.sin(7.0 * (u - 0.3)) * (2.0 + u),
}


def counted(function, ends):
    """The roots, and how often the function was asked."""
    calls = []

    def asked(u):
        calls.append(len(u))
        return function(u)

    low, high = (np.atleast_1d(np.asarray(end, dtype=float)) for end in ends)
    return roots(asked, (low, high), (function(low), function(high))), len(calls)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_root_is_found_to_the_last_digits(name):
    found, asked = counted(FUNCTIONS[name], (0.05, 0.7))
    # Nine times as flat, its values vanish in rounding before its root is reached.
    assert_allclose(found, 0.3, rtol=0.0, atol=1e-14 if name != "flat at its root" else 1e-9)
    assert asked <= 60


def test_it_is_asked_for_a_smooth_function_a_few_times_only():
    assert counted(FUNCTIONS["a cubic"], (0.05, 0.7))[1] <= 12


@given(st.lists(st.floats(0.01, 0.99), min_size=1, max_size=20))
def test_many_roots_are_found_at_once(places):
    at = np.array(places)
    ends = np.zeros(len(at)), np.ones(len(at))
    one = [counted(lambda u, a=a: np.tanh(3.0 * (u - a)), (0.0, 1.0))[0][0] for a in places]
    # Asked for all of them, the function does not know which root is meant: a saw has them all.
    step = np.arange(len(at), dtype=float)

    def saw(u):
        return np.tanh(3.0 * (u - np.floor(u) - at[np.floor(u).astype(int)]))

    many = roots(saw, (ends[0] + step, np.nextafter(ends[1] + step, 0.0)), (-at, 1.0 - at))
    assert_allclose(many - step, at, atol=1e-13)
    assert_allclose(one, at, atol=1e-14)


@given(st.floats(0.01, 0.99))
def test_a_jump_across_zero_is_found_between_two_numbers(place):
    found, _ = counted(lambda u: np.where(u < place, -1.0, 3.0), (0.0, 1.0))
    assert abs(found[0] - place) <= 4.0 * np.spacing(place)


def test_ends_next_to_each_other_are_the_second_of_them():
    low = np.nextafter(0.5, 0.0)
    found = roots(np.sign, (np.array([low]), np.array([0.5])), (np.array([-1.0]), np.array([1.0])))
    assert_array_equal(found, [0.5])


def test_there_may_be_none():
    none = np.zeros(0)
    assert len(roots(np.sin, (none, none), (none, none))) == 0
