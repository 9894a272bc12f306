"""The convex hull of points in space, as a closed mesh of triangles.

It grows from four points by the farthest point outside (Barber, Dobkin and Huhdanpaa, The
Quickhull Algorithm for Convex Hulls, 1996): triangles that see the new point go, and those
between it and the rim of the gap come. Which triangles see it is decided without any rounding:
coordinates are first brought onto a grid of whole numbers, 2^48 to the extent of the points, on
which normals and the side of a plane are exact. A triangle in one plane with the new point does
not see it; then the gap always has one simple rim, however flat or regular the points are.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.hulls import convex_hull

GRID = 2.0**48  # of a coordinate: differences of whole numbers up to 2^53 are exact
OFF = 4.0  # grid units, 1e-14 of the extent: what stands off by less is rounding
BLOCK = 1 << 18  # heights worked out at once

Indices = NDArray[np.intp]
Whole = tuple[int, int, int]
"""A point of the grid, a normal, or the numbers of three points."""


@dataclass(frozen=True, eq=False)
class HullMesh:
    """A convex body: triangles counter-clockwise as seen from outside.

    Of points in one plane it is flat and has two sides; points in a row, or in one place, have
    no triangles.
    """

    points: Floats
    """(h, 3) the corners, some of the points given"""
    triangles: Indices
    """(t, 3) three indices of `points` each"""


def hull_mesh(points: Floats) -> HullMesh:
    """The smallest convex body that holds the points (m, 3), to 1e-14 of their extent.

    Where many points lie on one side of the body some of them may be corners of its triangles.
    """
    points = np.asarray(points, dtype=np.float64).reshape(-1, 3)
    first = _simplex(points)
    if len(first) <= 2:
        return HullMesh(points[first], np.zeros((0, 3), dtype=np.intp))
    if len(first) == 3:
        return _flat(points, first)
    return _Growing(points, first).grown()


def on_grid(points: Floats) -> Floats:
    """The points brought onto whole numbers, the largest extent of the three 2^48."""
    low = points.min(axis=0)
    extent = float((points - low).max())
    return np.rint((points - low) * (GRID / extent)) if extent > 0.0 else np.zeros_like(points)


def _simplex(points: Floats) -> Indices:
    """Up to four points far apart: fewer where all lie in a plane, a row or one place."""
    if len(points) <= 1:
        return np.arange(len(points))
    grid = on_grid(points)
    axis = int(grid.max(axis=0).argmax())
    a, b = int(grid[:, axis].argmin()), int(grid[:, axis].argmax())
    if a == b:
        return np.array([a])
    from_a = grid - grid[a]
    along = from_a[b] / np.linalg.norm(from_a[b])
    off_line = np.linalg.norm(from_a - np.outer(from_a @ along, along), axis=1)
    c = int(off_line.argmax())
    if off_line[c] <= OFF:
        return np.array([a, b])
    normal = np.cross(along, from_a[c])
    height = from_a @ (normal / np.linalg.norm(normal))
    d = int(np.abs(height).argmax())
    if abs(height[d]) <= OFF:
        return np.array([a, b, c])
    return np.array([a, b, c, d] if height[d] < 0.0 else [a, c, b, d])


def _flat(points: Floats, three: Indices) -> HullMesh:
    """The polygon of points in one plane, both of its sides."""
    a, b, c = points[three]
    dropped = int(np.abs(np.cross(b - a, c - a)).argmax())
    points = points[_outer(np.delete(points, dropped, axis=1))]
    seen = np.delete(points, dropped, axis=1)
    number = {tuple(row): index for index, row in enumerate(seen.tolist())}
    corners = points[[number[tuple(row)] for row in convex_hull(seen).tolist()]]
    # The other side begins one corner further: no edge but those around belongs to both.
    front = _fan(np.arange(len(corners)))
    back = _fan(np.roll(np.arange(len(corners)), -1))[:, ::-1]
    return HullMesh(corners, np.concatenate([front, back]))


def _fan(around: Indices) -> Indices:
    """(h - 2, 3) triangles from the first of the numbers (h,) to each two neighbors."""
    return np.stack([np.full(len(around) - 2, around[0]), around[1:-1], around[2:]], axis=1)


def _outer(points: Floats) -> Indices:
    """Of points in the plane those that are not well inside: few are left of many."""
    angles = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    corners = points[(points @ [np.cos(angles), np.sin(angles)]).argmax(axis=0)]
    (x, y), edges = corners.T, np.roll(corners, -1, axis=0) - corners
    left = np.outer(edges[:, 0], points[:, 1]) - np.outer(edges[:, 1], points[:, 0])
    left -= (edges[:, 0] * y - edges[:, 1] * x)[:, None]
    inside = left > np.abs(left).max() * 1e-9
    inside[(edges == 0.0).all(axis=1)] = True
    return np.flatnonzero(~inside.all(axis=0))


class _Facet(NamedTuple):
    """A triangle of the body while it grows, and the points known to be outside of it."""

    corners: Whole
    normal: Whole
    """outward, exact, of any length"""
    outside: Indices
    """the farthest is the last"""


class _Growing:
    """A convex body that takes in one point after the other."""

    def __init__(self, points: Floats, simplex: Indices) -> None:
        self._points = points
        self._grid = on_grid(points)
        self._rows = np.ascontiguousarray(self._grid.T)
        self._whole: dict[int, Whole] = {}  # of those that were corners
        self._facets: dict[int, _Facet] = {}
        self._edges: dict[tuple[int, int], int] = {}  # the facet to the left of each way
        self._made = 0
        a, b, c, d = (self._corner(int(index)) for index in simplex)
        sides = [(a, b, c), (a, d, b), (b, d, c), (c, d, a)]
        self._add(sides, np.arange(len(points)))

    def grown(self) -> HullMesh:
        """The body that holds all points."""
        waiting = list(self._facets)
        while waiting:
            while waiting:
                number = waiting.pop()
                facet = self._facets.get(number)
                if facet is not None and len(facet.outside):
                    waiting.extend(self._take_in(number, int(facet.outside[-1])))
            waiting = self._left_out()
        triangles = np.array([facet.corners for facet in self._facets.values()], dtype=np.intp)
        corners, numbers = np.unique(triangles, return_inverse=True)
        return HullMesh(self._points[corners], numbers.reshape(-1, 3).astype(np.intp))

    def _take_in(self, number: int, point: int) -> list[int]:
        """Let the body reach to a point that one of its facets sees; the new facets' numbers."""
        seeing, rim = self._seeing(number, self._corner(point))
        gone = [self._facets.pop(facet) for facet in seeing]
        for facet in gone:
            a, b, c = facet.corners
            for edge in ((a, b), (b, c), (c, a)):
                del self._edges[edge]
        outside = np.concatenate([facet.outside for facet in gone])
        return self._add([(a, b, point) for a, b in rim], outside)

    def _corner(self, point: int) -> int:
        """The number of a point, its coordinates known as whole numbers from now on."""
        x, y, z = self._grid[point].tolist()
        self._whole[point] = (int(x), int(y), int(z))
        return point

    def _seeing(self, number: int, point: int) -> tuple[set[int], list[tuple[int, int]]]:
        """The facets that see a point, and the edges around them."""
        seeing, rim, waiting = {number}, [], [number]
        known: dict[int, bool] = {number: True}
        while waiting:
            a, b, c = self._facets[waiting.pop()].corners
            for start, end in ((a, b), (b, c), (c, a)):
                beyond = self._edges[end, start]
                if beyond not in known:
                    known[beyond] = self._sees(self._facets[beyond], point)
                    if known[beyond]:
                        seeing.add(beyond)
                        waiting.append(beyond)
                if not known[beyond]:
                    rim.append((start, end))
        return seeing, rim

    def _sees(self, facet: _Facet, point: int) -> bool:
        (x, y, z), (nx, ny, nz) = self._whole[point], facet.normal
        ax, ay, az = self._whole[facet.corners[0]]
        return nx * (x - ax) + ny * (y - ay) + nz * (z - az) > 0

    def _add(self, sides: list[Whole], outside: Indices) -> list[int]:
        """New facets, each with those of the points that stand off it farthest of all of them."""
        normals = [self._normal(side) for side in sides]
        heights = self._heights(sides, normals, outside)
        owner, highest = heights.argmax(axis=0), heights.max(axis=0)
        order = np.lexsort((highest, owner))
        order = order[highest[order] > OFF]
        # Point by point, the highest of each facet last.
        outside = outside[order]
        ends = owner[order].searchsorted(np.arange(len(sides) + 1)).tolist()
        numbers = list(range(self._made, self._made + len(sides)))
        self._made += len(sides)
        for place, (number, side) in enumerate(zip(numbers, sides, strict=True)):
            own = outside[ends[place] : ends[place + 1]]
            self._facets[number] = _Facet(side, normals[place], own)
            a, b, c = side
            self._edges[a, b] = self._edges[b, c] = self._edges[c, a] = number
        return numbers

    def _normal(self, side: Whole) -> Whole:
        a, b, c = side
        ax, ay, az = self._whole[a]
        bx, by, bz = self._whole[b]
        cx, cy, cz = self._whole[c]
        bx, by, bz, cx, cy, cz = bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az
        return by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx

    def _heights(self, sides: list[Whole], normals: list[Whole], of: Indices) -> Floats:
        """(f, m) how far points stand off the planes of the sides, outward, in grid units."""
        outward = np.array(normals, dtype=np.float64)
        outward /= np.sqrt(np.einsum("fd,fd->f", outward, outward))[:, None]
        feet = self._grid[[side[0] for side in sides]]
        # Not by @: threads that wait for each other take longer than so small a product.
        heights: Floats = np.einsum("fd,dm->fm", outward, self._rows.take(of, axis=1))
        heights -= np.einsum("fd,fd->f", feet, outward)[:, None]
        return heights

    def _left_out(self) -> list[int]:
        """Facets that points not taken in are still outside of; told to wait for them.

        A point goes to the new facets where it lost its old one. Where it stands off all of them
        by next to nothing it is dropped, and once in a while another facet sees it clearly.
        """
        numbers = list(self._facets)
        sides = [self._facets[number].corners for number in numbers]
        normals = [self._facets[number].normal for number in numbers]
        found: list[tuple[int, int]] = []
        step = max(1, BLOCK // len(sides))
        for start in range(0, len(self._points), step):
            rows = np.arange(start, min(start + step, len(self._points)))
            heights = self._heights(sides, normals, rows)
            off = np.flatnonzero(heights.max(axis=0) > OFF)
            found += zip(heights[:, off].argmax(axis=0).tolist(), rows[off], strict=True)
        for place, point in found:
            number = numbers[place]
            self._facets[number] = _Facet(sides[place], normals[place], np.array([point]))
        return [numbers[place] for place, _ in found]
