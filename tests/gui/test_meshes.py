"""Surfaces of meshes in the window."""

from functools import partial
from threading import Event

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt

from plusedit.commands.meshes import SetSmoothness
from plusedit.commands.shapes import AddShapes, SetVisible
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.scene.drawn_mesh import known_drawing, previewed
from plusedit.views import mesh_evaluation
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
    form.facets.click()
    assert all(shape.style.facets for shape in landscape.session.design.shapes.values())
    landscape.undo()
    inspector.refresh()
    assert not form.facets.isChecked()
    form.weights.click()
    assert (hill(landscape).smoothness, hill(landscape).s) == (2.0, 0.25)
    assert hill(landscape).area_weights


def test_a_small_picture_shows_a_mesh(window):
    image = sketch_of(a_landscape(), (120, 90), transparent=True)
    assert image.pixelColor(60, 45).alpha() == 255


def test_nothing_is_done_once_all_is_exact(landscape):
    meshes = landscape.panes.meshes
    assert not meshes.is_busy
    assert not meshes._glance.isActive()
    assert not meshes._rest.isActive()


def test_hidden_meshes_are_evaluated_when_they_are_shown(qtbot, window):
    window.files.show(a_landscape(visible=False), None)
    settle(qtbot, window)
    assert known_drawing(hill(window)) is None
    window.session.commit(SetVisible((HILL,), True))
    settle(qtbot, window)
    assert known_drawing(hill(window)).is_exact


def test_undo_and_redo_draw_what_was_drawn(qtbot, landscape):
    before = known_drawing(hill(landscape))
    landscape.session.commit(SetSmoothness({HILL: 2.0}))
    settle(qtbot, landscape)
    after = known_drawing(hill(landscape))
    landscape.session.undo()
    assert known_drawing(hill(landscape)) is before
    landscape.session.redo()
    assert known_drawing(hill(landscape)) is after
    assert not landscape.panes.meshes._job


def is_longer(row, count):
    return len(row) > count


def test_meshes_that_are_edited_together_take_turns(qtbot, landscape, monkeypatch):
    other = ShapeId("other")
    shape = Shape(a_hill(5), "Other")
    landscape.session.commit(AddShapes(((other, shape),)))
    settle(qtbot, landscape)
    done = []

    def noted(surface, before):
        done.append(surface.mesh)
        return previewed(surface, before)

    monkeypatch.setattr(mesh_evaluation, "previewed", noted)
    for smoothness in (1.0, 1.5, 2.0, 2.5):
        landscape.session.preview(SetSmoothness({HILL: smoothness, other: smoothness}))
        qtbot.waitUntil(partial(is_longer, done, len(done)), timeout=20000)
    meshes = {id(mesh) for mesh in done}
    assert len(meshes) == 2
    landscape.session.abort()


def test_an_evaluation_ends_when_its_surface_is_no_longer_shown(qtbot, landscape, monkeypatch):
    begun, ended = Event(), Event()

    def endless(surface, before, check):
        begun.set()
        while True:
            try:
                check()
            except Exception:
                ended.set()
                raise

    monkeypatch.setattr(mesh_evaluation, "evaluated", endless)
    landscape.session.commit(SetSmoothness({HILL: 2.0}))
    qtbot.waitUntil(begun.is_set, timeout=20000)
    monkeypatch.undo()
    landscape.session.commit(SetSmoothness({HILL: 3.0}))
    qtbot.waitUntil(ended.is_set, timeout=20000)
    settle(qtbot, landscape)
    assert known_drawing(hill(landscape)).is_exact


def test_views_are_drawn_anew_only_with_something_new(qtbot, landscape, monkeypatch):
    asked = []
    monkeypatch.setattr(landscape.panes.plane, "update", lambda *region: asked.append(region))
    landscape.session.preview(SetSmoothness({HILL: 2.0}))
    assert not asked
    qtbot.waitUntil(lambda: known_drawing(hill(landscape)) is not None, timeout=20000)
    assert asked
    asked.clear()
    landscape.session.abort()
    assert asked
