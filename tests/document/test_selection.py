"""Selections: lines, shapes, and what an edit acts on."""

import numpy as np

from plusedit.document.selection import NOTHING_SELECTED, LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from tests.designs import BOW, WING, a_curve
from tests.scene.meshes import HILL, a_landscape

FIRST, SECOND, OTHER = LineId(WING, 0), LineId(WING, 1), LineId(BOW, 2)


def test_the_shapes_of_selected_lines_are_selected():
    assert Selection.of_lines([FIRST, OTHER]).shapes == {WING, BOW}


def test_a_single_line_is_active():
    assert Selection.of_lines([FIRST]).active == FIRST
    assert Selection.of_lines([FIRST, SECOND]).active is None


def test_the_active_line_is_one_of_the_selected():
    assert Selection.of_lines([FIRST, SECOND], OTHER).active is None
    assert Selection.of_lines([FIRST, SECOND], SECOND).active == SECOND


def test_nothing_selected_is_false():
    assert not NOTHING_SELECTED
    assert Selection.of_shapes([WING])


def test_toggling_twice_selects_the_same_lines():
    selection = Selection.of_lines([FIRST])
    assert selection.toggled(SECOND).active == SECOND
    assert selection.toggled(SECOND).toggled(SECOND).lines == selection.lines


def test_a_line_that_is_taken_out_leaves_its_shape_selected():
    assert Selection.of_lines([FIRST]).toggled(FIRST) == Selection.of_shapes([WING])


def test_a_shape_is_taken_out_with_its_lines():
    selection = Selection.of_lines([FIRST, SECOND, OTHER])
    assert selection.toggled_shape(WING) == Selection(frozenset({OTHER}))
    assert selection.toggled_shape(WING).toggled_shape(WING).shapes == {WING, BOW}


def test_two_selections_together_hold_the_lines_of_both():
    both = Selection.of_lines([FIRST]) | Selection.of_lines([OTHER])
    assert both.lines == {FIRST, OTHER}
    assert both.active == OTHER


def test_lines_by_shape_rise():
    lines = [LineId(WING, i) for i in (3, 0, 2)]
    assert Selection.of_lines(lines).by_shape() == {WING: (0, 2, 3)}


def test_an_edit_acts_on_the_selected_lines_and_on_all_of_a_shape_without_any(design):
    selection = Selection.of_lines([SECOND]) | Selection.of_shapes([BOW])
    assert selection.targets(design) == {WING: (1,), BOW: (0, 1, 2)}


def test_an_edit_acts_on_no_locked_or_hidden_shape(design):
    selection = Selection.of_shapes([WING, BOW])
    locked = design.with_shape(WING, Shape(a_curve(), "wing", locked=True))
    assert set(selection.targets(locked)) == {BOW}
    hidden = design.with_shape(WING, Shape(a_curve(), "wing", visible=False))
    assert set(selection.targets(hidden)) == {BOW}


def test_a_selection_is_cut_to_what_there_is(design):
    gone = Selection.of_lines([FIRST, LineId(WING, 4), LineId(ShapeId("sail"), 0)])
    assert gone.cut_to(design) == Selection(frozenset({FIRST}))


def test_a_selection_that_is_all_there_is_cut_to_itself(design):
    selection = Selection.of_lines([FIRST, OTHER])
    assert selection.cut_to(design) is selection


def test_renumbered_lines_are_the_same_lines_under_other_numbers():
    selection = Selection.of_lines([FIRST, SECOND, OTHER], SECOND)
    after = selection.renumbered({WING: np.array([3, 1, 2])})
    assert after == Selection.of_lines([LineId(WING, 1), OTHER], LineId(WING, 1))


def test_of_lines_that_are_gone_none_is_active_under_the_number_of_another():
    selection = Selection.of_lines([FIRST, SECOND], FIRST)
    after = selection.renumbered({WING: np.array([1, 2])})
    assert after.lines == {LineId(WING, 0)} and after.active is None


FACE = LineId(HILL, 7)


def test_faces_of_a_mesh_are_selected_as_control_planes_are():
    design = a_landscape()
    assert Selection.of_lines([FACE]).targets(design) == {HILL: (7,)}
    assert Selection.of_lines([FACE]).cut_to(design).lines == {FACE}
    assert Selection.of_lines([FACE, LineId(HILL, 36)]).cut_to(design).lines == {FACE}


def test_a_mesh_without_selected_faces_is_meant_as_a_whole():
    assert Selection.of_shapes([HILL]).targets(a_landscape()) == {HILL: ()}


def test_the_active_line_leads_else_the_first():
    assert Selection.of_lines([FIRST, SECOND], SECOND).leading == SECOND
    assert Selection.of_lines([SECOND, FIRST]).leading == FIRST
    assert NOTHING_SELECTED.leading is None
