"""Fields: what is typed, refused, stepped and shown."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication

from plusedit.views.fields import MIXED, NumberField
from tests.gui.finding import type_into

pytestmark = pytest.mark.gui


class Taker:
    """Takes values and remembers them; refuses what is negative."""

    def __init__(self):
        self.taken = []

    def __call__(self, value):
        if value < 0.0:
            return "below zero"
        self.taken.append(value)
        self.field.show_value(value)
        return ""


@pytest.fixture
def taker():
    return Taker()


@pytest.fixture
def field(qtbot, taker):
    field = NumberField("x", taker, step=0.5)
    taker.field = field
    qtbot.addWidget(field)
    field.show()
    field.show_value(2.0)
    return field


def test_a_sum_is_taken_once(qtbot, field, taker):
    type_into(qtbot, field, "2*3+1")
    field.clearFocus()
    assert taker.taken == [7.0]
    assert field.text() == "7"


def test_what_is_no_number_goes_back_to_what_was_there(qtbot, field, taker):
    type_into(qtbot, field, "two")
    assert (field.text(), taker.taken) == ("2", [])


def test_what_the_edit_refuses_goes_back_too(qtbot, field, taker):
    type_into(qtbot, field, "-1")
    assert (field.text(), taker.taken) == ("2", [])


def test_escape_forgets_what_was_typed(qtbot, field, taker):
    field.setFocus()
    qtbot.keyClicks(field, "99")
    qtbot.keyClick(field, Qt.Key.Key_Escape)
    field.clearFocus()
    assert (field.text(), taker.taken) == ("2", [])


def test_leaving_the_field_takes_what_was_typed(qtbot, field, taker):
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "5")
    QApplication.sendEvent(field, focus_out())
    assert taker.taken == [5.0]


def focus_out():
    from PySide6.QtCore import QEvent
    from PySide6.QtGui import QFocusEvent

    return QFocusEvent(QEvent.Type.FocusOut)


def test_looking_at_a_number_does_not_round_it(qtbot, field, taker):
    field.show_value(1.23456789012345)
    field.setFocus()
    field.selectAll()
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert taker.taken == []
    assert field.value == 1.23456789012345


@pytest.mark.parametrize(
    ("held", "value"),
    [
        (Qt.KeyboardModifier.NoModifier, 2.5),
        (Qt.KeyboardModifier.ShiftModifier, 7.0),
        (Qt.KeyboardModifier.ControlModifier, 2.05),
    ],
)
def test_arrow_keys_step(qtbot, field, taker, held, value):
    field.setFocus()
    qtbot.keyClick(field, Qt.Key.Key_Up, held)
    assert taker.taken == [pytest.approx(value)]


def test_the_wheel_steps_only_where_the_field_has_the_focus(qtbot, field, taker):
    def turn():
        QApplication.sendEvent(
            field,
            QWheelEvent(
                QPointF(5, 5),
                QPointF(5, 5),
                QPoint(),
                QPoint(0, -120),
                Qt.MouseButton.NoButton,
                Qt.KeyboardModifier.NoModifier,
                Qt.ScrollPhase.NoScrollPhase,
                False,
            ),
        )

    field.clearFocus()
    turn()
    assert taker.taken == []
    field.setFocus()
    turn()
    assert taker.taken == [1.5]


def test_values_that_differ_show_as_mixed_and_take_one_for_all(qtbot, field, taker):
    field.show_value(None)
    assert (field.text(), field.placeholderText()) == ("", MIXED)
    qtbot.keyClick(field, Qt.Key.Key_Up)
    assert taker.taken == []
    type_into(qtbot, field, "3")
    assert taker.taken == [3.0]


def test_what_is_being_typed_survives_a_refresh(qtbot, field):
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "1234")
    field.show_value(8.0)
    assert field.text() == "1234"


def test_a_number_has_a_true_minus_sign_until_it_is_edited_or_copied(qtbot, field):
    field.clearFocus()
    field.show_value(-2.5)
    assert field.text() == "−2.5"
    field.setFocus()
    field.selectAll()
    assert float(field.selectedText()) == -2.5
    field.clearFocus()
    assert field.text() == "−2.5"


@pytest.mark.parametrize("sign", ["-", "−"])
def test_both_minus_signs_are_taken(qtbot, sign):
    taken = []
    field = NumberField("x", lambda value: taken.append(value) or "")
    qtbot.addWidget(field)
    field.show()
    field.setFocus()
    QApplication.clipboard().setText(f"{sign}4")
    field.paste()
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert taken == [-4.0]
