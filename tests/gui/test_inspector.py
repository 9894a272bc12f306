"""The Inspector: numbers of the selection, each edit one undo step."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QLineEdit

from plusedit.document.selection import LineId, Selection
from plusedit.geometry.magnitude import polygon_length
from plusedit.views.fields import MIXED, Choice
from tests.designs import BOW, WING, a_design
from tests.gui.conftest import select_lines
from tests.gui.finding import named, type_into

pytestmark = pytest.mark.gui


@pytest.fixture
def inspector(window):
    window.files.show(a_design(), None)
    return window.docks.widget("inspector")


def points(window, shape_id=WING):
    return window.session.design.curve(shape_id).lines.points


def undo_steps(window):
    steps = 0
    while window.session.undo_label:
        window.session.undo()
        steps += 1
    return steps


def test_one_line_shows_its_numbers(window, inspector):
    select_lines(window, WING, 1)
    inspector.refresh()
    assert named(inspector, "x").text() == "1"
    assert named(inspector, "y").text() == "2"
    assert float(named(inspector, "angle").text()) == pytest.approx(53.1301, abs=1e-4)
    assert named(inspector, "length").text() == "1"
    assert named(inspector, "weight").text() == "1"
    assert not named(inspector, "automatic direction").isChecked()


def test_lines_that_differ_are_mixed_where_they_differ(window, inspector):
    select_lines(window, WING, 1, 2)
    inspector.refresh()
    x, y = named(inspector, "x"), named(inspector, "y")
    assert (x.text(), x.placeholderText()) == ("", MIXED)
    assert y.text() == "2"
    switch = named(inspector, "automatic direction", QCheckBox)
    assert switch.checkState() == Qt.CheckState.PartiallyChecked


def test_a_number_for_several_lines_is_one_step(qtbot, window, inspector):
    select_lines(window, WING, 1, 2)
    inspector.refresh()
    type_into(qtbot, named(inspector, "x"), "2*3+1")
    assert_allclose(points(window)[[1, 2], 0], 7.0)
    assert undo_steps(window) == 1


def test_lines_of_two_curves_are_edited_together(qtbot, window, inspector):
    window.session.select(Selection.of_lines([LineId(WING, 0), LineId(BOW, 0)]))
    inspector.refresh()
    type_into(qtbot, named(inspector, "y"), "5")
    assert points(window, WING)[0, 1] == points(window, BOW)[0, 1] == 5.0
    assert undo_steps(window) == 1


def test_an_angle_makes_the_direction_the_users(qtbot, window, inspector):
    select_lines(window, WING, 0)
    inspector.refresh()
    type_into(qtbot, named(inspector, "angle"), "90")
    curve = window.session.design.curve(WING)
    assert_allclose(curve.directions[0], [0.0, 1.0], atol=1e-15)
    assert not curve.lines.automatic[0]


def test_the_automatic_switch_goes_both_ways(qtbot, window, inspector):
    select_lines(window, WING, 1)
    inspector.refresh()
    switch = named(inspector, "automatic direction", QCheckBox)
    before = window.session.design.curve(WING).directions.copy()
    switch.click()
    assert window.session.design.curve(WING).lines.automatic[1]
    inspector.refresh()
    switch.click()
    kept = window.session.design.curve(WING)
    assert not kept.lines.automatic[1]
    assert not np.allclose(kept.directions[1], before[1])


def test_a_weight_must_be_positive(qtbot, window, inspector):
    select_lines(window, WING, 1)
    inspector.refresh()
    type_into(qtbot, named(inspector, "weight"), "-1")
    assert named(inspector, "weight").text() == "1"
    assert window.session.undo_label is None
    type_into(qtbot, named(inspector, "weight"), "3")
    assert_allclose(window.session.design.curve(WING).lines.weights, [1, 3, 1, 1])


def test_a_locked_shape_says_why_it_stays_as_it_is(qtbot, window, inspector):
    from plusedit.commands.shapes import SetLocked

    window.session.commit(SetLocked((WING,), True))
    select_lines(window, WING, 1)
    inspector.refresh()
    type_into(qtbot, named(inspector, "x"), "9")
    assert points(window)[1, 0] == 1.0
    assert "locked" in window.status.text.text()


def test_shapes_of_two_families_are_mixed(window, inspector):
    window.session.select(Selection.of_shapes([WING, BOW]))
    inspector.refresh()
    family = named(inspector, "family", Choice)
    assert family.currentIndex() == -1
    assert named(inspector, "s", QLineEdit).placeholderText() == MIXED
    assert not [w for w in inspector.findChildren(QLineEdit) if w.accessibleName() == "order"]


def test_order_knots_and_family_are_edited(qtbot, window, inspector):
    window.session.select(Selection.of_shapes([WING]))
    inspector.refresh()
    type_into(qtbot, named(inspector, "order"), "3")
    assert window.session.design.curve(WING).basis.order == 3
    inspector.refresh()
    type_into(qtbot, named(inspector, "knots"), "0 0 0 0.25 1 1 1")
    assert window.session.design.curve(WING).basis.knots == (0.0, 0.0, 0.0, 0.25, 1.0, 1.0, 1.0)
    inspector.refresh()
    type_into(qtbot, named(inspector, "knots"), "0 1")
    assert len(window.session.design.curve(WING).basis.knots) == 7
    family = named(inspector, "family", Choice)
    family.activated.emit(family.findData("rag"))
    inspector.refresh()
    type_into(qtbot, named(inspector, "sigma"), "0.25")
    assert window.session.design.curve(WING).basis.sigma == 0.25
    assert undo_steps(window) == 4


def test_s_over_l_is_that_of_the_slider(qtbot, window, inspector):
    window.session.select(Selection.of_shapes([WING, BOW]))
    inspector.refresh()
    type_into(qtbot, named(inspector, "s / L"), "1/2")
    for shape_id in (WING, BOW):
        curve = window.session.design.curve(shape_id)
        assert curve.s == pytest.approx(polygon_length(curve) / 2.0)
    window.magnitude.refresh()
    assert window.magnitude.slider.ratio == pytest.approx(0.5)
    assert undo_steps(window) == 1


def test_a_name_that_is_empty_is_refused(qtbot, window, inspector):
    window.session.select(Selection.of_shapes([WING]))
    inspector.refresh()
    type_into(qtbot, named(inspector, "name"), "Left wing")
    assert window.session.design[WING].name == "Left wing"
    inspector.refresh()
    name = named(inspector, "name")
    name.setText(" ")
    name.setModified(True)
    qtbot.keyClick(name, Qt.Key.Key_Return)
    assert name.text() == "Left wing"


def test_a_color_is_one_step_for_all_selected_shapes(window, inspector):
    window.session.select(Selection.of_shapes([WING, BOW]))
    inspector.refresh()
    named(inspector, "color").menu().actions()[2].trigger()
    colors = {window.session.design[i].style.color for i in (WING, BOW)}
    assert len(colors) == 1 and None not in colors
    assert undo_steps(window) == 1


def test_nothing_selected_says_what_to_do(window, inspector):
    from plusedit.document.selection import NOTHING_SELECTED

    window.session.select(NOTHING_SELECTED)
    inspector.refresh()
    assert inspector._empty.isVisibleTo(inspector)
    assert "press P" in inspector._empty.text()
