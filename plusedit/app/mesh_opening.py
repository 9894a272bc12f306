"""Files of meshes and terrains made into shapes that the window can draw at once."""

from pathlib import Path
from typing import TYPE_CHECKING

from plusedit.scene.drawn_mesh import net_of

if TYPE_CHECKING:
    from plusedit.geometry.mesh.maps import Progress
    from plusedit.io.mesh_import import Imported
    from plusedit.io.mesh_report import ImportReport


def is_mesh(path: Path) -> bool:
    """Whether a file of that name holds a mesh or a terrain."""
    return path.name.lower().endswith(mesh_suffixes())


def mesh_suffixes() -> tuple[str, ...]:
    """Those of all meshes and terrains that can be read."""
    from plusedit.io.meshes import meshes

    return tuple(suffix for kind in meshes.values() for suffix in kind.suffixes)


def opened(path: Path, tell: "Progress") -> "Imported":
    """The parts of a mesh or terrain as surfaces, the largest first.

    FormatError in one sentence; what `tell` raises.
    """
    from plusedit.io.mesh_import import import_mesh

    found = import_mesh(path, tell=tell)
    for part in found.parts:
        # Worked out here and not in the window's thread, which draws it next.
        net_of(part.surface)
    return found


def told(report: "ImportReport") -> tuple[str, ...]:
    """What is said at once: the notes, and where all the rest stands."""
    return (f"{report.summary}; File > Mesh report has the numbers", *report.notes)
