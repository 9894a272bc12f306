"""Curves as polylines that look smooth: no farther than a quarter pixel from the curve.

A curve is tessellated once, as finely as its own size asks for. Where the view needs it finer,
all intervals are halved until it is: a chord half as long strays a quarter as far. So panning,
zooming and dragging meet the same few grids again and again, and with them the same matrices.
A curve much larger than the view is tessellated for what is seen of it. In space the first chords
are as fine from wherever they are seen.

What was worked out is kept with its curve, for as long as that lives: a drawing may have thousands,
and a cache of any fixed size would forget each just before it is asked for again.
"""

from dataclasses import dataclass, field
from functools import lru_cache
from math import ceil, floor, frexp, log
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevation
from plusedit.geometry.tessellate import is_fine, tessellation
from plusedit.scene.camera import Camera, PlaneCamera

TOLERANCE = 0.25  # pixels
COARSEST = 1.0 / 256.0  # of the size of a curve: how far its first chords may stray
AHEAD = 0.5  # of the tolerance: a new grid is that fine, so that it lasts through a drag
KEPT = 0.8  # of the tolerance: where a curve is tight, half a chord strays more than a quarter
LARGE = 4.0  # times the view: a larger curve is made fine only near what is seen
SIMPLE = 6  # lines up to which a Bezier+ curve is judged by its standard form
ROUNDS = 24  # of halving what is seen of a large curve in space
MOST = 20000  # points of it
SIDES = ((0, 1), (0, 2))  # along which a curve that is fine is fine from anywhere

Window = tuple[float, float, float, float]
"""left, bottom, right, top in the world"""

Axes = tuple[int, int]
IN_SPACE: Axes = (-1, -1)
"""Stands for all axes together."""

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


@dataclass(eq=False)
class _Kept:
    """What is known of one curve. It holds as long as the curve: neither ever changes."""

    size: float
    first: dict[Axes, Grid] = field(default_factory=dict)
    samples: dict[tuple[int, Axes], tuple[Grid, Floats]] = field(default_factory=dict)
    """by halvings; those of the last two, as a view goes to and fro"""
    view: tuple[Camera, float] | None = None
    shown: Drawn | None = None


_KEPT: "WeakKeyDictionary[PlusCurve, _Kept]" = WeakKeyDictionary()


def drawn(curve: PlusCurve, camera: Camera, tolerance: float = TOLERANCE) -> Drawn:
    """The polyline that shows `curve` in that view."""
    kept = _KEPT.get(curve)
    if kept is None:
        kept = _KEPT[curve] = _Kept(_size(curve))
    view = (camera, tolerance)
    if kept.shown is None or kept.view != view:
        if isinstance(camera, PlaneCamera):
            kept.shown = _shown(curve, kept, camera, tolerance)
        else:
            kept.shown = _shown_in_space(curve, kept, camera, tolerance)
        kept.view = view
    return kept.shown


def _shown(curve: PlusCurve, kept: _Kept, camera: PlaneCamera, tolerance: float) -> Drawn:
    size = kept.size
    if size * camera.scale > LARGE * max(camera.size):
        level = 2.0 ** ceil(log(camera.scale, 2.0))
        grid, points = _sampled_near(curve, tolerance / level, _window(camera, level), camera.axes)
    else:
        halvings = _halvings(size, tolerance / camera.scale)
        grid, points = _sampled(curve, kept, halvings, camera.axes)
    return Drawn(grid, points, camera.to_screen(points))


def _shown_in_space(curve: PlusCurve, kept: _Kept, camera: Camera, tolerance: float) -> Drawn:
    nearest = float(camera.pixel_at(curve.lines.points).min())
    if kept.size / nearest > LARGE * max(camera.size):
        return _refined(curve, _sampled(curve, kept, 0, IN_SPACE)[0], camera, tolerance)
    grid, points = _sampled(curve, kept, _halvings(kept.size, tolerance * nearest), IN_SPACE)
    return Drawn(grid, points, camera.to_screen(points))


def _halvings(size: float, allowed: float) -> int:
    return max(0, ceil(log(COARSEST * size / allowed, 4.0))) if size else 0


