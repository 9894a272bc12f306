"""Deviations of meshes in the window: numbers beside the slider of S, colors in the 3D view."""

import pytest

from plusedit.commands.meshes import SetSmoothness
from plusedit.document.selection import Selection
from plusedit.scene.coloring import has_values
from plusedit.scene.drawn_deviation import known_deviation
from plusedit.scene.drawn_mesh import known_drawing
from plusedit.scene.overlays import overlays
from plusedit.views import mesh_evaluation, mesh_measuring
from plusedit.views.deviation_label import percentage
from tests.scene.meshes import HILL, a_landscape

pytestmark = pytest.mark.gui


@pytest.fixture
def landscape(qtbot, window):
    """The window with a hill, drawn and measured."""
    window.files.show(a_landscape(), None)
    window.session.select(Selection.of_shapes([HILL]))
    window.magnitude.refresh()
    settle(qtbot, window)
    return window


def settle(qtbot, window):
    panes = window.panes
    qtbot.waitUntil(lambda: not panes.meshes.is_busy and not panes.measuring.is_busy, timeout=20000)


def drawing(window):
    return known_drawing(window.session.design.mesh(HILL))


def numbers(window):
    return window.magnitude.smoothness.numbers


def percents(text):
    """The numbers in a text such as "rms 0.02 %"."""
    return [float(word) for word in text.split() if word[0].isdigit()]


def test_what_is_drawn_is_measured_and_told_beside_the_slider(landscape):
    found = known_deviation(drawing(landscape))
    rms, largest = percents(numbers(landscape).text())
    assert rms == pytest.approx(100.0 * found.to_surface.rms / found.diagonal, rel=0.05)
    assert largest == pytest.approx(100.0 * found.to_surface.largest / found.diagonal, rel=0.05)
    assert "…" not in numbers(landscape).text()


def test_the_tip_tells_of_both_ways_in_the_unit_of_the_mesh_too(landscape):
    found, tip = known_deviation(drawing(landscape)), numbers(landscape).toolTip()
    assert "Hill" in tip
    for spread in (found.to_surface, found.to_mesh):
        for value in (spread.rms, spread.median, spread.largest):
            assert f"{value:.3g}" in tip


def test_after_a_change_the_old_numbers_have_dots_until_the_new_ones_are_there(qtbot, landscape):
    before = numbers(landscape).text()
    landscape.session.commit(SetSmoothness({HILL: 4.0}))
    landscape.magnitude.refresh()
    assert numbers(landscape).text() == before.replace(" %\nmax", " % …\nmax")
    settle(qtbot, landscape)
    assert percents(numbers(landscape).text())[0] > percents(before)[0]
    assert "…" not in numbers(landscape).text()


def test_undo_tells_the_numbers_before(qtbot, landscape):
    before = numbers(landscape).text()
    landscape.session.commit(SetSmoothness({HILL: 4.0}))
    settle(qtbot, landscape)
    landscape.session.undo()
    landscape.magnitude.refresh()
    settle(qtbot, landscape)
    assert numbers(landscape).text() == before


def test_values_of_the_map_are_found_once_it_is_switched_on(qtbot, landscape):
    entry = overlays["deviation"]
    assert not has_values(entry, drawing(landscape))
    landscape.view.toggle_overlay("deviation")
    settle(qtbot, landscape)
    assert has_values(entry, drawing(landscape))
    landscape.session.commit(SetSmoothness({HILL: 2.0}))
    settle(qtbot, landscape)
    assert has_values(entry, drawing(landscape))


def test_the_view_menu_switches_the_map_on_and_off(landscape):
    action = landscape.actions_table["overlay.deviation"]
    action.trigger()
    assert action.isChecked()
    assert "deviation" in landscape.view.options.overlays
    action.trigger()
    assert not action.isChecked()


def test_nothing_is_measured_while_edits_go_on(qtbot, landscape):
    landscape.session.preview(SetSmoothness({HILL: 3.0}))
    measuring = landscape.panes.measuring
    assert measuring.is_busy
    assert measuring._thread is None
    settle(qtbot, landscape)
    assert known_deviation(drawing(landscape)) is not None
    landscape.session.abort()


def test_previews_are_not_measured_while_the_accurate_surface_is_on_its_way(
    qtbot, landscape, monkeypatch
):
    measured = []
    find = mesh_measuring.drawn_deviation

    def note(surface, drawn):
        measured.append(drawn)
        return find(surface, drawn)

    monkeypatch.setattr(mesh_measuring, "drawn_deviation", note)
    for smoothness in (2.0, 3.0):
        landscape.session.commit(SetSmoothness({HILL: smoothness}))
        settle(qtbot, landscape)
    assert [each.is_exact for each in measured] == [True, True]


def test_a_preview_is_measured_where_it_stays_all_there_is(qtbot, landscape, monkeypatch):
    def fail(*_):
        raise ValueError("points: has a value that is not finite")

    monkeypatch.setattr(mesh_evaluation, "evaluated", fail)
    landscape.panes.measuring._patience.setInterval(100)
    landscape.session.commit(SetSmoothness({HILL: 2.0}))
    settle(qtbot, landscape)
    assert not drawing(landscape).is_exact
    assert known_deviation(drawing(landscape)) is not None


def test_a_mesh_that_is_hidden_is_not_measured(qtbot, window):
    window.files.show(a_landscape(visible=False), None)
    settle(qtbot, window)
    found = drawing(window)
    assert found is None or known_deviation(found) is None


def test_what_can_not_be_measured_is_tried_once(qtbot, window, monkeypatch):
    tried = []

    def fail(surface, drawn):
        tried.append(drawn)
        raise ValueError("points: has a value that is not finite")

    monkeypatch.setattr(mesh_measuring, "drawn_deviation", fail)
    window.files.show(a_landscape(), None)
    settle(qtbot, window)
    assert len(tried) == len(set(tried)) >= 1
    window.magnitude.refresh()
    assert "…" in numbers(window).text()


def test_numbers_leave_the_sliders_their_room_in_a_small_window(qtbot, landscape):
    landscape.resize(1280, 700)
    bar = landscape.magnitude
    qtbot.waitUntil(lambda: bar.width() <= 1280)
    assert bar.slider.width() >= 240
    assert bar.smoothness.slider.width() >= 160
    assert numbers(landscape).geometry().right() <= bar.smoothness.width()
    text = numbers(landscape).text().split("\n")
    room = numbers(landscape).fontMetrics().horizontalAdvance(max(text, key=len) + " …")
    assert room <= numbers(landscape).width()


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0 %"),
        (1e-7, "< 0.001 %"),
        (0.0254, "0.025 %"),
        (0.1, "0.10 %"),
        (1.24, "1.2 %"),
        (47.3, "47 %"),
        (312.4, "312 %"),
    ],
)
def test_percentages_have_two_digits(value, text):
    assert percentage(value) == text
