"""What stands in PLY files, and what is wrong with some."""

import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plusedit.io.mesh_reading import read_mesh
from tests.io.meshes.sample_files import FACES, POINTS, UV, ply
from tests.io.meshes.test_mesh_format_contract import sentence

orders = pytest.mark.parametrize("order", ["ascii", "<", ">"])
HEAD = "ply\nformat {} 1.0\n"
VERTICES = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
LIST = "property list uchar int vertex_indices\n"
ROWS = "0 0 0\n1 0 0\n0 1 0\n"


def text_ply(elements, rows):
    return f"{HEAD.format('ascii')}{elements}end_header\n{rows}".encode()


def read(data):
    return read_mesh(data, "a.ply")


def why(data):
    return sentence("a.ply", data)


@orders
def test_texture_coordinates_by_vertex_are_given_to_corners(order):
    read_uv = read(ply(order)).uv
    np.testing.assert_array_equal(read_uv, [UV[n] for face in FACES for n in face])


@orders
def test_without_texture_coordinates_there_are_none(order):
    assert read(ply(order, uv=False)).uv is None


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_lines_may_end_in_any_way(end):
    assert read(ply().replace(b"\n", end.encode())).mesh.faces == FACES


@pytest.mark.parametrize("order", "<>")
def test_tables_of_every_kind_of_number_are_read(order):
    head = HEAD.format({"<": "binary_little_endian", ">": "binary_big_endian"}[order])
    head += "element camera 1\nproperty list ushort double lens\nproperty char c\n"
    head += "element vertex 4\nproperty uchar red\nproperty double x\nproperty short y\n"
    head += "property int8 z\nelement face 2\nproperty float32 quality\n"
    head += "property list int32 uint16 vertex_index\nproperty list uint8 float texcoord\n"
    data = (head + "end_header\n").encode() + struct.pack(f"{order}H2db", 2, 0.5, 0.5, 1)
    for x, y, z in POINTS[:4]:
        data += struct.pack(f"{order}Bdhb", 7, x, int(y), int(z))
    for face in [(0, 1, 2), (0, 1, 2, 3)]:
        size = len(face)
        uv = [float(n) for n in range(2 * size)]
        data += struct.pack(f"{order}fi{size}H", 1.0, size, *face)
        data += struct.pack(f"{order}B{2 * size}f", 2 * size, *uv)
    found = read(data)
    assert found.mesh.faces == [(0, 1, 2), (0, 1, 2, 3)]
    np.testing.assert_array_equal(found.mesh.vertices, POINTS[:4])
    np.testing.assert_array_equal(found.uv[:3], [(0, 1), (2, 3), (4, 5)])


def test_texture_coordinates_of_another_number_than_corners_are_ignored():
    rows = f"{ROWS}3 0 1 2 4 0 0 1 1\n"
    lists = f"{LIST}property list uchar float texcoord\n"
    found = read(text_ply(f"{VERTICES}element face 1\n{lists}", rows))
    assert found.uv is None
    assert found.notes == (
        "the texture coordinates of corners were ignored: 1 face has not two a corner",
    )


@given(st.lists(st.integers(3, 9), min_size=1, max_size=30))
def test_faces_of_any_sizes_are_found(sizes):
    rng = np.random.default_rng(len(sizes))
    points = rng.normal(size=(9, 3)).astype("<f4")
    faces = [tuple(rng.permutation(9)[:size].tolist()) for size in sizes]
    head = HEAD.format("binary_little_endian") + VERTICES.replace("3", "9", 1)
    head += f"element face {len(faces)}\n{LIST}end_header\n"
    rows = b"".join(struct.pack(f"<B{len(f)}i", len(f), *f) for f in faces)
    assert read(head.encode() + points.tobytes() + rows).mesh.faces == faces


@orders
@pytest.mark.parametrize("element", ["vertex", "face"])
@pytest.mark.parametrize("count", [1000, 2**31, 4_000_000_000, 10**17])
def test_counts_are_not_believed(order, element, count):
    old, new = f"element {element} 5".encode(), f"element {element} {count}".encode()
    data = ply(order).replace(old, new)
    assert "is cut off: promises" in why(data)


@pytest.mark.parametrize(
    ("elements", "rows", "reason"),
    [
        (VERTICES, ROWS, "has 3 points but no faces"),
        (
            f"{VERTICES}element tristrips 1\n{LIST}",
            f"{ROWS}3 0 1 2",
            "holds triangle strips (tristrips), which are not read; save faces",
        ),
        (
            f"{VERTICES}element face 1\nproperty int vertex_indices\n",
            f"{ROWS}3",
            'its face has a number "vertex_indices" for a list',
        ),
        ("element face 0\n" + LIST, "", "has no vertices"),
        ("element vertex 1\nproperty float x\n", "1\n", 'its vertex has no "y"'),
        ("element vertex -1\n", "", 'its header has a line "element vertex -1"'),
        (
            "element vertex 1\nproperty half x\n",
            "1",
            'its header has a number of unknown kind "half"',
        ),
    ],
)
def test_what_is_wrong_with_the_tables_is_told(elements, rows, reason):
    assert why(text_ply(elements, rows)) == reason


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("3 0 1 7", "face 1 names vertex 7, but there are 3 vertices, numbered from 0"),
        ("3 0 1 0.5", "has a face that names vertex 0.5"),
        ("3 0 1 nan", "has a face that names vertex nan"),
        ("-3 0 1 2", 'has a list "vertex_indices" of -3 numbers'),
        ("2.5 0 1 2", "has a list of 2.5 numbers"),
        ("1e300 0 1 2", "is cut off: promises 1 row of face, but ends after at most 0"),
        ("4 0 1 2", "is cut off: promises 1 row of face, but ends after at most 0"),
        ("3 0 one 2", 'line 4: "one" is no number'),
    ],
)
def test_what_is_wrong_with_a_face_is_told(row, reason):
    assert why(text_ply(f"{VERTICES}element face 1\n{LIST}", f"{ROWS}{row}\n")) == reason


def test_elements_without_properties_take_no_room():
    elements = f"element nothing 4000000000\n{VERTICES}element face 1\n{LIST}"
    assert read(text_ply(elements, f"{ROWS}3 0 1 2\n")).mesh.face_count == 1
