"""Files of meshes and terrains made into smooth surfaces, one for each connected part.

Read, repaired and parted, split where faces are uneven, given parameters by the map that suits, and
blended: what was found and done on the way is in the report.
"""

import hashlib
import os
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType

from plusedit.document.design import Design
from plusedit.document.map_record import MapRecord, with_map
from plusedit.document.shape import NOTHING, Shape, ShapeId, Tree
from plusedit.geometry.mesh.deviation import deviation
from plusedit.geometry.mesh.mapping import Mapped
from plusedit.geometry.mesh.maps import Progress, maps, share_of, silent
from plusedit.geometry.mesh.mesh_surface import USUAL_SMOOTHNESS, MeshSurface
from plusedit.geometry.mesh.refine import FEWEST
from plusedit.geometry.mesh.repair import Part, Repaired, repaired
from plusedit.geometry.mesh.splitting import Wishes, split_and_mapped
from plusedit.io.fields import within
from plusedit.io.files import shown_name
from plusedit.io.formats import FormatError
from plusedit.io.mesh_file import MeshFile, Up
from plusedit.io.mesh_reading import read_mesh
from plusedit.io.mesh_report import ImportReport, PartReport, faces_by_corners

READ, REPAIRED = 0.15, 0.3  # of all the time, about
MEASURED = 0.5  # of the time of one part, if its deviation is measured after
MAPPED = 0.85  # of the time of one part before that
CHUNK = 1 << 20  # bytes
MOST = 256  # parts: crumbs beyond would take long and help nobody
NOT_SUITED = "does not suit"  # the words of `mapped`


@dataclass(frozen=True)
class ImportOptions:
    """What a person may choose."""

    smoothness: float = USUAL_SMOOTHNESS
    s: float = 1.0
    area_weights: bool = False
    refine: bool = True
    """whether large and thin faces are split before"""
    map_name: str | None = None
    """of the map for all parts that it suits; None takes for each the one that suits best"""
    up: Up | None = None
    """the axis that points up in the file; None for that of its kind"""
    measure: bool = False
    """whether the deviation from the mesh is measured, which takes as long as all else"""


@dataclass(frozen=True, eq=False)
class ImportedPart:
    """A part as a surface."""

    name: str
    surface: MeshSurface
    report: PartReport


@dataclass(frozen=True, eq=False)
class Imported:
    """The parts of a file, the largest first; at least one."""

    parts: tuple[ImportedPart, ...]
    report: ImportReport
    source: Tree = field(default_factory=lambda: NOTHING)
    """where the mesh came from, as design files tell it"""

    @property
    def shapes(self) -> tuple[tuple[ShapeId, Shape], ...]:
        """A shape for each part, with its id."""
        source: Tree = MappingProxyType({"source": self.source}) if self.source else NOTHING
        return tuple(
            (
                ShapeId(f"mesh-{number}"),
                Shape(
                    part.surface,
                    part.name,
                    extra=with_map(source, MapRecord(part.report.map_name)),
                ),
            )
            for number, part in enumerate(self.parts, 1)
        )

    @property
    def design(self) -> Design:
        """A design of these shapes alone."""
        return Design(dict(self.shapes))


def import_mesh(
    path: str | os.PathLike[str],
    options: ImportOptions = ImportOptions(),
    tell: Progress = silent,
) -> Imported:
    """The surfaces of a file of a mesh or a terrain.

    `tell` is told what share is done and what comes next; what it raises ends the work.
    FormatError in one sentence, which begins with the name of the file.
    """
    place, tell = Path(path), _growing(tell)
    tell(0.0, "Reading the file")
    read = read_mesh(place)
    source = MappingProxyType({"file": place.name, "sha256": _digest(place)})
    return _with_source(smoothed(read, shown_name(place), options, tell), source)


def smoothed(
    read: MeshFile,
    name: str,
    options: ImportOptions = ImportOptions(),
    tell: Progress = silent,
) -> Imported:
    """The surfaces of a mesh that was read from a file of that name."""
    tell = _growing(tell)
    with within(name):
        _check_map(options.map_name)
        tell(READ, "Mending the mesh")
        read = read.upright(options.up)
        mended = repaired(read.mesh)
        parts, notes = _parts(read, mended, Path(name).stem, options, tell)
        if not parts:
            raise FormatError(notes[-1])
        if options.map_name is not None:
            _check_taken(parts, notes, options.map_name)
    reports = tuple(part.report for part in parts)
    told = ImportReport(name, (*read.notes, *mended.notes, *notes), reports)
    return Imported(tuple(parts), told)


