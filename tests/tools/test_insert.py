import numpy as np
from numpy.testing import assert_allclose

from plusedit.document.selection import LineId
from tests.interaction.hand import EMPTY, WAVE, Hand

PARAMETERS = np.linspace(0.0, 1.0, 33)


def test_a_click_inserts_a_line_that_is_selected_and_keeps_the_shape():
    hand = Hand(tool="insert")
    before = hand.curve()
    hand.click(before.at([0.3])[0])
    assert len(hand.points()) == 6
    assert_allclose(hand.curve().at(PARAMETERS), before.at(PARAMETERS), atol=1e-9)
    assert len(hand.numbers) == 1
    assert hand.session.undo_label == "Insert control line"


def test_hovering_shows_where_on_the_nearest_curve():
    hand = Hand(tool="insert")
    place = hand.curve().at([0.3])[0]
    hand.gestures.move(hand.at(place + 0.05))
    (ring,) = hand.said.items
    assert np.linalg.norm(ring.points[0] - place) < 0.1
    hand.gestures.move(hand.at(EMPTY))
    assert hand.said.items == ()


def test_the_selected_numbers_of_other_lines_are_not_kept():
    hand = Hand(tool="insert")
    hand.select(4)
    hand.click(hand.curve().at([0.3])[0])
    (number,) = hand.numbers
    assert hand.session.selection.active == LineId(WAVE, number)


def test_a_drag_inserts_and_moves_in_one_step():
    hand = Hand(tool="insert")
    before = hand.session.design
    place = hand.curve().at([0.3])[0]
    hand.drag(place, np.add(place, 0.5), moves=10)
    assert len(hand.points()) == 6
    hand.session.undo()
    assert hand.session.design is before


def test_a_click_far_from_curves_does_nothing():
    hand = Hand(tool="insert")
    before = hand.session.design
    hand.click(EMPTY)
    hand.drag(EMPTY, (0.0, 3.9))
    assert hand.session.design is before
