"""What menus let shapes keep."""

import numpy as np
import pytest

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.constraints import Wish, constraints
from plusedit.geometry.keeping import holds
from plusedit.interaction.actions import edit_actions
from plusedit.interaction.constraint_actions import TITLES
from tests.geometry.surfaces import a_surface
from tests.interaction.hand import BOW, EMPTY, WAVE, Hand

ACTIONS = {action.name: action for action in edit_actions()}


def perform(hand, name):
    hand.gestures.perform_by(lambda: ACTIONS[name].make(hand.gestures.stage()))


def wishes(hand, shape=WAVE):
    return set(hand.session.design[shape].constraints)


def test_every_constraint_has_an_action():
    assert set(TITLES) == set(constraints)


def test_an_action_sets_a_constraint_and_the_same_again_releases_it():
    hand = Hand()
    hand.session.select(Selection.of_shapes([WAVE]))
    perform(hand, "keep_tangent_start")
    assert wishes(hand) == {Wish("tangent_start")}
    perform(hand, "keep_tangent_start")
    assert wishes(hand) == set()


def test_points_that_are_passed_are_the_selected_ones_and_stay_so_through_a_drag():
    hand = Hand()
    hand.select(1, 3)
    perform(hand, "keep_passing")
    assert wishes(hand) == {Wish("passing", (1, 3))}
    hand.session.select(Selection())
    hand.drag(hand.points()[1], hand.points()[1] + 0.4, moves=5)
    assert holds(hand.curve(), Wish("passing", (1, 3)))


def test_a_whole_shape_passes_through_all_of_its_points():
    hand = Hand()
    hand.session.select(Selection.of_shapes([WAVE]))
    perform(hand, "keep_passing")
    assert wishes(hand) == {Wish("passing", (0, 1, 2, 3, 4))}


def test_corners_are_those_among_the_selected_planes():
    sheet = ShapeId("sheet")
    hand = Hand(Design({sheet: Shape(a_surface(5, 5), "Sheet")}))
    hand.session.select(Selection.of_lines([LineId(sheet, 0), LineId(sheet, 24)]))
    perform(hand, "keep_corner_tangency")
    assert wishes(hand, sheet) == {Wish("corner_tangency", (0, 3))}


def test_what_cannot_be_kept_is_told_in_a_sentence():
    hand = Hand()
    before = hand.session.design
    hand.session.select(Selection.of_shapes([BOW]))
    perform(hand, "keep_smooth_closing")
    assert "insert some" in hand.errors[-1]
    perform(hand, "keep_corner_tangency")
    assert "Tangent at corners" in hand.errors[-1]
    perform(hand, "release_constraints")
    assert "no constraints" in hand.errors[-1]
    assert hand.session.design is before


def test_all_are_released_at_once():
    hand = Hand()
    hand.select(2)
    for name in ("keep_tangent_start", "keep_tangent_end", "keep_passing"):
        perform(hand, name)
    assert len(wishes(hand)) == 3
    perform(hand, "release_constraints")
    assert wishes(hand) == set()
    hand.session.undo()
    assert len(wishes(hand)) == 3


@pytest.mark.parametrize("moves", [1, 7])
def test_a_drag_given_up_leaves_constraints_as_they_were(moves):
    hand = Hand()
    hand.select(2)
    perform(hand, "keep_passing")
    before = hand.session.design
    hand.hold(hand.points()[2], EMPTY, moves=moves)
    hand.gestures.cancel()
    assert hand.session.design is before
    assert np.isfinite(hand.curve().at([0.5])).all()
