import pytest
from PySide6.QtGui import QTextDocument
from PySide6.QtWidgets import QApplication

from plusedit.document.selection import Selection
from plusedit.views.panels import fit_comparison

pytestmark = pytest.mark.gui


@pytest.fixture
def panel(opened, monkeypatch):
    monkeypatch.setattr(fit_comparison, "SIZES_OF_CURVES", (4, 6))
    monkeypatch.setattr(fit_comparison, "SIZES_OF_SURFACES", (3, 4))
    opened.docks.toggle("fit_comparison")
    return opened.docks.widget("fit_comparison")


def select(window, kind):
    shapes = window.session.design.shapes.items()
    shape_id = next(i for i, shape in shapes if getattr(shape, kind) is not None)
    window.session.select(Selection.of_shapes([shape_id]))
    return shape_id


def made(qtbot, panel):
    qtbot.waitUntil(lambda: not panel.run.is_running, timeout=60_000)
    return panel.run.fits


@pytest.mark.parametrize("kind", ["curve", "surface", "mesh"])
def test_the_selected_shape_is_come_near_to_by_every_family(qtbot, opened, panel, kind):
    select(opened, kind)
    assert panel.compare() == ""
    fits = made(qtbot, panel)
    assert len(fits) == 8
    assert all(len(plot.plot.lines) == 4 for plot in panel.plots.values())
    assert "B-spline+" in panel.numbers.text()


def test_no_number_of_the_legend_is_cut(qtbot, opened, panel):
    select(opened, "curve")
    panel.compare()
    made(qtbot, panel)
    QApplication.processEvents()
    text = QTextDocument()
    text.setDefaultFont(panel.numbers.font())
    text.setHtml(panel.numbers.text().replace("width=100%", ""))
    assert text.idealWidth() <= panel.numbers.contentsRect().width()


def test_known_points_need_no_selection(qtbot, panel):
    panel._choose_source("Franke's hills")
    assert panel.compare() == ""
    assert {fit.elements for fit in made(qtbot, panel)} == {9, 16}


def test_without_a_selection_it_says_what_to_do(opened, panel):
    opened.session.select(Selection())
    assert panel.compare()
    assert not panel.run.is_running


def test_cancelled_it_keeps_what_was_made(qtbot, opened, panel):
    select(opened, "curve")
    panel.compare()
    qtbot.waitUntil(lambda: len(panel.run.fits) > 0, timeout=60_000)
    panel.start.click()
    assert not panel.run.is_running
    assert panel.start.text() == "Compare"
    assert panel.run.fits


def test_a_fit_at_the_cursor_is_added_in_one_step(qtbot, opened, panel):
    select(opened, "curve")
    panel.compare()
    made(qtbot, panel)
    before = len(opened.session.design)
    panel.plots["elements"].moved.emit(4.1)
    panel._fill_menu()
    chosen = panel.add.menu().actions()[-1]
    assert chosen.text().startswith("B-spline+ of 4")
    chosen.trigger()
    assert len(opened.session.design) == before + 1
    opened.undo()
    assert len(opened.session.design) == before


def test_largest_distances_are_shown_instead(qtbot, panel):
    panel._choose_source("Wave")
    panel.compare()
    made(qtbot, panel)
    before = panel.plots["elements"].plot.lines[0].y
    panel._choose_measure("largest")
    assert (panel.plots["elements"].plot.lines[0].y > before).all()
