"""Curves as polylines that look smooth: no farther than a quarter pixel from the curve.

A curve is tessellated once, as finely as its own size asks for. Where the view needs it finer,
all intervals are halved until it is: a chord half as long strays a quarter as far. So panning,
zooming and dragging meet the same few grids again and again, and with them the same matrices.
A curve much larger than the view is tessellated for what is seen of it.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import ceil, floor, frexp, log

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tessellate import is_fine, tessellation
from plusedit.scene.camera import PlaneCamera

TOLERANCE = 0.25  # pixels
COARSEST = 1.0 / 256.0  # of the size of a curve: how far its first chords may stray
AHEAD = 0.5  # of the tolerance: a new grid is that fine, so that it lasts through a drag
KEPT = 0.8  # of the tolerance: where a curve is tight, half a chord strays more than a quarter
LARGE = 4.0  # times the view: a larger curve is made fine only near what is seen

Window = tuple[float, float, float, float]
"""left, bottom, right, top in the world"""

Axes = tuple[int, int]
Key = tuple[Basis, float, Axes]


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
    size, allowed = _size(curve), tolerance / camera.scale
    if size * camera.scale > LARGE * max(camera.size):
        level = 2.0 ** ceil(log(camera.scale, 2.0))
        grid, points = _sampled_near(curve, tolerance / level, _window(camera, level), camera.axes)
    else:
        halvings = max(0, ceil(log(COARSEST * size / allowed, 4.0))) if size else 0
        grid, points = _sampled(curve, halvings, camera.axes)
    return Drawn(grid, points, camera.to_screen(points))


@lru_cache(maxsize=1024)
def _size(curve: PlusCurve) -> float:
    """The size of a curve, up to the next power of two: it seldom changes during a drag."""
    points = curve.lines.points
    extent = float((points.max(axis=0) - points.min(axis=0)).max())
    pull = curve.spacing * float(np.abs(curve.gradients).max())
    mantissa, exponent = frexp(max(extent, pull))
    return 2.0**exponent if mantissa else 0.0


@lru_cache(maxsize=1024)
def _sampled(curve: PlusCurve, halvings: int, axes: Axes) -> tuple[Grid, Floats]:
    """The grid of a curve, halved that often, and the points there; good for any such view."""
    grid = _halved(_first(curve, axes), halvings)
    return grid, curve.sample(grid)


@lru_cache(maxsize=1024)
def _first(curve: PlusCurve, axes: Axes) -> Grid:
    """The grid that suits the size of the curve; that of the frame before, if it does."""
    allowed = COARSEST * (_size(curve) or 1.0)
    key = (curve.basis, allowed, axes)
    recent = _RECENT.get(key)
    if recent is not None and is_fine(curve, recent, KEPT * allowed, axes=axes):
        return recent
    grid = tessellation(curve, AHEAD * allowed, axes=axes)
    _RECENT.keep(key, grid)
    return grid


@lru_cache(maxsize=128)
def _halved(grid: Grid, times: int) -> Grid:
    if times == 0:
        return grid
    u = _halved(grid, times - 1).parameters
    halves = np.empty(2 * len(u) - 1)
    halves[::2], halves[1::2] = u, (u[:-1] + u[1:]) / 2.0
    return Grid(halves)


def _window(camera: PlaneCamera, level: float) -> Window:
    """What is seen and somewhat more, the same for views that differ little."""
    cell = max(camera.size) / level
    low, high = camera.window
    left, bottom = (floor(value / cell) * cell for value in low)
    right, top = (ceil(value / cell) * cell for value in high)
    return left, bottom, right, top


@lru_cache(maxsize=64)
def _sampled_near(
    curve: PlusCurve, tolerance: float, window: Window, axes: Axes
) -> tuple[Grid, Floats]:
    """A grid that is fine inside the window, and the points there."""
    seen = (np.array(window[:2]), np.array(window[2:]))
    grid = tessellation(curve, tolerance, window=seen, axes=axes)
    return grid, curve.sample(grid)


class _Recent:
    """The last grid for curves of one basis and size: a drag meets it at every move."""

    def __init__(self, count: int) -> None:
        self._count = count
        self._grids: dict[Key, Grid] = {}

    def get(self, key: Key) -> Grid | None:
        return self._grids.get(key)

    def keep(self, key: Key, grid: Grid) -> None:
        self._grids.pop(key, None)
        self._grids[key] = grid
        if len(self._grids) > self._count:
            del self._grids[next(iter(self._grids))]


_RECENT = _Recent(64)
