"""A surface as a coarse net of cells: where to look closely, and where not.

The corners of a cell are joined by two flat triangles. The surface over it lies within a known
distance of them, so a cell that is farther away than another one by more than that is out of the
question. Cells hold no knots inside: over each of them the surface is smooth.
"""

from dataclasses import dataclass
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.blend import Grid
from plusedit.geometry.candidates import TOGETHER, Numbers, lengths, levels
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_tessellate import surface_size, surface_tessellation

STRAY = 5e-3  # of the size of the surface: how far triangles may lie from it
MOST = 1 << 13  # corners of all cells
SLACK = 1e-9  # of a triangle: a line between two of them goes through both
AHEAD = 1.5  # times what a cell strays in its middle, it strays at most

TRIANGLES = np.array([[0, 1, 2], [0, 2, 3]])
"""The corners of the two triangles of a cell."""

EDGES = np.array([[0, 1, 2, 3, 0], [1, 2, 3, 0, 2]])
"""The corners where edges and the diagonal begin and end."""

PLACES = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
"""Of the corners in a cell, shares of its width by u and by v."""


@dataclass(frozen=True, eq=False)
class Cells:
    """All cells of a surface, k of them."""

    low: Floats
    """(k, 2) u and v where they begin"""
    high: Floats
    corners: Floats
    """(k, 4, 3) points of the surface, round each of them"""
    strays: Floats
    """(k,) how far the surface may lie from the triangles"""
    middles: Floats
    """(k, 3) of balls that hold the triangles and the surface over them"""
    radii: Floats
    """(k,)"""

    @cached_property
    def stray(self) -> float:
        """The largest of them."""
        return float(self.strays.max())

    @cached_property
    def largest(self) -> float:
        """No coordinate of the surface is larger."""
        return float(np.abs(self.middles).max() + self.radii.max())

    @cached_property
    def balls(self) -> tuple["Balls", ...]:
        """Balls that hold the surface over some cells each: over many first, over one last."""
        return levels(Balls(self.middles, self.radii))


@dataclass(frozen=True, eq=False)
class Balls:
    """k balls, each of which holds a part of the surface."""

    middles: Floats
    """(k, 3)"""
    strays: Floats
    """(k,) their radii: that far the surface may lie from the middle"""

    def coarser(self) -> "Balls":
        """Balls that hold several of these each."""
        first = np.arange(0, len(self.strays), TOGETHER)
        count = np.diff(first, append=len(self.strays))
        middles = np.add.reduceat(self.middles, first) / count[:, None]
        away = lengths(self.middles - np.repeat(middles, count, axis=0))
        return Balls(middles, np.maximum.reduceat(away + self.strays, first))


_KEPT: "WeakKeyDictionary[PlusSurface, Cells]" = WeakKeyDictionary()


def cells_of(surface: PlusSurface) -> Cells:
    """Those of a surface; worked out once, and kept for as long as it lives."""
    kept = _KEPT.get(surface)
    if kept is None:
        kept = _KEPT[surface] = _cells(surface)
    return kept


def _cells(surface: PlusSurface) -> Cells:
    stray = max(STRAY * surface_size(surface), np.finfo(np.float64).tiny)
    grids = surface_tessellation(surface, stray, MOST)
    u, v = (grid.parameters for grid in grids)
    corners = _round_cells(surface.sample(*grids))
    between = (Grid((each[:-1] + each[1:]) / 2.0) for each in (u, v))
    centers = surface.sample(*between).reshape(-1, 3)
    middles = corners.mean(axis=1)
    off = np.linalg.norm(centers - middles, axis=1)
    strays = np.maximum(stray, AHEAD * off)
    radii = np.linalg.norm(corners - middles[:, None], axis=2).max(axis=1) + strays
    low = np.stack(np.meshgrid(u[:-1], v[:-1], indexing="ij"), axis=-1).reshape(-1, 2)
    high = np.stack(np.meshgrid(u[1:], v[1:], indexing="ij"), axis=-1).reshape(-1, 2)
    order = _winding(len(u) - 1, len(v) - 1)
    return Cells(*(each[order] for each in (low, high, corners, strays, middles, radii)))


