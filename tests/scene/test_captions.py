"""Where captions lie, and what they say."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plusedit.scene.camera import PlaneCamera
from plusedit.scene.captions import clear_of_legends, in_corners, placed_caption, stacked
from plusedit.scene.items import Caption, Legend, Row
from plusedit.scene.legends import MARGIN
from plusedit.scene.svg_picture import svg_of
from plusedit.scene.theme import DARK, LIGHT

SIZE = (800.0, 600.0)
ROWS = (Row("length", "12.5 units"), Row("bending energy", "0.25 / unit", "plus"), Row("none"))


def a_caption(title="Curve", rows=ROWS):
    return Caption(title, rows)


@given(st.floats(50.0, 2000.0), st.floats(40.0, 2000.0), st.integers(0, 12), st.booleans())
def test_a_caption_is_whole_within_the_picture(width, height, count, titled):
    placed = placed_caption(a_caption("Title" * titled, ROWS[:1] * count), (width, height))
    if placed is None:
        return
    left, top, wide, high = placed.box
    assert left >= MARGIN and top >= MARGIN
    assert left + wide <= width - MARGIN and top + high <= height - MARGIN + 1e-9
    for word in placed.words:
        assert left < word.x < left + wide
        assert top < word.y - 0.7 * word.size and word.y < top + high


@pytest.mark.parametrize(("width", "count"), [(800.0, 2), (300.0, 0)])
def test_captions_leave_legends_free(width, count):
    legend = Legend("Mean curvature", "1 / unit", ("#000000", "#FFFFFF"), ((0.0, "0"), (1.0, "3")))
    shown = [*clear_of_legends([legend, *stacked([a_caption()] * 2)], (width, 600.0))]
    assert shown[0] is legend
    assert len(shown) == 1 + count


def test_there_is_none_where_it_would_not_fit():
    assert placed_caption(a_caption(), (90.0, 600.0)) is None
    assert placed_caption(a_caption(), (800.0, 60.0)) is None


def test_captions_stand_one_upon_the_other_by_their_titles():
    boxes = [
        placed_caption(caption, SIZE).box
        for caption in stacked([a_caption("C"), a_caption("A", ROWS[:1]), a_caption("B")])
    ]
    assert [box[0] for box in boxes] == [MARGIN] * 3
    for lower, upper in pairwise(boxes):
        assert upper[1] + upper[3] < lower[1]
    assert boxes[0][3] < boxes[1][3] == boxes[2][3]


@pytest.mark.parametrize(("width", "is_there"), [(900.0, True), (400.0, False)])
def test_many_captions_are_all_there_where_they_leave_most_of_the_width_free(width, is_there):
    highest = stacked([a_caption()] * 4)[-1]
    assert (placed_caption(highest, (width, 330.0)) is not None) == is_there


def test_what_is_beside_rulers_stays_beside_them():
    (caption,) = stacked([a_caption()], 22.0)
    assert placed_caption(caption, SIZE).box[0] == MARGIN + 22.0


def test_numbers_stand_at_the_right_edge_and_colors_before_the_words():
    placed = placed_caption(a_caption(), SIZE)
    numbers = [word for word in placed.words if word.anchor == "right"]
    assert [word.text for word in numbers] == ["12.5 units", "0.25 / unit"]
    assert len({word.x for word in numbers}) == 1
    ((_, right, _, color),) = placed.samples
    assert color == "plus"
    assert all(word.x > right for word in placed.words[1:])


def test_of_several_legends_one_is_shown():
    legends = [Legend(title, "", ("#000000", "#FFFFFF"), ()) for title in "AB"]
    shown = in_corners([legends[0], a_caption(), legends[1]])
    assert [type(item) for item in shown] == [Legend, Caption]
    assert shown[0] is legends[0]


@pytest.mark.parametrize("theme", [LIGHT, DARK])
def test_an_svg_picture_has_its_words(theme):
    picture = svg_of([a_caption()], PlaneCamera(SIZE), theme).decode()
    for text in ("Curve", "length", "12.5 units", theme.color("plus")):
        assert text in picture
