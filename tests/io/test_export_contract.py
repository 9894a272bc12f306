"""What holds for every export on the shelf."""

import errno
import io
import os
from pathlib import Path

import numpy as np
import pytest

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.io import files
from plusedit.io.exporting import export_design
from plusedit.io.exports import exports
from plusedit.io.formats import FormatError, formats
from plusedit.io.surface_mesh import Strand, meshed
from tests.geometry.surfaces import a_surface

every_export = pytest.mark.parametrize("export", exports.values(), ids=list(exports))
EVEN = np.linspace(0.0, 1.0, 9)


@pytest.fixture
def design():
    """A design of one sheet."""
    return Design({"sail": Shape(a_surface(), "Sail")})


def test_no_two_exports_share_a_suffix_nor_do_they_with_formats():
    suffixes = [
        s for shelf in (exports, formats) for entry in shelf.values() for s in entry.suffixes
    ]
    assert sorted(suffixes) == sorted(set(suffixes))


@every_export
def test_suffixes_are_lower_case_and_begin_with_a_dot(export):
    assert export.suffixes
    assert all(suffix[0] == "." and suffix == suffix.lower() for suffix in export.suffixes)


@every_export
def test_it_has_a_title(export):
    assert export.title


@every_export
def test_writing_the_same_gives_the_same_bytes(export):
    meshes = [meshed(a_surface(), EVEN, EVEN, name="a", numbers=export.numbers)]
    strands = [Strand("b", None, np.eye(3))] if export.has_curves else []
    streams = io.BytesIO(), io.BytesIO()
    for stream in streams:
        export.write(stream, meshes, strands)
    assert streams[0].getvalue() == streams[1].getvalue() != b""


@every_export
def test_it_writes_piece_by_piece(export):
    class Pieces(io.BytesIO):
        longest = 0

        def write(self, data):
            self.longest = max(self.longest, len(data))
            return super().write(data)

    even = np.linspace(0.0, 1.0, 250)
    stream = Pieces()
    export.write(stream, [meshed(a_surface(), even, even, numbers=export.numbers)], [])
    assert stream.longest < len(stream.getvalue()) / 3


@every_export
def test_without_curves_a_design_of_surfaces_is_written(export, design, tmp_path):
    report = export_design(design, tmp_path / f"out{export.suffixes[0]}")
    assert (report.surfaces, report.curves, report.left_out) == (1, 0, ())
    assert report.faces > 0


@every_export
def test_an_empty_design_is_refused_and_nothing_written(export, tmp_path):
    with pytest.raises(FormatError, match="there is nothing to write"):
        export_design(Design(), tmp_path / f"out{export.suffixes[0]}")
    assert list(tmp_path.iterdir()) == []


@every_export
def test_a_disk_that_fails_in_the_middle_leaves_the_old_file(export, design, tmp_path, monkeypatch):
    path = tmp_path / f"out{export.suffixes[0]}"
    path.write_bytes(b"old")

    def fdopen(descriptor, mode):
        os.close(descriptor)
        return Path("/dev/null").open(mode) if mode == "rb" else Full()

    class Full(io.BytesIO):
        def write(self, data):
            if self.tell() > 50:
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            return super().write(data)

    monkeypatch.setattr(files.os, "fdopen", fdopen)
    with pytest.raises(FormatError, match=r"^out\.[a-z]+: the disk is full$"):
        export_design(design, path)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


@every_export
def test_points_that_the_file_can_not_hold_are_refused_or_written(export, tmp_path):
    huge = a_surface().with_net(a_surface().net.with_points(a_surface().net.points * 1e90))
    try:
        export_design(Design({"sail": Shape(huge, "Sail")}), tmp_path / f"out{export.suffixes[0]}")
    except FormatError as error:
        assert 'shape "Sail": a point is beyond the numbers' in str(error)
        assert list(tmp_path.iterdir()) == []
