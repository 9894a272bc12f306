"""A design as a file of triangles and lines: which shapes, how fine, and what is left out.

A plain number as a tolerance is a length in the unit of the points; with % it is a share of the
diagonal of the box about what is exported.
"""

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import isfinite
from pathlib import Path

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.blend import Grid
from plusedit.geometry.mesh.maps import Progress, silent
from plusedit.geometry.mesh.rectangle import rectangle
from plusedit.io.export_pieces import BY_TOLERANCE, Fineness, Pieces, in_space
from plusedit.io.exports import Export, Sink, exports
from plusedit.io.fields import of_number, within
from plusedit.io.files import by_suffix, replacing
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown

SEEN = Grid.uniform(33)  # where the size of a design is measured
MADE = 0.7  # of the time, about, when all points are known


@dataclass(frozen=True)
class Tolerance:
    """How far what is written may stray from the curves and surfaces."""

    amount: float
    is_share: bool = False
    """whether `amount` is a share of the size, not a length"""

    def __post_init__(self) -> None:
        if not (isfinite(self.amount) and self.amount > 0.0):
            raise ValueError("a tolerance must be above zero")

    @classmethod
    def of(cls, words: str) -> "Tolerance":
        """Such as "0.01", a length, or "0.05%", of the size. ValueError if it is neither."""
        number, percent, rest = words.strip().partition("%")
        try:
            amount = float(number)
        except ValueError:
            amount = 0.0
        if rest or not (isfinite(amount) and amount > 0.0):
            raise ValueError(
                f"expected a tolerance such as 0.01, or 0.05% of the size, got {words!r}"
            )
        return cls(amount / 100.0, True) if percent else cls(amount)

    def length(self, size: float) -> float:
        """In the unit of the points."""
        return self.amount * size if self.is_share else self.amount


USUAL = Tolerance(0.0005, is_share=True)


@dataclass(frozen=True)
class Report:
    """What an export has written."""

    surfaces: int
    curves: int
    points: int
    faces: int
    tolerance: float | None
    """a length; None where it was not asked for"""
    left_out: tuple[str, ...]
    """one sentence for each shape, and for each that is coarser than was asked"""
    is_coarser: bool = False
    """whether one is"""
    meshes: int = 0
    """surfaces of meshes"""

    def __str__(self) -> str:
        """Such as "2 surfaces and 1 curve: 800 points, 760 faces, within 0.0021"."""
        is_known = self.tolerance is not None and not self.is_coarser
        within = f", within {self.tolerance:.2g}" if is_known else ""
        kinds = [("surface", self.surfaces), ("mesh", self.meshes), ("curve", self.curves)]
        shapes = " and ".join(of_number(count, noun) for noun, count in kinds if count)
        counts = f"{of_number(self.points, 'point')}, {of_number(self.faces, 'face')}"
        return f"{shapes}: {counts}{within}"


def export_of(path: str | os.PathLike[str]) -> Export:
    """The export whose suffix the name ends with. FormatError lists the suffixes there are."""
    return by_suffix(Path(path), exports)


def export_design(
    design: Design,
    path: str | os.PathLike[str],
    shapes: Iterable[ShapeId] | None = None,
    tolerance: Tolerance = USUAL,
    *,
    fineness: Fineness = BY_TOLERANCE,
    tell: Progress = silent,
) -> Report:
    """Write curves and surfaces as the suffix of `path` says, all of it or nothing.

    All that are visible, or the named `shapes`, hidden ones too. `tell` is told what share is done
    and what comes next; what it raises ends the work. FormatError in one sentence, also if nothing
    is left to write, or if a named shape can't be.
    """
    entry = export_of(path)
    with replacing(path) as stream:
        chosen, left_out = _chosen(design, shapes, entry)
        _check_grid(chosen, fineness)
        length = tolerance.length(size_of(chosen))
        pieces = Pieces(entry, length, fineness)
        for number, shape in enumerate(chosen):
            with within(f"shape {shown(shape.name)}"):
                pieces.add(shape, _of_shape(tell, number, len(chosen)))
        entry.write(_Told(stream, tell), pieces.meshes, pieces.strands)
        tell(1.0, "Done")
    return _report(entry, pieces, length, left_out)


