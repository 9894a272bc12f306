"""Which places of a view the surface of a mesh hides: one look for thousands of points.

The view is divided into small cells; of each the nearest triangle in its middle is noted. A point
is hidden where it lies behind the plane of that triangle, by more than the plane can be wrong.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

CELL = 4.0  # pixels
MARGIN = 6.0  # pixels that a surface has to be nearer to the eye to hide a point
AWAY = 3.0  # pixels from the middle of a cell to its corners, about
NOTHING = -1


@dataclass(frozen=True, eq=False)
class DepthMap:
    """The nearest triangles in the cells of a view."""

    nearest: NDArray[np.intp]
    """(columns, rows) of triangles; NOTHING where there is none"""
    planes: Floats
    """(t, 3) depth at the origin of the view, and by how much it grows to the right and down"""

    def hides(self, screen: Floats, depths: Floats, pixel: Floats) -> NDArray[np.bool_]:
        """Which of points at pixels (m, 2) are behind; `pixel` (m,) is its length there."""
        cells = np.floor(screen / CELL)
        size = np.array(self.nearest.shape)
        seen = (np.isfinite(cells) & (cells >= 0) & (cells < size)).all(axis=1)
        hidden = np.zeros(len(screen), dtype=np.bool_)
        column, row = cells[seen].astype(np.intp).T
        found = self.nearest[column, row]
        planes = self.planes[found]
        there = planes[:, 0] + (planes[:, 1:] * screen[seen]).sum(axis=1)
        slack = MARGIN * pixel[seen] + AWAY * np.hypot(planes[:, 1], planes[:, 2])
        hidden[seen] = (found != NOTHING) & (depths[seen] > there + slack)
        return hidden


def depth_map(corners: Floats, depths: Floats, size: tuple[float, float]) -> DepthMap:
    """The map of triangles with corners (t, 3, 2) in pixels, as deep as (t, 3), in a view."""
    planes = _planes(corners, depths)
    columns, rows = (max(1, int(np.ceil(side / CELL))) for side in size)
    nearest = np.full((columns, rows), NOTHING, dtype=np.intp)
    usable = np.flatnonzero(np.isfinite(planes).all(axis=1))
    owners, at = _cells(corners / CELL, usable, (columns, rows))
    middles = np.asarray((at + 0.5) * CELL, dtype=np.float64)
    inside = _covers(corners[owners], middles)
    owners, at, middles = owners[inside], at[inside], middles[inside]
    deep = planes[owners, 0] + (planes[owners, 1:] * middles).sum(axis=1)
    # The nearest is written last, and so stays.
    order = np.argsort(-deep, kind="stable")
    nearest[at[order, 0], at[order, 1]] = owners[order]
    return DepthMap(nearest, planes)


def _planes(corners: Floats, depths: Floats) -> Floats:
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    rise, climb = depths[:, 1] - depths[:, 0], depths[:, 2] - depths[:, 0]
    with np.errstate(all="ignore"):
        twice = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
        right = (rise * second[:, 1] - climb * first[:, 1]) / twice
        down = (climb * first[:, 0] - rise * second[:, 0]) / twice
        level = depths[:, 0] - right * corners[:, 0, 0] - down * corners[:, 0, 1]
    return np.stack([level, right, down], axis=1)


def _cells(
    corners: Floats, chosen: NDArray[np.intp], size: tuple[int, int]
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """(k,) triangles of the chosen and (k, 2) cells whose middles are in the boxes around them."""
    low, high = corners[chosen].min(axis=1), corners[chosen].max(axis=1)
    last = np.array(size) - 1.0
    low, high = np.ceil(low - 0.5).clip(0.0, last + 1.0), np.floor(high - 0.5).clip(-1.0, last)
    widths = np.maximum(high - low + 1.0, 0.0).astype(np.intp)
    counts = widths.prod(axis=1)
    owners = np.repeat(np.arange(len(chosen)), counts)
    within = np.arange(len(owners)) - np.repeat(np.cumsum(counts) - counts, counts)
    right, down = np.divmod(within, np.maximum(widths[owners, 1], 1))
    return chosen[owners], low[owners].astype(np.intp) + np.stack([right, down], axis=1)


def _covers(corners: Floats, points: Floats) -> NDArray[np.bool_]:
    """(k,) whether triangles (k, 3, 2) have points (k, 2) inside, whichever way round they run."""
    sides = []
    for place in range(3):
        along = corners[:, (place + 1) % 3] - corners[:, place]
        off = points - corners[:, place]
        sides.append(along[:, 0] * off[:, 1] - along[:, 1] * off[:, 0])
    signs = np.stack(sides)
    covers: NDArray[np.bool_] = (signs.min(axis=0) >= 0.0) | (signs.max(axis=0) <= 0.0)
    return covers
