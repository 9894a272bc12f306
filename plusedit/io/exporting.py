"""A design as a file of triangles and lines: which shapes, how fine, and what is left out.

A plain number as a tolerance is a length in the unit of the points; with % it is a share of the
diagonal of the box about what is exported.
"""

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import TypeAlias

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_tessellate import affordable_tessellation
from plusedit.geometry.tessellate import tessellation
from plusedit.io.exports import Export, Meshed, exports
from plusedit.io.fields import of_number, within
from plusedit.io.files import by_suffix, replacing
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_piece import MeshPiece, pieced, times_within
from plusedit.io.surface_mesh import Strand, SurfaceMesh, meshed

SEEN = Grid.uniform(33)  # where the size of a design is measured
MOST = 1_000_000  # points of one surface

Times: TypeAlias = Callable[[PolygonMesh], int]


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
    times: Times | None = None,
) -> Report:
    """Write curves and surfaces as the suffix of `path` says, all of it or nothing.

    All that are visible, or the named `shapes`, hidden ones too. `times` says how often the faces
    of a mesh are split into smaller ones, whatever the tolerance is. FormatError in one sentence,
    also if nothing is left to write, or if a named shape can't be.
    """
    entry = export_of(path)
    with replacing(path) as stream:
        chosen, left_out = _chosen(design, shapes, entry)
        length = tolerance.length(_size(chosen))
        pieces = Pieces(entry, length, times)
        for shape in chosen:
            with within(f"shape {shown(shape.name)}"):
                pieces.add(shape)
        entry.write(stream, pieces.meshes, pieces.strands)
    return pieces.report(left_out)


class Pieces:
    """What is written, shape by shape."""

    def __init__(self, entry: Export, length: float, times: Times | None) -> None:
        self.meshes: list[Meshed] = []
        self.strands: list[Strand] = []
        self._entry, self._length, self._times = entry, length, times
        self._coarse: list[str] = []

    def add(self, shape: Shape) -> None:
        """Add what the shape becomes. ValueError where that can't be written."""
        length = self._length
        if shape.curve is not None:
            self.strands.append(_strand(shape, shape.curve, length))
        elif shape.surface is not None:
            made = affordable_tessellation(shape.surface, length, MOST)
            self.meshes.append(_mesh(shape, shape.surface, made.by_u, made.by_v, self._entry))
            self._note(shape, made.tolerance)
        elif shape.mesh is not None:
            if self._times is None:
                times, reached = times_within(shape.mesh, length, MOST)
            else:
                times, reached = self._times(shape.mesh.mesh), 0.0
            self.meshes.append(_piece(shape, shape.mesh, times, self._entry))
            self._note(shape, reached)

    def report(self, left_out: tuple[str, ...]) -> Report:
        """What there is to say of it."""
        pieces = sum(isinstance(mesh, MeshPiece) for mesh in self.meshes)
        points = sum(map(len, self.meshes)) + sum(len(strand.points) for strand in self.strands)
        quads = self._entry.has_quads
        is_asked = self._times is None or pieces < len(self.meshes) + len(self.strands)
        return Report(
            len(self.meshes) - pieces,
            len(self.strands),
            points,
            sum(mesh.face_count if quads else mesh.triangle_count for mesh in self.meshes),
            self._length if is_asked else None,
            (*left_out, *self._coarse),
            bool(self._coarse),
            pieces,
        )

    def _note(self, shape: Shape, reached: float) -> None:
        if reached > self._length:
            name = shown(shape.name)
            self._coarse.append(
                f"{name} is coarser than asked: no more than {MOST} points are made"
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


def _size(shapes: list[Shape]) -> float:
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


def _mesh(shape: Shape, surface: PlusSurface, by_u: Grid, by_v: Grid, entry: Export) -> SurfaceMesh:
    mesh = meshed(
        surface,
        by_u.parameters,
        by_v.parameters,
        name=shape.name,
        color=shape.style.color,
        numbers=entry.numbers,
    )
    if not any(mesh.face_counts):
        raise FormatError("has no area")
    return mesh


def _piece(shape: Shape, surface: MeshSurface, times: int, entry: Export) -> MeshPiece:
    return pieced(
        surface,
        times,
        name=shape.name,
        color=shape.style.color,
        numbers=entry.numbers,
        has_polygons=entry.has_quads,
    )


def _strand(shape: Shape, curve: PlusCurve, tolerance: float) -> Strand:
    points = curve.sample(tessellation(curve, tolerance, axes=None))
    return Strand(shape.name, shape.style.color, in_space(points))


def in_space(points: Floats) -> Floats:
    """(m, 3) points of a plane curve as those of one in space, at z = 0."""
    return np.pad(points, ((0, 0), (0, 3 - points.shape[1])))
