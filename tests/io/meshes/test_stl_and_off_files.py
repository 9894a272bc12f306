"""What stands in STL and OFF files, and what is wrong with some."""

import struct

import numpy as np
import pytest

from plusedit.io.mesh_reading import read_mesh
from plusedit.io.mesh_welding import welded
from tests.io.meshes.sample_files import FACES, UV, off, stl_binary, stl_text
from tests.io.meshes.test_mesh_format_contract import sentence


def read(data, name="a.stl"):
    return read_mesh(data, name)


def why(data, name="a.stl"):
    return sentence(name, data)


def test_a_binary_file_may_begin_with_solid():
    assert read(stl_binary(b"solid and text")).mesh.faces == read(stl_text()).mesh.faces


def test_words_of_a_text_may_be_capital():
    assert read(stl_text().upper()).mesh.face_count == 6


def test_solids_are_groups_and_may_have_any_name():
    text = stl_text() + stl_text().replace(b"Pyramid", b"vertex endloop")
    assert {name: len(faces) for name, faces in read(text).groups.items()} == {
        "Pyramid": 6,
        "vertex endloop": 6,
    }


def test_a_loop_of_four_is_a_polygon():
    text = "solid\nfacet normal 0 0 1\nouter loop\n" + "".join(
        f"vertex {x} {y} 0\n" for x, y in [(0, 0), (1, 0), (1, 1), (0, 1)]
    )
    assert read(f"{text}endloop\nendfacet\nendsolid\n".encode()).mesh.faces == [(0, 1, 2, 3)]


@pytest.mark.parametrize("count", [7, 1000, 2**32 - 1])
def test_more_triangles_promised_than_there_are_refuses(count):
    data = bytearray(stl_binary())
    data[80:84] = struct.pack("<I", count)
    assert why(bytes(data)).startswith(f"is cut off, or no STL file: promises {count} triangles")


def test_fewer_triangles_promised_than_there_are_is_told():
    data = bytearray(stl_binary())
    data[80:84] = struct.pack("<I", 3)
    assert read(bytes(data)).notes == ("says it has 3 triangles, but 6 were found",)


def test_bytes_after_the_last_triangle_are_told():
    assert read(stl_binary() + b"extra").notes == ("5 bytes after the last triangle were ignored",)


def test_a_text_without_its_end_is_suspicious():
    cut = stl_text().replace(b"endsolid Pyramid\n", b"")
    assert read(cut).notes == ("endsolid is missing: the file may be cut off",)


def test_a_text_cut_within_a_loop_is_refused():
    assert why(stl_text()[:400]).startswith(("is cut off: after", "line "))


def test_equal_points_are_one_vertex_in_the_order_in_which_they_come():
    points = np.array([(1.0, 2, 3), (0, 0, 0), (1, 2, 3), (-0.0, 0, 0), (3, 2, 1)])
    found = welded(points)
    assert found.numbers.tolist() == [0, 1, 0, 1, 2]
    np.testing.assert_array_equal(found.points[found.numbers], points)


def test_points_that_share_a_key_stay_apart(monkeypatch):
    points = np.random.default_rng(1).integers(0, 3, (50, 3)).astype(float)
    wanted = welded(points).numbers
    monkeypatch.setattr("plusedit.io.mesh_welding._keys", lambda p: np.zeros(len(p), np.uint64))
    np.testing.assert_array_equal(welded(points).points[welded(points).numbers], points)
    assert len(np.unique(welded(points).numbers)) == len(np.unique(wanted))


@pytest.mark.parametrize(
    "header",
    ["OFF\n5 5 0", "OFF 5 5 8", "5 5 0", "# one\nOFF # two\n\n5 5", "OFF\n# one\n 5 5 0 # two"],
)
def test_headers_of_off_vary(header):
    assert read(off(header), "a.off").mesh.faces == FACES


def test_colors_of_off_are_ignored():
    text = off("COFF\n5 5 0").decode().splitlines()
    points = [f"{line} 255 0 0 255" for line in text[2:7]]
    faces = [f"{line} 0.5 0.5 0.5" for line in text[7:]]
    data = "\n".join([*text[:2], *points, *faces]).encode()
    assert read(data, "a.off").mesh.faces == FACES


def test_texture_coordinates_of_off_are_read():
    text = off("STOFF\n5 5 0").decode().splitlines()
    rows = [f"{line} {u} {v}" for line, (u, v) in zip(text[2:7], UV, strict=True)]
    found = read("\n".join([*text[:2], *rows, *text[7:]]).encode(), "a.off")
    np.testing.assert_array_equal(found.uv, [UV[n] for face in FACES for n in face])


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("OFF", "4OFF", "has points of other than three dimensions, which are not read"),
        ("OFF", "OFF BINARY", "is a binary OFF file, which are not read; save it as text"),
        ("OFF", "Off with it", 'begins with "Off with it" instead of OFF'),
        ("5 5 0", "5", "line 2: expected the counts of vertices and faces"),
        ("5 5 0", "-5 5 0", "promises -5 vertices or faces"),
        ("5 5 0", "5 1e300 0", "promises 1e+300 vertices or faces"),
        (
            "5 5 0",
            "2000000000 5 0",
            "is cut off: promises 2000000000 vertices and 5 faces, but has only 10 lines of them",
        ),
        ("3 0 1 4", "3 0 1", "line 9: face 2 promises 3 corners, but the line has 2 numbers more"),
        ("3 0 1 4", "3 0 1 5", "face 2 names vertex 5, but there are 5 vertices, numbered from 0"),
        ("3 0 1 4", "3 0 1 1.5", "has a face that names vertex 1.5"),
        ("1.0 1.0 1.5", "1.0 1.0", "line 7: a vertex has 2 numbers, expected 3"),
    ],
)
def test_what_is_wrong_with_an_off_file_is_told(old, new, reason):
    assert why(off().replace(old.encode(), new.encode(), 1), "a.off") == reason
