"""OFF, the Object File Format of Geomview: text with polygons; colors and normals are ignored."""

import re

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import of_number, within
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_cleaning import ReadMesh, cleaned, vertices
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_numbers import LineNumbers, line_numbers
from plusedit.io.mesh_text import name_of, plain_text, without_comments
from plusedit.io.meshes import register

HEADER = re.compile(rb"\s*((ST)?C?(N)?(4)?(n)?OFF\b)?([^\n]*)\n")
LARGEST = 1e15


class ObjectFile:
    """OFF, and COFF, NOFF and STOFF, which have colors, normals or texture coordinates too."""

    title = "Object File Format"
    suffixes = (".off", ".coff", ".noff")

    def read(self, data: bytes, name: str) -> MeshFile:
        """Its polygons, with texture coordinates by vertex."""
        with within(name):
            text = without_comments(plain_text(data, "an OFF file"))
            found = HEADER.match(text)
            if not found or found[4] or found[5]:
                raise FormatError("has points of other than three dimensions, which are not read")
            rest = text[found.start(6) :]
            if rest.lstrip()[:6].upper() == b"BINARY":
                raise FormatError("is a binary OFF file, which are not read; save it as text")
            if not found[1]:
                _check_counts_line(found[6])
            table = line_numbers(rest, text.count(b"\n", 0, found.start(6)) + 1)
            return cleaned(_mesh(table, normals=bool(found[3]), uv=bool(found[2])))


register("off")(ObjectFile())


def _check_counts_line(line: bytes) -> None:
    """FormatError if a file without the word OFF does not begin with its counts."""
    if not re.fullmatch(rb"\s*\d+\s+\d+(\s+\d+)?\s*", line):
        raise FormatError(f"begins with {shown(name_of(line))} instead of OFF")


def _mesh(table: LineNumbers, *, normals: bool, uv: bool) -> ReadMesh:
    if not len(table.counts):
        raise FormatError("is cut off: says no counts of vertices and faces")
    promised = [_count(value) for value in table.row(0)[:2].tolist()]
    if len(promised) < 2:
        raise FormatError(f"{table.where(0)}: expected the counts of vertices and faces")
    points, faces = promised
    there = len(table.counts) - 1
    if points + faces > there:
        raise FormatError(
            f"is cut off: promises {vertices(points)} and {of_number(faces, 'face')},"
            f" but has only {of_number(there, 'line')} of them"
        )
    rows = table.rows(1, 1 + points, 6 if normals else 3, "a vertex")
    sizes, corners = _faces(table, 1 + points, faces)
    read = ReadMesh(rows[:, :3], corners, sizes)
    if uv and points:
        ends = table.firsts[2 : 2 + points]
        read.vertex_uv = np.stack([table.values[ends - 2], table.values[ends - 1]], axis=1)
    return read


def _count(value: float) -> int:
    if not (0 <= value < LARGEST and value.is_integer()):
        raise FormatError(f"promises {value:g} vertices or faces")
    return int(value)


def _faces(
    table: LineNumbers, first: int, count: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """How many corners each face has, and their vertices."""
    begins = table.firsts[first : first + count]
    room = table.counts[first : first + count] - 1
    promised = table.values[begins]
    wrong = ~((promised >= 0) & (promised <= room) & (promised == np.floor(promised)))
    if wrong.any():
        row = int(wrong.argmax())
        raise FormatError(
            f"{table.where(first + row)}: face {row + 1} promises {promised[row]:g} corners,"
            f" but the line has {of_number(int(room[row]), 'number')} more"
        )
    sizes = promised.astype(np.int64)
    shifts = begins + 1 - (np.cumsum(sizes) - sizes)
    values = table.values[np.arange(int(sizes.sum())) + np.repeat(shifts, sizes)]
    return sizes, _whole(values)


def _whole(values: Floats) -> NDArray[np.int64]:
    if (wrong := ~(np.floor(values) == values)).any():
        raise FormatError(f"has a face that names vertex {values[wrong.argmax()]:g}")
    numbers: NDArray[np.int64] = np.clip(values, -LARGEST, LARGEST).astype(np.int64)
    return numbers
