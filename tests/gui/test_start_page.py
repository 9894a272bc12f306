"""The start page: examples, recent files, the live figure."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QPushButton

from plusedit.app.figure import CURVE, Figure
from plusedit.app.main import begin
from plusedit.app.start_page import MOST_ACROSS, words_of
from plusedit.resources import example_files
from plusedit.scene.theme import DARK

pytestmark = pytest.mark.gui


@pytest.fixture
def page(window):
    window.show_start_page()
    return window.start_page


def test_the_first_window_shows_the_start_page(window):
    assert window.stack.currentWidget() is window.start_page
    assert not window.docks.by_name["inspector"].isVisible()


def test_it_waits_in_white_for_a_file_that_was_asked_for_and_is_there_if_none_comes(page, window):
    page.set_blank(True)
    assert not any(button.isVisible() for button in page.findChildren(QPushButton))
    begin(window, [])
    assert all(button.isVisible() for button in page.findChildren(QPushButton))


def test_every_example_gets_a_picture_after_the_first_frame(qtbot, page):
    assert sorted(card.path for card in page._cards) == example_files()
    qtbot.waitUntil(lambda: page.figure is not None and not page._waiting, timeout=20_000)
    for card in page._cards:
        assert not card.picture.pixmap().isNull(), card.path


def test_an_example_is_opened_by_the_keyboard_too(qtbot, window, page):
    qtbot.keyClick(page._cards[0], Qt.Key.Key_Return)
    assert window.files.path == page._cards[0].path


def test_new_curve_puts_the_pen_on_an_empty_canvas(qtbot, window, page):
    button = next(b for b in page.findChildren(QPushButton) if b.text() == "New curve")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert window.gestures.tool_name == "pen"
    assert window.stack.currentWidget() is window.panes
    assert window.docks.by_name["inspector"].isVisible()
    assert len(window.session.design) == 0


def test_recent_files_are_listed_while_they_exist(window, document, tmp_path):
    gone = tmp_path / "gone.json"
    window.settings.recent = [gone, document]
    window.show_start_page()
    links = [b.text() for b in window.start_page.findChildren(QPushButton) if b.property("link")]
    assert links == ["bow.json"]


def test_escape_goes_back_to_a_design_that_is_open(qtbot, opened):
    opened.show_start_page()
    qtbot.keyClick(opened, Qt.Key.Key_Escape)
    assert opened.stack.currentWidget() is opened.panes


def test_the_s_of_the_figure_is_dragged(qtbot):
    figure = Figure()
    qtbot.addWidget(figure)
    figure.set_theme(DARK)
    figure.show()
    before = figure.session.design.curve(CURVE).s
    slider = figure.slider
    start, end = (QPoint(round(slider._x(ratio)), 15) for ratio in (0.5, 1.25))
    qtbot.mousePress(slider, Qt.MouseButton.LeftButton, pos=start)
    qtbot.mouseMove(slider, end)
    assert figure.session.design.curve(CURVE).s == pytest.approx(2.5 * before, rel=0.01)
    qtbot.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=end)
    assert not figure.session.is_previewing
    qtbot.mouseDClick(slider, Qt.MouseButton.LeftButton, pos=end)
    assert figure.session.design.curve(CURVE).s == pytest.approx(before)


def test_names_of_files_become_words(tmp_path):
    assert words_of(tmp_path / "figure_1.plus.json") == "Figure 1"


def test_examples_end_where_the_figure_ends(qtbot, window, page):
    window.resize(1280, 820)
    qtbot.waitUntil(lambda: page.figure is not None)
    last = page._cards[MOST_ACROSS - 1]

    def right(widget):
        return widget.mapTo(page, widget.rect().topRight()).x()

    qtbot.waitUntil(lambda: right(last) == right(page.figure))
