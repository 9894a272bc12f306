"""Tessellated surfaces and curves, as files of triangles and lines want them.

A surface becomes a grid of points, row i at u_i and column j at v_j. Point (i, j) has the number
i * columns + j. What is one place on the surface is one place here to the last bit: both sides of
the seam of a closed direction, and a whole side that is a single point, a pole.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.surface import PlusSurface
from plusedit.io.mesh_faces import Faces, Numbers, cells, faces_of

BLOCK = 16_384  # points that are worked on at once
POLE = 1e-9  # of the size: a side shorter than that is a single point
STILL = 1e-9  # of the size, or in radians: below, two tangents span no plane
ASIDE = 1e-5  # of the way to the middle, where there is a normal again
MIDDLE = (0.4871, 0.5129)  # nothing of a symmetric surface is exactly there

Points = NDArray[Any]  # in the kind of number that the file has


@dataclass(frozen=True, eq=False)
class Strand:
    """A curve as a row of points."""

    name: str
    color: str | None
    points: Floats
    """(m, 3); of a closed curve the first stands at the end again"""


@dataclass(frozen=True, eq=False)
class SurfaceMesh:
    """A surface as quads, and triangles where quads have lost a side."""

    name: str
    color: str | None
    points: Points
    """(rows, columns, 3)"""
    normals: NDArray[np.float32]
    """(rows, columns, 3) unit vectors of the surface; outward where it bounds a body"""
    u: Floats
    """(rows,) from 0 to 1"""
    v: Floats
    """(columns,) from 0 to 1"""
    closed: tuple[bool, bool]
    """whether the last row is the first, and the last column the first"""
    poles: tuple[bool, bool, bool, bool]
    """whether the first row, the last row, the first column, the last column is one point"""
    turned: bool = False
    """whether faces run around the other way, from v to u"""

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns)"""
        return len(self.u), len(self.v)

    def __len__(self) -> int:
        return len(self.u) * len(self.v)

    def blocks(self) -> Iterator[slice]:
        """Slices of rows, together all of them."""
        step = max(1, BLOCK // len(self.v))
        for first in range(0, len(self.u), step):
            yield slice(first, min(first + step, len(self.u)))

    def parameters(self, rows: slice) -> Floats:
        """(k, columns, 2) u and v of the points of those rows."""
        return np.stack(np.meshgrid(self.u[rows], self.v, indexing="ij"), axis=-1)

    def faces(self) -> Iterator[Faces]:
        """All faces but those without an area, block by block."""
        for rows in self.blocks():
            last = min(rows.stop, len(self.u) - 1)
            if rows.start < last:
                corners = cells(rows.start, last, len(self.v))
                if self.turned:
                    corners = corners[:, ::-1]
                yield faces_of(self.scaled, corners)

    @cached_property
    def scaled(self) -> Floats:
        """(rows * columns, 3) the points, halved or doubled until they are no larger than one."""
        points = self.points.reshape(-1, 3).astype(np.float64)
        # By a power of two, nothing is rounded: what was the same stays so, and nothing else.
        return np.ldexp(points, -int(np.frexp(np.abs(points).max())[1]))

    @cached_property
    def face_counts(self) -> tuple[int, int]:
        """How many quads and how many triangles `faces` yields."""
        counts = [(len(faces.quads), len(faces.triangles)) for faces in self.faces()]
        return sum(quads for quads, _ in counts), sum(triangles for _, triangles in counts)

    @property
    def face_count(self) -> int:
        """How many faces `faces` yields."""
        return sum(self.face_counts)

    @property
    def triangle_count(self) -> int:
        """How many triangles there are once every quad is cut in two."""
        quads, triangles = self.face_counts
        return 2 * quads + triangles

    @cached_property
    def welded(self) -> tuple[Numbers, Numbers]:
        """Seams and poles joined: which points (k,) are left, and what each has become.

        The second is (rows * columns,), places among the points that are left.
        """
        numbers = np.arange(len(self)).reshape(self.shape)
        # Twice, for a corner where two of the rules meet.
        for _ in range(2):
            for is_one, side in zip(self.poles, SIDES, strict=True):
                if is_one:
                    numbers[side] = numbers[side].flat[0]
            if self.closed[0]:
                numbers[-1] = numbers[0]
            if self.closed[1]:
                numbers[:, -1] = numbers[:, 0]
        left, places = np.unique(numbers, return_inverse=True)
        return left, places.ravel()


ALL, START, END = slice(None), slice(0, 1), slice(-1, None)
SIDES = ((START, ALL), (END, ALL), (ALL, START), (ALL, END))
"""The first row, the last row, the first column and the last column of a grid."""


def meshed(
    surface: PlusSurface,
    u: Floats,
    v: Floats,
    *,
    name: str = "",
    color: str | None = None,
    numbers: Any = np.float64,
) -> SurfaceMesh:
    """The mesh of a surface at every pair of parameters u and v, which run from 0 to 1.

    `numbers` is the kind of number that points are rounded to.
    """
    points = np.empty((len(u), len(v), 3))
    normals = np.empty(points.shape, dtype=np.float32)
    mesh = SurfaceMesh(name, color, points, normals, u, v, surface.closed, (False,) * 4)
    with np.errstate(all="ignore"):
        for rows in mesh.blocks():
            points[rows] = surface.at(u[rows], v)
        if not np.isfinite(points).all():
            raise ValueError("a point is beyond a double")
        size = float(np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0)))
        for rows in mesh.blocks():
            normals[rows] = _normals(surface, u[rows], v, size)
        poles = _joined(points, normals, surface.closed, size)
        rounded = replace(mesh, points=points.astype(numbers), poles=poles)
    if not np.isfinite(rounded.points).all():
        raise ValueError("a point is beyond the numbers that the file has")
    return _outward(rounded)


