"""The table of what shapes are made of."""

import pytest
from PySide6.QtWidgets import QApplication

from plusedit.document.selection import Selection
from plusedit.scene.shape_account import HEADS, account_of

pytestmark = pytest.mark.gui


@pytest.fixture
def panel(opened):
    opened.docks.toggle("comparison")
    panel = opened.docks.widget("comparison")
    panel.refresh()
    return panel


def rows(panel):
    table = panel.table
    return {
        table.verticalHeaderItem(row).text(): tuple(
            table.item(row, column).text() for column in range(table.columnCount())
        )
        for row in range(table.rowCount())
    }


def test_selected_shapes_stand_side_by_side(opened, panel):
    design = opened.session.design
    chosen = list(design)[:2]
    opened.session.select(Selection.of_shapes(chosen))
    panel.refresh()
    wanted = {design[i].name: account_of(design[i].geometry) for i in chosen}
    assert rows(panel) == wanted


def test_the_columns_have_room_beside_the_panels(opened, panel):
    opened.resize(1280, 820)
    spatial = [i for i, curve in opened.session.design.surfaces()]
    opened.session.select(Selection.of_shapes(spatial))
    panel.refresh()
    QApplication.processEvents()
    header, bar = panel.table.horizontalHeader(), panel.table.horizontalScrollBar()
    assert bar.maximum() == 0
    assert header.length() <= panel.table.viewport().width()


def test_all_ten_columns_need_less_than_800_pixels(opened, panel):
    plane = [i for i, curve in opened.session.design.curves() if curve.dimension == 2]
    opened.session.select(Selection.of_shapes(plane))
    panel.refresh()
    panel.resize(800, 200)
    QApplication.processEvents()
    table = panel.table
    assert not any(table.isColumnHidden(column) for column in range(table.columnCount()))
    assert table.verticalHeader().width() + table.horizontalHeader().length() <= 800


def test_a_column_that_tells_nothing_of_any_shape_is_not_there(opened, panel):
    surfaces = [i for i, _ in opened.session.design.surfaces()]
    opened.session.select(Selection.of_shapes(surfaces))
    panel.refresh()
    assert panel.table.isColumnHidden(HEADS.index("Inflections"))
    assert not panel.table.isColumnHidden(HEADS.index("Family"))


def test_it_follows_edits(opened, panel):
    shape_id = next(i for i, _ in opened.session.design.curves())
    opened.session.select(Selection.of_shapes([shape_id]))
    panel.refresh()
    before = rows(panel)
    shape = opened.session.design[shape_id]
    classical = shape.with_curve(shape.curve.classical)
    opened.session.open(opened.session.design.with_shape(shape_id, classical))
    opened.session.select(Selection.of_shapes([shape_id]))
    panel.refresh()
    assert rows(panel) != before
