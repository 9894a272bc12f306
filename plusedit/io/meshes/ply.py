"""PLY, the Stanford polygon format: text or binary, with polygons and texture coordinates."""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import within
from plusedit.io.formats import FormatError
from plusedit.io.mesh_cleaning import ReadMesh, cleaned
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_numbers import numbers_of
from plusedit.io.mesh_text import check_content, plain_text
from plusedit.io.meshes import register
from plusedit.io.ply_header import Header, header_of
from plusedit.io.ply_tables import Body, Table, table_of

LISTS = ("vertex_indices", "vertex_index")
UV_NAMES = (("s", "t"), ("u", "v"), ("texture_u", "texture_v"), ("texcoord_u", "texcoord_v"))
UV_LIST = "texcoord"


class StanfordPly:
    """Faces as they stand; elements besides vertices and faces are left out."""

    title = "Stanford PLY"
    suffixes = (".ply",)

    def read(self, data: bytes, name: str) -> MeshFile:
        """The polygons, with texture coordinates by vertex or by corner."""
        with within(name):
            if not data.startswith(b"ply"):
                check_content(data, "a PLY file")
                data = plain_text(data, "a PLY file")
            header = header_of(data)
            return cleaned(_mesh(_tables(header, data)))


register("ply")(StanfordPly())


def _tables(header: Header, data: bytes) -> dict[str, Table]:
    """The tables that matter, by name."""
    if strips := [entry.name for entry in header.elements if entry.name == "tristrips"]:
        raise FormatError(f"holds triangle strips ({strips[0]}), which are not read; save faces")
    if header.order == "ascii":
        text = data[header.end :]
        body = Body(numbers_of(plain_text(text, "a PLY file") if text.strip() else b""), "")
    else:
        body = Body(np.frombuffer(data, dtype=np.uint8, offset=header.end), header.order)
    tables: dict[str, Table] = {}
    at = 0
    for element in header.elements:
        table = table_of(element, body, at)
        tables.setdefault(element.name, table)
        at = table.end
    return tables


def _mesh(tables: dict[str, Table]) -> ReadMesh:
    if "vertex" not in tables:
        raise FormatError("has no vertices")
    vertex = tables["vertex"]
    points = np.stack([vertex.column(axis) for axis in "xyz"], axis=1)
    nothing = np.zeros(0, dtype=np.int64)
    if "face" not in tables:
        return ReadMesh(points, nothing, nothing)
    face = tables["face"]
    sizes, corners = face.lists(next((name for name in LISTS if face.has(name)), LISTS[0]))
    read = ReadMesh(points, _whole(corners), sizes)
    if face.has(UV_LIST):
        read.uv = _uv_of_faces(face, sizes, read.notes)
    if read.uv is None:
        read.vertex_uv = _uv_of_vertices(vertex)
    return read


def _whole(corners: Floats) -> NDArray[np.int64]:
    """The numbers of vertices; FormatError if they are none."""
    # What is beyond all counts stays beyond them.
    bounded = np.clip(corners, -1e15, 1e15)
    numbers = np.nan_to_num(bounded, nan=0.5)
    whole: NDArray[np.int64] = numbers.astype(np.int64)
    if (wrong := whole != numbers).any():
        raise FormatError(f"has a face that names vertex {corners[wrong.argmax()]:g}")
    return whole


def _uv_of_vertices(vertex: Table) -> Floats | None:
    for u, v in UV_NAMES:
        if vertex.has(u) and vertex.has(v):
            return np.stack([vertex.column(u), vertex.column(v)], axis=1)
    return None


def _uv_of_faces(face: Table, sizes: NDArray[np.int64], notes: list[str]) -> Floats | None:
    lengths, values = face.lists(UV_LIST)
    if wrong := int((lengths != 2 * sizes).sum()):
        faces = "1 face has" if wrong == 1 else f"{wrong} faces have"
        notes.append(f"the texture coordinates of corners were ignored: {faces} not two a corner")
        return None
    return values.reshape(-1, 2)
