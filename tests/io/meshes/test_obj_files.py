"""What stands in OBJ files, and what is wrong with some."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plusedit.io import mesh_words
from plusedit.io.mesh_reading import read_mesh
from tests.io.meshes.sample_files import FACES, POINTS, UV, obj
from tests.io.meshes.test_mesh_format_contract import sentence

SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"


def read(text):
    return read_mesh(text.encode() if isinstance(text, str) else text, "a.obj")


def faces(text):
    return read(text).mesh.faces


def why(text):
    return sentence("a.obj", text.encode() if isinstance(text, str) else text)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r", "  \n\n", "\t# a comment\n"])
def test_lines_may_end_in_any_way(end):
    assert faces(obj(end=end)) == FACES


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "latin-1"])
def test_other_encodings_are_understood(encoding):
    text = obj().decode().replace("Sides", "Flächen").encode(encoding)
    assert list(read(text).groups) == ["Base", "Flächen"]


def test_texture_coordinates_are_kept_by_corner():
    uv = read(obj()).uv
    np.testing.assert_array_equal(uv, [UV[n] for face in FACES for n in face])


def test_groups_say_which_faces_belong_together():
    groups = read(obj()).groups
    assert {name: faces.tolist() for name, faces in groups.items()} == {
        "Base": [0],
        "Sides": [1, 2, 3, 4],
    }


def test_a_group_that_comes_again_goes_on():
    text = SQUARE + "g a\nf 1 2 3\ng b\nf 2 3 4\ng a\nf 1 2 4\n"
    assert {name: list(found) for name, found in read(text).groups.items()} == {
        "a": [0, 2],
        "b": [1],
    }


def test_negative_numbers_count_back_from_the_face():
    assert faces(SQUARE + "f -4 -3 -2 -1\nv 9 9 9\nf -5 -4 -3\n") == [(0, 1, 2, 3), (0, 1, 2)]


def test_faces_may_stand_before_their_vertices():
    assert faces("f 1 2 3 4\n" + SQUARE) == [(0, 1, 2, 3)]


def test_a_line_goes_on_after_a_backslash():
    assert faces(SQUARE + "f 1 2 \\\n3 4\n") == [(0, 1, 2, 3)]


@pytest.mark.parametrize("corner", ["{0}", "{0}/{0}", "{0}//{0}", "{0}/{0}/{0}", "{0}/", "+{0}"])
def test_corners_are_written_in_many_ways(corner):
    extra = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" + "vn 0 0 1\n" * 4
    words = " ".join(corner.format(n) for n in (1, 2, 3, 4))
    assert faces(f"{SQUARE}{extra}f {words}\n") == [(0, 1, 2, 3)]


@pytest.mark.parametrize("tail", ["", " 1.0", " 0.5 0.5 0.5"])
def test_weights_and_colors_of_vertices_are_ignored(tail):
    assert faces(SQUARE.replace("\n", f"{tail}\n") + "f 1 2 3 4\n") == [(0, 1, 2, 3)]


@pytest.mark.parametrize(
    ("vt", "corners", "reason"),
    [
        ("vt 0 0\n" * 3, "1/1 2/2 3/3 4", "1 corner has none"),
        ("vt 0 0\n" * 3, "1/1 2/2 3/3 4/4", "1 corner names some that are not there"),
        ("vt 0 0\n" * 3, "1/1 2/2 3/3 4/-4", "1 corner names some that are not there"),
        ("vt 0\n" * 4, "1/1 2/2 3/3 4/4", "some are no pairs of numbers"),
        ("vt 0 x\n" * 4, "1/1 2/2 3/3 4/4", "some are no pairs of numbers"),
    ],
)
def test_wrong_texture_coordinates_are_all_ignored(vt, corners, reason):
    found = read(f"{SQUARE}{vt}f {corners}\n")
    assert found.uv is None
    assert found.notes == (f"all texture coordinates were ignored: {reason}",)


def test_texture_coordinates_that_are_not_finite_are_ignored():
    found = read(f"{SQUARE}vt 0 0\nvt nan 0\nf 1/1 2/2 3/1 4/1\n")
    assert found.uv is None
    assert found.notes == (
        "all texture coordinates were ignored: those of 1 corner are no finite numbers",
    )


@pytest.mark.parametrize(
    ("lines", "reason"),
    [
        ("f 1 2 9\n", "face 1 names vertex 9, but there are 4 vertices, numbered from 1"),
        ("f 1 2 0\n", "line 5: face 1 names vertex 0, but they are numbered from 1"),
        ("f 1 2 -5\n", "line 5: face 1 names vertex -5, but there are 4 vertices before it"),
        (
            "f 1 2 3\n\nf 1 2 12345678901234567890\n",
            "line 7: face 2 names vertex 12345678901234567890, but there are 4 vertices before it",
        ),
        ("f 1 2 3.5\n", 'line 5: "3.5" is no corner of a face'),
        ("f 1 2 /3\n", 'line 5: "/3" is no corner of a face'),
        ("f 1/1 2/2 x/3\n", 'line 5: "x/3" is no corner of a face'),
        ("f 1 2 \\\n x\n", 'line 6: "x" is no corner of a face'),
        ("v 1 2\nf 1 2 3\n", "line 5: a vertex has 2 numbers, not three"),
        ("v 1 2 1_0\nf 1 2 3\n", 'line 5: "1_0" is no number'),
        ("v 1 2 0,5\nf 1 2 3\n", 'line 5: "0,5" is no number; decimals are written with a point'),
        ("", "has 4 points but no faces"),
        ("l 1 2\np 3\n", "has 4 points but no faces, only lines and points"),
    ],
)
def test_what_is_wrong_is_told_with_its_place(lines, reason):
    assert why(SQUARE + lines) == reason


@pytest.mark.parametrize(
    "word", ["nan", "-NaN", "inf", "1.#QNAN", "-1.#IND00", "-nan(ind)", "-1.#INF", "1e999"]
)
def test_faces_with_vertices_that_are_not_finite_are_left_out(word):
    found = read(f"{SQUARE}v {word} 0 0\nf 1 2 3 4\nf 1 2 5\nf 2 3 5\n")
    assert found.mesh.faces == [(0, 1, 2, 3)]
    assert found.notes == ("2 faces with a vertex that is no finite number were left out",)


def test_what_is_no_face_is_left_out_and_counted():
    found = read(SQUARE + "l 1 2\nl 2 3\np 1\nsurf 0 1 0 1 1 2\nhello\nf 1 2 3 4\n")
    assert found.notes == (
        "1 unknown statement was left out",
        "1 free-form curve or surface was left out",
        "2 lines were left out",
        "1 point was left out",
    )


def test_a_last_line_without_its_end_and_too_short_is_suspicious():
    notes = read(SQUARE + "f 1 2 3\nf 1").notes
    assert "the last line is not ended: the file may be cut off" in notes


def test_blocks_make_no_difference(monkeypatch):
    text = obj() + b"v 1 1 9\nvt 0 0\nf -2/-2 -3/-3 -4/-4\n"
    whole = read(text)
    monkeypatch.setattr(mesh_words, "BLOCK", 7)
    parts = read(text)
    assert whole.mesh.faces == parts.mesh.faces
    assert list(whole.groups) == list(parts.groups)
    np.testing.assert_array_equal(whole.uv, parts.uv)


def test_a_line_without_end_is_refused(monkeypatch):
    monkeypatch.setattr(mesh_words, "LONGEST_LINE", 1 << 10)
    assert "has a line of more than" in why(SQUARE + "f" + " 1 2 3" * 1000)


@given(st.lists(st.tuples(*[st.floats(-1e9, 1e9)] * 3), min_size=5, max_size=5, unique=True))
def test_numbers_come_out_as_they_were_written(points):
    text = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in [*points, *POINTS])
    np.testing.assert_array_equal(read(text + "f 6 7 8\nf 1 2 3\n").mesh.vertices[:5], points)


@pytest.mark.parametrize("end", ["\\", "\\\n", "\\\n\\\n", "#", "# \\\n", "\\ \n"])
def test_a_file_may_end_in_any_way(end):
    assert faces(f"{SQUARE}f 1 2 3 4\n{end}") == [(0, 1, 2, 3)]


def test_a_name_may_contain_what_begins_a_comment():
    text = f"{SQUARE}g part#1 # the first\nf 1 2 3 # 4\n"
    assert list(read(text).groups) == ["part#1"]
