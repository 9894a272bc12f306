"""Faces of meshes in the panels of the window."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QCheckBox, QPushButton

from plusedit.app import menus
from plusedit.commands.lines import MovePoints
from plusedit.document.selection import LineId, Selection
from plusedit.scene.theme import DARK
from plusedit.views.face_form import FaceForm
from tests.gui.conftest import select_lines
from tests.gui.finding import named, type_into
from tests.scene.meshes import HILL, a_hill, a_landscape

pytestmark = pytest.mark.gui

LIFT = np.array([0.0, 0.0, 0.5])


@pytest.fixture
def landscape(window):
    """The window with a hill of 225 faces, selected."""
    window.files.show(a_landscape(a_hill(15)), None)
    window.session.select(Selection.of_shapes([HILL]))
    return window


@pytest.fixture
def inspector(landscape):
    return landscape.docks.widget("inspector")


@pytest.fixture
def table(landscape):
    return landscape.docks.widget("lines_table")


def hill(window):
    return window.session.design.mesh(HILL)


def button(inspector, text):
    (found,) = [b for b in inspector.findChildren(QPushButton) if b.text() == text]
    return found


def pick(inspector, window, *numbers):
    select_lines(window, HILL, *numbers)
    inspector.refresh()


def form_of(inspector):
    (form,) = inspector.findChildren(FaceForm)
    return form


def test_the_inspector_shows_and_takes_the_numbers_of_a_face(qtbot, landscape, inspector):
    pick(inspector, landscape, 40)
    own = hill(landscape).planes.points[40]
    assert named(inspector, "x").value == pytest.approx(own[0])
    assert not named(inspector, "weight").isVisibleTo(inspector)
    type_into(qtbot, named(inspector, "z"), "2")
    type_into(qtbot, named(inspector, "length by u"), "3")
    edited = hill(landscape).edited
    assert list(edited) == [40]
    assert_array_equal(edited[40].point, [*own[:2], 2.0])
    assert_allclose(np.linalg.norm(edited[40].gradient_u), 3.0)
    assert edited[40].gradient_v is None


def test_a_gradient_is_the_faces_own_until_it_is_turned(qtbot, landscape, inspector):
    pick(inspector, landscape, 40)
    switch = named(inspector, "automatic direction by u", QCheckBox)
    assert switch.isChecked() and not switch.isEnabled()
    type_into(qtbot, named(inspector, "elevation by u"), "45")
    inspector.refresh()
    assert not switch.isChecked() and switch.isEnabled()
    switch.click()
    assert not hill(landscape).edited


def test_edited_planes_are_counted_and_taken_back(landscape, inspector):
    landscape.session.commit(MovePoints({HILL: (3, 7)}, LIFT))
    inspector.refresh()
    form = form_of(inspector)
    assert form.edited.count.text() == "2 edited planes"
    pick(inspector, landscape, 7, 8)
    assert form.edited.count.text() == "1 edited plane"
    named(inspector, "reset edited planes").click()
    assert list(hill(landscape).edited) == [3]
    inspector.refresh()
    assert form.edited.isHidden()
    assert landscape.session.undo_label == "Reset 2 control planes"


def test_smoothness_at_faces_is_typed_stepped_and_taken_back(qtbot, landscape, inspector):
    pick(inspector, landscape, 3, 7)
    type_into(qtbot, named(inspector, "local S"), "3")
    assert_array_equal(hill(landscape).factors[[3, 7, 8]], [3.0, 3.0, 1.0])
    button(inspector, "Sharper").click()
    button(inspector, "Smoother").click()
    button(inspector, "Smoother").click()
    assert_array_equal(hill(landscape).factors[[3, 7, 8]], [6.0, 6.0, 1.0])
    inspector.refresh()
    assert form_of(inspector).uneven.count.text() == "2 faces with local S"
    named(inspector, "reset local S").click()
    assert hill(landscape).factors is None


def test_the_local_slider_is_drawn_again_in_other_colors(qtbot, landscape, inspector):
    pick(inspector, landscape, 3)
    slider = form_of(inspector).slider
    qtbot.waitUntil(slider.isVisible)
    drawn = []
    slider.paintEvent = lambda event: drawn.append(slider.theme)
    landscape.view.set_look("dark")
    qtbot.waitUntil(lambda: DARK in drawn)


def test_a_drag_of_the_local_slider_is_live_and_one_step(qtbot, landscape, inspector):
    pick(inspector, landscape, 3)
    slider, before = form_of(inspector).slider, hill(landscape)
    inspector.resize(260, 700)
    places = [QPoint(round(slider._x(value)), 15) for value in (1.0, 2.0, 4.0)]
    qtbot.mousePress(slider, Qt.MouseButton.LeftButton, pos=places[0])
    for place in places[1:]:
        qtbot.mouseMove(slider, place)
    assert landscape.session.is_previewing
    assert hill(landscape).factors[3] == pytest.approx(4.0, rel=0.1)
    qtbot.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=places[-1])
    assert landscape.session.undo_label == "Set local S of control plane"
    landscape.session.undo()
    assert hill(landscape) is before


def test_what_can_not_be_says_why(qtbot, landscape, inspector):
    pick(inspector, landscape, 3)
    type_into(qtbot, named(inspector, "local S"), "-1")
    assert "a factor of S lies between" in landscape.status.text.text()
    assert hill(landscape).factors is None


def test_many_faces_are_mixed_where_they_differ(landscape, inspector):
    pick(inspector, landscape, *range(100))
    assert named(inspector, "x").placeholderText() == "mixed"
    assert named(inspector, "azimuth by u").text() == "0"


def test_the_table_lists_faces_of_a_large_mesh_that_are_selected_or_edited(landscape, table):
    table.refresh()
    assert table.model.rows == []
    landscape.session.commit(MovePoints({HILL: (9,)}, LIFT))
    select_lines(landscape, HILL, 4, 200)
    table.refresh()
    assert table.model.rows == [LineId(HILL, face) for face in (4, 9, 200)]
    assert table.model.data(table.model.index(1, 0)) == "Hill 10"
    assert "weight" not in [column.kind for column in table.model._columns]


def test_a_face_picked_in_the_table_is_selected_and_the_others_stay_listed(landscape, table):
    select_lines(landscape, HILL, 4, 5, 200)
    table.refresh()
    table.table.selectRow(1)
    assert landscape.session.selection.by_shape() == {HILL: (5,)}
    table.refresh()
    assert len(table.model.rows) == 3
    select_lines(landscape, HILL, 6)
    table.refresh()
    assert table.model.rows == [LineId(HILL, 6)]


def test_a_cell_of_a_face_takes_a_number(landscape, table):
    select_lines(landscape, HILL, 4)
    table.refresh()
    heads = [column.head for column in table.model._columns]
    assert table.model.setData(table.model.index(0, heads.index("z")), "1.5")
    assert hill(landscape).edited[4].point[2] == 1.5


def test_faces_have_a_menu(landscape):
    actions = landscape.actions_table
    select_lines(landscape, HILL, 4)
    actions["edit.sharper"].trigger()
    assert hill(landscape).factors[4] == 0.5
    landscape.session.commit(MovePoints({HILL: (4, 9)}, LIFT))
    actions["edit.select_edited"].trigger()
    assert landscape.session.selection.by_shape() == {HILL: (4, 9)}
    for name in ("reset_factor", "reset_planes"):
        actions[f"edit.{name}"].trigger()
    assert hill(landscape).factors is None and not hill(landscape).edited
    landscape.session.select(Selection.of_shapes([HILL]))
    actions["edit.smoother"].trigger()
    assert "Select faces of a mesh first" in landscape.status.text.text()
    assert landscape._selected_kinds() == [menus.MESHES]


def test_copies_of_selected_faces_are_copies_of_their_mesh(landscape):
    select_lines(landscape, HILL, 4)
    landscape.session.commit(MovePoints({HILL: (4,)}, LIFT))
    landscape.clipboard.copy()
    landscape.clipboard.paste()
    (copy,) = [i for i in landscape.session.design if i != HILL]
    assert list(landscape.session.design.mesh(copy).edited) == [4]
    select_lines(landscape, HILL, 4)
    landscape.actions_table["edit.duplicate"].trigger()
    assert len(landscape.session.design) == 3
