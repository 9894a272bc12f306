"""The table of actions: shortcuts, conflicts, the palette, preferences, help."""

import pytest
from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QKeySequence

from plusedit.app.actions import belongs_to_view, conflicts
from plusedit.app.facts import FACTS
from plusedit.app.help_window import page_of
from plusedit.app.palette import Palette, score
from plusedit.app.preferences import Preferences
from plusedit.interaction.actions import edit_actions
from plusedit.interaction.tool import tools
from plusedit.scene.overlays import overlays
from tests.designs import a_design

pytestmark = pytest.mark.gui


@pytest.fixture
def table(window):
    return window.actions_table


def test_no_two_actions_share_a_key(table):
    assert conflicts(table.shortcuts()) == {}


def test_every_shelf_is_on_the_table(table):
    assert all(f"tool.{name}" in table for name in tools)
    assert all(f"overlay.{name}" in table for name in overlays)
    assert all(f"edit.{action.name}" in table for action in edit_actions())


def test_every_shortcut_is_a_key(table):
    for entry in table:
        for keys in entry.shortcuts:
            assert QKeySequence(keys).toString(), f"{entry.name}: {keys}"


@pytest.mark.parametrize(
    "keys", ["Delete", "Backspace", "Tab", "Left", "Ctrl+Left", "Home", "PgUp", "Space"]
)
def test_keys_that_lists_and_fields_use_belong_to_the_view(keys):
    assert belongs_to_view(QKeySequence(keys))


@pytest.mark.parametrize("keys", ["Ctrl+S", "F1", "Alt+Home", "", "V", "Shift+H", "[", "Num+7"])
def test_signs_and_keys_that_nobody_types_belong_to_the_window(keys):
    assert not belongs_to_view(QKeySequence(keys))


def test_nothing_but_delete_and_backspace_destroys_by_a_single_key(table):
    for entry in table:
        if "delete" in entry.name or "cut" in entry.name:
            single = [keys for keys in entry.shortcuts if "+" not in keys]
            assert set(single) <= {"Delete", "Backspace"}


def test_every_action_can_be_done_with_nothing_selected(window, table, monkeypatch):
    window.files.show(a_design(), None)
    asking = ("open", "save", "import", "export", "quit", "preferences", "about", "recover",
              "full_screen", "help", "palette", "new")  # fmt: skip
    for entry in table:
        if not entry.name.startswith(asking):
            table[entry.name].trigger()
            window.gestures.cancel()


def test_letters_in_order_find_a_title():
    assert score("rvc", "Reverse curve") is not None
    assert score("zzz", "Reverse curve") is None
    assert score("rev", "Reverse curve") > score("rev", "Recover unsaved designs")


def test_the_palette_does_what_is_chosen(qtbot, window, table):
    window.files.show(a_design(), None)
    window.side.show_palette()
    palette = window.side.palette
    qtbot.keyClicks(palette.typed, "select all")
    assert palette.chosen().text() == "Select all"
    qtbot.keyClick(palette.typed, Qt.Key.Key_Return)
    assert len(window.session.selection.lines) == 7
    assert not palette.isVisible()


def test_the_palette_is_walked_with_arrow_keys(qtbot, table, window):
    palette = Palette(table, window)
    qtbot.addWidget(palette)
    palette.show()
    first = palette.chosen()
    qtbot.keyClick(palette.typed, Qt.Key.Key_Down)
    assert palette.chosen() is not first
    qtbot.keyClick(palette.typed, Qt.Key.Key_Up)
    assert palette.chosen() is first


def test_the_palette_finds_nothing_for_nonsense(qtbot, table, window):
    palette = Palette(table, window)
    qtbot.addWidget(palette)
    palette.look_for("qqqqqq")
    assert palette.chosen() is None
    palette.accept()


@pytest.fixture
def preferences(qtbot, window):
    dialog = Preferences(window.settings, window.actions_table, window)
    qtbot.addWidget(dialog)
    return dialog


def select(editor, name):
    for item in editor._items():
        if item.data(0, Qt.ItemDataRole.UserRole) == name:
            editor.list.setCurrentItem(item)
            return
    raise AssertionError(name)


def test_a_shortcut_is_changed_and_taken_from_whoever_had_it(window, preferences, table):
    editor = preferences.shortcuts
    select(editor, "tool.pen")
    editor.keys.setKeySequence(QKeySequence("Ctrl+S"))
    assert "Save" in editor.remark.text()
    editor.assign(QKeySequence("Ctrl+S"))
    preferences._take()
    window.take_settings()
    assert table.shortcuts()["tool.pen"] == ["Ctrl+S"]
    assert table.shortcuts()["save"] == []
    assert conflicts(table.shortcuts()) == {}
    assert set(window.settings.shortcuts) == {"tool.pen", "save"}


def test_resetting_all_shortcuts_forgets_what_was_chosen(window, preferences, table):
    editor = preferences.shortcuts
    select(editor, "tool.pen")
    editor.assign(QKeySequence("Ctrl+F12"))
    editor.reset()
    preferences._take()
    assert window.settings.shortcuts == {}


def test_preferences_take_effect(window, preferences):
    preferences.look.setCurrentIndex(preferences.look.findData("dark"))
    preferences.grid_step.setText("1/4")
    preferences.family.setCurrentIndex(preferences.family.findData("rag"))
    preferences._take()
    window.take_settings()
    assert window.desk.theme.name == "dark"
    assert window.gestures.grid_step == 0.25
    assert window.gestures.new_curves.family == "rag"
    window.canvas.zoom(4.0)
    assert window.gestures.grid_step == 0.25


@pytest.mark.parametrize(("field", "text"), [("grid_step", "-1"), ("order", "1"), ("order", "2.5")])
def test_preferences_that_make_no_sense_are_refused_with_a_reason(preferences, field, text):
    getattr(preferences, field).setText(text)
    preferences._take()
    assert preferences._reason.text()
    assert preferences.result() == 0


def test_help_shows_the_keys_as_they_are_now(window, table):
    assert "Ctrl+Shift+P" in page_of(table)
    table.set_shortcuts({"palette": ["Ctrl+F11"]})
    assert "Ctrl+Shift+P" not in page_of(table)
    window.side.show_help()
    assert "plus curve" in window.side.help.page.toPlainText()
    window.side.help.close()


def test_the_help_opens_the_design_that_proves_a_fact(window, table):
    table["facts"].trigger()
    page = window.side.help.page
    assert "what is true" in page.toPlainText()
    page.anchorClicked.emit(QUrl(FACTS[1].design))
    assert window.files.path == FACTS[1].path
    assert "cusp" in window.notes.text.text()
    window.side.help.close()


def test_keys_that_were_pressed_and_not_set_are_taken_with_ok(window, preferences):
    editor = preferences.shortcuts
    select(editor, "tool.pen")
    editor.keys.setKeySequence(QKeySequence("Ctrl+F12"))
    preferences._take()
    assert window.settings.shortcuts == {"tool.pen": ["Ctrl+F12"]}


def test_the_palette_leaves_out_what_fits_by_chance(table, window):
    window.side.show_palette()
    palette = window.side.palette
    palette.look_for("clos")
    titles = [palette.list.item(row).text() for row in range(palette.list.count())]
    assert titles[0].startswith("Close")
    assert "Control lines: Of selected shapes" in titles, "its words begin with these letters"
    assert "Family: Rational Gaussian" not in titles
