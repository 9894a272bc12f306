"""STL: triangles with their points written out, as text or binary."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import of_number, within
from plusedit.io.formats import FormatError
from plusedit.io.mesh_cleaning import ReadMesh, cleaned, doubles
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_text import check_content, plain_text
from plusedit.io.mesh_welding import welded
from plusedit.io.meshes import register
from plusedit.io.stl_text import facets_of

HEAD = 84  # bytes before the triangles, the last four of them their count
TRIANGLE = np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("attribute", "<u2")])


class Stereolithography:
    """Points at exactly the same place become one vertex; the normals written are ignored."""

    title = "STL"
    suffixes = (".stl",)

    def read(self, data: bytes, name: str) -> MeshFile:
        """The facets of all solids together."""
        with within(name):
            check_content(data, "an STL file")
            # Many binary files begin with the word solid too: their size tells.
            if len(data) == HEAD + TRIANGLE.itemsize * _promised(data) or not _is_text(data):
                return cleaned(_binary(data))
            read = facets_of(plain_text(data, "an STL file"))
            _weld(read)
            return cleaned(read)


register("stl")(Stereolithography())


def _promised(data: bytes) -> int:
    """How many triangles a binary file says it has; -1 if it is too short for that."""
    return int.from_bytes(data[HEAD - 4 : HEAD], "little") if len(data) >= HEAD else -1


def _is_text(data: bytes) -> bool:
    begin = data[:512].lstrip(b"\xef\xbb\xbf \t\r\n").lower()
    return data[:2] in (b"\xff\xfe", b"\xfe\xff") or (
        begin.startswith(b"solid") and b"\0" not in data
    )


def _binary(data: bytes) -> ReadMesh:
    notes = []
    promised = _promised(data)
    there, rest = divmod(len(data) - HEAD, TRIANGLE.itemsize)
    if promised < 0:
        raise FormatError(f"is cut off, or no STL file: it has {of_number(len(data), 'byte')}")
    if there < promised:
        raise FormatError(
            f"is cut off, or no STL file: promises {of_number(promised, 'triangle')},"
            f" but has bytes for {there}"
        )
    if there > promised and not rest:
        notes.append(f"says it has {of_number(promised, 'triangle')}, but {there} were found")
        promised = there
    elif there > promised or rest:
        notes.append(
            f"{of_number(len(data) - HEAD - promised * TRIANGLE.itemsize, 'byte')} after the last"
            " triangle were ignored"
        )
    triangles = np.frombuffer(data, dtype=TRIANGLE, count=promised, offset=HEAD)
    points: Floats = doubles(triangles["points"]).reshape(-1, 3)
    sizes = np.full(promised, 3, dtype=np.int64)
    read = ReadMesh(points, np.arange(len(points)), sizes, notes=notes)
    _weld(read)
    return read


def _weld(read: ReadMesh) -> None:
    read.points, numbers = welded(read.points)
    read.corners = numbers[read.corners]
