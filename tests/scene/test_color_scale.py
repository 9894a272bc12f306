"""Scales of colors: even, told apart by everyone, with round numbers beside them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.scene.color_scale import SCALES, UNKNOWN, ColorScale, Span, oklab_of, rgb_of
from plusedit.scene.theme import THEMES, contrast

every_scale = pytest.mark.parametrize("name", list(SCALES))
SHARES = np.linspace(0.0, 1.0, 65)

# Machado, Oliveira and Fernandes (2009), severity 1: what eyes without one kind of cones see.
BLINDNESS = {
    "protanopia": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    "deuteranopia": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    "tritanopia": [
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ],
}


def linear(rgb):
    return np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)


def lightness(rgb):
    """(n,) L* of CIELAB, which knows nothing of the space that the scales are made in."""
    luminance = linear(rgb.astype(float)) @ [0.2126, 0.7152, 0.0722]
    return np.where(luminance > 0.008856, 116.0 * np.cbrt(luminance) - 16.0, 903.3 * luminance)


def seen_by(kind, rgb):
    """(n, 3) colors as they are seen with that color-blindness."""
    seen = np.clip(linear(rgb.astype(float)) @ np.array(BLINDNESS[kind]).T, 0.0, 1.0)
    return np.where(seen <= 0.0031308, 12.92 * seen, 1.055 * seen ** (1.0 / 2.4) - 0.055)


def apart(rgb):
    """(n - 1,) how different each color looks from the next."""
    return np.linalg.norm(np.diff(oklab_of(rgb.astype(float)), axis=0), axis=1)


@every_scale
def test_steps_along_a_scale_look_alike(name):
    steps = apart(SCALES[name].at(SHARES))
    assert steps.min() > 0.8 * steps.max()


def test_lightness_rises_all_along_the_sequential_scale():
    steps = np.diff(lightness(SCALES["sequential"].at(SHARES)))
    assert (steps > 0.0).all()
    assert steps.min() > 0.4 * steps.max()


def test_the_diverging_scale_is_light_in_the_middle_and_as_dark_at_both_ends():
    light = lightness(SCALES["diverging"].at(SHARES))
    assert (np.diff(light[:33]) > 0.0).all()
    assert (np.diff(light[32:]) < 0.0).all()
    assert light[0] == pytest.approx(light[-1], abs=6.0)


@every_scale
@pytest.mark.parametrize("kind", list(BLINDNESS))
def test_colors_far_apart_on_a_scale_are_so_for_the_color_blind_too(name, kind):
    seen = oklab_of(seen_by(kind, SCALES[name].at(np.linspace(0.0, 1.0, 9))))
    differences = np.linalg.norm(seen[:, None] - seen[None], axis=-1)
    assert differences[~np.eye(9, dtype=bool)].min() > 0.045


@every_scale
@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
def test_a_scale_is_seen_on_every_canvas_but_for_its_palest_part(name, theme):
    canvas = theme.color("canvas")
    seen = [contrast(color, canvas) >= 1.5 for color in SCALES[name].hexadecimal(20)]
    assert sum(seen) >= 14


@every_scale
def test_values_beyond_a_scale_have_the_colors_of_its_ends(name):
    scale = SCALES[name]
    found = scale.at(np.array([-5.0, 0.0, 1.0, 7.0, np.inf, -np.inf]))
    assert_array_equal(found[[0, 3, 4, 5]], found[[1, 2, 2, 1]])
    assert found.dtype == np.float32


@every_scale
def test_what_is_no_number_is_gray(name):
    assert_allclose(SCALES[name].at(np.array([0.3, np.nan]))[1], UNKNOWN, atol=1e-6)


def test_values_of_a_grid_become_colors_of_a_grid():
    assert SCALES["sequential"].at(np.zeros((4, 7))).shape == (4, 7, 3)


def test_a_scale_runs_through_its_colors():
    scale = ColorScale(("#102030", "#405060", "#F0E0D0"), is_diverging=True)
    assert scale.hexadecimal(3) == ("#102030", "#405060", "#F0E0D0")
    assert SCALES["sequential"].hexadecimal(2) == ("#3F3C8E", "#F7E874")


@given(st.tuples(*[st.floats(0.0, 1.0)] * 3))
def test_colors_come_back_from_oklab(rgb):
    there = oklab_of(np.array([rgb]))
    assert_allclose(rgb_of(there)[0], rgb, atol=1e-5)


@given(st.floats(-1e6, 1e6), st.floats(1e-2, 1e7))
def test_ticks_are_few_round_and_within_the_span(low, width):
    span = Span(low, low + width)
    ticks = span.ticks()
    assert len(ticks) <= 7
    for value, _ in ticks:
        assert span.low - 1e-6 * width <= value <= span.high + 1e-6 * width
    steps = np.diff([value for value, _ in ticks])
    assert_allclose(steps, steps[0] if len(steps) else 0.0, rtol=1e-6)


@pytest.mark.parametrize("high", [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 0.02, 3000.0])
def test_scales_that_end_at_round_numbers_have_ticks_at_both_ends(high):
    values = [value for value, _ in Span(0.0, high).ticks()]
    assert_allclose(values[0], 0.0, atol=1e-12)
    assert_allclose(values[-1], high)
    assert len(values) >= 4


def test_numbers_are_written_with_as_many_digits_as_the_step_has():
    assert [text for _, text in Span(0.0, 0.2).ticks()] == ["0", "0.05", "0.10", "0.15", "0.20"]
    minus = "\N{MINUS SIGN}"
    assert [text for _, text in Span(-2.0, 2.0).ticks()] == [
        f"{minus}2",
        f"{minus}1",
        "0",
        "1",
        "2",
    ]


def test_shares_run_from_zero_to_one():
    assert_allclose(Span(-1.0, 3.0).shares(np.array([-1.0, 0.0, 3.0, 5.0])), [0.0, 0.25, 1.0, 1.5])
