import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.magnitude import polygon_length
from plusedit.interaction.tool import Held, NewCurves
from plusedit.scene.items import Polyline
from tests.interaction.hand import Hand, design, wave

CORNERS = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (-1.0, 1.0)]


def pen(start=None, **new):
    hand = Hand(Design() if start is None else start, tool="pen")
    hand.gestures.new_curves = NewCurves(**new)
    return hand


def draw(hand, count):
    for place in CORNERS[:count]:
        hand.gestures.move(hand.at(place))
        hand.click(place)


def test_the_first_click_makes_nothing_the_second_a_curve():
    hand = pen()
    draw(hand, 1)
    assert len(hand.session.design) == 0
    draw_second = CORNERS[1]
    hand.click(draw_second)
    assert_allclose(hand.points("curve"), CORNERS[:2], atol=1e-12)
    assert hand.session.undo_label == "Draw curve"


def test_every_further_line_is_one_step():
    hand = pen()
    draw(hand, 5)
    for left in (4, 3, 2):
        hand.session.undo()
        assert len(hand.points("curve")) == left
    hand.session.undo()
    assert len(hand.session.design) == 0


@pytest.mark.parametrize("count, order", [(2, 2), (3, 3), (4, 4), (5, 4)])
def test_the_order_grows_with_the_lines_up_to_the_wanted_one(count, order):
    hand = pen(order=4)
    draw(hand, count)
    assert hand.curve("curve").basis == BSpline(count, order)


@pytest.mark.parametrize("family, kind", [("bezier", Bernstein), ("rag", RationalGaussian)])
def test_new_curves_are_of_the_chosen_family(family, kind):
    hand = pen(family=family)
    draw(hand, 4)
    assert isinstance(hand.curve("curve").basis, kind)


def test_s_stays_half_the_length_of_the_polygon_while_drawing():
    hand = pen()
    for count in (2, 3, 4, 5):
        hand.session.open(Design())
        hand.gestures.choose("pen")
        draw(hand, count)
        curve = hand.curve("curve")
        assert_allclose(curve.s, polygon_length(curve) / 2.0)


def test_a_drag_places_and_directs():
    hand = pen()
    hand.drag((0.0, 0.0), (0.0, 3.0), moves=10)
    hand.drag((2.0, 0.0), (2.5, 0.0), moves=10)
    assert_allclose(hand.points("curve"), [[0, 0], [2, 0]], atol=1e-12)
    assert_allclose(hand.directions("curve"), [[0, 1], [1, 0]], atol=1e-12)
    assert not hand.curve("curve").lines.automatic.any()
    hand.session.undo()
    assert len(hand.session.design) == 0


def test_with_alt_the_handle_is_as_long_as_it_was_drawn():
    hand = pen()
    hand.click((0.0, 0.0))
    hand.drag((2.0, 0.0), (2.0, 0.6), moves=10, held=Held.ALT)
    curve = hand.curve("curve")
    assert_allclose(curve.spacing * curve.gradients[1], [0.0, 0.6], atol=1e-12)


def test_escape_during_the_first_drag_forgets_it():
    hand = pen()
    hand.hold((0.0, 0.0), (0.0, 1.0))
    hand.gestures.key("Escape")
    hand.click((1.0, 1.0))
    assert len(hand.session.design) == 0


def test_escape_during_a_later_drag_goes_on_with_the_curve():
    hand = pen()
    draw(hand, 3)
    before = hand.session.design
    hand.hold((0.0, 2.0), (0.0, 3.0))
    hand.gestures.key("Escape")
    assert hand.session.design is before
    hand.click((0.0, 2.0))
    assert len(hand.points("curve")) == 4


def test_a_click_on_the_first_point_closes():
    hand = pen()
    draw(hand, 4)
    hand.gestures.move(hand.at((0.02, 0.02)))
    assert hand.said.hint == "Click to close the curve"
    hand.click((0.02, 0.02))
    curve = hand.curve("curve")
    assert curve.basis == BSpline(4, 4, closed=True)
    assert_allclose(curve.s, polygon_length(curve) / 2.0)
    assert hand.session.selection == Selection.of_shapes(["curve"])
    hand.session.undo()
    assert not hand.curve("curve").closed


def test_a_closed_curve_of_few_lines_has_the_wanted_order():
    hand = pen(order=5)
    draw(hand, 3)
    assert hand.gestures.key("C")
    assert hand.curve("curve").basis == BSpline(3, 5, closed=True)


def test_a_bezier_is_closed_smoothly():
    hand = pen(family="bezier")
    draw(hand, 4)
    hand.gestures.key("C")
    curve = hand.curve("curve")
    _, velocity = curve.derivatives([0.0, 1.0], highest=1)
    assert len(curve.lines) == 5
    assert_allclose(curve.at([0.0]), curve.at([1.0]), atol=1e-12)
    assert_allclose(velocity[0], velocity[1], atol=1e-9)


def test_two_lines_can_not_be_closed():
    hand = pen()
    draw(hand, 2)
    assert not hand.gestures.takes("C")


