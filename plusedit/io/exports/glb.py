"""GLB, the binary form of glTF 2.0: for browsers, renderers and games.

A JSON chunk says what there is, a binary chunk holds points, normals, parameters and the corners of
triangles, one mesh after the other. glTF has y up; the root of the scene turns what has z up.
"""

import json
import struct
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from plusedit.io.exports import Meshed, Sink, register
from plusedit.io.formats import FormatError
from plusedit.io.surface_mesh import Strand

FLOAT, UNSIGNED_INT, TRIANGLES = 5126, 5125, 4  # the numbers of the standard
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
MOST = 2**32 - 1  # bytes; the length has four bytes
Z_UP = [-(0.5**0.5), 0.0, 0.0, 0.5**0.5]  # a quarter turn about x, as a quaternion
USUAL_COLOR = "#c9c2b8"
ROUGHNESS = 0.6
PER_POINT = (("POSITION", 3), ("NORMAL", 3), ("TEXCOORD_0", 2))


class BinaryGltf:
    """One node a shape, with its name and color, seen from both sides."""

    title = "Binary glTF"
    suffixes = (".glb",)
    has_curves = False
    has_quads = False
    numbers = np.float32

    def write(self, stream: Sink, meshes: Sequence[Meshed], _strands: Sequence[Strand]) -> None:
        """Write the file piece by piece. FormatError if it would be too large."""
        tree = _tree(meshes)
        text = json.dumps(tree, ensure_ascii=True, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        size = tree["buffers"][0]["byteLength"]
        total = 12 + 8 + len(text) + 8 + size
        if total > MOST:
            raise FormatError(f"a GLB file holds up to {MOST} bytes, not {total}")
        stream.write(struct.pack("<4sII", b"glTF", 2, total))
        stream.write(struct.pack("<I4s", len(text), b"JSON") + text)
        stream.write(struct.pack("<I4s", size, b"BIN\0"))
        for mesh in meshes:
            for part in _binary(mesh):
                stream.write(part)

    def size(self, points: int, triangles: int) -> int:
        return 4 * sum(width for _, width in PER_POINT) * points + 12 * triangles


register("glb")(BinaryGltf())


def _binary(mesh: Meshed) -> Iterator[bytes]:
    """Points, normals, parameters and corners of one mesh; each a multiple of four bytes."""
    for rows in mesh.blocks():
        yield mesh.points[rows].astype("<f4").tobytes()
    for rows in mesh.blocks():
        yield mesh.normals[rows].astype("<f4").tobytes()
    for rows in mesh.blocks():
        yield mesh.parameters(rows).astype("<f4").tobytes()
    for faces in mesh.faces():
        yield faces.cut().astype("<u4").tobytes()


def _tree(meshes: Sequence[Meshed]) -> dict[str, Any]:
    """What the JSON chunk says."""
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []
    colors = list(dict.fromkeys(mesh.color or USUAL_COLOR for mesh in meshes))
    made, offset = [], 0
    for mesh in meshes:
        attributes = {}
        for key, width in PER_POINT:
            attributes[key] = len(accessors)
            accessors.append(_accessor(len(views), len(mesh), f"VEC{width}", FLOAT))
            views.append(_view(offset, 4 * width * len(mesh), ARRAY_BUFFER))
            offset += views[-1]["byteLength"]
        points = mesh.points.reshape(-1, 3)
        accessors[attributes["POSITION"]]["min"] = points.min(axis=0).tolist()
        accessors[attributes["POSITION"]]["max"] = points.max(axis=0).tolist()
        count = 3 * mesh.triangle_count
        primitive = {"attributes": attributes, "indices": len(accessors), "mode": TRIANGLES}
        primitive["material"] = colors.index(mesh.color or USUAL_COLOR)
        made.append({"name": _name(mesh), "primitives": [primitive]})
        accessors.append(_accessor(len(views), count, "SCALAR", UNSIGNED_INT))
        views.append(_view(offset, 4 * count, ELEMENT_ARRAY_BUFFER))
        offset += views[-1]["byteLength"]
    return {
        "asset": {"version": "2.0", "generator": "PlusEdit"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": _nodes(meshes),
        "meshes": made,
        "materials": [_material(color) for color in colors],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": offset}],
    }


def _nodes(meshes: Sequence[Meshed]) -> list[dict[str, Any]]:
    """The root, and one child a mesh."""
    children = [{"name": _name(mesh), "mesh": i} for i, mesh in enumerate(meshes)]
    return [{"rotation": Z_UP, "children": list(range(1, len(children) + 1))}, *children]


def _name(mesh: Meshed) -> str:
    """As Unicode that every reader takes: half a surrogate pair is no character."""
    return mesh.name.encode("utf-8", "replace").decode()


def _accessor(view: int, count: int, kind: str, component: int) -> dict[str, Any]:
    return {"bufferView": view, "componentType": component, "count": count, "type": kind}


def _view(offset: int, length: int, target: int) -> dict[str, Any]:
    return {"buffer": 0, "byteOffset": offset, "byteLength": length, "target": target}


def _material(color: str) -> dict[str, Any]:
    paint = {
        "baseColorFactor": [*(_linear(int(color[i : i + 2], 16)) for i in (1, 3, 5)), 1.0],
        "metallicFactor": 0.0,
        "roughnessFactor": ROUGHNESS,
    }
    return {"name": color, "pbrMetallicRoughness": paint, "doubleSided": True}


def _linear(value: int) -> float:
    """Of a channel from 0 to 255 the share of light, by the curve of sRGB."""
    share = value / 255.0
    return share / 12.92 if share <= 0.04045 else float(((share + 0.055) / 1.055) ** 2.4)
