"""The view of the parameters of a mesh, and the change of its map, in the window."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QEnterEvent
from PySide6.QtWidgets import QApplication

from plusedit.app.background import CancelledError
from plusedit.document.design import Design
from plusedit.document.map_record import MapRecord, map_of, with_map
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import NOTHING, Shape, ShapeId
from plusedit.geometry.mesh.domains import PillowDomain, PlaneDomain
from plusedit.geometry.mesh.mapping import mapped
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from tests.designs import a_design
from tests.geometry.mesh.mapped_bodies import ball
from tests.scene.meshes import HILL, a_landscape

pytestmark = pytest.mark.gui

BALL = ShapeId("ball")


def a_ball():
    mesh = ball(3, (1.0, 0.8, 1.4))
    found = mapped(mesh)
    return MeshSurface(mesh, found.domain, found.parameters)


@pytest.fixture
def closed(qtbot, window):
    """The window with a closed body selected and its parameters in view."""
    window.files.show(Design({BALL: Shape(a_ball(), "Ball")}), None)
    return looked_at(qtbot, window, BALL)


@pytest.fixture
def sheet(qtbot, window):
    """The same with a hill."""
    window.files.show(a_landscape(), None)
    return looked_at(qtbot, window, HILL)


def looked_at(qtbot, window, shape_id):
    window.resize(1500, 900)
    window.session.select(Selection.of_shapes([shape_id]))
    window.actions_table["panel.parameters"].trigger()
    settle(qtbot, window)
    return window


def settle(qtbot, window):
    panel = window.docks.widget("parameters")
    panel.refresh()
    qtbot.waitUntil(
        lambda: panel.view.sheet is not None and not panel.view.picture.is_busy, timeout=20000
    )


def panel(window):
    return window.docks.widget("parameters")


def view(window):
    return panel(window).view


def pixel(window, place):
    x, y = view(window).camera.to_screen(np.array(place, dtype=float)[None])[0]
    return QPoint(round(float(x)), round(float(y)))


def center(window, face):
    return pixel(window, view(window).sheet.unfolding.centers[face])


def enter(widget):
    middle = QPointF(widget.rect().center())
    QApplication.sendEvent(widget, QEnterEvent(middle, middle, middle))


def drag(qtbot, window, start, end, held=Qt.KeyboardModifier.NoModifier):
    button = Qt.MouseButton.LeftButton
    qtbot.mousePress(view(window), button, held, pos=start)
    for share in (0.3, 0.7, 1.0):
        qtbot.mouseMove(view(window), start + (end - start) * share)
    qtbot.mouseRelease(view(window), button, held, pos=end)


def test_it_is_hidden_at_first_and_ctrl_4_shows_and_hides_it(qtbot, window):
    window.resize(1500, 900)
    window.files.show(a_landscape(), None)
    dock, action = window.docks.by_name["parameters"], window.actions_table["panel.parameters"]
    assert dock.isHidden()
    assert action.shortcut().toString() == "Ctrl+4"
    inspector = window.docks.by_name["inspector"].width()
    action.trigger()
    assert dock.isVisible()
    qtbot.waitUntil(lambda: dock.width() > 300)
    qtbot.waitUntil(lambda: window.docks.by_name["inspector"].width() == inspector)
    action.trigger()
    assert dock.isHidden()
    qtbot.waitUntil(lambda: window.docks.by_name["inspector"].width() == inspector)


def test_without_a_mesh_it_says_what_to_do(qtbot, window):
    window.files.show(a_design(), None)
    window.actions_table["panel.parameters"].trigger()
    panel(window).refresh()
    assert view(window).sheet is None
    assert not panel(window).bar.map.isEnabled()
    assert view(window).grab().toImage().pixelColor(3, 3).isValid()


def test_the_only_mesh_is_shown_though_it_is_not_selected(qtbot, sheet):
    sheet.session.select(Selection())
    settle(qtbot, sheet)
    assert view(sheet).sheet is not None


def test_a_click_selects_a_face_for_all_views(qtbot, sheet):
    qtbot.mouseClick(view(sheet), Qt.MouseButton.LeftButton, pos=center(sheet, 14))
    assert sheet.session.selection.lines == {LineId(HILL, 14)}
    shift = Qt.KeyboardModifier.ShiftModifier
    qtbot.mouseClick(view(sheet), Qt.MouseButton.LeftButton, shift, pos=center(sheet, 20))
    assert sheet.session.selection.lines == {LineId(HILL, 14), LineId(HILL, 20)}


def test_a_box_selects_faces(qtbot, sheet):
    drag(qtbot, sheet, pixel(sheet, (-0.02, 0.35)), pixel(sheet, (0.35, -0.02)))
    numbers = {line.number for line in sheet.session.selection.lines}
    expected = view(sheet).sheet.unfolding.faces_within(np.zeros(2), np.full(2, 0.35))
    assert numbers == set(expected.tolist())
    assert len(numbers) == 4


def test_escape_ends_a_box(qtbot, sheet):
    before = sheet.session.selection
    qtbot.mousePress(view(sheet), Qt.MouseButton.LeftButton, pos=pixel(sheet, (0.1, 0.1)))
    qtbot.mouseMove(view(sheet), pixel(sheet, (0.6, 0.6)))
    qtbot.keyClick(view(sheet), Qt.Key.Key_Escape)
    qtbot.mouseRelease(view(sheet), Qt.MouseButton.LeftButton, pos=pixel(sheet, (0.6, 0.6)))
    assert sheet.session.selection == before


def test_what_is_under_the_pointer_stands_in_the_status_bar(qtbot, sheet):
    qtbot.mouseMove(view(sheet), center(sheet, 14))
    # As planes are counted in the inspector and in the table, from one on.
    qtbot.waitUntil(lambda: "face 15" in sheet.status.bend.text())
    assert "angles" in sheet.status.bend.text()
    assert sheet.status.place.text().startswith("u 0.")
    assert "box" in sheet.status.text.text()


def test_selected_faces_are_seen_in_another_color(qtbot, sheet):
    at = center(sheet, 14) + QPoint(0, 4)
    plain = view(sheet).grab().toImage().pixelColor(at)
    sheet.session.select(Selection.of_lines([LineId(HILL, 14)]))
    settle(qtbot, sheet)
    assert view(sheet).grab().toImage().pixelColor(at) != plain


def test_keys_frame_the_selected_faces_and_all(qtbot, sheet):
    whole = view(sheet).camera
    sheet.session.select(Selection.of_lines([LineId(HILL, 14)]))
    settle(qtbot, sheet)
    enter(view(sheet))
    qtbot.keyClick(view(sheet), Qt.Key.Key_F)
    assert view(sheet).camera.scale > 3.0 * whole.scale
    qtbot.keyClick(view(sheet), Qt.Key.Key_Home)
    assert view(sheet).camera == whole


def test_the_view_pans_with_what_it_has_and_then_has_more(qtbot, sheet):
    raster = view(sheet).picture._raster
    view(sheet).pan(3.0, 2.0)
    assert not view(sheet).picture.is_busy
    view(sheet).pan(400.0, 0.0)
    settle(qtbot, sheet)
    assert view(sheet).picture._raster is not raster


def test_a_slider_of_smoothness_lays_nothing_out_anew(qtbot, sheet):
    before = view(sheet).sheet
    sheet.session.select(Selection.of_shapes([HILL]))
    sheet.magnitude.smoothness._set(2.0)
    settle(qtbot, sheet)
    assert view(sheet).sheet is before


def test_maps_that_do_not_suit_can_not_be_chosen_and_say_why(sheet):
    combo = panel(sheet).bar.map
    pillow = combo.findData("pillow")
    assert not combo.model().item(pillow).isEnabled()
    assert "it isn't closed" in combo.itemData(pillow, Qt.ItemDataRole.ToolTipRole)
    assert combo.model().item(combo.findData("square")).isEnabled()
    assert combo.findData("file_uv") < 0


def choose(window, name):
    combo = panel(window).bar.map
    combo.activated.emit(combo.findData(name))


def test_another_map_is_one_step(qtbot, sheet):
    before = sheet.session.design.mesh(HILL)
    choose(sheet, "circle")
    after = sheet.session.design.mesh(HILL)
    assert not np.array_equal(after.parameters, before.parameters)
    assert map_of(sheet.session.design[HILL]) == MapRecord("circle")
    assert sheet.session.undo_label == "Change map"
    settle(qtbot, sheet)
    assert panel(sheet).bar.map.currentData() == "circle"
    sheet.session.undo()
    assert sheet.session.design.mesh(HILL) is before
    settle(qtbot, sheet)
    assert panel(sheet).bar.map.currentIndex() == -1


def test_edited_planes_lie_in_space_as_before(qtbot, sheet):
    edited = sheet.session.design.mesh(HILL).with_plane(5, gradient_u=[1.0, 0.0, 2.0])
    sheet.files.show(a_landscape(edited), None)
    looked_at(qtbot, sheet, HILL) if sheet.docks.by_name["parameters"].isHidden() else None
    settle(qtbot, sheet)
    before = edited.planes
    choose(sheet, "square")
    after = sheet.session.design.mesh(HILL)
    normal = np.cross(before.gradients_u[5], before.gradients_v[5])
    turned = np.cross(after.planes.gradients_u[5], after.planes.gradients_v[5])
    cosine = normal @ turned / np.linalg.norm(normal) / np.linalg.norm(turned)
    assert cosine == pytest.approx(1.0, abs=1e-6)


def test_a_cone_point_is_dragged_to_another_vertex(qtbot, closed):
    unfolding, old = view(closed).sheet.unfolding, view(closed).sheet.cone_points
    target = unfolding.mesh.corners[unfolding.face_at(np.array([0.3, 0.2])) * 3]
    drag(
        qtbot,
        closed,
        pixel(closed, unfolding.domain.cone_points[2]),
        pixel(closed, unfolding.vertex_places[target]),
    )
    assert closed.session.undo_label == "Choose cone points"
    record = map_of(closed.session.design[BALL])
    assert record.name == "pillow"
    assert set(record.cone_points) - set(old) == {target}
    settle(qtbot, closed)
    assert set(view(closed).sheet.cone_points) == set(record.cone_points)
    panel(closed).bar.reset.trigger()
    assert map_of(closed.session.design[BALL]) == MapRecord("pillow")
    settle(qtbot, closed)
    assert set(view(closed).sheet.cone_points) == set(old)


def test_cone_points_are_taken_from_four_selected_faces(qtbot, closed):
    bar, mesh = panel(closed).bar, closed.session.design.mesh(BALL).mesh
    assert not bar.from_faces.isEnabled()
    chosen = (10, 120, 250, 400)
    closed.session.select(Selection.of_lines(LineId(BALL, face) for face in chosen))
    settle(qtbot, closed)
    assert bar.from_faces.isEnabled()
    bar.from_faces.trigger()
    points = map_of(closed.session.design[BALL]).cone_points
    assert len(set(points)) == 4
    for face, point in zip(chosen, points, strict=True):
        assert point in mesh.corners[3 * face : 3 * face + 3]
    assert isinstance(closed.session.design.mesh(BALL).domain, PillowDomain)


def test_texture_coordinates_are_named_where_a_file_brought_them(qtbot, window):
    extra = with_map(NOTHING, MapRecord("file_uv"))
    window.files.show(a_landscape(extra=extra), None)
    looked_at(qtbot, window, HILL)
    assert panel(window).bar.map.currentText() == "texture coordinates"


def test_a_mesh_that_is_read_tells_of_its_map(qtbot, window, tmp_path):
    path = tmp_path / "square.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    assert window.files.open(path)
    (shape,) = window.session.design.shapes.values()
    assert map_of(shape) == MapRecord("height_field")


def test_only_pillows_have_cone_points(sheet):
    assert panel(sheet).bar.cones.isHidden()


def test_what_can_not_be_done_is_said_and_changes_nothing(qtbot, sheet):
    before, said = sheet.session.design, []
    sheet.desk.said.listen(said.append)
    sheet.desk.map_asked.emit(HILL, MapRecord("torus"))
    assert sheet.session.design is before
    assert "does not suit" in said[-1]


def test_work_that_is_given_up_changes_nothing(sheet, monkeypatch):
    before, said = sheet.session.design, []
    sheet.desk.said.listen(said.append)

    def given_up(*_, **__):
        raise CancelledError

    monkeypatch.setattr("plusedit.app.remapping.in_background", given_up)
    sheet.desk.map_asked.emit(HILL, MapRecord("circle"))
    assert sheet.session.design is before
    assert said == ["Hill keeps its map."]


def test_a_locked_mesh_keeps_its_map(qtbot, window):
    window.files.show(a_landscape(locked=True), None)
    looked_at(qtbot, window, HILL)
    assert not panel(window).bar.map.isEnabled()
    window.desk.map_asked.emit(HILL, MapRecord("circle"))
    assert isinstance(window.session.design.mesh(HILL).domain, PlaneDomain)
    assert not window.session.undo_label


def test_the_inspector_names_the_map(qtbot, sheet):
    form = sheet.docks.widget("inspector")._shape._meshes
    assert form.map.text() == "unknown"
    choose(sheet, "circle")
    sheet.docks.widget("inspector").refresh()
    assert form.map.text() == "disk"


def test_colors_stand_for_areas_if_so_chosen(qtbot, sheet):
    bar, legend = panel(sheet).bar, panel(sheet).legend
    assert legend.legend.title == "Stretch of angles"
    bar.measure.setCurrentIndex(bar.measure.findData("areas"))
    bar.measure.activated.emit(bar.measure.currentIndex())
    assert legend.legend.title == "Stretch of areas"
    assert legend.text == "No triangle is turned over"
