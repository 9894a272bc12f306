"""The table of control lines."""

import pytest
from numpy.testing import assert_allclose
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from plusedit.commands.lines import SetCoordinate
from plusedit.commands.shapes import Rename
from plusedit.document.selection import LineId
from plusedit.views.arithmetic import calculated
from tests.designs import BOW, WING, a_design

pytestmark = pytest.mark.gui

COLUMNS = {"line": 0, "x": 1, "y": 2, "angle": 3, "length": 4, "auto": 5, "weight": 6}


@pytest.fixture
def panel(window):
    window.files.show(a_design(), None)
    panel = window.docks.widget("lines_table")
    panel.refresh()
    return panel


def cell(panel, row, column):
    return panel.model.index(row, COLUMNS[column])


def test_every_line_of_every_curve_has_a_row(panel):
    assert panel.model.rows == [*(LineId(WING, i) for i in range(4)),
                                *(LineId(BOW, i) for i in range(3))]  # fmt: skip
    assert panel.model.data(cell(panel, 1, "line")) == "wing 2"
    assert panel.model.data(cell(panel, 1, "angle")) == "53.13"


def test_a_cell_takes_a_sum(window, panel):
    assert panel.model.setData(cell(panel, 1, "x"), "3/2")
    assert window.session.design.curve(WING).lines.points[1, 0] == 1.5
    assert panel.model.setData(cell(panel, 6, "weight"), "2")
    assert_allclose(window.session.design.curve(BOW).lines.weights, [1, 1, 2])
    assert panel.model.setData(cell(panel, 0, "angle"), "0")
    assert_allclose(window.session.design.curve(WING).directions[0], [1.0, 0.0])
    assert panel.model.setData(cell(panel, 0, "length"), "4")
    assert_allclose(window.session.design.curve(WING).directions[0], [4.0, 0.0])


def test_what_is_no_number_leaves_the_cell_and_says_why(window, panel):
    before = window.session.design
    assert not panel.model.setData(cell(panel, 1, "x"), "wide")
    assert window.session.design is before
    assert "wide" in window.status.text.text()


def test_opening_a_cell_and_leaving_it_edits_nothing(window, panel):
    before = window.session.design
    index = cell(panel, 1, "angle")
    panel.model.setData(index, panel.model.data(index, Qt.ItemDataRole.EditRole))
    assert window.session.design is before


def test_the_check_box_makes_a_direction_automatic_and_keeps_it_again(window, panel):
    index, role = cell(panel, 1, "auto"), Qt.ItemDataRole.CheckStateRole
    panel.model.setData(index, Qt.CheckState.Checked, role)
    assert window.session.design.curve(WING).lines.automatic[1]
    panel.model.setData(index, Qt.CheckState.Unchecked, role)
    assert not window.session.design.curve(WING).lines.automatic[1]


def test_rows_and_selection_are_one(window, panel):
    panel.table.selectRow(2)
    assert window.session.selection.lines == {LineId(WING, 2)}
    from tests.gui.conftest import select_lines

    select_lines(window, BOW, 0, 2)
    panel.refresh()
    rows = {index.row() for index in panel.table.selectionModel().selectedRows()}
    assert rows == {4, 6}


def test_a_space_curve_brings_a_column_for_z(opened):
    panel = opened.docks.widget("lines_table")
    panel.refresh()
    heads = [
        panel.model.headerData(i, Qt.Orientation.Horizontal)
        for i in range(panel.model.columnCount())
    ]
    assert heads[:4] == ["Line", "x", "y", "z"]
    wing_z = panel.model.index(0, 3)
    assert panel.model.data(wing_z) == ""


def test_a_drag_repaints_cells_without_making_rows_anew(window, panel):
    from plusedit.commands.lines import SetCoordinate

    resets = []
    panel.model.modelReset.connect(lambda: resets.append(1))
    window.session.preview(SetCoordinate({WING: (1,)}, 0, 9.0))
    panel.refresh()
    assert panel.model.data(cell(panel, 1, "x")) == "9"
    assert resets == []


def test_a_longer_name_gets_a_wider_column(window, panel):
    before = panel.table.columnWidth(0)
    window.desk.commit(Rename(WING, "a much longer name than before"))
    panel.refresh()
    assert panel.table.columnWidth(0) > before


def test_place_and_angle_of_plane_curves_are_in_sight_from_the_start(window):
    window.files.show(a_design(), None)
    window.resize(1280, 800)
    panel = window.docks.widget("lines_table")
    panel.refresh()
    QApplication.processEvents()
    header, model = panel.table.horizontalHeader(), panel.model
    heads = [model.headerData(i, Qt.Orientation.Horizontal) for i in range(model.columnCount())]
    angle = next(place for place, head in enumerate(heads) if head.startswith("Angle"))
    right = header.sectionPosition(angle) + header.sectionSize(angle)
    assert right <= panel.table.viewport().width()


@pytest.mark.parametrize(
    "value", [-0.76251, -0.087921, -123456.7, -1.23456e-7, 1.23456e11, -0.5, 12.0]
)
def test_every_number_has_room_in_its_cell_and_is_edited_in_full(panel, value):
    panel.desk.commit(SetCoordinate({WING: (1,)}, 0, value))
    cell = panel.model.index(1, COLUMNS["x"])
    shown, edited = panel.model.data(cell), panel.model.data(cell, Qt.ItemDataRole.EditRole)
    assert panel.table.sizeHintForIndex(cell).width() <= panel.table.columnWidth(COLUMNS["x"])
    assert float(edited) == value
    assert calculated(shown) == pytest.approx(value, rel=0.25)
    assert "-" not in shown
