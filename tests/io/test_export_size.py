"""What an export will hold is told before it is written."""

import pytest

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.mesh.mapping import mapped
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.io.export_pieces import Fineness, even_cells
from plusedit.io.export_size import expected, triangles_of, words_of
from plusedit.io.exporting import export_design
from plusedit.io.exports import exports
from plusedit.io.formats import FormatError
from tests.designs import a_curve
from tests.geometry.mesh.bodies import cube, sheet, torus
from tests.geometry.surfaces import a_surface


def smooth(mesh):
    found = mapped(mesh)
    return MeshSurface(mesh, found.domain, found.parameters)


DESIGN = Design(
    {
        "sail": Shape(a_surface(), "Sail"),
        "boom": Shape(a_curve(), "Boom"),
        "ring": Shape(smooth(torus(24, 12)), "Ring"),
        "cube": Shape(smooth(cube().subdivided(3).mesh), "Cube"),
    }
)


def times(number):
    return Fineness(times=lambda mesh: number)


@pytest.mark.parametrize(
    "fineness",
    [Fineness(), times(0), times(2), Fineness(cells=even_cells)],
    ids=["tolerance", "vertices", "split", "grid"],
)
@pytest.mark.parametrize("kind", exports)
def test_about_as_much_is_written_as_was_told(tmp_path, kind, fineness):
    entry = exports[kind]
    told = expected(DESIGN, entry, fineness=fineness)
    path = tmp_path / f"out{entry.suffixes[0]}"
    report = export_design(DESIGN, path, fineness=fineness)
    assert told.points == pytest.approx(report.points, rel=0.25)
    assert told.size == pytest.approx(path.stat().st_size, rel=0.25)
    if not entry.has_quads:
        assert told.triangles == report.faces


@pytest.mark.parametrize("number", range(4))
@pytest.mark.parametrize("mesh", [cube(), sheet(2, 3)])
def test_triangles_are_counted_exactly(mesh, number):
    split = mesh.subdivided(number).mesh
    assert triangles_of(mesh, number) == len(split.triangulation.triangles)


def test_nothing_to_write_is_told_in_the_words_of_the_export():
    with pytest.raises(FormatError, match="nothing to write"):
        expected(Design({"boom": Shape(a_curve(), "Boom")}), exports["stl"])


@pytest.mark.parametrize(
    ("size", "words"),
    [
        (0, "0 bytes"),
        (999, "999 bytes"),
        (1000, "1.0 kB"),
        (9_960, "10 kB"),
        (4_230_000, "4.2 MB"),
        (999_600_000, "1.0 GB"),
    ],
)
def test_sizes_are_told_in_two_or_three_digits(size, words):
    assert words_of(size) == words
