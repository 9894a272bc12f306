"""The parameter of the point of a curve that is nearest to a given point, or to a ray.

The curve is first taken for a chain of chords that stray from it by less than a small part of
its size. Only chords about as near as the nearest one can hide the answer; on each of those the
distance is made least by Newton's method, kept inside the chord by bisection: to a point q on
(C - q) . C', to a ray from q along d on the same less its part along d, where that is positive.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plusedit.geometry.arrays import Floats, frozen, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tessellate import Axes, seen_along, tessellation

STRAY = 1e-4  # of the size of the curve: how far chords may lie from it
CANDIDATES = 12  # chords looked at closely, for one point
STEPS = 60  # a bracket shrinks below the spacing of doubles in 52 halvings
BLOCK = 1 << 18  # distances of points from chords worked out at once


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
    goals = [_Points(curve, at[i : i + step], axes) for i in range(0, len(at), step)]
    return np.concatenate([np.zeros(0), *(_nearest(goal, chords) for goal in goals)])


def nearest_to_ray(curve: PlusCurve, origin: ArrayLike, direction: ArrayLike) -> float:
    """The parameter in [0, 1] of the point of `curve` nearest to a ray.

    The ray begins at `origin` (3,) and runs along `direction` (3,), of any length, without end;
    a plane curve lies in z = 0. Where several points are equally near it is one of them. Raises
    ValueError if the direction is zero or a number is not finite.
    """
    start = frozen(origin, shape=(3,), name="origin")
    heading = unit(frozen(direction, shape=(3,), name="direction"))
    if not heading.any():
        raise ValueError("direction: a ray needs one that is not zero")
    return float(_nearest(_Ray(curve, start, heading), _chords(curve, None))[0])


@lru_cache(maxsize=64)
def _chords(curve: PlusCurve, axes: Axes) -> _Chords:
    rough = curve.at(np.linspace(0.0, 1.0, 33))
    size = float((rough.max(axis=0) - rough.min(axis=0)).max())
    stray = STRAY * max(size, np.finfo(np.float64).tiny / STRAY)
    u = tessellation(curve, stray, axes=axes).parameters
    return _Chords(u, seen_along(curve.at(u), axes), stray)


class _Goal(Protocol):
    """What a curve shall come near to: m things at once."""

    @property
    def curve(self) -> PlusCurve: ...

    def from_chords(self, chords: _Chords) -> tuple[Floats, Floats]:
        """(m, k) distances from chords, and how far along the chord the nearest place is."""
        ...

    def distances(self, row: NDArray[np.intp], u: Floats) -> Floats:
        """(r,) of the points of the curve at u from the things of those numbers."""
        ...

    def slopes(self, row: NDArray[np.intp], u: Floats) -> tuple[Floats, Floats]:
        """(r,) first and second derivative by u of half the squared distance."""
        ...


@dataclass(frozen=True, eq=False)
class _Points:
    """Points (m, dim) as seen along axes."""

    curve: PlusCurve
    at: Floats
    axes: Axes

    def from_chords(self, chords: _Chords) -> tuple[Floats, Floats]:
        start, way = chords.points[:-1], np.diff(chords.points, axis=0)
        length, heading = np.linalg.norm(way, axis=1), unit(way)
        offset = self.at[:, None] - start
        along = np.clip(np.einsum("mkd,kd->mk", offset, heading), 0.0, length)
        distance = np.linalg.norm(offset - along[..., None] * heading, axis=2)
        return distance, np.divide(along, length, out=np.zeros_like(along), where=length > 0.0)

    def distances(self, row: NDArray[np.intp], u: Floats) -> Floats:
        away: Floats = seen_along(self.curve.at(u), self.axes) - self.at[row]
        return np.asarray(np.linalg.norm(away, axis=1))

    def slopes(self, row: NDArray[np.intp], u: Floats) -> tuple[Floats, Floats]:
        point, velocity, acceleration = (
            seen_along(rows, self.axes) for rows in self.curve.derivatives(u)
        )
        away = point - self.at[row]
        slope: Floats = (away * velocity).sum(axis=1)
        bend: Floats = (velocity * velocity).sum(axis=1) + (away * acceleration).sum(axis=1)
        return slope, bend


@dataclass(frozen=True, eq=False)
class _Ray:
    """One ray in space."""

    curve: PlusCurve
    origin: Floats
    heading: Floats

    def from_chords(self, chords: _Chords) -> tuple[Floats, Floats]:
        points = _in_space(chords.points)
        start, way = points[:-1] - self.origin, np.diff(points, axis=0)
        distances, places = segments_from_ray(start, way, self.heading)
        return distances[None], places[None]

    def distances(self, row: NDArray[np.intp], u: Floats) -> Floats:
        return from_ray(_in_space(self.curve.at(u)) - self.origin, self.heading)

    def slopes(self, row: NDArray[np.intp], u: Floats) -> tuple[Floats, Floats]:
        point, velocity, acceleration = (_in_space(rows) for rows in self.curve.derivatives(u))
        away = point - self.origin
        ahead = np.maximum(away @ self.heading, 0.0)
        away -= ahead[:, None] * self.heading
        across = np.where(ahead > 0.0, velocity @ self.heading, 0.0)
        slope: Floats = (away * velocity).sum(axis=1)
        bend: Floats = (velocity * velocity).sum(axis=1) + (away * acceleration).sum(axis=1)
        return slope, bend - across**2


def from_ray(away: Floats, heading: Floats) -> Floats:
    """(...) distances of points from a ray, given as seen from its origin (..., 3)."""
    ahead = np.maximum(away @ heading, 0.0)
    return np.asarray(np.linalg.norm(away - ahead[..., None] * heading, axis=-1))


def segments_from_ray(start: Floats, way: Floats, heading: Floats) -> tuple[Floats, Floats]:
    """(k,) distances of segments from a ray, and (k,) how far along each the nearest place is.

    They run from `start` by `way` (k, 3), as seen from the origin of the ray, which runs along
    the unit vector `heading` (3,).
    """
    # Along a segment the distance falls and then rises. It is least at an end, at the foot on
    # the line of the ray, at that of the origin, or where the one takes over from the other.
    rise, ahead = way @ heading, start @ heading
    beside, across = start - np.outer(ahead, heading), way - np.outer(rise, heading)
    places = np.stack(
        [
            np.zeros(len(way)),
            np.ones(len(way)),
            _quotient(-(beside * across).sum(axis=1), (across * across).sum(axis=1)),
            _quotient(-(start * way).sum(axis=1), (way * way).sum(axis=1)),
            _quotient(-ahead, rise),
        ]
    )
    found = from_ray(start + places[..., None] * way, heading)
    best = found.argmin(axis=0)
    column = np.arange(len(way))
    return found[best, column], places[best, column]


def _nearest(goal: _Goal, chords: _Chords) -> Floats:
    """(m,) the parameters at which the curve is nearest to each thing, by the chords."""
    distance, along = goal.from_chords(chords)
    count = min(CANDIDATES, distance.shape[1])
    best = np.argpartition(distance, count - 1, axis=1)[:, :count]
    near = np.take_along_axis(distance, best, axis=1)
    row, place = np.nonzero(near <= near.min(axis=1, keepdims=True) + 2.0 * chords.stray)
    chord = best[row, place]
    low, high = chords.u[chord], chords.u[chord + 1]
    inside = _descended(goal, row, (low, high), low + along[row, chord] * (high - low))
    u = np.concatenate([low, inside, high])
    row = np.tile(row, 3)
    order = np.lexsort((goal.distances(row, u), row))
    first = np.searchsorted(row[order], np.arange(len(distance)))
    found: Floats = u[order[first]]
    return np.where(found == 1.0, 0.0, found) if goal.curve.closed else found


def _descended(
    goal: _Goal, row: NDArray[np.intp], between: tuple[Floats, Floats], start: Floats
) -> Floats:
    """(r,) parameters between two, near `start`, where the distance stops falling."""
    low, high = between[0].copy(), np.nextafter(between[1], between[0])
    u, moving = start, np.arange(len(start))
    result = u.copy()
    for _ in range(STEPS):
        slope, bend = goal.slopes(row[moving], u)
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


def _quotient(above: Floats, below: Floats) -> Floats:
    """The places from 0 to 1; 0 where there is nothing to divide by."""
    with np.errstate(over="ignore"):
        quotient = np.divide(above, below, out=np.zeros_like(above), where=below != 0.0)
    return np.clip(quotient, 0.0, 1.0)


def _in_space(points: Floats) -> Floats:
    """(m, 3) the points; those of a plane curve lie in z = 0."""
    if points.shape[1] == 3:
        return points
    return np.column_stack([points, np.zeros(len(points))])
