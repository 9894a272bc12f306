"""Meshes and terrains from files, by their suffix."""

import os
from pathlib import Path
from typing import Protocol, runtime_checkable

from plusedit.io.files import by_suffix, read_file, shown_name
from plusedit.io.formats import FormatError
from plusedit.io.gltf_buffers import SideFiles
from plusedit.io.json_text import shown
from plusedit.io.mesh_file import MeshFile
from plusedit.io.meshes import meshes


@runtime_checkable
class HasSideFiles(Protocol):
    """A format whose documents may keep data in files beside them."""

    def read_beside(self, data: bytes, name: str, beside: SideFiles) -> MeshFile:
        """As `MeshFormat.read`, with the files that `beside` gives."""
        ...


def read_mesh(source: str | os.PathLike[str] | bytes, name: str = "") -> MeshFile:
    """The mesh or terrain in a file, or in bytes that a file of that name would hold.

    FormatError in one sentence, which begins with the name of the file.
    """
    place = Path(name if isinstance(source, bytes) else source)
    mesh_format = by_suffix(place, meshes)
    shown_as = shown_name(place)
    data = source if isinstance(source, bytes) else read_file(place)
    try:
        if isinstance(mesh_format, HasSideFiles) and not isinstance(source, bytes):
            return mesh_format.read_beside(data, shown_as, beside_file(place))
        return mesh_format.read(data, shown_as)
    except MemoryError:
        raise FormatError(f"{shown_as}: needs more memory than there is") from None


def beside_file(place: Path) -> SideFiles:
    """A reader of the files that really lie in the same folder as `place`."""

    def read(name: str) -> bytes:
        found = place.parent / name
        folder = os.path.realpath(place.parent)
        if os.path.dirname(os.path.realpath(found)) != folder:  # noqa: PTH120
            raise FormatError(f"the file {shown(name)} is a link that leads elsewhere")
        return read_file(found)

    return read
