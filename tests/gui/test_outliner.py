"""The Shapes panel: names, eyes, locks, order and selection."""

import pytest
from PySide6.QtCore import QItemSelectionModel, QPoint, Qt

from plusedit.document.selection import NOTHING_SELECTED, LineId, Selection
from plusedit.views.shape_rows import switch_place
from tests.designs import BOW, WING, a_design

pytestmark = pytest.mark.gui


@pytest.fixture
def outliner(window):
    window.files.show(a_design(), None)
    outliner = window.docks.widget("outliner")
    outliner.refresh()
    return outliner


def row_of(outliner, shape_id):
    return outliner.model.index(outliner.model.ids.index(shape_id))


def click_switch(qtbot, outliner, shape_id, switch):
    row = outliner.list.visualRect(row_of(outliner, shape_id))
    at = switch_place(row, switch).center()
    qtbot.mouseClick(outliner.list.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(at))


def test_the_shape_in_front_stands_on_top(outliner):
    assert outliner.model.ids == [BOW, WING]
    assert outliner.model.data(row_of(outliner, BOW)) == "Bow"


def test_an_eye_hides_and_a_lock_locks_without_selecting(qtbot, window, outliner):
    click_switch(qtbot, outliner, WING, "eye")
    click_switch(qtbot, outliner, BOW, "lock")
    design = window.session.design
    assert (design[WING].visible, design[BOW].locked) == (False, True)
    assert window.session.selection == NOTHING_SELECTED
    click_switch(qtbot, outliner, WING, "eye")
    assert window.session.design[WING].visible


def test_the_eye_of_one_selected_shape_hides_all_selected(qtbot, window, outliner):
    window.session.select(Selection.of_shapes([WING, BOW]))
    outliner.refresh()
    click_switch(qtbot, outliner, WING, "eye")
    assert not any(shape.visible for shape in window.session.design.shapes.values())
    assert window.session.undo_label is not None


def test_selecting_a_row_selects_the_shape(window, outliner):
    flag = QItemSelectionModel.SelectionFlag.ClearAndSelect
    outliner.list.selectionModel().select(row_of(outliner, WING), flag)
    assert window.session.selection == Selection.of_shapes([WING])


def test_selecting_in_the_view_selects_the_row_and_keeps_the_lines(window, outliner):
    lines = Selection.of_lines([LineId(BOW, 1)])
    window.session.select(lines)
    outliner.refresh()
    assert outliner.list.chosen() == (BOW,)
    assert window.session.selection == lines


def test_renaming_in_place_is_one_step(window, outliner):
    assert outliner.model.setData(row_of(outliner, BOW), "Stern")
    assert window.session.design[BOW].name == "Stern"
    assert not outliner.model.setData(row_of(outliner, BOW), "  ")
    window.session.undo()
    assert window.session.design[BOW].name == "Bow"


def test_dragging_a_row_below_another_draws_it_behind(window, outliner):
    data = outliner.model.mimeData([row_of(outliner, BOW)])
    from PySide6.QtCore import QModelIndex

    outliner.model.dropMimeData(data, Qt.DropAction.MoveAction, 2, 0, QModelIndex())
    assert list(window.session.design) == [BOW, WING]
    outliner.refresh()
    assert outliner.model.ids == [WING, BOW]


def test_delete_takes_the_selected_shapes(qtbot, window, outliner):
    window.session.select(Selection.of_shapes([BOW]))
    outliner.refresh()
    outliner.list.setFocus()
    qtbot.keyClick(outliner.list, Qt.Key.Key_Delete)
    assert list(window.session.design) == [WING]


def test_the_kinds_of_shapes_are_told(opened):
    outliner = opened.docks.widget("outliner")
    outliner.refresh()
    tips = [
        outliner.model.data(outliner.model.index(row), Qt.ItemDataRole.ToolTipRole)
        for row in range(outliner.model.rowCount())
    ]
    assert "sail: tube of 2 × 3 control planes" in tips
    assert "knee: mesh of 2 faces" in tips
    assert not outliner.grab().isNull()


def test_an_empty_design_says_how_to_begin(window):
    window.show_view()
    outliner = window.docks.widget("outliner")
    outliner.refresh()
    assert "Press P" in outliner._stack.currentWidget().text()