def _with_source(imported: Imported, source: Tree) -> Imported:
    return Imported(imported.parts, imported.report, source)


def _digest(place: Path) -> str:
    digest = hashlib.sha256()
    with place.open("rb") as file:
        while piece := file.read(CHUNK):
            digest.update(piece)
    return digest.hexdigest()


def _check_map(name: str | None) -> None:
    if name is not None and name not in maps:
        raise FormatError(f"there is no map {name!r}; there are {', '.join(sorted(maps))}")


def _check_taken(parts: list[ImportedPart], notes: list[str], name: str) -> None:
    """FormatError where the map that was wished for suits no part."""
    if all(part.report.map_name != name for part in parts):
        raise FormatError(next(note for note in notes if NOT_SUITED in note))


def _parts(
    read: MeshFile, mended: Repaired, stem: str, options: ImportOptions, tell: Progress
) -> tuple[list[ImportedPart], list[str]]:
    """The parts that became surfaces, and notes on them and on those that did not."""
    parts: list[ImportedPart] = []
    notes: list[str] = []
    several, taken = len(mended.parts) > 1, mended.parts[:MOST]
    area = sum(float(part.mesh.areas.sum()) for part in taken)
    done, whole = 0, max(sum(part.mesh.face_count for part in taken), 1)
    for number, part in enumerate(taken, 1):
        name, count = f"{stem} {number}" if several else stem, part.mesh.face_count
        shares = (REPAIRED + (1.0 - REPAIRED) * faces / whole for faces in (done, done + count))
        told = share_of(tell, *shares)
        try:
            found = _part(_Piece(read, part, name, area), options, told)
        except ValueError as error:
            if not several:
                raise
            notes.append(f"{name} was left out: {error}")
        else:
            parts.append(found)
            notes += [f"{name}: {note}" if several else note for note in found.report.notes]
        done += count
    if len(mended.parts) > MOST:
        notes.append(f"{len(mended.parts) - MOST} smaller parts beside {MOST} were left out")
    tell(1.0, "Done")
    return parts, notes


def _growing(tell: Progress) -> Progress:
    """Progress that never goes back, though some of the work may have to be done again, and
    speaks in sentences."""
    told = 0.0

    def growing(share: float, words: str) -> None:
        nonlocal told
        told = max(told, min(share, 1.0))
        tell(told, words[:1].upper() + words[1:])

    return growing


@dataclass(frozen=True, eq=False)
class _Piece:
    """A part on its way to a surface."""

    read: MeshFile
    part: Part
    name: str
    area: float
    """of all parts together"""


def _part(piece: _Piece, options: ImportOptions, tell: Progress) -> ImportedPart:
    """One part as a surface. ValueError where it can't be."""
    read, part = piece.read, piece.part
    uv = None if read.uv is None else read.uv[part.corners]
    tell(0.0, "looking at the faces")
    told = share_of(tell, 0.0, MEASURED if options.measure else 1.0)
    # Each part has its share of the faces, so that crumbs of a mesh don't get as many as it has.
    share = float(part.mesh.areas.sum()) / piece.area if piece.area > 0.0 else 1.0
    wishes = Wishes(
        uv, read.is_height_field, options.map_name, options.refine, round(share * FEWEST)
    )
    split = split_and_mapped(part.mesh, wishes, share_of(told, 0.0, MAPPED))
    mesh, found = split.mesh, split.mapped
    told(MAPPED, "laying planes through the faces")
    surface = MeshSurface(
        mesh, found.domain, found.parameters, options.smoothness, options.s, options.area_weights
    )
    _ = surface.foundation.planes  # so that nobody who draws the surface has to wait for them
    report = _report(piece, found, split.notes)
    if options.measure:
        tell(MEASURED, "measuring how far the surface is from the mesh")
        report = replace(report, deviation=deviation(surface))
    return ImportedPart(piece.name, surface, report)


def _report(piece: _Piece, found: Mapped, notes: tuple[str, ...]) -> PartReport:
    mesh = piece.part.mesh
    component = mesh.topology.components[0]
    return PartReport(
        piece.name,
        faces_by_corners(mesh),
        component.vertices,
        component.boundaries,
        component.handles,
        found.name,
        found.title,
        found.why,
        found.flips,
        notes,
    )
