"""Where legends lie, and what they say."""

from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plusedit.scene.items import Legend
from plusedit.scene.legends import AXES, MARGIN, placed

SIZES = [(1400.0, 900.0), (700.0, 820.0), (420.0, 300.0), (300.0, 220.0), (260.0, 170.0)]


def a_legend(ticks=7, **changes):
    shares = tuple((k / (ticks - 1), f"0.{k}5") for k in range(ticks))
    whole = {"title": "Deviation", "unit": "% of the size", "colors": ("#000000", "#FFFFFF")}
    return Legend(**{**whole, "ticks": shares, **changes})


def corners(box):
    left, top, width, height = box
    return left, top, left + width, top + height


def overlap(one, other):
    (a, b, c, d), (e, f, g, h) = corners(one), corners(other)
    return a < g and e < c and b < h and f < d


@given(st.floats(120.0, 3000.0), st.floats(100.0, 3000.0), st.sampled_from([2, 3, 6, 7]))
def test_a_legend_is_whole_within_the_picture_beside_the_axes(width, height, ticks):
    legend = placed(a_legend(ticks, is_open=(True, True)), (width, height))
    if legend is None:
        return
    left, top, right, bottom = corners(legend.box)
    assert left >= MARGIN
    assert top >= MARGIN - 1e-9
    assert right <= width - MARGIN + 1e-9
    assert bottom <= height - MARGIN + 1e-9
    assert not overlap(legend.box, (width - AXES, 0.0, AXES, AXES)) or width < 2.5 * AXES


@pytest.mark.parametrize("size", SIZES)
def test_there_is_a_legend_in_small_panes_too(size):
    assert placed(a_legend(), size) is not None


@pytest.mark.parametrize("size", [(60.0, 900.0), (1400.0, 90.0), (160.0, 120.0)])
def test_there_is_none_where_it_would_not_fit(size):
    assert placed(a_legend(), size) is None


@pytest.mark.parametrize("size", SIZES)
def test_numbers_stand_beside_their_ticks_and_clear_of_each_other(size):
    legend = placed(a_legend(), size)
    numbers = [word for word in legend.words if word.text.startswith("0.")]
    assert len(numbers) == len(legend.ticks) >= 2
    for word, (_, right, y) in zip(numbers, legend.ticks, strict=True):
        assert word.x > right
        assert abs(word.y - word.size * 0.36 - y) < 1e-9
    for one, other in combinations(numbers, 2):
        assert abs(one.y - other.y) >= one.size


def test_high_values_are_on_top():
    legend = placed(a_legend(2), SIZES[0])
    (low, high) = [word.y for word in legend.words if word.text.startswith("0.")]
    assert high < low
    _, top, _, length = legend.bar
    assert [y for *_, y in legend.ticks] == [top + length, top]


def test_the_title_stands_over_the_unit_and_all_words_are_within_the_box():
    legend = placed(a_legend(), SIZES[0])
    assert [word.text for word in legend.words[:2]] == ["Deviation", "% of the size"]
    assert legend.words[0].y < legend.words[1].y
    left, top, right, bottom = corners(legend.box)
    for word in legend.words:
        assert left < word.x < right
        assert top < word.y - 0.7 * word.size
        assert word.y < bottom


def test_a_legend_without_a_unit_leaves_no_line_for_it():
    assert placed(a_legend(unit=""), SIZES[0]).box[3] < placed(a_legend(), SIZES[0]).box[3]


def test_open_ends_have_tips_beyond_the_bar():
    legend = placed(a_legend(is_open=(True, True)), SIZES[0])
    _, top, _, length = legend.bar
    low, high = legend.tips
    assert max(y for _, y in low) > top + length
    assert min(y for _, y in high) < top
    assert placed(a_legend(), SIZES[0]).tips == ((), ())