def chosen_shapes(
    design: Design, shapes: Iterable[ShapeId] | None, entry: Export
) -> tuple[Shape, ...]:
    """Those that `export_design` would write. FormatError if there are none."""
    return tuple(_chosen(design, shapes, entry)[0])


class _Told(Sink):
    """A stream that lets the work be given up between two pieces of it."""

    def __init__(self, stream: Sink, tell: Progress) -> None:
        self._stream, self._tell = stream, tell

    def write(self, data: bytes, /) -> int:
        self._tell(MADE, "Writing the file")
        return self._stream.write(data)


def _of_shape(tell: Progress, number: int, count: int) -> Progress:
    """Progress with one of some shapes."""

    def told(share: float, words: str) -> None:
        tell(MADE * (number + min(share, 1.0)) / count, words[:1].upper() + words[1:])

    return told


def _check_grid(shapes: Iterable[Shape], fineness: Fineness) -> None:
    """FormatError where a grid was asked for, and no mesh can have one."""
    surfaces = [shape.mesh for shape in shapes if shape.mesh is not None]
    if fineness.cells and surfaces and not any(map(rectangle, surfaces)):
        raise FormatError("no mesh has parameters that fill a rectangle, as a grid needs")


def _report(entry: Export, pieces: Pieces, length: float, left_out: tuple[str, ...]) -> Report:
    """What there is to say of what was written."""
    meshes, strands = pieces.meshes, pieces.strands
    points = sum(map(len, meshes)) + sum(len(strand.points) for strand in strands)
    return Report(
        len(meshes) - pieces.of_meshes,
        len(strands),
        points,
        sum(mesh.face_count if entry.has_quads else mesh.triangle_count for mesh in meshes),
        length if pieces.is_by_tolerance else None,
        (*left_out, *pieces.remarks),
        pieces.is_coarser,
        pieces.of_meshes,
    )


def _chosen(
    design: Design, named: Iterable[ShapeId] | None, entry: Export
) -> tuple[list[Shape], tuple[str, ...]]:
    """The shapes to write, and what is left out and why. FormatError if none is to be written."""
    chosen, left_out = [], []
    for shape_id in design if named is None else dict.fromkeys(named):
        if shape_id not in design:
            raise FormatError(f"shape {shown(shape_id)}: the design has no such shape")
        shape = design[shape_id]
        reason = _reason(shape, entry)
        if named is not None and reason:
            raise FormatError(f"shape {shown(shape_id)}: {reason}")
        if not reason and named is None and not shape.visible:
            reason = "it is hidden"
        if reason:
            left_out.append(f"{shown(shape.name)} is left out: {reason}")
        else:
            chosen.append(shape)
    if not chosen:
        raise FormatError("; ".join(["there is nothing to write", *left_out[:1]]))
    return chosen, tuple(left_out)


def _reason(shape: Shape, entry: Export) -> str:
    """Why it can't be written; empty if it can."""
    if shape.curve is not None and not entry.has_curves:
        return f"{entry.title} has no curves"
    return ""


def size_of(shapes: Sequence[Shape]) -> float:
    """The diagonal of the box about them."""
    points = [
        *(in_space(shape.curve.sample(SEEN)) for shape in shapes if shape.curve is not None),
        *(shape.surface.sample(SEEN, SEEN) for shape in shapes if shape.surface is not None),
        *(np.stack(shape.mesh.mesh.bounds) for shape in shapes if shape.mesh is not None),
    ]
    every = np.concatenate([rows.reshape(-1, 3) for rows in points])
    size = float(np.linalg.norm(np.ptp(every, axis=0)))
    if not size > 0.0:
        raise FormatError("all of it is a single point")
    return size