@pytest.mark.parametrize("key", ["Enter", "Escape"])
def test_a_key_ends_the_curve_and_the_next_click_begins_another(key):
    hand = pen()
    draw(hand, 3)
    assert hand.gestures.key(key)
    assert hand.session.selection == Selection.of_shapes(["curve"])
    hand.click((3.0, 3.0))
    hand.click((4.0, 3.0))
    assert [len(hand.points(i)) for i in hand.session.design] == [3, 2]
    names = [shape.name for shape in hand.session.design.shapes.values()]
    assert names == ["Curve", "Curve 2"]


def test_a_double_click_places_the_last_line_and_ends():
    hand = pen()
    draw(hand, 2)
    hand.double_click((2.0, 2.0))
    assert len(hand.points("curve")) == 3
    assert hand.session.selection == Selection.of_shapes(["curve"])


def test_ending_closes_where_new_curves_are_to_be_closed():
    hand = pen(closed=True)
    draw(hand, 4)
    hand.gestures.key("Enter")
    assert hand.curve("curve").closed


def test_backspace_takes_back_line_after_line_down_to_the_first_point():
    hand = pen()
    draw(hand, 3)
    for left in (2, 0):
        assert hand.gestures.key("Backspace")
        assert len(hand.points("curve") if left else hand.session.design) == left
    hand.click((5.0, 0.0))
    assert_allclose(hand.points("curve"), [[0, 0], [5, 0]], atol=1e-12)


def test_backspace_is_left_to_others_where_nothing_is_drawn():
    hand = pen()
    assert not hand.gestures.takes("Backspace")
    draw(hand, 1)
    assert hand.gestures.key("Backspace")
    assert not hand.gestures.takes("Backspace")


def test_undo_while_drawing_goes_on_from_the_line_before():
    hand = pen()
    draw(hand, 4)
    hand.session.undo()
    hand.click((5.0, 5.0))
    assert_allclose(hand.points("curve"), [*CORNERS[:3], (5, 5)], atol=1e-12)
    for _ in range(3):
        hand.session.undo()
    assert len(hand.session.design) == 0
    hand.click((5.0, 0.0))
    assert_allclose(hand.points("curve"), [[0, 0], [5, 0]], atol=1e-12)


def test_redo_while_drawing_goes_on_at_the_end():
    hand = pen()
    draw(hand, 4)
    hand.session.undo()
    hand.session.redo()
    hand.click((5.0, 5.0))
    assert_allclose(hand.points("curve")[-2:], [CORNERS[3], (5, 5)], atol=1e-12)


@pytest.mark.parametrize("end, place", [(0, 0), (4, 5)])
def test_a_curve_is_continued_at_the_end_that_is_selected(end, place):
    hand = pen(design(wave=wave()))
    hand.select(end)
    hand.click((2.0, 3.0))
    assert_allclose(hand.points()[place], [2.0, 3.0], atol=1e-12)
    assert hand.numbers == (place,)
    assert hand.curve().s == wave().s


def test_ctrl_places_on_the_grid():
    hand = pen()
    hand.gestures.grid_step = 0.5
    hand.click((0.1, 0.2), Held.CTRL)
    hand.click((1.6, 0.8), Held.CTRL)
    assert_array_equal(hand.points("curve"), [[0.0, 0.0], [1.5, 1.0]])


def test_shift_keeps_to_multiples_of_45_degrees():
    hand = pen()
    hand.click((0.0, 0.0))
    hand.click((2.0, 0.3), Held.SHIFT)
    hand.click((3.0, 1.2), Held.SHIFT)
    points = hand.points("curve")
    assert_allclose(points[1], [2.0, 0.0], atol=1e-12)
    way = points[2] - points[1]
    assert_allclose(way, [1.1, 1.1], atol=1e-12)
    assert way[0] == pytest.approx(way[1], abs=1e-15)


def test_the_curve_to_be_is_shown_while_hovering_and_never_enters_history():
    hand = pen()
    draw(hand, 3)
    before = hand.session.design
    hand.gestures.move(hand.at((1.0, 3.0)))
    shown = hand.said.items[0].points
    assert_allclose(shown[-1], [1.0, 3.0], atol=1e-12)
    assert hand.session.design is before and not hand.session.is_previewing


def test_every_placed_line_is_selected_alone():
    hand = pen()
    draw(hand, 4)
    assert hand.session.selection == Selection.of_lines([LineId("curve", 3)])


def test_another_tool_forgets_the_first_point():
    hand = pen()
    draw(hand, 1)
    hand.gestures.choose("select")
    hand.gestures.choose("pen")
    hand.click((3.0, 3.0))
    assert len(hand.session.design) == 0


def test_escape_with_nothing_drawn_goes_back_to_selecting():
    hand = pen()
    assert hand.gestures.key("Escape")
    assert hand.gestures.tool_name == "select"
    assert not hand.errors


def test_no_second_line_is_shown_where_the_last_was_just_placed():
    hand = pen()
    draw(hand, 3)
    feedback = []
    hand.gestures.feedback.listen(feedback.append)
    hand.gestures.move(hand.at(CORNERS[2]))
    lines = [item for item in feedback[-1].items if isinstance(item, Polyline)]
    assert all(item.color != "hover" for item in lines)