def _refined(curve: PlusCurve, grid: Grid, camera: Camera, tolerance: float) -> Drawn:
    """The curve with chords halved until those that come near the view stray no farther."""
    u, points = grid.parameters, curve.sample(grid)
    screen = camera.to_screen(points)
    halved = np.ones(len(u) - 1, dtype=np.bool_)
    for _ in range(ROUNDS):
        places = np.flatnonzero(halved & _near(screen, camera))
        if not len(places) or len(u) + len(places) > MOST:
            break
        middles = (u[places] + u[places + 1]) / 2.0
        inner = curve.at(middles)
        inner_screen = camera.to_screen(inner)
        straying = inner_screen - (screen[places] + screen[places + 1]) / 2.0
        is_coarse = np.hypot(straying[:, 0], straying[:, 1]) > tolerance
        # Both halves of a chord that strayed are looked at again, no others.
        halved = np.repeat(False, len(u) - 1)
        halved[places[is_coarse]] = True
        halved = np.insert(halved, places + 1, is_coarse)
        u = np.insert(u, places + 1, middles)
        points = np.insert(points, places + 1, inner, axis=0)
        screen = np.insert(screen, places + 1, inner_screen, axis=0)
    return Drawn(Grid(u), points, screen)


def _near(screen: Floats, camera: Camera) -> NDArray[np.bool_]:
    """(m,) whether chords between pixels (m + 1, 2) come near the view."""
    low, high = np.minimum(screen[:-1], screen[1:]), np.maximum(screen[:-1], screen[1:])
    more = high - low
    near: NDArray[np.bool_] = ((high > -more) & (low < np.array(camera.size) + more)).all(axis=1)
    return near


def _size(curve: PlusCurve) -> float:
    """The size of a curve, up to the next power of two: it seldom changes during a drag."""
    points = curve.lines.points
    extent = float((points.max(axis=0) - points.min(axis=0)).max())
    pull = curve.spacing * float(np.abs(curve.gradients).max())
    mantissa, exponent = frexp(max(extent, pull))
    return 2.0**exponent if mantissa else 0.0


def _sampled(curve: PlusCurve, kept: _Kept, halvings: int, axes: Axes) -> tuple[Grid, Floats]:
    """The grid of a curve, halved that often, and the points there; good for any such view."""
    key = (halvings, axes)
    found = kept.samples.get(key)
    if found is None:
        grid = _halved(_first(curve, kept, axes), halvings)
        found = grid, curve.sample(grid)
        while len(kept.samples) > 1:
            del kept.samples[next(iter(kept.samples))]
        kept.samples[key] = found
    return found


def _first(curve: PlusCurve, kept: _Kept, axes: Axes) -> Grid:
    """The grid that suits the size of the curve; that of the frame before, if it does."""
    if axes not in kept.first:
        allowed = COARSEST * (kept.size or 1.0)
        kept.first[axes] = _simple(curve, KEPT * allowed) or (
            _from_anywhere(curve, allowed) if axes == IN_SPACE else _general(curve, allowed, axes)
        )
    return kept.first[axes]


def _from_anywhere(curve: PlusCurve, allowed: float) -> Grid:
    """A grid that strays no farther in space: by Pythagoras, what two sides show of it is all."""
    if curve.dimension == 2:
        return _general(curve, allowed, SIDES[0])
    first, second = (_general(curve, allowed * 0.5**0.5, axes) for axes in SIDES)
    return Grid(np.union1d(first.parameters, second.parameters))


def _simple(curve: PlusCurve, tolerance: float) -> Grid | None:
    """An even grid for a Bezier+ curve of a few lines; None for any other.

    A polynomial of degree d strays from the chord of an m-th of its domain by no more than
    d (d - 1) / (8 m^2) times the largest second difference of its Bezier points.
    """
    lines, basis = curve.lines, curve.basis
    if not isinstance(basis, Bernstein) or basis.size > SIMPLE or lines.weights is not None:
        return None
    form = elevation(basis)
    points = form.values @ lines.points + form.reaches @ curve.gradients
    bends = points[2:] - 2.0 * points[1:-1] + points[:-2]
    degree = basis.size
    bound = degree * (degree - 1) / 8.0 * float(np.linalg.norm(bends, axis=1).max())
    return _even(max(0, ceil(log(bound / tolerance, 4.0))) if bound > tolerance else 0)


@lru_cache(maxsize=16)
def _even(halvings: int) -> Grid:
    return Grid.uniform(2**halvings + 1)


def _general(curve: PlusCurve, allowed: float, axes: Axes) -> Grid:
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
