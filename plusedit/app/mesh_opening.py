"""Files of meshes and terrains made into shapes, with a report of what was found and done."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.io.formats import FormatError
from plusedit.scene.drawn_mesh import net_of

Tell = Callable[[float, str], None]
"""Is told what share is done and what comes next; what it raises ends the work."""

NAMED = {3: "triangles", 4: "quads", 5: "pentagons", 6: "hexagons"}
READ, REPAIRED = 0.15, 0.3  # of all the time, about


@dataclass(frozen=True)
class PartReport:
    """What there is to tell of one part."""

    name: str
    rows: tuple[tuple[str, str], ...]
    """what, and how it is"""


@dataclass(frozen=True)
class MeshReport:
    """What there is to tell of a file."""

    name: str
    notes: tuple[str, ...]
    """what was repaired, left out or assumed, and what to look out for"""
    parts: tuple[PartReport, ...]

    @property
    def summary(self) -> str:
        """Such as "3 parts"."""
        count = len(self.parts)
        return "1 part" if count == 1 else f"{count} parts"

    @property
    def told(self) -> tuple[str, ...]:
        """What is said at once: the notes, and where all the rest stands."""
        return (f"{self.summary}; File > Mesh report has the numbers", *self.notes)


@dataclass(frozen=True, eq=False)
class Opened:
    """The shapes of a file."""

    shapes: tuple[tuple[ShapeId, Shape], ...]
    report: MeshReport

    @property
    def design(self) -> Design:
        """One with these shapes alone."""
        return Design(dict(self.shapes))


def is_mesh(path: Path) -> bool:
    """Whether a file of that name holds a mesh or a terrain."""
    return path.name.lower().endswith(mesh_suffixes())


def mesh_suffixes() -> tuple[str, ...]:
    """Those of all meshes and terrains that can be read."""
    from plusedit.io.meshes import meshes

    return tuple(suffix for kind in meshes.values() for suffix in kind.suffixes)


def opened(path: Path, tell: Tell) -> Opened:
    """The parts of a mesh or terrain as shapes, the largest first.

    FormatError in one sentence; what `tell` raises.
    """
    from plusedit.geometry.mesh.repair import repaired
    from plusedit.io.mesh_reading import read_mesh

    tell(0.0, "Reading the file")
    read = read_mesh(path)
    tell(READ, "Mending the mesh")
    try:
        mended = repaired(read.mesh)
    except ValueError as error:
        raise FormatError(f"{path.name}: {error}") from error
    shapes: dict[ShapeId, Shape] = {}
    reports: list[PartReport] = []
    notes = [*read.notes, *mended.notes]
    done, whole = 0, max(sum(part.mesh.face_count for part in mended.parts), 1)
    for number, part in enumerate(mended.parts):
        name = path.stem if len(mended.parts) == 1 else f"{path.stem} {number + 1}"
        first = REPAIRED + (1.0 - REPAIRED) * done / whole
        share = (1.0 - REPAIRED) * part.mesh.face_count / whole
        uv = None if read.uv is None else read.uv[part.corners]

        def told(of_part: float, words: str, first: float = first, share: float = share) -> None:
            tell(first + share * of_part, words[:1].upper() + words[1:])

        try:
            shape, report, found = _shape(name, part.mesh, uv, read.is_height_field, told)
        except ValueError as error:
            notes.append(f"{name} was left out: {error}")
        else:
            shapes[ShapeId(f"mesh-{number + 1}")] = shape
            reports.append(report)
            notes += [f"{name}: {note}" if len(mended.parts) > 1 else note for note in found]
        done += part.mesh.face_count
    if not shapes:
        raise FormatError(f"{path.name}: {notes[-1] if notes else 'no part became a surface'}")
    report_of_all = MeshReport(path.name, tuple(notes), tuple(reports))
    return Opened(tuple(shapes.items()), report_of_all)


def _shape(
    name: str, mesh: PolygonMesh, uv: np.ndarray | None, is_height_field: bool, tell: Tell
) -> tuple[Shape, PartReport, tuple[str, ...]]:
    from plusedit.geometry.mesh.mapping import mapped
    from plusedit.geometry.mesh.mesh_surface import MeshSurface

    found = mapped(mesh, uv=uv, is_height_field=is_height_field, progress=tell)
    surface = MeshSurface(mesh, found.domain, found.parameters)
    # Worked out here and not in the window's thread, which draws it next.
    net_of(surface)
    _ = surface.foundation.planes
    part = mesh.topology.components[0]
    rows = (
        ("Faces", f"{mesh.face_count:,}: {by_corners(mesh)}"),
        ("Vertices", f"{part.vertices:,}"),
        ("Holes", str(part.boundaries)),
        ("Handles", str(part.handles)),
        ("Map", f"{found.title}, {found.why}"),
        ("Flipped triangles", str(found.flips)),
    )
    return Shape(surface, name), PartReport(name, rows), found.notes


def by_corners(mesh: PolygonMesh) -> str:
    """Such as "120 triangles, 8 quads"."""
    counts = np.bincount(mesh.sizes)
    return ", ".join(
        f"{count:,} {NAMED.get(size, f'polygons of {size} corners')}"
        for size, count in enumerate(counts.tolist())
        if count
    )
