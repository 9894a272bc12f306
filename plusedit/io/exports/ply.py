"""PLY, the Stanford polygon format: binary, with normals and parameters for every point."""

from collections.abc import Sequence

import numpy as np

from plusedit.io.exports import Meshed, Sink, register
from plusedit.io.formats import FormatError
from plusedit.io.mesh_faces import Numbers
from plusedit.io.surface_mesh import Strand

PROPERTIES = ("x", "y", "z", "nx", "ny", "nz", "s", "t")
MOST = 2**31 - 1  # numbers of points are signed, of four bytes


class StanfordPly:
    """All surfaces as one mesh of triangles, numbers least byte first.

    Quads could stand among them, but many readers expect all faces to be of one kind.
    """

    title = "Stanford PLY"
    suffixes = (".ply",)
    has_curves = False
    has_quads = False
    numbers = np.float32

    def write(self, stream: Sink, meshes: Sequence[Meshed], _strands: Sequence[Strand]) -> None:
        """Write the file piece by piece. FormatError if there are too many points."""
        points = sum(map(len, meshes))
        if points > MOST:
            raise FormatError(f"a PLY file holds up to {MOST} points, not {points}")
        stream.write(_header(points, sum(mesh.triangle_count for mesh in meshes)))
        for mesh in meshes:
            for rows in mesh.blocks():
                parts = (mesh.points[rows], mesh.normals[rows], mesh.parameters(rows))
                stream.write(np.concatenate(parts, axis=-1, dtype="<f4").tobytes())
        first = 0
        for mesh in meshes:
            for faces in mesh.faces():
                stream.write(_lists(faces.cut() + first))
            first += len(mesh)

    def size(self, points: int, triangles: int) -> int:
        return 4 * len(PROPERTIES) * points + 13 * triangles


register("ply")(StanfordPly())


def _header(points: int, faces: int) -> bytes:
    lines = ["ply", "format binary_little_endian 1.0", "comment PlusEdit"]
    lines += [f"element vertex {points}", *(f"property float {name}" for name in PROPERTIES)]
    lines += [f"element face {faces}", "property list uchar int vertex_indices", "end_header"]
    return "".join(f"{line}\n" for line in lines).encode()


def _lists(triangles: Numbers) -> bytes:
    """Of every triangle how many corners it has, and their numbers."""
    lists = np.empty(len(triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    lists["count"], lists["corners"] = 3, triangles
    return lists.tobytes()
