"""Surfaces of meshes in the window."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from plusedit.document.selection import Selection
from plusedit.scene.drawn_mesh import known_drawing
from plusedit.views.mesh_form import MeshForm
from plusedit.views.panels.inspector import Inspector
from plusedit.views.sketch import sketch_of
from tests.gui.finding import type_into
from tests.scene.meshes import HILL, a_hill, a_landscape

pytestmark = pytest.mark.gui


@pytest.fixture
def landscape(qtbot, window):
    """The window with a hill, drawn as it is."""
    window.files.show(a_landscape(), None)
    window.session.select(Selection.of_shapes([HILL]))
    window.magnitude.refresh()
    settle(qtbot, window)
    return window


def settle(qtbot, window):
    qtbot.waitUntil(lambda: not window.panes.meshes.is_busy, timeout=20000)


def hill(window):
    return window.session.design.mesh(HILL)


def at(slider, value):
    return QPoint(round(slider._x(value)), 15)


def drag(qtbot, slider, start, *stops):
    qtbot.mousePress(slider, Qt.MouseButton.LeftButton, pos=at(slider, start))
    for stop in stops:
        qtbot.mouseMove(slider, at(slider, stop))


def release(qtbot, slider, end):
    qtbot.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=at(slider, end))


def test_a_mesh_that_is_opened_is_evaluated_beside_until_it_is_exact(landscape):
    drawing = known_drawing(hill(landscape))
    assert drawing.is_exact
    np.testing.assert_array_equal(drawing.points, hill(landscape).at(drawing.net.places))


def test_for_meshes_s_runs_to_one_and_a_half_and_smoothness_stands_beside(landscape):
    bar = landscape.magnitude
    assert bar.slider.scale.high == 1.5
    assert bar.slider.ratio == 1.0
    assert bar.ratio_field.isHidden()
    assert bar.smoothness.isVisible()
    assert bar.smoothness.slider.ratio == hill(landscape).smoothness == 0.7


def test_for_curves_the_bar_is_as_ever(landscape, document):
    landscape.files.open(document)
    landscape.session.select(Selection.of_shapes([next(iter(landscape.session.design))]))
    landscape.magnitude.refresh()
    assert landscape.magnitude.slider.scale.high == 2.0
    assert not landscape.magnitude.ratio_field.isHidden()
    assert landscape.magnitude.smoothness.isHidden()


def test_a_drag_of_smoothness_is_live_and_one_step(qtbot, landscape):
    slider, before = landscape.magnitude.smoothness.slider, hill(landscape)
    drag(qtbot, slider, 0.7, 1.0, 2.0, 4.0)
    assert landscape.session.is_previewing
    assert hill(landscape).smoothness == pytest.approx(4.0, rel=0.05)
    settle(qtbot, landscape)
    assert known_drawing(hill(landscape)) is not None
    release(qtbot, slider, 4.0)
    settle(qtbot, landscape)
    assert known_drawing(hill(landscape)).is_exact
    assert landscape.session.undo_label == "Set S"
    landscape.session.undo()
    assert hill(landscape) is before
    assert landscape.session.undo_label is None


def test_escape_restores_the_very_same_surface(qtbot, landscape):
    slider, before = landscape.magnitude.smoothness.slider, hill(landscape)
    drag(qtbot, slider, 0.7, 2.0)
    qtbot.keyClick(slider, Qt.Key.Key_Escape)
    release(qtbot, slider, 2.0)
    assert hill(landscape) is before
    assert not landscape.session.is_previewing


def test_numbers_of_smoothness_and_s_are_typed(qtbot, landscape):
    type_into(qtbot, landscape.magnitude.smoothness.field, "3")
    type_into(qtbot, landscape.magnitude.s_field, "0.5")
    assert (hill(landscape).smoothness, hill(landscape).s) == (3.0, 0.5)


def test_a_double_click_puts_the_sliders_back(qtbot, landscape):
    type_into(qtbot, landscape.magnitude.smoothness.field, "3")
    type_into(qtbot, landscape.magnitude.s_field, "0.5")
    for slider in (landscape.magnitude.slider, landscape.magnitude.smoothness.slider):
        qtbot.mouseDClick(slider, Qt.MouseButton.LeftButton, pos=at(slider, slider.ratio))
    assert (hill(landscape).smoothness, hill(landscape).s) == (0.7, 1.0)


def test_panels_speak_of_meshes(qtbot, landscape):
    for dock in landscape.docks.by_name.values():
        dock.show()
    for widget in landscape.docks.by_name.values():
        widget.widget().refresh() if hasattr(widget.widget(), "refresh") else None
    landscape.clipboard.copy()
    landscape.clipboard.paste()
    assert len(landscape.session.design) == 2
    for action in ("duplicate", "select_all", "invert", "select_none"):
        landscape.actions_table[f"edit.{action}"].trigger()
    landscape.session.select(Selection.of_shapes([HILL]))
    landscape.actions_table["edit.delete"].trigger()
    assert HILL not in landscape.session.design


def test_evaluation_goes_on_with_what_is_shown_last(qtbot, landscape):
    for smoothness in (0.5, 1.0, 1.5, 2.0):
        landscape.files.show(a_landscape(a_hill(smoothness=smoothness)), None)
    settle(qtbot, landscape)
    assert known_drawing(hill(landscape)).is_exact
    assert hill(landscape).smoothness == 2.0


def test_the_inspector_shows_and_takes_the_numbers_of_a_mesh(qtbot, landscape):
    (form,) = landscape.findChildren(MeshForm)
    inspector = landscape.findChild(Inspector)
    inspector.refresh()
    assert form.counts.text() == "36 faces, 49 vertices"
    type_into(qtbot, form.smoothness, "2")
    type_into(qtbot, form.magnitude, "0.25")
    form.weights.click()
    assert (hill(landscape).smoothness, hill(landscape).s) == (2.0, 0.25)
    assert hill(landscape).area_weights


def test_a_small_picture_shows_a_mesh(window):
    image = sketch_of(a_landscape(), (120, 90), transparent=True)
    assert image.pixelColor(60, 45).alpha() == 255
