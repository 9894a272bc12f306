"""A design as a file of triangles and lines: which shapes, how fine, and what is left out.

A plain number as a tolerance is a length in the unit of the points; with % it is a share of the
diagonal of the box about what is exported.
"""

import os
from collections.abc import Iterable
from dataclasses import dataclass
from math import isfinite
from pathlib import Path

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_tessellate import affordable_tessellation
from plusedit.geometry.tessellate import tessellation
from plusedit.io.exports import Export, exports
from plusedit.io.fields import of_number, within
from plusedit.io.files import by_suffix, replacing
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.surface_mesh import Strand, SurfaceMesh, meshed

SEEN = Grid.uniform(33)  # where the size of a design is measured
MOST = 1_000_000  # points of one surface


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
    tolerance: float
    """a length"""
    left_out: tuple[str, ...]
    """one sentence for each shape, and for each that is coarser than was asked"""
    is_coarser: bool = False
    """whether one is"""

    def __str__(self) -> str:
        """Such as "2 surfaces and 1 curve: 800 points, 760 faces, within 0.0021"."""
        within = "" if self.is_coarser else f", within {self.tolerance:.2g}"
        kinds = [("surface", self.surfaces), ("curve", self.curves)]
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
) -> Report:
    """Write curves and surfaces as the suffix of `path` says, all of it or nothing.

    All that are visible, or the named `shapes`, hidden ones too. FormatError in one sentence, also
    if nothing is left to write, or if a named shape can't be.
    """
    entry = export_of(path)
    with replacing(path) as stream:
        chosen, left_out = _chosen(design, shapes, entry)
        length = tolerance.length(_size(chosen))
        strands, meshes, coarse = [], [], []
        for shape in chosen:
            with within(f"shape {shown(shape.name)}"):
                if shape.curve is not None:
                    strands.append(_strand(shape, shape.curve, length))
                elif shape.surface is not None:
                    made = affordable_tessellation(shape.surface, length, MOST)
                    meshes.append(_mesh(shape, shape.surface, made.by_u, made.by_v, entry))
                    if made.tolerance > length:
                        coarse.append(_coarse(shape.name))
        entry.write(stream, meshes, strands)
    points = sum(len(strand.points) for strand in strands) + sum(map(len, meshes))
    faces = sum(sum(m.face_counts) if entry.has_quads else m.triangle_count for m in meshes)
    told = (*left_out, *coarse)
    return Report(len(meshes), len(strands), points, faces, length, told, bool(coarse))


def _coarse(name: str) -> str:
    return f"{shown(name)} is coarser than asked: no more than {MOST} points are made"


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
    if shape.mesh is not None:
        return "a mesh can't be exported yet"
    if shape.curve is not None and not entry.has_curves:
        return f"{entry.title} has no curves"
    return ""


def _size(shapes: list[Shape]) -> float:
    """The diagonal of the box about them."""
    points = [
        *(in_space(shape.curve.sample(SEEN)) for shape in shapes if shape.curve is not None),
        *(shape.surface.sample(SEEN, SEEN) for shape in shapes if shape.surface is not None),
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


def _strand(shape: Shape, curve: PlusCurve, tolerance: float) -> Strand:
    points = curve.sample(tessellation(curve, tolerance, axes=None))
    return Strand(shape.name, shape.style.color, in_space(points))


def in_space(points: Floats) -> Floats:
    """(m, 3) points of a plane curve as those of one in space, at z = 0."""
    return np.pad(points, ((0, 0), (0, 3 - points.shape[1])))
