"""The table of what shapes are made of."""

import pytest

from plusedit.document.selection import Selection
from plusedit.scene.shape_account import account_of

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
