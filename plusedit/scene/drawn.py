"""Curves as polylines that look smooth: no farther than a quarter pixel from the curve.

The grid of parameters is made for the next power of two of the camera's scale and for a window
wider than the view, so that panning, zooming and dragging meet the same grid again and again and
with it the same matrices.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import ceil, floor, log2

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tessellate import is_fine, tessellation
from plusedit.scene.camera import PlaneCamera

TOLERANCE = 0.25  # pixels
AHEAD = (
    0.5  # of the tolerance: a new grid is that fine, so that it lasts while the curve is dragged
)
REUSED_UP_TO = 2048  # parameters: a longer grid is made for one curve, and too much for others

Window = tuple[float, float, float, float]
"""left, bottom, right, top in the world"""


@dataclass(frozen=True, eq=False)
class Drawn:
    """A curve as a polyline."""

    grid: Grid
    """rising parameters, 0 and 1 among them"""
    points: Floats
    """(m, dim) in the world"""
    screen: Floats
    """(m, 2) pixels of the view"""


@lru_cache(maxsize=512)
def drawn(curve: PlusCurve, camera: PlaneCamera, tolerance: float = TOLERANCE) -> Drawn:
    """The polyline that shows `curve` in that view."""
    level = 2.0 ** ceil(log2(camera.scale))
    grid = _grid(curve, tolerance / level, _window(camera, level), camera.axes)
    points = curve.sample(grid)
    return Drawn(grid, points, camera.to_screen(points))


def _window(camera: PlaneCamera, level: float) -> Window:
    """What is seen and somewhat more, the same for views that differ little."""
    cell = max(camera.size) / level
    low, high = camera.window
    left, bottom = (floor(value / cell) * cell for value in low)
    right, top = (ceil(value / cell) * cell for value in high)
    return left, bottom, right, top


@lru_cache(maxsize=512)
def _grid(curve: PlusCurve, tolerance: float, window: Window, axes: tuple[int, int]) -> Grid:
    seen = (np.array(window[:2]), np.array(window[2:]))
    recent = _RECENT.get((curve.basis, tolerance, window, axes))
    if recent is not None and is_fine(curve, recent, tolerance, window=seen, axes=axes):
        return recent
    grid = tessellation(curve, AHEAD * tolerance, window=seen, axes=axes)
    if len(grid) <= REUSED_UP_TO:
        _RECENT.keep((curve.basis, tolerance, window, axes), grid)
    return grid


class _Recent:
    """The last grid for curves of one basis, seen alike: a drag meets it at every move."""

    def __init__(self, size: int) -> None:
        self._size = size
        self._grids: dict[tuple[Basis, float, Window, tuple[int, int]], Grid] = {}

    def get(self, key: tuple[Basis, float, Window, tuple[int, int]]) -> Grid | None:
        return self._grids.get(key)

    def keep(self, key: tuple[Basis, float, Window, tuple[int, int]], grid: Grid) -> None:
        self._grids.pop(key, None)
        self._grids[key] = grid
        if len(self._grids) > self._size:
            del self._grids[next(iter(self._grids))]


_RECENT = _Recent(64)
