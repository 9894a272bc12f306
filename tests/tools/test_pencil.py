import numpy as np
import pytest

from plusedit.commands.fitting import Refit, fit_source
from plusedit.document.design import Design
from plusedit.io.formats.json_document import dumps, loads
from tests.interaction.hand import Hand


def wavy(count=60):
    x = np.linspace(-1.5, 3.5, count)
    return np.stack([x, 2.6 + 0.5 * np.sin(2.0 * x)], axis=1)


def ring(count=80):
    angles = np.linspace(0.0, 2.0 * np.pi, count)
    return np.stack([1.0 + np.cos(angles), 1.0 + np.sin(angles)], axis=1)


def drawn(places):
    hand = Hand(Design(), tool="pencil")
    hand.drag(*places)
    return hand


def the_shape(hand):
    (shape_id,) = hand.session.design
    return shape_id, hand.session.design[shape_id]


def test_a_stroke_becomes_a_curve_of_few_lines_within_two_pixels():
    hand = drawn(wavy())
    _, shape = the_shape(hand)
    away = shape.curve.at(np.linspace(0.0, 1.0, 400))
    nearest = [np.linalg.norm(away - place, axis=1).min() for place in wavy()]
    assert max(nearest) < 2.5 * hand.gestures.camera.pixel
    assert len(shape.curve.lines) < 20
    assert hand.session.undo_label == "Draw curve by hand"


def test_nothing_is_edited_before_the_button_is_let_go():
    hand = Hand(Design(), tool="pencil")
    before = hand.session.design
    hand.hold(*wavy())
    assert hand.session.design is before
    assert hand.said.items
    hand.gestures.key("Escape")
    hand.gestures.release(hand.at(wavy()[-1]))
    assert hand.session.design is before


def test_a_stroke_that_ends_where_it_began_is_closed():
    _, shape = the_shape(drawn(ring()))
    assert shape.curve.closed


@pytest.mark.parametrize("places", [[(0.0, 0.0)], [(0.0, 0.0), (0.04, 0.0)]])
def test_a_slip_of_the_hand_draws_nothing(places):
    hand = Hand(Design(), tool="pencil")
    hand.drag(*places)
    assert not len(hand.session.design)


def test_a_curve_is_fitted_again_to_its_stroke_even_from_a_file():
    hand = drawn(wavy())
    shape_id, _ = the_shape(hand)
    again = loads(dumps(hand.session.design), "a.json").design
    source = fit_source(again[shape_id])
    assert source is not None
    assert (source.points == fit_source(the_shape(hand)[1]).points).all()
    looser = type(source)(source.points, 20.0 * source.tolerance, source.closed, source.order)
    hand.session.commit(Refit(shape_id, looser))
    assert len(the_shape(hand)[1].curve.lines) < len(again.curve(shape_id).lines)
    assert hand.session.undo_label == "Fit curve"


@pytest.mark.parametrize(
    "kept",
    [
        "points",
        {},
        {"points": [[0, 0]], "tolerance": 1.0, "closed": False, "order": 4},
        {"points": [[0, 0], [1]], "tolerance": 1.0, "closed": False, "order": 4},
        {"points": [[0, 0], [1, 1]], "tolerance": -1.0, "closed": False, "order": 4},
        {"points": [[0, 0], [1, 1]], "tolerance": 1.0, "closed": 0, "order": 4},
        {"points": [[0, 0, 0], [1, 1, 1]], "tolerance": 1.0, "closed": False, "order": 4},
    ],
)
def test_a_source_that_makes_no_sense_is_none(kept):
    shape = the_shape(drawn(wavy()))[1]
    assert fit_source(type(shape)(shape.geometry, "A", extra={"fit": kept})) is None
