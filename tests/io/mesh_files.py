"""Readers of exported files, written from the formats' definitions: what others would see.

Each gives parts: a name, points (k, 3), and per corner of every face its point, normal and
parameters.
"""

import json
import struct
from dataclasses import dataclass, field

import numpy as np

from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface


@dataclass
class Part:
    """One object of a file."""

    name: str = ""
    faces: list = field(default_factory=list)
    """of each face the numbers of its points in the file, in order around it"""
    points: np.ndarray | None = None
    normals: np.ndarray | None = None
    parameters: np.ndarray | None = None
    corners: list = field(default_factory=list)
    """of each face the numbers of its normals and parameters"""
    lines: list = field(default_factory=list)
    color: list | None = None

    def at(self, face):
        return self.points[list(face)]


def read_obj(data):
    rows = {"v": [], "vt": [], "vn": []}
    parts = []
    for line in data.decode().splitlines():
        key, _, rest = line.partition(" ")
        if key in rows:
            rows[key].append([float(word) for word in rest.split()])
        elif key == "o":
            parts.append(Part(rest))
        elif key == "f":
            corners = [[int(n) - 1 for n in word.split("/")] for word in rest.split()]
            assert all(uv == normal for _, uv, normal in corners)
            parts[-1].faces.append([point for point, _, _ in corners])
            parts[-1].corners.append([normal for _, _, normal in corners])
        elif key == "l":
            parts[-1].lines.append([int(word) - 1 for word in rest.split()])
        else:
            assert key == "#"
    for part in parts:
        part.points = np.array(rows["v"])
        part.normals, part.parameters = np.array(rows["vn"]), np.array(rows["vt"])
    return parts


def read_ply(data):
    header, _, rest = data.partition(b"end_header\n")
    lines = header.decode("ascii").splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"]
    counts = {words[1]: int(words[2]) for words in map(str.split, lines) if words[0] == "element"}
    names = [line.split()[2] for line in lines if line.startswith("property float")]
    assert names == ["x", "y", "z", "nx", "ny", "nz", "s", "t"]
    assert lines[-1] == "property list uchar int vertex_indices"
    values = np.frombuffer(rest, "<f4", 8 * counts["vertex"]).reshape(-1, 8).astype(float)
    at, faces = 32 * counts["vertex"], []
    for _ in range(counts["face"]):
        sides = rest[at]
        faces.append(list(struct.unpack_from(f"<{sides}i", rest, at + 1)))
        at += 1 + 4 * sides
    assert at == len(rest)
    return [Part("", faces, values[:, :3], values[:, 3:6], values[:, 6:], faces)]


def read_stl(data):
    assert not data.startswith(b"solid")
    [count] = struct.unpack_from("<I", data, 80)
    kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    assert len(data) == 84 + 50 * count
    facets = np.frombuffer(data, kind, count, 84)
    points, numbers = np.unique(facets["corners"].reshape(-1, 3), axis=0, return_inverse=True)
    faces = numbers.reshape(-1, 3).tolist()
    own = [[i] * 3 for i in range(count)]
    return [Part("", faces, points.astype(float), facets["normal"].astype(float), None, own)]


SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}
KINDS = {5126: "<f4", 5125: "<u4"}


def read_glb(data):
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert (kind, size % 4) == (b"JSON", 0)
    tree = json.loads(data[20 : 20 + size])
    binary_size, kind = struct.unpack_from("<I4s", data, 20 + size)
    assert (kind, binary_size % 4) == (b"BIN\0", 0)
    assert 28 + size + binary_size == len(data)
    binary = data[28 + size :]
    assert tree["asset"]["version"] == "2.0"
    assert tree["buffers"] == [{"byteLength": len(binary)}]
    [root] = tree["scenes"][tree["scene"]]["nodes"]
    assert_turns_z_up(tree["nodes"][root]["rotation"])
    return [_node(tree, tree["nodes"][i], binary) for i in tree["nodes"][root]["children"]]


def _node(tree, node, binary):
    [primitive] = tree["meshes"][node["mesh"]]["primitives"]
    values = {key: _values(tree, i, binary, 34962) for key, i in primitive["attributes"].items()}
    assert set(values) == {"POSITION", "NORMAL", "TEXCOORD_0"}
    position = tree["accessors"][primitive["attributes"]["POSITION"]]
    assert position["min"] == values["POSITION"].min(axis=0).tolist()
    assert position["max"] == values["POSITION"].max(axis=0).tolist()
    assert primitive["mode"] == 4
    indices = _values(tree, primitive["indices"], binary, 34963)
    assert indices.max() < len(values["POSITION"])
    material = tree["materials"][primitive["material"]]
    assert material["doubleSided"]
    faces = indices.reshape(-1, 3).tolist()
    three = (values["POSITION"], values["NORMAL"], values["TEXCOORD_0"])
    color = material["pbrMetallicRoughness"]["baseColorFactor"]
    return Part(node["name"], faces, *(v.astype(float) for v in three), faces, color=color)


def _values(tree, number, binary, target):
    accessor = tree["accessors"][number]
    view = tree["bufferViews"][accessor["bufferView"]]
    assert view["target"] == target
    assert view["byteOffset"] % 4 == 0
    width = SIZES[accessor["type"]]
    raw = binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    values = np.frombuffer(raw, KINDS[accessor["componentType"]])
    assert len(values) == width * accessor["count"] > 0
    return values.reshape(-1, width) if width > 1 else values


def assert_turns_z_up(quaternion):
    """That the unit quaternion (x, y, z, w) takes z to y, and leaves x."""
    x, y, z, w = quaternion
    assert abs(x * x + y * y + z * z + w * w - 1.0) < 1e-12
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    np.testing.assert_allclose(turn @ [0, 0, 1], [0, 1, 0], atol=1e-12)
    np.testing.assert_allclose(turn @ [1, 0, 0], [1, 0, 0], atol=1e-12)


READERS = {"obj": read_obj, "ply": read_ply, "stl": read_stl, "glb": read_glb}


def ring(count, radius=1.0):
    """(count, 2) points around a circle, counterclockwise."""
    angle = 2.0 * np.pi * np.arange(count) / count
    return radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def a_torus(s=0.5, inside_out=False):
    """Eight planes around the z axis, six around the tube."""
    tube = ring(6) if inside_out else ring(6)[::-1]
    radius, height = 3.0 + tube[:, 0], tube[:, 1]
    around = ring(8)[:, None] * radius[:, None]
    points = np.dstack([around, np.broadcast_to(height, (8, 6))])
    return PlusSurface(BSpline(8, 4, True), BSpline(6, 4, True), ControlPlanes.of(points), s)


def a_tube(s=0.5):
    """Open by u along the z axis, closed by v."""
    heights = np.linspace(0.0, 3.0, 4)
    points = np.stack([np.column_stack([ring(6), np.full(6, height)]) for height in heights])
    return PlusSurface(BSpline(4, 3), BSpline(6, 4, True), ControlPlanes.of(points), s)


def a_ball(s=0.3):
    """Closed by v, and by u drawn together to a point at both ends."""
    heights, radii = [-1.0, -1.0, 0.0, 1.0, 1.0], [0.0, 1.0, 1.2, 1.0, 0.0]
    rows = [
        np.column_stack([ring(8, radius), np.full(8, height)])
        for height, radius in zip(heights, radii, strict=True)
    ]
    return PlusSurface(BSpline(5, 4), BSpline(8, 4, True), ControlPlanes.of(rows), s)
