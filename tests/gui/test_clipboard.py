"""Copy, cut and paste of shapes."""

import json

import numpy as np
import pytest
from numpy.testing import assert_allclose
from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from plusedit.app.clipboard import KIND
from plusedit.document.selection import Selection
from tests.designs import BOW, WING, a_design

pytestmark = pytest.mark.gui


@pytest.fixture
def filled(window):
    window.files.show(a_design(), None)
    window.session.select(Selection.of_shapes([WING]))
    return window


def points(window, shape_id):
    return window.session.design.curve(shape_id).lines.points


def set_text(text):
    QGuiApplication.clipboard().setText(text)


def test_what_is_copied_is_a_design_as_text(filled):
    filled.clipboard.copy()
    tree = json.loads(QGuiApplication.clipboard().text())
    assert [shape["id"] for shape in tree["shapes"]] == ["wing"]


def test_a_pasted_shape_has_an_id_of_its_own_and_lies_beside(filled):
    filled.clipboard.copy()
    filled.clipboard.paste()
    (new,) = set(filled.session.design) - {WING, BOW}
    step = 2.0 * filled.gestures.grid_step
    assert_allclose(points(filled, new), points(filled, WING) + np.array([step, -step]))
    assert filled.session.selection == Selection.of_shapes([new])


def test_pasting_again_goes_further_away(filled):
    filled.clipboard.copy()
    filled.clipboard.paste()
    filled.clipboard.paste()
    step = 2.0 * filled.gestures.grid_step
    last = list(filled.session.design)[-1]
    assert_allclose(points(filled, last), points(filled, WING) + 2.0 * np.array([step, -step]))
    assert len(filled.session.design) == 4


def test_what_was_cut_is_pasted_where_it_was(filled):
    before = points(filled, WING).copy()
    filled.clipboard.cut()
    assert WING not in filled.session.design
    filled.clipboard.paste()
    assert_allclose(points(filled, WING), before)


def test_the_text_of_another_window_is_pasted_in_place(filled):
    filled.clipboard.copy()
    data = QMimeData()
    data.setData(KIND, QGuiApplication.clipboard().mimeData().data(KIND))
    filled.clipboard.copy()
    before = points(filled, WING).copy()
    filled.files.new()
    QGuiApplication.clipboard().setMimeData(data)
    filled.clipboard._pasted = ""
    filled.clipboard.paste()
    assert_allclose(points(filled, WING), before)


@pytest.mark.parametrize("text", ["", "hello", "{}", '{"format": "plusedit-design"}', "[" * 5000])
def test_a_clipboard_without_shapes_is_passed_over_with_a_word(filled, text):
    before = filled.session.design
    set_text(text)
    filled.clipboard.paste()
    assert filled.session.design is before
    assert "clipboard" in filled.status.text.text()


def test_copying_nothing_leaves_the_clipboard_as_it_was(filled):
    set_text("precious")
    filled.session.select(Selection())
    assert not filled.clipboard.copy()
    assert QGuiApplication.clipboard().text() == "precious"


def test_pasting_says_how_many_shapes_came(filled):
    filled.clipboard.copy()
    filled.clipboard.paste()
    assert filled.status.text.text() == "Pasted 1 shape."


def test_what_was_copied_outlives_the_window_as_text(filled):
    filled.clipboard.copy()
    text = QGuiApplication.clipboard().text()
    filled.session.mark_saved()
    assert filled.close()
    data = QGuiApplication.clipboard().mimeData()
    assert data.text() == text
    assert not data.hasFormat(KIND)
