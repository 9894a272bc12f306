"""The parameter of the point of a curve that is nearest to a given point.

The curve is first taken for a chain of chords that stray from it by less than a small part of
its size. Only chords about as near as the nearest one can hide the answer; on each of those the
distance is made least by Newton's method on (C - q) . C', kept inside the chord by bisection.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tessellate import seen_along, tessellation

STRAY = 1e-4  # of the size of the curve: how far chords may lie from it
CANDIDATES = 12  # chords looked at closely, for one point
STEPS = 60  # a bracket shrinks below the spacing of doubles in 52 halvings
BLOCK = 1 << 18  # distances of points from chords worked out at once

Axes = tuple[int, int] | None


@dataclass(frozen=True, eq=False)
class _Chords:
    """Parameters (k + 1,), the points there (k + 1, dim), and how far the curve may stray."""

    u: Floats
    points: Floats
    stray: float


def nearest_parameter(curve: PlusCurve, point: ArrayLike, *, axes: Axes = None) -> float:
    """The parameter in [0, 1] of the point of `curve` nearest to `point`.

    With `axes` the curve is seen along them, and `point` (2,) holds the two coordinates that
    are seen; else it has as many as the points of the curve. Where several are equally near it
    is one of them.
    """
    return float(nearest_parameters(curve, np.asarray(point, dtype=np.float64)[None], axes=axes)[0])


def nearest_parameters(curve: PlusCurve, points: ArrayLike, *, axes: Axes = None) -> Floats:
    """(m,) what `nearest_parameter` says for each of the points (m, dim).

    Raises ValueError if the points have another number of coordinates than the curve as seen,
    or one is not finite.
    """
    at = np.asarray(points, dtype=np.float64)
    wanted = curve.dimension if axes is None else 2
    if at.ndim != 2 or at.shape[1] != wanted:
        raise ValueError(f"points: expected shape (None, {wanted}), got {at.shape}")
    if not np.isfinite(at).all():
        raise ValueError("points: has a value that is not finite")
    chords = _chords(curve, axes)
    step = max(1, BLOCK // len(chords.u))
    found = [_nearest(curve, at[i : i + step], chords, axes) for i in range(0, len(at), step)]
    return np.concatenate([np.zeros(0), *found])


@lru_cache(maxsize=64)
def _chords(curve: PlusCurve, axes: Axes) -> _Chords:
    rough = curve.at(np.linspace(0.0, 1.0, 33))
    size = float((rough.max(axis=0) - rough.min(axis=0)).max())
    size = max(size, np.finfo(np.float64).tiny)
    # A space curve strays little if it does so both from above and from the front.
    views = [axes] if axes else [(0, 1), (0, 2)][: curve.dimension - 1]
    grids = [tessellation(curve, STRAY * size, axes=view).parameters for view in views]
    u = np.unique(np.concatenate(grids))
    return _Chords(u, _seen(curve.at(u), axes), STRAY * size * len(views))


def _nearest(curve: PlusCurve, at: Floats, chords: _Chords, axes: Axes) -> Floats:
    """`nearest_parameters` of few points, by the chords."""
    distance, along = _from_chords(at, chords)
    count = min(CANDIDATES, distance.shape[1])
    best = np.argpartition(distance, count - 1, axis=1)[:, :count]
    near = np.take_along_axis(distance, best, axis=1)
    row, place = np.nonzero(near <= near.min(axis=1, keepdims=True) + 2.0 * chords.stray)
    chord = best[row, place]
    low, high = chords.u[chord], chords.u[chord + 1]
    inside = _descended(curve, at[row], low, high, low + along[row, chord] * (high - low), axes)
    u = np.concatenate([low, inside, high])
    row = np.tile(row, 3)
    missed = np.linalg.norm(_seen(curve.at(u), axes) - at[row], axis=1)
    order = np.lexsort((missed, row))
    first = np.searchsorted(row[order], np.arange(len(at)))
    found: Floats = u[order[first]]
    return np.where(found == 1.0, 0.0, found) if curve.closed else found


def _from_chords(at: Floats, chords: _Chords) -> tuple[Floats, Floats]:
    """(m, k) distances of points from chords, and how far along the chord the nearest is."""
    start, way = chords.points[:-1], np.diff(chords.points, axis=0)
    length = np.linalg.norm(way, axis=1)
    heading = np.divide(way, length[:, None], out=np.zeros_like(way), where=length[:, None] > 0.0)
    offset = at[:, None] - start
    along = np.clip(np.einsum("mkd,kd->mk", offset, heading), 0.0, length)
    distance = np.linalg.norm(offset - along[..., None] * heading, axis=2)
    return distance, np.divide(along, length, out=np.zeros_like(along), where=length > 0.0)


def _descended(
    curve: PlusCurve, at: Floats, low: Floats, high: Floats, start: Floats, axes: Axes
) -> Floats:
    """(m,) parameters between `low` and `high`, near `start`, where the distance stops falling."""
    u, low, high = start, low.copy(), np.nextafter(high, low)
    moving = np.arange(len(u))
    result = u.copy()
    for _ in range(STEPS):
        slope, bend = _slopes(curve, at[moving], u, axes)
        high = np.where(slope > 0.0, u, high)
        low = np.where(slope > 0.0, low, u)
        step = np.divide(slope, bend, out=np.full_like(slope, np.inf), where=bend > 0.0)
        # Newton's step where it stays inside the bracket, else half of it.
        ahead = np.where((u - step > low) & (u - step < high), u - step, (low + high) / 2.0)
        result[moving] = ahead
        going = _going(ahead, u, low, high)
        if not going.any():
            break
        moving, u, low, high = moving[going], ahead[going], low[going], high[going]
    return result


def _going(ahead: Floats, u: Floats, low: Floats, high: Floats) -> NDArray[np.bool_]:
    close = 2.0 * np.spacing(np.maximum(np.abs(u), 1e-3))
    going: NDArray[np.bool_] = (np.abs(ahead - u) > close) & (high - low > close)
    return going


def _slopes(curve: PlusCurve, at: Floats, u: Floats, axes: Axes) -> tuple[Floats, Floats]:
    """(m,) first and second derivative of half the squared distance."""
    point, velocity, acceleration = (_seen(row, axes) for row in curve.derivatives(u))
    away = point - at
    slope: Floats = (away * velocity).sum(axis=1)
    bend: Floats = (velocity * velocity).sum(axis=1) + (away * acceleration).sum(axis=1)
    return slope, bend


def _seen(points: Floats, axes: Axes) -> Floats:
    return points if axes is None else seen_along(points, axes)
