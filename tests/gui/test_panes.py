"""Both views of the window: which are shown, which is in use, what is kept of them."""

import pytest
from PySide6.QtCore import Qt

from plusedit.commands.shapes import AddShapes
from plusedit.document.shape import Shape, ShapeId
from plusedit.views.missing_space import MissingSpace
from tests.geometry.surfaces import a_surface


@pytest.fixture
def with_surface(window):
    """The window with one surface in it."""
    sail = (ShapeId("sail"), Shape(a_surface(), "Sail"))
    window.session.commit(AddShapes((sail,)))
    return window


def test_a_flat_design_has_the_room_of_both_views(window):
    window.show_view()
    assert window.panes.shown == "2d"
    assert window.canvas.isVisible()


def test_the_3d_view_appears_with_the_first_surface(with_surface):
    assert with_surface.panes.shown == "both"
    with_surface.undo()
    assert with_surface.panes.shown == "both"


def test_what_a_person_chose_stays(window):
    window.view.show_panes("2d")
    window.session.commit(AddShapes(((ShapeId("sail"), Shape(a_surface(), "Sail")),)))
    assert window.panes.shown == "2d"


def test_without_opengl_the_pane_says_so_and_the_2d_view_edits(with_surface):
    panes = with_surface.panes
    missing = panes.findChild(MissingSpace)
    assert missing.isVisible()
    assert "OpenGL" in missing.accessibleDescription()
    assert panes.active is panes.plane
    with_surface.actions_table["edit.select_all"].trigger()
    with_surface.actions_table["edit.nudge_up"].trigger()
    assert with_surface.session.undo_label == "Move 20 control planes"


def test_only_the_3d_pane_is_seen_when_asked_for(with_surface):
    with_surface.actions_table["panes.3d"].trigger()
    assert not with_surface.canvas.isVisible()
    with_surface.actions_table["panes.both"].trigger()
    assert with_surface.canvas.isVisible()


def test_the_panes_a_person_chose_are_kept_with_the_design(with_surface):
    assert "panes" not in with_surface.view.kept_with(with_surface.session.design).view
    with_surface.view.show_panes("3d")
    assert with_surface.view.kept_with(with_surface.session.design).view["panes"] == "3d"


def test_a_tool_is_chosen_for_all_views(window):
    window.choose_tool("pen")
    assert window.gestures.tool_name == "pen"
    assert window.canvas.gestures.tool_name == "pen"


@pytest.mark.parametrize("side", ["top", "front", "right"])
def test_the_2d_view_looks_from_three_sides(with_surface, side):
    with_surface.actions_table[f"projection.{side}"].trigger()
    assert with_surface.canvas.camera.projection == side
    assert with_surface.actions_table[f"projection.{side}"].isChecked()


def test_other_sides_are_for_the_3d_view(with_surface):
    with_surface.actions_table["projection.left"].trigger()
    assert "2D view looks from" in with_surface.status.text.text()
    assert with_surface.canvas.camera.projection == "top"


def test_the_table_lists_control_planes_with_both_directions(with_surface):
    table = with_surface.docks.widget("lines_table")
    table.refresh()
    heads = [
        table.model.headerData(column, Qt.Orientation.Horizontal)
        for column in range(table.model.columnCount())
    ]
    assert {"x", "y", "z", "u Az", "v El", "u Length", "Weight"} <= set(heads)
    assert len(table.model.rows) == len(with_surface.session.design.surface("sail").planes)
    assert table.model.data(table.model.index(5, 0)) == "Sail 2, 1"
