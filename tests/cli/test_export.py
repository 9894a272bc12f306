"""`plusedit export`: files for other programs, or one line that says why not."""

import pytest

from plusedit.__main__ import main
from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.io.files import save
from tests.designs import a_curve
from tests.geometry.mesh.bodies import sheet
from tests.geometry.surfaces import a_surface
from tests.io.mesh_files import READERS, a_torus


@pytest.fixture
def sail(tmp_path):
    """A file with a surface, a ring and a curve."""
    shapes = {
        "sail": Shape(a_surface(), "Main sail"),
        "ring": Shape(a_torus(), "Ring"),
        "boom": Shape(a_curve(), "Boom"),
    }
    save(Design(shapes), tmp_path / "sail.json")
    return tmp_path / "sail.json"


@pytest.fixture
def refused(capsys):
    """Why `plusedit export` refuses."""

    def run(*words):
        assert main(["export", *map(str, words)]) == 2
        out, complaint = capsys.readouterr()
        assert out == ""
        assert complaint.count("\n") == 1
        return complaint.strip()

    return run


@pytest.mark.parametrize("suffix", READERS)
def test_all_that_a_file_can_hold_is_written_and_told(sail, tmp_path, capsys, suffix):
    out = tmp_path / f"out.{suffix}"
    assert main(["export", str(sail), str(out)]) == 0
    told, notes = capsys.readouterr()
    assert told.startswith(f"out.{suffix}: 2 surfaces")
    assert READERS[suffix](out.read_bytes())
    assert ('"Boom" is left out' in notes) == (suffix != "obj")


def test_shapes_can_be_named(sail, tmp_path):
    out = tmp_path / "out.glb"
    assert main(["export", str(sail), str(out), "--shape", "ring", "--shape", "sail"]) == 0
    assert [part.name for part in READERS["glb"](out.read_bytes())] == ["Ring", "Main sail"]


def test_the_tolerance_can_be_a_length_or_a_share(sail, tmp_path, capsys):
    for words, said in (("0.02", "within 0.02"), ("1%", "within 0.1")):
        assert main(["export", str(sail), str(tmp_path / "o.stl"), "--tolerance", words]) == 0
        assert said in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "faces"),
    [
        (["--subdivide", "0"], 8),
        (["--subdivide", "2"], 8 * 16),
        (["--grid", "5x7"], 35),
        (["--grid", "even"], 8),
    ],
)
def test_meshes_are_as_fine_as_is_said(tmp_path, capsys, words, faces):
    mesh = sheet(2, 4)
    surface = MeshSurface(mesh, PlaneDomain(), mesh.vertices[mesh.corners, :2])
    save(Design({"a": Shape(surface, "A")}), tmp_path / "a.json")
    assert main(["export", str(tmp_path / "a.json"), str(tmp_path / "a.obj"), *words]) == 0
    [part] = READERS["obj"]((tmp_path / "a.obj").read_bytes())
    assert len(part.faces) == faces
    assert "within" not in capsys.readouterr().out


def test_an_existing_file_is_replaced(sail, tmp_path):
    out = tmp_path / "out.stl"
    out.write_bytes(b"old")
    assert main(["export", str(sail), str(out)]) == 0
    assert READERS["stl"](out.read_bytes())


def test_the_design_is_not_written_over(sail, tmp_path, refused):
    link = tmp_path / "link.obj"
    link.symlink_to(sail)
    before = sail.read_bytes()
    assert refused(sail, link) == "link.obj: is read from and can't be written to"
    assert sail.read_bytes() == before


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["gone.json", "out.obj"], "gone.json: there is no such file"),
        (["sail.json", "out.step"], 'out.step: suffix ".step" is not known; known are .glb, .obj'),
        (["sail.json", "out"], "out: has no suffix"),
        (["sail.json", "no/out.obj"], "out.obj: there is no folder"),
        (["sail.json", "out.obj", "--shape", "x"], 'out.obj: shape "x": the design has no such'),
        (["sail.json", "out.stl", "--shape", "boom"], 'out.stl: shape "boom": STL has no curves'),
        (
            ["sail.json", "out.obj", "--tolerance", "x"],
            "plusedit export: argument --tolerance: exp",
        ),
        (
            ["sail.json", "out.obj", "--tolerance", "0"],
            "plusedit export: argument --tolerance: exp",
        ),
        (["sail.json"], "plusedit export: the following arguments are required"),
        (["sail.json", "out.obj", "--grid", "9x"], "plusedit export: argument --grid: expected"),
        (["sail.json", "out.obj", "--grid", "1x9"], "plusedit export: argument --grid: expected"),
        (["sail.json", "out.obj", "--subdivide", "9"], "plusedit export: argument --subdivide"),
        (
            ["sail.json", "out.obj", "--subdivide", "1", "--grid", "even"],
            "plusedit export: argument --grid: not allowed with",
        ),
    ],
)
def test_what_can_not_be_done_is_said_in_one_sentence(
    sail, tmp_path, refused, monkeypatch, words, why
):
    monkeypatch.chdir(tmp_path)
    assert refused(*words).startswith(why)
    assert [path.name for path in tmp_path.iterdir()] == ["sail.json"]