def _winding(rows: int, columns: int) -> Numbers:
    """The order of cells in which those that follow each other lie together (Morton's)."""
    places = np.indices((rows, columns)).reshape(2, -1)
    code = np.zeros(rows * columns, dtype=np.intp)
    for bit in range(max(rows, columns).bit_length()):
        for way in (0, 1):
            code |= ((places[way] >> bit) & 1) << (2 * bit + way)
    return np.argsort(code)


def _round_cells(points: Floats) -> Floats:
    """(k, 4, 3) the corners of each cell of a grid of points."""
    around = [points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]]
    return np.ascontiguousarray(np.stack(around, axis=2).reshape(-1, 4, 3))


def from_triangles(points: Floats, corners: Floats) -> Floats:
    """(k,) distances of points (k, 3), or one (3,), from the triangles of cells.

    These have the corners (k, 4, 3).
    """
    start, end = corners[:, EDGES[0]], corners[:, EDGES[1]]
    point = points[..., None, :]
    way, away = end - start, point - start
    length, heading = np.linalg.norm(way, axis=2), unit(way)
    along = np.clip(np.einsum("kid,kid->ki", away, heading), 0.0, length)
    nearest = np.linalg.norm(away - along[..., None] * heading, axis=2).min(axis=1)
    three = corners[:, TRIANGLES]
    a, b = three[:, :, 1] - three[:, :, 0], three[:, :, 2] - three[:, :, 0]
    normal = unit(np.cross(a, b))
    heights = np.einsum("kid,kid->ki", point - three[:, :, 0], normal)
    shares = _shares(a, b, normal, point - three[:, :, 0])
    over = (shares.min(axis=0) >= 0.0) & normal.any(axis=2)
    inside = np.where(over, np.abs(heights), np.inf).min(axis=1)
    distances: Floats = np.minimum(nearest, inside)
    return distances


def _shares(a: Floats, b: Floats, normal: Floats, away: Floats) -> Floats:
    """(3, ...) what the corners of triangles with edges a and b have in a point above them.

    Up to a positive factor; `away` is the point as seen from the first corner.
    """
    second = np.einsum("...d,...d->...", np.cross(away, b), normal)
    third = np.einsum("...d,...d->...", np.cross(a, away), normal)
    twice = np.einsum("...d,...d->...", np.cross(a, b), normal)
    return np.stack([twice - second - third, second, third])


@dataclass(frozen=True, eq=False)
class Piercings:
    """Where a line goes through triangles, h times."""

    along: Floats
    """(h,) how far along the line"""
    places: Floats
    """(h, 2) u and v"""
    rows: NDArray[np.intp]
    """(h,) of the cells"""

    def taken(self, order: NDArray[np.intp]) -> "Piercings":
        """Some of them, in that order."""
        return Piercings(self.along[order], self.places[order], self.rows[order])


def piercings(origin: Floats, heading: Floats, cells: Cells, rows: NDArray[np.intp]) -> Piercings:
    """Where a line through `origin` along a unit vector goes through triangles of some cells."""
    three = cells.corners[rows][:, TRIANGLES]
    a, b = three[:, :, 1] - three[:, :, 0], three[:, :, 2] - three[:, :, 0]
    away = origin - three[:, :, 0]
    across, turned = np.cross(heading, b), np.cross(away, a)
    volume = np.einsum("kid,kid->ki", a, across)
    usable = volume != 0.0
    below = np.where(usable, volume, 1.0)
    second = np.einsum("kid,kid->ki", away, across) / below
    third = np.einsum("kid,d->ki", turned, heading) / below
    shares = np.stack([1.0 - second - third, second, third], axis=2)
    row, half = np.nonzero(usable & (shares.min(axis=2) >= -SLACK))
    along = np.einsum("kid,kid->ki", turned, b) / below
    inside = np.einsum("hs,hsd->hd", shares[row, half], PLACES[TRIANGLES][half])
    hit = rows[row]
    low, high = cells.low[hit], cells.high[hit]
    places = low + np.clip(inside, 0.0, 1.0) * (high - low)
    return Piercings(along[row, half], places, hit)
