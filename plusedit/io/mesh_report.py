"""What there is to tell of a mesh that was read and made smooth: as data, and as text."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from plusedit.geometry.mesh.deviation import Deviation, Spread
from plusedit.geometry.mesh.polygons import PolygonMesh

NAMED = {3: "triangle", 4: "quad", 5: "pentagon", 6: "hexagon"}
IN_FULL = 8  # parts, of which a text tells everything


@dataclass(frozen=True, eq=False)
class PartReport:
    """What there is to tell of one connected part."""

    name: str
    faces: Mapping[int, int]
    """how many there are, by how many corners they have"""
    vertices: int
    holes: int
    """rings of its border; the rim of a sheet is one"""
    handles: int
    map_name: str
    """as on the shelf of maps"""
    map_title: str
    why: str
    """why that map, as a phrase"""
    flips: int
    """triangles turned over by the map"""
    notes: tuple[str, ...] = ()
    """what else there is to know, a sentence each"""
    deviation: Deviation | None = None
    """of the surface from the mesh, if it was asked for"""

    @property
    def face_count(self) -> int:
        return sum(self.faces.values())

    @property
    def rows(self) -> tuple[tuple[str, str], ...]:
        """What, and how it is: ("Faces", "6 quads")."""
        rows = [
            ("Faces", faces_in_words(self.faces)),
            ("Vertices", f"{self.vertices:,}"),
            ("Holes", str(self.holes)),
            ("Handles", str(self.handles)),
            ("Map", f"{self.map_title}, {self.why}"),
            ("Flipped triangles", str(self.flips)),
        ]
        if self.deviation is not None:
            size = self.deviation.diagonal
            rows.append(("Mesh to surface", of_size(self.deviation.to_surface, size)))
            rows.append(("Surface to mesh", of_size(self.deviation.to_mesh, size)))
        return tuple(rows)

    def __str__(self) -> str:
        """Such as "knee: 6 quads, 0 holes, 0 handles"."""
        return (
            f"{self.name}: {by_corners(self.faces)}, {_counted(self.holes, 'hole')}, "
            f"{_counted(self.handles, 'handle')}, {self.map_title}"
        )


@dataclass(frozen=True, eq=False)
class ImportReport:
    """What there is to tell of a file."""

    name: str
    notes: tuple[str, ...]
    """what was repaired, left out or assumed, and what to look out for"""
    parts: tuple[PartReport, ...]
    """those that became surfaces, the largest first"""

    @property
    def summary(self) -> str:
        """Such as "3 parts"."""
        return _counted(len(self.parts), "part")

    @property
    def text(self) -> str:
        """All of it as lines; of many parts the largest in full."""
        lines = [f"{self.name}: {self.summary}"]
        width = 2 + max(len(what) for part in self.parts[:1] for what, _ in part.rows)
        for part in self.parts[:IN_FULL]:
            if len(self.parts) > 1:
                lines.append(part.name)
            lines += [f"  {what.ljust(width)}{how}" for what, how in part.rows]
        lines += [f"  {part}" for part in self.parts[IN_FULL:]]
        return "\n".join([*lines, *(f"* {note}" for note in self.notes)])


def faces_by_corners(mesh: PolygonMesh) -> dict[int, int]:
    """How many faces there are of each number of corners."""
    counts = np.bincount(mesh.sizes).tolist()
    return {size: count for size, count in enumerate(counts) if count}


def faces_in_words(faces: Mapping[int, int]) -> str:
    """Such as "6 quads", or "128: 120 triangles, 8 quads"."""
    total = f"{sum(faces.values()):,}: " if len(faces) > 1 else ""
    return total + by_corners(faces)


def by_corners(faces: Mapping[int, int]) -> str:
    """Such as "120 triangles, 8 quads"."""
    return ", ".join(
        _counted(count, NAMED[size])
        if size in NAMED
        else f"{_counted(count, 'polygon')} of {size} corners"
        for size, count in sorted(faces.items())
    )


def of_size(spread: Spread, size: float) -> str:
    """Such as "rms 0.025 %, median 0.01 %, largest 1.2 % of the size"."""
    share = 100.0 / size if size > 0.0 else 0.0
    numbers = {"rms": spread.rms, "median": spread.median, "largest": spread.largest}
    words = (f"{name} {share * number:.2g} %" for name, number in numbers.items())
    return f"{', '.join(words)} of the size {size:.4g}"


def _counted(count: int, noun: str) -> str:
    return f"1 {noun}" if count == 1 else f"{count:,} {noun}s"
