"""The parameter of the point of a curve that is nearest to a given point, or to a ray.

The curve is first taken for a chain of chords that stray from it by less than a small part of
its size. Only chords about as near as the nearest one can hide the answer; on each of those the
distance is made least by Newton's method, kept inside the chord by bisection: to a point q on
(C - q) . C', to a ray from q along d on the same less its part along d, where that is positive.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, frozen, unit
from plusedit.geometry.candidates import Numbers, candidates, firsts, lengths, products
from plusedit.geometry.chords import Chords, chains
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tessellate import Axes, seen_along

STEPS = 60  # a bracket shrinks below the spacing of doubles in 52 halvings
CLOSE = 1e-9  # of the chord: Newton's method squares what is left after a step that short
MOST = 12  # chords looked at closely; more are equally near at the center of a circle
BLOCK = 1 << 20  # pairs of points and chords at most, at once


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
    chain = chains(curve, axes)
    step = max(1, BLOCK // len(chain[-1]))
    goals = [_Points(curve, at[i : i + step], axes) for i in range(0, len(at), step)]
    return np.concatenate([np.zeros(0), *(_nearest(goal, chain) for goal in goals)])


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
    return float(_nearest(_Ray(curve, start, heading), chains(curve, None))[0])


class _Goal(Protocol):
    """What a curve shall come near to: m things at once."""

    @property
    def curve(self) -> PlusCurve: ...

    def __len__(self) -> int: ...

    def from_chords(self, row: Numbers, chords: Chords, place: Numbers) -> tuple[Floats, Floats]:
        """(r,) distances of the things `row` from the chords `place`, and how far along these."""
        ...

    def distances(self, row: Numbers, points: Floats) -> Floats:
        """(r,) of points of the curve, as it is seen, from the things of those numbers."""
        ...

    def slopes(self, row: Numbers, u: Floats) -> "_Slopes":
        """At u, from the things of those numbers."""
        ...


@dataclass(frozen=True, eq=False)
class _Slopes:
    """(r,) distances, and of half their squares the first and second derivative by u."""

    distance: Floats
    slope: Floats
    bend: Floats

    @classmethod
    def of(cls, away: Floats, velocity: Floats, acceleration: Floats) -> "_Slopes":
        bend = products(velocity, velocity) + products(away, acceleration)
        return cls(lengths(away), products(away, velocity), bend)


@dataclass(frozen=True, eq=False)
class _Points:
    """Points (m, dim) as seen along axes."""

    curve: PlusCurve
    at: Floats
    axes: Axes

    def __len__(self) -> int:
        return len(self.at)

    def from_chords(self, row: Numbers, chords: Chords, place: Numbers) -> tuple[Floats, Floats]:
        return chords.from_points(self.at.take(row, axis=0), place)

    def distances(self, row: Numbers, points: Floats) -> Floats:
        return lengths(points - self.at.take(row, axis=0))

    def slopes(self, row: Numbers, u: Floats) -> _Slopes:
        point, velocity, acceleration = (
            seen_along(rows, self.axes) for rows in self.curve.derivatives(u)
        )
        return _Slopes.of(point - self.at.take(row, axis=0), velocity, acceleration)


@dataclass(frozen=True, eq=False)
class _Ray:
    """One ray in space."""

    curve: PlusCurve
    origin: Floats
    heading: Floats

    def __len__(self) -> int:
        return 1

    def from_chords(self, row: Numbers, chords: Chords, place: Numbers) -> tuple[Floats, Floats]:
        start, way = _in_space(chords.points[place]), _in_space(chords.ways[place])
        return segments_from_ray(start - self.origin, way, self.heading)

    def distances(self, row: Numbers, points: Floats) -> Floats:
        return from_ray(_in_space(points) - self.origin, self.heading)

    def slopes(self, row: Numbers, u: Floats) -> _Slopes:
        point, velocity, acceleration = (_in_space(rows) for rows in self.curve.derivatives(u))
        away = point - self.origin
        ahead = np.maximum(away @ self.heading, 0.0)
        across = np.where(ahead > 0.0, velocity @ self.heading, 0.0)
        found = _Slopes.of(away - ahead[:, None] * self.heading, velocity, acceleration)
        return _Slopes(found.distance, found.slope, found.bend - across**2)


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


def _nearest(goal: _Goal, chain: tuple[Chords, ...]) -> Floats:
    """(m,) the parameters at which the curve is nearest to each thing, by the chords."""
    chords = chain[-1]
    near = candidates(chain, len(goal), lambda *pairs: goal.from_chords(*pairs)[0]).nearest(MOST)
    row, low, high = near.row, chords.u[near.place], chords.u[near.place + 1]
    start = low + goal.from_chords(row, chords, near.place)[1] * (high - low)
    inside, distance = _descended(goal, row, (low, high), start)
    ends = (goal.distances(row, chords.points.take(near.place + k, axis=0)) for k in (0, 1))
    distances = np.stack([distance, *ends])
    best = distances.argmin(axis=0), np.arange(len(row))
    # As the numbers of the things rise, sorting by distance leaves them in their places.
    nearest = np.lexsort((distances[best], row))[firsts(row)]
    found: Floats = np.stack([inside, low, high])[best][nearest]
    return np.where(found == 1.0, 0.0, found) if goal.curve.closed else found


def _descended(
    goal: _Goal, row: Numbers, between: tuple[Floats, Floats], start: Floats
) -> tuple[Floats, Floats]:
    """(r,) parameters between two, near `start`, where the distance stops falling, and (r,) it."""
    # A knot belongs to the span on its right: in it the derivatives are others.
    low, high = between[0], np.nextafter(between[1], between[0])
    u, distance, moving = np.clip(start, low, high), np.empty(len(row)), np.arange(len(row))
    result, last = u.copy(), high
    # The least distance lies between what was looked at; where nothing was yet, the chord ends.
    below, above = np.full(len(row), -np.inf), np.full(len(row), np.inf)
    for _ in range(STEPS):
        found = goal.slopes(row[moving], u)
        distance[moving] = found.distance
        rising = found.slope >= 0.0
        below, above = np.where(rising, below, u), np.where(rising, u, above)
        # Newton's step, or else downhill, up to the ends; what is not a number leads to one.
        downhill = np.where(rising, np.inf, -np.inf)
        step = np.divide(found.slope, found.bend, out=downhill, where=found.bend > 0.0)
        ahead = np.fmin(np.fmax(u - step, low), high)
        astray = np.flatnonzero(((ahead <= below) | (ahead >= above)) & (ahead != u))
        ahead[astray] = (below[astray] + above[astray]) / 2.0
        result[moving] = ahead
        close = np.maximum(CLOSE * (high - low), 2.0 * np.spacing(high))
        going = np.flatnonzero(np.abs(ahead - u) > close)
        if not len(going):
            break
        moving = moving[going]
        u, low, high, below, above = (each.take(going) for each in (ahead, low, high, below, above))
    return np.where(result >= last, between[1], result), distance


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
