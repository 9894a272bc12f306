"""The shelf of mesh files: polygon meshes and terrains that can be read."""

from typing import Protocol

from plusedit.io.mesh_file import MeshFile
from plusedit.registry import Registry


class MeshFormat(Protocol):
    """One kind of mesh file."""

    @property
    def title(self) -> str:
        """Such as "Wavefront OBJ"."""
        ...

    @property
    def suffixes(self) -> tuple[str, ...]:
        """Such as (".obj",); no other mesh format has them."""
        ...

    def read(self, data: bytes, name: str) -> MeshFile:
        """The mesh in a file of that name. FormatError, beginning with `name`, says what is wrong.

        Nothing of `data` is believed before it is checked; memory stays within what its size
        explains.
        """
        ...


meshes: Registry[MeshFormat] = Registry("plusedit.io.meshes")
register = meshes.register
