"""Designs from files of any kind that opens: designs, drawings, meshes and terrains."""

import os
from pathlib import Path

from plusedit.document.design import Design
from plusedit.io.files import load
from plusedit.io.mesh_file import Up
from plusedit.io.meshes import meshes


def is_mesh(path: Path) -> bool:
    """Whether a file of that name holds a mesh or a terrain."""
    return path.name.lower().endswith(mesh_suffixes())


def mesh_suffixes() -> tuple[str, ...]:
    """Those of all meshes and terrains that can be read."""
    return tuple(suffix for kind in meshes.values() for suffix in kind.suffixes)


def opened_design(path: str | os.PathLike[str], up: Up | None = None) -> Design:
    """The design in a file; of a mesh or terrain the surfaces that an import makes of it.

    `up` is the axis that points up in a mesh; None for that of its kind of file. FormatError in
    one sentence.
    """
    place = Path(path)
    if not is_mesh(place):
        return load(place).design
    # What it needs takes its time to load.
    from plusedit.io.mesh_import import ImportOptions, import_mesh

    return import_mesh(place, ImportOptions(up=up)).design
