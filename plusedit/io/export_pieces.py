"""What shapes become in a file of triangles and lines, and how fine that is."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.maps import Progress, silent
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.rectangle import Rectangle, rectangle
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_tessellate import affordable_tessellation
from plusedit.geometry.tessellate import tessellation
from plusedit.io.exports import Export, Meshed
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_grid import gridded
from plusedit.io.mesh_piece import pieced, times_within
from plusedit.io.surface_mesh import Strand, SurfaceMesh, meshed

MOST = 1_000_000  # points of one surface

Times: TypeAlias = Callable[[PolygonMesh], int]
Cells: TypeAlias = Callable[[MeshSurface, Rectangle], tuple[int, int]]


@dataclass(frozen=True)
class Fineness:
    """How fine surfaces of meshes are, whatever the tolerance is; with neither, it decides."""

    times: Times | None = None
    """how often the faces of a mesh are split into smaller ones"""
    cells: Cells | None = None
    """how many cells along u and v an even grid has, where the parameters fill a rectangle"""

    def grid(self, surface: MeshSurface) -> Rectangle | None:
        """What the grid of a surface covers; None where it gets none."""
        return None if self.cells is None else rectangle(surface)

    @property
    def is_given(self) -> bool:
        return self.times is not None or self.cells is not None


BY_TOLERANCE = Fineness()


def even_cells(surface: MeshSurface, over: Rectangle) -> tuple[int, int]:
    """About as many cells as the mesh has faces, and about square."""
    return over.cells(surface.mesh.face_count)


class Pieces:
    """What is written, shape by shape."""

    def __init__(self, entry: Export, length: float, fineness: Fineness = BY_TOLERANCE) -> None:
        self.meshes: list[Meshed] = []
        self.strands: list[Strand] = []
        self.of_meshes = 0
        """how many are surfaces of meshes"""
        self.remarks: list[str] = []
        """one sentence for each shape that is not as it was asked for"""
        self.is_coarser = False
        """whether one of them is coarser than the tolerance asks"""
        self._entry, self._length, self._fineness = entry, length, fineness

    def add(self, shape: Shape, tell: Progress = silent) -> None:
        """Add what the shape becomes. ValueError where that can't be written."""
        if shape.curve is not None:
            self.strands.append(_strand(shape, shape.curve, self._length))
        elif shape.surface is not None:
            made = affordable_tessellation(shape.surface, self._length, MOST)
            self.meshes.append(_mesh(shape, shape.surface, made.by_u, made.by_v, self._entry))
            self._note(shape, made.tolerance)
        elif shape.mesh is not None:
            self.meshes.append(self._of_mesh(shape, shape.mesh, tell))
            self.of_meshes += 1

    @property
    def is_by_tolerance(self) -> bool:
        """Whether any of them is as fine as the tolerance asks."""
        others = len(self.meshes) + len(self.strands) > self.of_meshes
        return others or not self._fineness.is_given

    def _of_mesh(self, shape: Shape, surface: MeshSurface, tell: Progress) -> Meshed:
        entry, fineness = self._entry, self._fineness
        looks = {"name": shape.name, "color": shape.style.color, "numbers": entry.numbers}
        over = fineness.grid(surface)
        if over is not None and fineness.cells is not None:
            return gridded(surface, over, fineness.cells(surface, over), **looks, tell=tell)
        if fineness.cells is not None:
            self.remarks.append(
                f"{shown(shape.name)} has its faces, not a grid: its parameters fill no rectangle"
            )
        times = 0
        if fineness.times is not None:
            times = fineness.times(surface.mesh)
        elif fineness.cells is None:
            times, reached = times_within(surface, self._length, MOST)
            self._note(shape, reached)
        return pieced(surface, times, **looks, has_polygons=entry.has_quads, tell=tell)

    def _note(self, shape: Shape, reached: float) -> None:
        if reached > self._length:
            self.is_coarser = True
            self.remarks.append(
                f"{shown(shape.name)} is coarser than asked: no more than {MOST} points are made"
            )


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
