"""The window as a whole: parts, keys, themes, what it remembers."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QByteArray, QEvent, QPointF, Qt
from PySide6.QtGui import QEnterEvent, QPalette
from PySide6.QtWidgets import QApplication, QLineEdit

from plusedit.commands.lines import SetCoordinate
from plusedit.commands.shapes import Rename
from plusedit.document.selection import Selection
from plusedit.interaction.tool import Pointer
from plusedit.scene.theme import DARK, LIGHT
from plusedit.views.panels import panels
from plusedit.views.probe import reading
from tests.designs import BOW, WING, a_design
from tests.gui.conftest import select_lines
from tests.gui.finding import named

pytestmark = pytest.mark.gui


@pytest.fixture
def filled(window):
    window.files.show(a_design(), None)
    window.canvas.setFocus()
    return window


def test_every_panel_and_the_bar_of_s_are_in_sight(filled):
    for name, dock in filled.docks.by_name.items():
        assert dock.isVisible() == panels[name].is_shown
    assert filled.magnitude.isVisible()
    filled.resize(1100, 700)
    assert (filled.width(), filled.height()) == (1100, 700)


def test_a_letter_chooses_a_tool_in_the_view(qtbot, filled):
    qtbot.keyClick(filled.canvas, Qt.Key.Key_P)
    assert filled.gestures.tool_name == "pen"
    qtbot.waitUntil(filled.tool_bar.kinds.isVisible)
    qtbot.keyClick(filled.canvas, Qt.Key.Key_V)
    assert filled.gestures.tool_name == "select"
    qtbot.waitUntil(lambda: not filled.tool_bar.kinds.isVisible())


def test_a_letter_in_a_field_is_a_letter(qtbot, filled):
    select_lines(filled, WING, 1)
    inspector = filled.docks.widget("inspector")
    inspector.refresh()
    name = named(inspector, "name", QLineEdit)
    name.setFocus()
    name.selectAll()
    for letter in "pvigrs-+[]":
        qtbot.keyClick(name, letter)
    assert name.text() == "pvigrs-+[]"
    assert filled.gestures.tool_name == "select"
    assert not filled.gestures.is_busy
    assert filled.session.undo_label is None
    qtbot.keyClick(name, Qt.Key.Key_Backspace)
    assert len(filled.session.design.curve(WING).lines) == 4


def test_arrow_keys_in_a_list_do_not_nudge(qtbot, filled):
    select_lines(filled, WING, 1)
    before = filled.session.design
    for panel in ("outliner", "lines_table"):
        view = filled.docks.widget(panel)
        view = getattr(view, "list", None) or view.table
        view.setFocus()
        qtbot.keyClick(view, Qt.Key.Key_Right)
        qtbot.keyClick(view, Qt.Key.Key_Up, Qt.KeyboardModifier.ControlModifier)
    assert filled.session.design is before


def test_arrow_keys_in_the_view_nudge(qtbot, filled):
    select_lines(filled, WING, 1)
    filled.canvas.setFocus()
    qtbot.keyClick(filled.canvas, Qt.Key.Key_Right)
    moved = filled.session.design.curve(WING).lines.points[1, 0]
    assert moved == pytest.approx(1.0 + filled.gestures.grid_step)


def test_g_moves_with_the_pointer_and_digits_are_not_shortcuts(qtbot, filled):
    select_lines(filled, WING, 1)
    filled.canvas.setFocus()
    qtbot.keyClick(filled.canvas, Qt.Key.Key_G)
    assert filled.gestures.is_busy
    for key in ("2", "-"):
        qtbot.keyClick(filled.canvas, key)
    qtbot.keyClick(filled.canvas, Qt.Key.Key_Return)
    assert not filled.gestures.is_busy
    assert filled.session.design.curve(WING).lines.points[1, 0] == pytest.approx(-1.0)


def test_undo_is_named_and_ends_what_is_under_way(filled):
    filled.session.commit(SetCoordinate({WING: (1,)}, 0, 5.0))
    assert filled.actions_table["undo"].text().startswith("Undo ")
    select_lines(filled, WING, 1)
    before = filled.session.design
    filled.gestures.begin("move", Pointer(100.0, 100.0))
    filled.gestures.current.move(Pointer(140.0, 100.0))
    filled.actions_table["undo"].trigger()
    assert filled.session.design is before
    filled.actions_table["undo"].trigger()
    assert filled.session.design.curve(WING).lines.points[1, 0] == 1.0
    assert not filled.actions_table["undo"].isEnabled()
    assert filled.actions_table["redo"].isEnabled()


def test_tab_goes_to_the_next_control_line(qtbot, filled):
    select_lines(filled, WING, 1)
    filled.canvas.setFocus()
    qtbot.keyClick(filled.canvas, Qt.Key.Key_Tab)
    assert filled.session.selection.active.number == 2
    qtbot.keyClick(filled.canvas, Qt.Key.Key_Backtab, Qt.KeyboardModifier.ShiftModifier)
    assert filled.session.selection.active.number == 1


def test_the_pointer_takes_the_keys_along_unless_something_is_typed(filled):
    def enter():
        place = QPointF(5, 5)
        QApplication.sendEvent(filled.canvas, QEnterEvent(place, place, place))

    filled.docks.widget("outliner").list.setFocus()
    enter()
    assert QApplication.focusWidget() is filled.canvas
    field = filled.magnitude.s_field
    field.setFocus()
    enter()
    assert QApplication.focusWidget() is field


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda theme: theme.name)
def test_a_theme_reaches_everything(filled, theme):
    filled.actions_table[f"look.{theme.name}"].trigger()
    window = QApplication.palette().color(QPalette.ColorRole.Window)
    assert window.name().upper() == theme.color("window")
    assert filled.canvas.theme is theme
    assert filled.settings.look == theme.name
    assert not filled.grab().isNull()


def test_text_can_be_read_on_its_ground():
    from plusedit.views.look import on_accent, palette_of

    def luminance(color):
        def linear(c):
            return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4

        red, green, blue = map(linear, (color.redF(), color.greenF(), color.blueF()))
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue

    def contrast(one, other):
        low, high = sorted((luminance(one), luminance(other)))
        return (high + 0.05) / (low + 0.05)

    role = QPalette.ColorRole
    for theme in (LIGHT, DARK):
        palette = palette_of(theme)
        for text in (role.WindowText, role.Text, role.PlaceholderText):
            for ground in (role.Window, role.Base, role.Button):
                assert contrast(palette.color(text), palette.color(ground)) >= 4.5
        assert contrast(on_accent(theme), palette.color(role.Highlight)) >= 4.5


def test_switches_follow_what_the_view_shows(filled):
    grid = filled.actions_table["view.grid"]
    was_on = filled.canvas.options.grid
    grid.trigger()
    assert filled.canvas.options.grid is not was_on
    assert grid.isChecked() is not was_on
    filled.actions_table["handles.none"].trigger()
    checked = [n for n in ("auto", "selected", "all", "none")
               if filled.actions_table[f"handles.{n}"].isChecked()]  # fmt: skip
    assert checked == ["none"]


def test_projections_and_zoom(filled):
    filled.actions_table["projection.front"].trigger()
    assert filled.canvas.camera.projection == "front"
    assert filled.actions_table["projection.front"].isChecked()
    assert not filled.actions_table["projection.top"].isChecked()


def test_the_places_of_docks_are_remembered(filled, settings, qtbot):
    from plusedit.app.window import MainWindow

    filled.actions_table["panel.lines_table"].trigger()
    assert not filled.docks.by_name["lines_table"].isVisible()
    filled.actions_table["panel.parameters"].trigger()
    filled.session.mark_saved()
    filled.close()
    again = MainWindow(settings)
    qtbot.addWidget(again)
    again.show()
    again.files.show(a_design(), None)
    again.session.mark_saved()
    assert again.docks.by_name["lines_table"].isHidden()
    assert not again.docks.by_name["outliner"].isHidden()
    assert not again.docks.by_name["parameters"].isHidden()


def test_nonsense_in_the_settings_does_no_harm(settings, qtbot):
    from plusedit.app.window import MainWindow

    settings.keep_bytes("geometry", QByteArray(b"nonsense"))
    settings.keep_bytes("state", QByteArray(b"\x00\xff more nonsense"))
    settings.shortcuts = {"save": ["nonsense+++"], "no such action": ["F5"]}
    window = MainWindow(settings)
    qtbot.addWidget(window)
    window.show()
    assert window.isVisible()


def test_the_status_bar_tells_place_parameter_and_curvature(qtbot, filled):
    select_lines(filled, WING, 1)
    filled.status.point_at(((0, 1.0), (1, 1.5)))
    filled.status._measure()
    assert filled.status.place.text() == "x 1.000  y 1.500"
    assert filled.status.bend.text().startswith("u 0.")
    assert "κ" in filled.status.bend.text()
    filled.status.point_nowhere()
    filled.status._measure()
    assert filled.status.place.text() == filled.status.bend.text() == ""


@pytest.mark.parametrize("shape_id", [WING, BOW])
def test_of_several_chosen_curves_the_status_bar_tells_of_that_under_the_pointer(filled, shape_id):
    filled.session.select(Selection.of_shapes([WING, BOW]))
    camera, design = filled.canvas.camera, filled.session.design
    point = design.curve(shape_id).at([0.3])
    filled.canvas._pointer = Pointer(*camera.to_screen(point)[0])
    filled.status.point_at(((0, 1.0), (1, 1.5)))
    filled.status._measure()
    assert filled.status.bend.text() == reading(
        design.curve(shape_id), camera, filled.canvas.pointer.at
    )


def test_an_error_nobody_caught_is_a_sentence_and_a_log_entry(filled, monkeypatch):
    import sys

    from plusedit.app import errors
    from plusedit.machine import log_file

    shown = []
    monkeypatch.setattr(errors, "show_internal", shown.append)
    hook = sys.excepthook
    errors.install()
    try:
        try:
            raise ZeroDivisionError("for the log only")
        except ZeroDivisionError as error:
            sys.excepthook(type(error), error, error.__traceback__)
        QApplication.sendPostedEvents()
        QApplication.processEvents()
    finally:
        sys.excepthook = hook
        errors.uninstall()
    assert "for the log only" in log_file().read_text(encoding="utf-8")
    assert len(shown) == 1
    assert "Traceback" not in errors.SENTENCE


def test_the_context_menu_has_what_can_be_done_here(filled):
    from plusedit.app.menus import context_menu

    filled.canvas.context_menu_requested.emit(filled.canvas.rect().center())
    names = {
        action.objectName()
        for action in context_menu(filled.actions_table, filled, ["curves"]).actions()
    }
    assert {"cut", "paste", "edit.delete", "edit.pass_through", "frame_all"} <= names
    popup = QApplication.activePopupWidget()
    assert popup is not None
    popup.close()


def test_focus_leaves_the_field_for_the_view_by_escape(qtbot, filled):
    field = filled.magnitude.s_field
    field.setFocus()
    qtbot.keyClick(field, Qt.Key.Key_Escape)
    assert QApplication.focusWidget() is filled.canvas


def test_leaving_and_coming_back_does_not_lose_events(filled):
    QApplication.sendEvent(filled.canvas, QEvent(QEvent.Type.Leave))
    assert filled.status.text.text()


def test_the_first_window_fits_on_the_screen(window):
    room = window.screen().availableSize()
    assert window.width() <= max(room.width(), window.minimumWidth())
    assert window.height() <= max(room.height(), window.minimumHeight())


def test_a_long_label_leaves_the_menu_its_width(filled):
    filled.desk.commit(Rename(WING, "name " * 40))
    text = filled.actions_table["undo"].text()
    assert text.startswith("Undo Rename")
    assert text.endswith("…")
    assert len(text) < 60


def test_another_theme_moves_nothing(filled, qtbot):
    filled.view.set_look("light")
    before = {w: (w.pos(), w.size()) for w in (filled.canvas, filled.magnitude, filled.status)}
    filled.view.set_look("dark")
    QApplication.processEvents()
    assert {w: (w.pos(), w.size()) for w in before} == before


def test_a_design_that_says_nothing_of_its_view_is_shown_as_the_person_likes_it(window):
    names = {"overlays": ["names"], "grid": False}
    own = window.view.options
    window.files.show(replace(a_design(), view=names), None)
    assert window.view.options.overlays == {"names"}
    window.view.toggle("rulers")
    window.files.show(a_design(), None)
    assert window.view.options == replace(own, rulers=not own.rulers)
