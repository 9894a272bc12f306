"""Wavefront OBJ: text with polygons, normals and parameters, and curves as lines."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from plusedit.io.exports import Meshed, Sink, register
from plusedit.io.mesh_faces import Numbers
from plusedit.io.surface_mesh import Strand

LONGEST = 256  # points of one line of the file
PER_POINT, PER_TRIANGLE = 98, 42  # bytes, about: their numbers differ in length


class WavefrontObj:
    """One object a shape. Seams and poles are one point each, but keep all their parameters."""

    title = "Wavefront OBJ"
    suffixes = (".obj",)
    has_curves = True
    has_quads = True
    numbers = np.float64

    def write(self, stream: Sink, meshes: Sequence[Meshed], strands: Sequence[Strand]) -> None:
        """Write the file piece by piece."""
        stream.write(b"# PlusEdit\n")
        corners = points = 1  # numbers begin with one, and run on from object to object
        for mesh in meshes:
            for text in _mesh_lines(mesh, points, corners):
                stream.write(text.encode())
            points += len(mesh.welded[0])
            corners += len(mesh)
        for strand in strands:
            for text in _strand_lines(strand, points):
                stream.write(text.encode())
            points += len(strand.points)

    def size(self, points: int, triangles: int) -> int:
        return PER_POINT * points + PER_TRIANGLE * triangles


register("obj")(WavefrontObj())


def _mesh_lines(mesh: Meshed, first_point: int, first_corner: int) -> Iterator[str]:
    yield f"o {_name(mesh.name)}\n"
    left, places = mesh.welded
    yield from _rows("v %.12g %.12g %.12g\n", mesh.points.reshape(-1, 3)[left])
    for rows in mesh.blocks():
        yield from _rows("vt %.9g %.9g\n", mesh.parameters(rows).reshape(-1, 2))
        yield from _rows("vn %.6g %.6g %.6g\n", mesh.normals[rows].reshape(-1, 3))
    for faces in mesh.faces():
        for corners in (faces.quads, faces.triangles, faces.others):
            if corners is not None:
                yield _face_lines(corners, places + first_point, first_corner)


def _face_lines(corners: Numbers, places: Numbers, first_corner: int) -> str:
    """One line a face, each corner as point/parameters/normal."""
    own = corners + first_corner
    words = np.stack([places[corners], own, own], axis=2)
    sides: int = corners.shape[1]
    line = "f" + " %d/%d/%d" * sides + "\n"
    return line * len(corners) % tuple(words.ravel().tolist())


def _rows(line: str, values: NDArray[np.floating]) -> Iterator[str]:
    """`line` filled with each row of values, some thousand rows at a time."""
    for first in range(0, len(values), 4096):
        part = values[first : first + 4096]
        yield line * len(part) % tuple(part.ravel().tolist())


def _strand_lines(strand: Strand, first_point: int) -> Iterator[str]:
    yield f"o {_name(strand.name)}\n"
    yield from _rows("v %.12g %.12g %.12g\n", strand.points)
    for first in range(0, len(strand.points) - 1, LONGEST - 1):
        last = min(first + LONGEST, len(strand.points))
        yield f"l {' '.join(str(first_point + i) for i in range(first, last))}\n"


def _name(name: str) -> str:
    """On one line, and never empty."""
    return "".join(c if c.isprintable() else "_" for c in name).strip() or "unnamed"
