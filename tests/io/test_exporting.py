"""Exporting a design: which shapes, how fine, and what is said of it."""

from dataclasses import replace

import numpy as np
import pytest

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.planes import ControlPlanes
from plusedit.io import export_pieces
from plusedit.io.exporting import USUAL, Report, Tolerance, export_design, export_of
from plusedit.io.formats import FormatError
from tests.designs import a_curve, a_mesh
from tests.geometry.surfaces import a_surface
from tests.io.mesh_files import READERS

DESIGN = Design(
    {
        "wing": Shape(a_curve(), "Wing"),
        "sail": Shape(a_surface(), "Sail"),
        "knee": Shape(a_mesh(), "Knee"),
        "hidden": Shape(a_surface(), "Ghost", visible=False),
    }
)


def refused(*arguments):
    """Why an export is refused."""
    with pytest.raises(FormatError) as told:
        export_design(*arguments)
    assert str(told.value).isprintable()
    return str(told.value)


def test_what_is_left_out_is_told(tmp_path):
    report = export_design(DESIGN, tmp_path / "out.ply")
    assert (report.surfaces, report.meshes, report.curves) == (1, 1, 0)
    assert report.left_out == (
        '"Wing" is left out: Stanford PLY has no curves',
        '"Ghost" is left out: it is hidden',
    )


def test_only_what_is_named_is_written_even_if_it_is_hidden(tmp_path):
    report = export_design(DESIGN, tmp_path / "out.obj", ["hidden", "wing", "hidden"])
    assert (report.surfaces, report.curves, report.left_out) == (1, 1, ())


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("gone", "the design has no such shape"),
        ("wing", "STL has no curves"),
    ],
)
def test_what_is_named_and_can_not_be_written_is_refused(tmp_path, name, why):
    told = refused(DESIGN, tmp_path / "out.stl", ["sail", name])
    assert told == f'out.stl: shape "{name}": {why}'
    assert list(tmp_path.iterdir()) == []


def test_nothing_to_write_is_told_with_the_first_reason(tmp_path):
    only = Design({"wing": DESIGN["wing"], "hidden": DESIGN["hidden"]})
    told = refused(only, tmp_path / "out.stl")
    assert told == 'out.stl: there is nothing to write; "Wing" is left out: STL has no curves'


def test_a_single_point_is_no_design(tmp_path):
    surface = a_surface()
    point = surface.with_net(surface.net.with_points(np.ones_like(surface.net.points)))
    design = Design({"a": Shape(replace(point, s=0.0), "a")})
    assert refused(design, tmp_path / "out.obj") == "out.obj: all of it is a single point"


def test_a_surface_without_area_is_refused(tmp_path):
    points = np.zeros((3, 3, 3))
    points[..., 0] = np.arange(9).reshape(3, 3)
    line = replace(a_surface(3, 3, s=0.0), planes=ControlPlanes.of(points))
    told = refused(Design({"a": Shape(line, "a")}), tmp_path / "out.obj")
    assert told == 'out.obj: shape "a": has no area'


def test_other_suffixes_name_the_known_ones():
    with pytest.raises(FormatError, match=r"known are \.glb, \.obj, \.ply, \.stl$"):
        export_of("out.step")


@pytest.mark.parametrize(
    ("words", "tolerance"),
    [
        ("0.01", Tolerance(0.01)),
        (" 2e-3 ", Tolerance(0.002)),
        ("0.1%", Tolerance(0.001, is_share=True)),
        ("5 %", Tolerance(0.05, is_share=True)),
    ],
)
def test_a_tolerance_is_a_length_or_a_share_of_the_size(words, tolerance):
    assert Tolerance.of(words) == tolerance


@pytest.mark.parametrize("words", ["", "x", "0", "-1", "0%", "%", "1%%", "nan", "inf", "1 mm"])
def test_other_tolerances_are_refused(words):
    with pytest.raises(ValueError, match="expected a tolerance such as"):
        Tolerance.of(words)


def test_the_size_is_the_diagonal_of_all_that_is_written(tmp_path):
    flat = a_surface(s=0.0)
    points = flat.net.points * [1.0, 1.0, 0.0]
    design = Design({"a": Shape(flat.with_net(flat.net.with_points(points)), "a")})
    assert export_design(design, tmp_path / "out.stl").tolerance == pytest.approx(0.0005 * 5.0)
    assert USUAL.length(5.0) == pytest.approx(0.0025)
    long = PlusCurve(a_curve().basis, a_curve().lines.with_points(a_curve().lines.points * 100))
    design = design.with_shape("b", Shape(long, "b"))
    assert export_design(design, tmp_path / "out.obj").tolerance > 0.0005 * 400
    assert export_design(design, tmp_path / "out.stl").tolerance == pytest.approx(0.0005 * 5.0)


@pytest.mark.parametrize("suffix", READERS)
def test_as_many_faces_are_told_as_are_written(tmp_path, suffix):
    report = export_design(DESIGN, tmp_path / f"out.{suffix}", ["sail"])
    [part] = READERS[suffix]((tmp_path / f"out.{suffix}").read_bytes())
    assert report.faces == len(part.faces)


def test_more_points_than_are_made_leave_a_note(tmp_path, monkeypatch):
    monkeypatch.setattr(export_pieces, "MOST", 2000)
    fine, coarse = (
        export_design(DESIGN, tmp_path / "out.stl", ["sail"], Tolerance(t)) for t in (1e-9, 0.1)
    )
    assert fine.points <= 2000
    assert "within" not in str(fine)
    assert fine.left_out == ('"Sail" is coarser than asked: no more than 2000 points are made',)
    assert coarse.left_out == ()


def test_a_report_is_a_sentence():
    report = Report(2, 1, 8192, 1, 0.00213, ())
    assert str(report) == "2 surfaces and 1 curve: 8192 points, 1 face, within 0.0021"
    assert str(Report(1, 0, 4, 1, 1.0, ())) == "1 surface: 4 points, 1 face, within 1"