def _joined(
    points: Floats, normals: NDArray[np.float32], closed: tuple[bool, bool], size: float
) -> tuple[bool, bool, bool, bool]:
    """Make the same places the same to the last bit; which sides are poles."""
    for grid in (points, normals):
        if closed[0]:
            grid[-1] = grid[0]
        if closed[1]:
            grid[:, -1] = grid[:, 0]
    found = [bool(np.ptp(points[side], axis=(0, 1)).max() <= POLE * size) for side in SIDES]
    for is_one, side in zip(found, SIDES, strict=True):
        if is_one:
            points[side] = points[side][0, 0]
    return found[0], found[1], found[2], found[3]


def _normals(surface: PlusSurface, u: Floats, v: Floats, size: float) -> Floats:
    """(m_u, m_v, 3) unit normals; where there is none, as at a pole, that of the place beside."""
    _, by_u, by_v = surface.derivatives(u, v, highest=1)
    normals, found = crossed(by_u, by_v, size)
    if not found.all():
        places = np.stack(np.meshgrid(u, v, indexing="ij"), axis=-1)[~found]
        aside = places + ASIDE * (np.array(MIDDLE) - places)
        _, by_u, by_v = surface.derivatives_at(aside, highest=1)
        normals[~found] = crossed(by_u, by_v, size)[0]
    return normals


def crossed(by_u: Floats, by_v: Floats, size: float) -> tuple[Floats, NDArray[np.bool_]]:
    """Unit normals, and whether the tangents span a plane; where they do not, (0, 0, 1)."""
    across = np.cross(by_u, by_v)
    lengths = [np.linalg.norm(vectors, axis=-1) for vectors in (across, by_u, by_v)]
    moves = np.minimum(lengths[1], lengths[2]) > STILL * size
    found = moves & (lengths[0] > STILL * lengths[1] * lengths[2])
    unit = np.divide(
        across, lengths[0][..., None], where=found[..., None], out=np.zeros_like(across)
    )
    unit[~found] = (0.0, 0.0, 1.0)
    return unit, found


def _outward(mesh: SurfaceMesh) -> SurfaceMesh:
    """The mesh, turned if it bounds a body and has its normals inside."""
    ends = (all(mesh.poles[:2]), all(mesh.poles[2:]))
    if not all(closed or both for closed, both in zip(mesh.closed, ends, strict=True)):
        return mesh
    points = mesh.scaled - mesh.scaled.mean(axis=0)
    volume = 0.0
    for faces in mesh.faces():
        for a, b, c in (faces.quads.T[:3], faces.quads.T[[0, 2, 3]], faces.triangles.T):
            volume += float(np.einsum("kd,kd->", points[a], np.cross(points[b], points[c])))
    return replace(mesh, normals=-mesh.normals, turned=True) if volume < 0.0 else mesh
