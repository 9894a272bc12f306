"""Docks around the view: as many side by side as have room, the others as tabs."""

import pytest
from PySide6.QtWidgets import QApplication, QLabel, QTabBar

from plusedit.views.panels import panels

pytestmark = pytest.mark.gui

BELOW = [name for name in panels if panels[name].area == "below"]


@pytest.fixture
def crowded(opened):
    """The window with every panel below the views open."""
    opened.resize(1280, 720)
    for name in BELOW:
        opened.docks.toggle(name)
        QApplication.processEvents()
    QApplication.processEvents()
    return opened


def in_sight(window):
    docks = [window.docks.by_name[name] for name in BELOW]
    return [dock for dock in docks if not dock.visibleRegion().isEmpty()]


def test_no_panel_below_the_views_is_too_narrow_to_read(crowded):
    for dock in in_sight(crowded):
        assert dock.width() >= panels[dock.objectName()].least_width


def test_all_of_the_window_stays_in_sight(crowded):
    right = crowded.docks.by_name["inspector"]
    assert crowded.rect().contains(right.geometry())


def test_the_newest_panel_lies_in_front(crowded):
    assert crowded.docks.by_name[BELOW[-1]] in in_sight(crowded)


def test_what_another_tab_covers_comes_to_the_front_before_it_is_hidden(crowded):
    covered = next(name for name in BELOW if crowded.docks.by_name[name] not in in_sight(crowded))
    crowded.docks.toggle(covered)
    QApplication.processEvents()
    assert crowded.docks.by_name[covered] in in_sight(crowded)
    crowded.docks.toggle(covered)
    assert crowded.docks.by_name[covered].isHidden()


def test_two_lie_side_by_side_where_there_is_room(opened):
    opened.resize(1600, 900)
    for name in BELOW[:2]:
        opened.docks.toggle(name)
        QApplication.processEvents()
    assert len(in_sight(opened)) == 2


def test_a_panel_beside_the_views_leaves_those_below_legible(opened):
    opened.resize(1400, 860)
    for name in (*BELOW[:2], "parameters"):
        opened.docks.toggle(name)
        QApplication.processEvents()
    QApplication.processEvents()
    assert len(in_sight(opened)) == 1


def test_a_title_stands_once(crowded):
    tabs = {bar.tabText(i) for bar in crowded.findChildren(QTabBar) for i in range(bar.count())}
    for dock in in_sight(crowded):
        assert (dock.windowTitle() in tabs) != isinstance(dock.titleBarWidget(), QLabel)


def test_a_panel_beside_the_views_takes_its_room_from_them_alone(crowded):
    crowded.resize(1500, 860)
    QApplication.processEvents()
    sides = [crowded.docks.by_name[name] for name in ("outliner", "inspector")]
    before = [side.width() for side in sides]
    crowded.docks.toggle("parameters")
    QApplication.processEvents()
    assert [side.width() for side in sides] == before


def test_the_view_takes_the_keys_of_a_panel_that_is_hidden(opened):
    trigger = opened.actions_table["panel.fit_comparison"].trigger
    trigger()
    opened.docks.widget("fit_comparison").start.setFocus()
    trigger()
    assert opened.focusWidget() is opened.canvas
