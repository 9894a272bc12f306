"""The panels of plots: blending functions, and what s does."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication

from plusedit.commands.lines import MovePoints
from plusedit.document.selection import Selection
from plusedit.geometry.magnitude import best_s, polygon_length
from tests.designs import BOW, WING, a_design
from tests.gui.conftest import example, select_lines

pytestmark = pytest.mark.gui


def shown(window, name):
    """A panel, opened and up to date."""
    if window.docks.by_name[name].isHidden():
        window.docks.toggle(name)
        QApplication.processEvents()
    panel = window.docks.widget(name)
    panel.refresh()
    return panel


@pytest.fixture
def wing(window):
    """The window with the wing selected."""
    window.files.show(a_design(), None)
    window.session.select(Selection.of_shapes([WING]))
    return window


def drag(qtbot, plot, *stops):
    """Press where the cursor stands and move to those s / L."""
    at = [QPoint(round(plot.pixel_of(x)), plot.height() // 2) for x in (plot.cursor_x, *stops)]
    qtbot.mousePress(plot, Qt.MouseButton.LeftButton, pos=at[0])
    for stop in at[1:]:
        qtbot.mouseMove(plot, stop)
    return at[-1]


def s(window):
    return window.session.design.curve(WING).s


def length(window):
    return polygon_length(window.session.design.curve(WING))


def waited(qtbot, panel):
    """The panel with all that is worked out beside."""
    qtbot.waitUntil(lambda: panel.plots[1].plot is not None)
    return panel


def test_both_panels_are_hidden_at_first_and_say_what_to_do(window):
    for name in ("blending", "s_plot"):
        assert window.docks.by_name[name].isHidden()
        assert all(plot.plot is None for plot in shown(window, name).plots)


def test_functions_of_the_selected_lines_are_in_color(wing):
    select_lines(wing, WING, 1, 2)
    panel = shown(wing, "blending")
    names = [line.name for line in panel.plots[0].plot.lines if line.name]
    assert names == ["2", "3"]
    assert [plot.isHidden() for plot in panel.plots] == [False, False, True, True]


def test_moving_points_leaves_the_functions_as_they_are(wing):
    panel = shown(wing, "blending")
    before = panel.plots[0].plot
    wing.session.commit(MovePoints({WING: (1,)}, np.array([0.5, 0.5])))
    panel.refresh()
    assert panel.plots[0].plot is before


def test_a_surface_has_functions_by_both_parameters(window):
    assert window.files.open(example("sail.json"))
    (shape_id, _), *_ = window.session.design.surfaces()
    select_lines(window, shape_id, 5)
    panel = shown(window, "blending")
    assert not any(plot.isHidden() for plot in panel.plots)
    assert all(plot.plot is not None for plot in panel.plots)


def test_the_pointer_on_a_plot_marks_the_place_on_the_curve(qtbot, wing):
    panel = shown(wing, "blending")
    plot = panel.plots[0]
    qtbot.mouseMove(plot, QPoint(round(plot.pixel_of(0.5)), 40))
    spot = wing.panes.plane._mark
    assert spot.shape == WING
    assert spot.place[0] == pytest.approx(0.5, abs=0.01)
    assert "u 0.5" in panel.numbers.text()
    plot.pointed.emit(None)
    assert wing.panes.plane._mark is None


def test_the_pointer_on_the_curve_moves_the_cursor_of_the_plots(qtbot, wing):
    panel, canvas = shown(wing, "blending"), wing.panes.plane
    curve = wing.session.design.curve(WING)
    at = canvas.camera.to_screen(curve.at([0.25]))[0]
    qtbot.mouseMove(canvas, QPoint(round(at[0]), round(at[1])))
    qtbot.waitUntil(lambda: panel.plots[0].cursor_x is not None)
    assert panel.plots[0].cursor_x == pytest.approx(0.25, abs=0.03)


def test_a_hidden_panel_marks_nothing_and_hears_nothing(wing):
    shown(wing, "blending").plots[0].pointed.emit(0.5)
    wing.docks.toggle("blending")
    assert wing.panes.plane._mark is None
    assert not wing.desk.pointer_moved.is_heard


def test_what_s_does_is_worked_out_beside_and_shown(qtbot, wing):
    panel = waited(qtbot, shown(wing, "s_plot"))
    assert [plot.plot.title for plot in panel.plots] == [
        "Distance to points",
        "Bending energy",
        "Largest curvature",
    ]
    (mark,) = panel.plots[0].plot.marks
    curve = wing.session.design.curve(WING)
    assert mark.x == pytest.approx(best_s(curve) / length(wing))
    assert panel.plots[0].cursor_x == pytest.approx(curve.s / length(wing))


def test_dragging_its_cursor_is_live_and_one_undo_step(qtbot, wing):
    panel, before = shown(wing, "s_plot"), s(wing)
    plot = panel.plots[0]
    end = drag(qtbot, plot, 1.1, 1.3)
    assert wing.session.is_previewing
    assert s(wing) == pytest.approx(1.3 * length(wing), rel=0.02)
    qtbot.mouseRelease(plot, Qt.MouseButton.LeftButton, pos=end)
    assert not wing.session.is_previewing
    assert wing.session.undo_label == "Set s"
    wing.session.undo()
    assert s(wing) == before


def test_escape_breaks_the_drag_off(qtbot, wing):
    panel, committed = shown(wing, "s_plot"), wing.session.committed
    drag(qtbot, panel.plots[0], 1.1)
    qtbot.keyClick(panel.plots[0], Qt.Key.Key_Escape)
    assert wing.session.design is committed
    qtbot.mouseRelease(panel.plots[0], Qt.MouseButton.LeftButton)
    assert wing.session.undo_label is None


def test_the_cursor_sticks_to_the_best_s(qtbot, wing):
    panel = shown(wing, "s_plot")
    plot, best = panel.plots[0], best_s(wing.session.design.curve(WING))
    pixel = round(plot.pixel_of(best / length(wing))) + 3
    qtbot.mousePress(plot, Qt.MouseButton.LeftButton, pos=QPoint(pixel, 60))
    assert s(wing) == pytest.approx(best)
    qtbot.mouseRelease(plot, Qt.MouseButton.LeftButton, pos=QPoint(pixel, 60))


def test_changing_s_works_nothing_out_anew(qtbot, wing):
    panel = waited(qtbot, shown(wing, "s_plot"))
    before = panel._profile
    drag(qtbot, panel.plots[0], 1.1)
    panel.refresh()
    assert panel._profile is before
    assert not panel._newest.is_busy


def test_with_another_shape_selected_the_plots_are_of_that(qtbot, wing):
    panel = waited(qtbot, shown(wing, "s_plot"))
    before = panel.plots[1].plot
    wing.session.select(Selection.of_shapes([BOW]))
    panel.refresh()
    qtbot.waitUntil(lambda: panel.plots[1].plot not in (None, before))


def test_all_numbers_of_what_s_does_have_room_in_a_narrow_panel(qtbot, wing):
    panel = shown(wing, "s_plot")
    waited(qtbot, panel)
    panel.refresh()
    panel.numbers.setFixedWidth(340)
    QApplication.processEvents()
    assert "curvature" in panel.numbers.text()
    assert panel.numbers.height() >= panel.numbers.heightForWidth(panel.numbers.width())


def test_a_plot_says_what_its_lines_are_where_the_legend_has_no_room(wing):
    plot, *_ = shown(wing, "s_plot").plots
    assert plot.toolTip().splitlines() == [
        "Distance to points, units",
        "largest: dashed line",
        "rms: solid line",
    ]
