"""Meshes and terrains opened and imported in the window."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, Qt, QUrl
from PySide6.QtGui import QDropEvent

from plusedit.app.background import CancelledError, Progress
from plusedit.app.mesh_opening import is_mesh, opened
from plusedit.app.mesh_options import MeshOptionsDialog, offered_maps, options_of, tree_of
from plusedit.app.mesh_report import MeshReportWindow
from plusedit.commands.shapes import DeleteShapes, Rename, SetLocked
from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.maps import maps
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.io.formats import FormatError
from plusedit.io.mesh_import import ImportOptions
from plusedit.scene.drawn_mesh import known_drawing
from tests.designs import a_design
from tests.geometry.mesh.bodies import sheet

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


class Asked:
    """Answers how a mesh is to be read, and remembers what was offered."""

    def __init__(self):
        self.answer, self.offered = ImportOptions(), []

    def __call__(self, path, options):
        self.offered.append(options)
        return self.answer


@pytest.fixture
def asked(window):
    window.flows.ask_options = Asked()
    return window.flows.ask_options


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


def test_a_mesh_is_imported_beside_what_is_there_in_one_step(window, asked, cubes):
    window.files.show(a_design(), None)
    before = window.session.design
    window.flows.import_mesh(cubes)
    assert len(window.session.design) == len(before) + 2
    assert len(window.session.selection.shapes) == 2
    window.session.undo()
    assert window.session.design is before


def test_the_same_mesh_is_imported_twice_under_names_of_its_own(window, asked, cubes):
    for _ in range(2):
        window.flows.import_mesh(cubes)
    assert len(window.session.design) == 4
    assert window.session.undo_label


def test_a_mesh_is_read_as_the_person_chose_which_is_remembered(window, asked, cubes):
    asked.answer = ImportOptions(smoothness=1.5, refine=False, map_name="pillow", measure=False)
    window.flows.import_mesh(cubes)
    surfaces = [surface for _, surface in window.session.design.meshes()]
    assert {(s.smoothness, s.mesh.face_count) for s in surfaces} == {(1.5, 6)}
    window.flows.import_mesh(cubes)
    assert asked.offered[-1] == asked.answer


def test_nothing_is_read_where_the_person_changes_their_mind(window, asked, cubes):
    asked.answer = None
    before = window.session.design
    window.flows.import_mesh(cubes)
    assert window.session.design is before
    assert not window.settings.mesh_options


def test_a_mesh_is_read_again_in_another_way_in_place_of_its_parts(window, asked, cubes):
    window.files.open(cubes)
    first, second = window.session.design
    window.desk.commit(Rename(first, "left"))
    asked.answer = ImportOptions(refine=False)
    window.side.import_mesh_again()
    design = window.session.design
    assert list(design) == [first, second]
    assert design[first].name == "left"
    assert design.mesh(first).mesh.face_count == 6
    window.session.undo()
    assert window.session.design.mesh(first).mesh.face_count == 6 * 16


def test_parts_that_were_deleted_come_back_when_the_mesh_is_read_again(window, asked, cubes):
    window.files.show(a_design(), None)
    window.flows.import_mesh(cubes)
    *others, first, second = window.session.design
    window.desk.commit(DeleteShapes((first,)))
    window.side.import_mesh_again()
    design = window.session.design
    assert len(design) == len(others) + 2
    assert second in design
    assert set(others) <= set(design)


def test_a_locked_part_is_not_read_again(window, asked, cubes):
    window.files.open(cubes)
    first, _ = window.session.design
    window.desk.commit(SetLocked((first,), True))
    before = window.session.design
    window.side.import_mesh_again()
    assert window.session.design is before


def test_what_is_read_is_drawn_at_once(window, cubes):
    window.files.open(cubes)
    for _, surface in window.session.design.meshes():
        assert known_drawing(surface) is not None


@pytest.mark.parametrize(
    "options",
    [
        ImportOptions(),
        ImportOptions(smoothness=2.25, area_weights=True, refine=False, map_name="torus"),
        ImportOptions(measure=True, up="y"),
    ],
)
def test_the_form_gives_back_what_it_was_filled_with(qtbot, options):
    dialog = MeshOptionsDialog(None, options, "a.obj")
    qtbot.addWidget(dialog)
    assert dialog.read() == options
    assert options_of(tree_of(options)) == options


@pytest.mark.parametrize(
    "tree",
    [
        {},
        {"smoothness": "much", "map": 3, "refine": "yes"},
        {"smoothness": 1e9, "map": "no such map", "measure": None},
        {"smoothness": True, "map": ["pillow"], "up": ["y"]},
    ],
)
def test_whatever_is_remembered_there_are_options(tree):
    found = options_of(tree)
    assert (found.map_name, found.up) == (None, None)
    assert (found.refine, found.measure) == (True, True)
    assert found.smoothness in (ImportOptions().smoothness, 1.0)


def test_a_smoothness_that_makes_no_sense_is_not_taken(qtbot):
    dialog = MeshOptionsDialog(None, ImportOptions(), "a.obj")
    qtbot.addWidget(dialog)
    for words in ("0", "-1", "1e6"):
        dialog.smoothness.setText(words)
        with pytest.raises(ValueError, match="between"):
            dialog.read()


def test_every_map_is_offered():
    assert set(offered_maps()) == set(maps)


def test_a_mesh_is_dropped_on_the_window(window, cubes):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(cubes))])
    buttons, held = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    window.dropEvent(QDropEvent(QPoint(5, 5), Qt.DropAction.CopyAction, data, buttons, held))
    assert len(list(window.session.design.meshes())) == 2


def rows_of(item):
    return {item.child(k).text(0): item.child(k).text(1) for k in range(item.childCount())}


def shown_report(window):
    (dialog,) = (d for d in window.findChildren(MeshReportWindow) if d.isVisible())
    return dialog


def test_a_report_tells_of_every_part(qtbot, window, cubes):
    assert not window.actions_table["mesh_report"].isEnabled()
    window.files.open(cubes)
    assert window.notes.isVisible()
    window.actions_table.refresh()
    assert window.actions_table["mesh_report"].isEnabled()
    window.actions_table["mesh_report"].trigger()
    dialog = shown_report(window)
    assert dialog.parts.topLevelItemCount() == 3
    assert dialog.parts.topLevelItem(0).text(1) == "12 faces; 2 × pillow"
    rows = rows_of(dialog.parts.topLevelItem(1))
    assert rows["Faces"] == "6 quads"
    assert (rows["Holes"], rows["Handles"], rows["Flipped triangles"]) == ("0", "0", "0")
    assert rows["Map"].startswith("pillow, ")


def test_distances_are_filled_in_as_they_become_known(qtbot, window, cubes):
    window.files.open(cubes)
    window.side.show_mesh_report()
    first = shown_report(window).parts.topLevelItem(1)
    assert rows_of(first)["Mesh to surface"] == "being measured …"
    qtbot.waitUntil(lambda: "rms" in rows_of(first)["Mesh to surface"], timeout=20_000)
    qtbot.waitUntil(lambda: not window.side.mesh_report.is_measuring, timeout=20_000)
    assert all(part.deviation is not None for part in window.side.mesh_report.report.parts)


def test_a_report_that_is_open_follows_the_mesh_that_is_read_next(window, asked, cubes):
    window.files.open(cubes)
    window.side.show_mesh_report()
    one = cubes.with_name("one.obj")
    one.write_text(obj(0))
    window.flows.import_mesh(one)
    assert shown_report(window).parts.topLevelItemCount() == 1


def test_a_report_is_copied_as_text(qapp, window, cubes):
    window.files.open(cubes)
    window.side.show_mesh_report()
    shown_report(window).copy()
    text = qapp.clipboard().text()
    assert text.startswith("cubes.obj: 2 parts")
    assert "cubes 2" in text


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


def test_meshes_are_copied_and_pasted(window, cubes):
    window.files.open(cubes)
    first, _ = window.session.design
    window.session.select(Selection.of_shapes([first]))
    assert window.clipboard.copy()
    window.clipboard.paste()
    *_, pasted = window.session.design
    before, after = (window.session.design.mesh(i) for i in (first, pasted))
    np.testing.assert_array_equal(before.parameters, after.parameters)
    assert len(window.session.design) == 3


def test_one_large_mesh_may_be_selected_after_another(window):
    mesh = sheet(40, 40)
    surface = MeshSurface(mesh, PlaneDomain(), mesh.vertices[mesh.corners, :2])
    window.files.show(Design({name: Shape(surface, name) for name in "ab"}), None)
    table = window.docks.widget("lines_table")
    for name in "abab":
        window.session.select(Selection.of_shapes([name]))
        table.refresh()
        assert not table.model.rows
