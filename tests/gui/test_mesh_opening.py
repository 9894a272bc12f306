"""Meshes and terrains opened and imported in the window."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, Qt, QUrl
from PySide6.QtGui import QDropEvent

from plusedit.app.background import CancelledError, Progress
from plusedit.app.mesh_opening import is_mesh, opened
from plusedit.app.mesh_report import MeshReportWindow
from plusedit.io.formats import FormatError
from tests.designs import a_design

pytestmark = pytest.mark.gui

CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
SIDES = [(4, 3, 2, 1), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)]


def obj(*shifts, sides=SIDES):
    """The text of an OBJ with a cube at every shift along x."""
    lines = [f"v {x + shift} {y} {z}" for shift in shifts for x, y, z in CORNERS]
    for number in range(len(shifts)):
        lines += ["f " + " ".join(str(8 * number + c) for c in side) for side in sides]
    return "\n".join(lines) + "\n"


@pytest.fixture
def cubes(tmp_path):
    path = tmp_path / "cubes.obj"
    path.write_text(obj(0, 3))
    return path


def test_a_mesh_is_opened_with_one_shape_for_each_part(window, cubes):
    assert window.files.open(cubes)
    shapes = window.session.design.shapes.values()
    assert [shape.name for shape in shapes] == ["cubes 1", "cubes 2"]
    assert all(shape.mesh.mesh.face_count == 6 * 16 for shape in shapes)  # split: they were few
    assert window.files.path == cubes
    assert not window.session.undo_label


def test_a_design_from_a_mesh_is_saved_as_a_design_of_its_own(window, answers, cubes):
    window.files.open(cubes)
    answers.save = cubes.with_name("mine.plus.json")
    assert window.files.save()
    assert answers.suggested.name == "cubes.plus.json"
    assert cubes.read_text() == obj(0, 3)
    assert window.files.open(answers.save)
    assert len(list(window.session.design.meshes())) == 2


def test_a_mesh_is_imported_beside_what_is_there_in_one_step(window, answers, cubes):
    window.files.show(a_design(), None)
    before = window.session.design
    window.flows.import_mesh(cubes)
    assert len(window.session.design) == len(before) + 2
    assert len(window.session.selection.shapes) == 2
    window.session.undo()
    assert window.session.design is before


def test_a_mesh_is_dropped_on_the_window(window, cubes):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(cubes))])
    buttons, held = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    window.dropEvent(QDropEvent(QPoint(5, 5), Qt.DropAction.CopyAction, data, buttons, held))
    assert len(list(window.session.design.meshes())) == 2


def test_a_report_tells_of_every_part(qtbot, window, cubes):
    assert not window.actions_table["mesh_report"].isEnabled()
    window.files.open(cubes)
    assert window.notes.isVisible()
    window.actions_table.refresh()
    assert window.actions_table["mesh_report"].isEnabled()
    window.actions_table["mesh_report"].trigger()
    (dialog,) = window.findChildren(MeshReportWindow)
    assert dialog.parts.topLevelItemCount() == 2
    first = dialog.parts.topLevelItem(0)
    rows = {first.child(k).text(0): first.child(k).text(1) for k in range(first.childCount())}
    assert rows["Faces"] == "6: 6 quads"
    assert (rows["Holes"], rows["Handles"], rows["Flipped triangles"]) == ("0", "0", "0")
    assert rows["Map"]


def test_repairs_are_told(window, tmp_path):
    path = tmp_path / "twice.obj"
    path.write_text(obj(0) + "f 5 6 7 8\n")
    window.files.open(path)
    assert "copy" in window.notes.text.text()


def test_a_file_without_a_mesh_leaves_the_design_alone(window, answers, tmp_path):
    window.files.show(a_design(), None)
    before = window.session.design
    path = tmp_path / "none.obj"
    path.write_text("v 0 0 0\n")
    assert not window.files.open(path)
    assert window.session.design is before
    (sentence,) = answers.errors
    assert sentence.startswith("none.obj: ")


def test_work_that_was_cancelled_ends_as_it_tells_how_far_it_is(cubes):
    progress = Progress()
    progress.is_cancelled = True
    with pytest.raises(CancelledError):
        opened(cubes, progress.tell)


def test_progress_grows(cubes):
    told = []
    opened(cubes, lambda share, words: told.append((share, words)))
    shares = np.array([share for share, _ in told])
    assert (np.diff(shares) >= 0.0).all()
    assert 0.0 <= shares[0] <= shares[-1] <= 1.0
    assert all(words for _, words in told)


def test_names_of_meshes_are_told_from_those_of_designs():
    assert is_mesh(Path("Bunny.OBJ")) and is_mesh(Path("a.tar.ply"))
    assert not is_mesh(Path("a.plus.json")) and not is_mesh(Path("a.svg"))


def test_what_has_no_surface_is_said_in_a_sentence(tmp_path):
    path = tmp_path / "line.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
    with pytest.raises(FormatError, match=r"line\.obj: "):
        opened(path, lambda share, words: None)
