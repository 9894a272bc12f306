"""The shelf of exports: files of triangles and lines, for programs that know no plus shapes."""

from collections.abc import Sequence
from typing import Any, Protocol, TypeAlias

from plusedit.io.mesh_piece import MeshPiece
from plusedit.io.surface_mesh import Strand, SurfaceMesh
from plusedit.registry import Registry

Meshed: TypeAlias = SurfaceMesh | MeshPiece
"""What is written as faces: points in rows of a grid or in one row, with normals, parameters."""


class Sink(Protocol):
    """Where bytes go, such as a file."""

    def write(self, data: bytes, /) -> int:
        """Take some more; how many."""
        ...


class Export(Protocol):
    """One kind of file to export to."""

    @property
    def title(self) -> str:
        """Such as "Wavefront OBJ"."""
        ...

    @property
    def suffixes(self) -> tuple[str, ...]:
        """Such as (".obj",); no other export has them."""
        ...

    @property
    def has_curves(self) -> bool:
        """Whether it can hold curves; if not, it is given none."""
        ...

    @property
    def has_quads(self) -> bool:
        """Whether faces of four corners and more are written as such, not cut into triangles."""
        ...

    @property
    def numbers(self) -> Any:
        """The kind of number in which the file says points, such as numpy.float32."""
        ...

    def write(self, stream: Sink, meshes: Sequence[Meshed], strands: Sequence[Strand]) -> None:
        """Write the file piece by piece; at least one mesh or strand is there.

        FormatError if the file can't hold that much.
        """
        ...

    def size(self, points: int, triangles: int) -> int:
        """About how many bytes a file of so many points and triangles has."""
        ...


exports: Registry[Export] = Registry("plusedit.io.exports")
register = exports.register
