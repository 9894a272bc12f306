"""The form that asks how shapes are to be written as a mesh."""

import numpy as np
import pytest

from plusedit.app.background import CancelledError
from plusedit.app.mesh_export import COUNTING, Counter, MeshDialog, MeshExport, cells_of
from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape
from plusedit.geometry.mesh.mapping import mapped
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.rectangle import rectangle
from plusedit.io.export_pieces import Fineness
from plusedit.io.exporting import Tolerance
from plusedit.io.mesh_reading import read_mesh
from tests.designs import a_curve
from tests.geometry.mesh.bodies import cube, torus

pytestmark = pytest.mark.gui


def smooth(mesh):
    found = mapped(mesh)
    return MeshSurface(mesh, found.domain, found.parameters)


RING, CUBE = smooth(torus(24, 12)), smooth(cube().subdivided(2).mesh)
DESIGN = Design({"ring": Shape(RING, "Ring"), "cube": Shape(CUBE, "Cube")})
CURVE = Design({"boom": Shape(a_curve(), "Boom")})


@pytest.fixture
def dialog(qtbot):
    def make(design, selected=()):
        made = MeshDialog(None, design, selected)
        qtbot.addWidget(made)
        return made

    return make


def choose(field, words):
    field.setCurrentIndex(next(i for i in range(field.count()) if words in field.itemText(i)))


def shows(form, field):
    return form.form.isRowVisible(field)


def test_without_meshes_nothing_is_asked_about_them(dialog):
    form = dialog(CURVE)
    assert not shows(form, form.fineness)
    assert shows(form, form.tolerance)
    assert form.read().fineness == Fineness()


def test_the_tolerance_matters_where_it_decides(dialog):
    form = dialog(DESIGN)
    assert shows(form, form.tolerance)
    choose(form.fineness, "vertices")
    assert not shows(form, form.tolerance)
    assert form.read().fineness.times(CUBE.mesh) == 0
    choose(form.fineness, "twice")
    assert form.read().fineness.times(CUBE.mesh) == 2


def test_a_grid_is_offered_where_a_map_suits_it_with_about_as_many_cells_as_faces(dialog):
    form = dialog(DESIGN)
    choose(form.fineness, "grid")
    assert shows(form, form.cells)
    along, across = form.read().fineness.cells(RING, rectangle(RING))
    assert along * across == pytest.approx(RING.mesh.face_count, rel=0.2)
    none = dialog(Design({"cube": Shape(CUBE, "Cube")}))
    assert not any("grid" in none.fineness.itemText(i) for i in range(none.fineness.count()))


@pytest.mark.parametrize("words", ["200 × 100", "200x100", " 400/2 * 100 "])
def test_cells_are_two_numbers(words):
    assert cells_of(words) == (200, 100)


@pytest.mark.parametrize("words", ["", "200", "1 × 9", "a × b", "3 × 4 × 5", "1e9 × 3"])
def test_other_cells_are_refused(words):
    with pytest.raises(ValueError, match=r"\S"):
        cells_of(words)


def test_how_large_the_file_will_be_is_counted_beside(qtbot, dialog):
    form = dialog(DESIGN)
    assert form.size_of_file.text() == COUNTING
    choose(form.fineness, "vertices")
    qtbot.waitUntil(lambda: "triangles, about" in form.size_of_file.text())
    triangles = 2 * (RING.mesh.face_count + CUBE.mesh.face_count)
    assert form.size_of_file.text().startswith(f"{triangles:,} triangles")
    form.tolerance.setText("much")
    choose(form.fineness, "tolerance")
    assert "expected a tolerance" in form.size_of_file.text()


def test_only_the_last_of_several_wishes_is_told(qtbot, dialog):
    form = dialog(CURVE)
    counter, told = Counter(form), []
    counter.counted.listen(told.append)
    for number in range(5):
        counter.count(lambda number=number: str(number))
    qtbot.waitUntil(lambda: "4" in told)
    assert told == ["4"]


def test_meshes_are_written_as_was_chosen_and_told(window, answers, tmp_path):
    window.files.show(DESIGN, None)
    window.desk.select(Selection.of_shapes(["cube"]))
    answers.exported = tmp_path / "cube.ply"
    fineness = Fineness(times=lambda mesh: 1)
    window.flows.write_mesh(MeshExport("ply", Tolerance(1.0), True, fineness))
    mesh = read_mesh(answers.exported).mesh
    assert mesh.face_count == 2 * 4 * CUBE.mesh.face_count
    assert np.isfinite(mesh.vertices).all()


def test_the_mesh_that_was_opened_is_not_offered_to_be_written_over(window, answers, tmp_path):
    window.files.show(DESIGN, tmp_path / "hill.obj")
    for kind, name in (("obj", "hill smooth.obj"), ("ply", "hill.ply")):
        window.flows.write_mesh(MeshExport(kind, Tolerance(1.0), False))
        assert answers.suggested == tmp_path / name


def test_an_export_that_is_given_up_leaves_no_file_and_no_error(
    window, answers, tmp_path, monkeypatch
):
    def give_up(*_, **__):
        raise CancelledError

    monkeypatch.setattr("plusedit.app.files.in_background", give_up)
    window.files.show(DESIGN, None)
    answers.exported = tmp_path / "cube.ply"
    window.flows.write_mesh(MeshExport("ply", Tolerance(1.0), False))
    assert not answers.errors
    assert list(tmp_path.glob("*.ply")) == []
