"""STL, the format of printers: binary triangles, each with the normal of its own plane."""

from collections.abc import Sequence

import numpy as np

from plusedit.io.exports import Meshed, Sink, register
from plusedit.io.formats import FormatError
from plusedit.io.mesh_faces import Numbers
from plusedit.io.surface_mesh import Strand

# A reader takes a file that begins with "solid" for text.
TITLE = b"PlusEdit, binary STL".ljust(80)
FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attributes", "<u2")])
MOST = 2**32 - 1  # the count has four bytes


class BinaryStl:
    """All triangles of all surfaces in one list."""

    title = "STL"
    suffixes = (".stl",)
    has_curves = False
    has_quads = False
    numbers = np.float32

    def write(self, stream: Sink, meshes: Sequence[Meshed], _strands: Sequence[Strand]) -> None:
        """Write the file piece by piece. FormatError if there are too many triangles."""
        count = sum(mesh.triangle_count for mesh in meshes)
        if count > MOST:
            raise FormatError(f"an STL file holds up to {MOST} triangles, not {count}")
        stream.write(TITLE)
        stream.write(count.to_bytes(4, "little"))
        for mesh in meshes:
            for faces in mesh.faces():
                stream.write(_facets(mesh, faces.cut()))

    def size(self, points: int, triangles: int) -> int:
        return len(TITLE) + 4 + FACET.itemsize * triangles


register("stl")(BinaryStl())


def _facets(mesh: Meshed, triangles: Numbers) -> bytes:
    facets = np.zeros(len(triangles), dtype=FACET)
    facets["corners"] = mesh.points.reshape(-1, 3)[triangles]
    a, b, c = mesh.scaled[triangles.T]
    across = np.cross(b - a, c - a)
    length = np.linalg.norm(across, axis=1, keepdims=True)
    facets["normal"] = np.divide(across, length, out=np.zeros_like(across), where=length > 0.0)
    return facets.tobytes()
