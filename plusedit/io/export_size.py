"""How much an export will write, without writing it."""

from collections.abc import Iterable
from dataclasses import dataclass

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.surface_tessellate import affordable_tessellation
from plusedit.geometry.tessellate import tessellation
from plusedit.io.export_pieces import BY_TOLERANCE, MOST, Fineness
from plusedit.io.exporting import USUAL, Tolerance, chosen_shapes, size_of
from plusedit.io.exports import Export
from plusedit.io.fields import of_number
from plusedit.io.mesh_piece import times_within

UNITS = ("bytes", "kB", "MB", "GB", "TB")


@dataclass(frozen=True)
class Expected:
    """About what a file will hold."""

    points: int
    triangles: int
    size: int
    """bytes"""

    def __str__(self) -> str:
        """Such as "138,902 triangles, about 4.2 MB"."""
        triangles = of_number(self.triangles, "triangle").replace(
            str(self.triangles), f"{self.triangles:,}"
        )
        return f"{triangles}, about {words_of(self.size)}"


def expected(
    design: Design,
    entry: Export,
    shapes: Iterable[ShapeId] | None = None,
    tolerance: Tolerance = USUAL,
    fineness: Fineness = BY_TOLERANCE,
) -> Expected:
    """What `export_design` would write. FormatError where that would be nothing."""
    chosen = chosen_shapes(design, shapes, entry)
    length = tolerance.length(size_of(chosen))
    counts = [_counts(shape, length, fineness) for shape in chosen]
    points, triangles = (sum(column) for column in zip(*counts, strict=True))
    return Expected(points, triangles, entry.size(points, triangles))


def words_of(size: int) -> str:
    """A number of bytes in two digits or three, such as "4.2 MB"."""
    amount, unit = float(size), 0
    while amount >= 999.5 and unit < len(UNITS) - 1:
        amount, unit = amount / 1000.0, unit + 1
    return (
        f"{amount:.0f} {UNITS[unit]}"
        if unit == 0 or amount >= 9.95
        else f"{amount:.1f} {UNITS[unit]}"
    )


def _counts(shape: Shape, length: float, fineness: Fineness) -> tuple[int, int]:
    """Points and triangles, about."""
    if shape.curve is not None:
        return len(tessellation(shape.curve, length, axes=None).parameters), 0
    if shape.surface is not None:
        made = affordable_tessellation(shape.surface, length, MOST)
        return _of_grid(len(made.by_u.parameters) - 1, len(made.by_v.parameters) - 1)
    return (0, 0) if shape.mesh is None else _of_mesh(shape.mesh, length, fineness)


def _of_mesh(surface: MeshSurface, length: float, fineness: Fineness) -> tuple[int, int]:
    over = fineness.grid(surface)
    if over is not None and fineness.cells is not None:
        return _of_grid(*fineness.cells(surface, over))
    times = 0
    if fineness.times is not None:
        times = fineness.times(surface.mesh)
    elif fineness.cells is None:
        times = times_within(surface, length, MOST)[0]
    triangles = triangles_of(surface.mesh, times)
    # Of a closed mesh there are about half as many, of any other not many more.
    return max(surface.mesh.vertex_count, triangles // 2), triangles


def triangles_of(mesh: PolygonMesh, times: int) -> int:
    """How many triangles there are, once faces were split so often and then cut."""
    corners, faces = len(mesh.corners), mesh.face_count
    if not times:
        return corners - 2 * faces
    of_three = int((mesh.sizes == 3).sum())
    # A triangle becomes four, a larger face one quad for each corner.
    once = 4 * of_three + 2 * (corners - 3 * of_three)
    return once << 2 * (times - 1)


def _of_grid(along: int, across: int) -> tuple[int, int]:
    return (along + 1) * (across + 1), 2 * along * across
