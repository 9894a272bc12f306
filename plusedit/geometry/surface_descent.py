"""Where on a surface the distance from something is least, inside boxes of parameters.

Half the squared distance f(u, v) has the gradient and second derivatives

    f_u = r . S_u,    f_uv = S_u . S_v + r . S_uv,  ...

with r the way from the nearest place of the thing to S, and for a ray along d, where it is nearer
than its origin, less (d . S_u) (d . S_v). Newton's steps are cut short where they would not go
down (Levenberg and Marquardt), and end at the sides of the box.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.candidates import Numbers, lengths
from plusedit.geometry.nearest import from_ray, segments_from_ray
from plusedit.geometry.net import Flags
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_cells import EDGES, Balls, Cells, from_triangles

ROUNDS = 60
LEAST_BEND = 1e-6  # as in the units of steps: with less, a step leads nowhere
SHORTER = 16.0  # the factor of the damping after a step that did not go down
DAMPED = 0.1  # the first damping
HARDEST = 1e12  # damping with which steps are rounding
CLOSE = 1e-9  # of a box: Newton's method squares what is left after a step that short
LEVEL = 1e-9  # part of the distance: a slope that is none
PUSH = 1e-2  # the slope, as a part of the distance, that leads off a ridge
EVEN = 1e-12  # differences of f that may be rounding


@dataclass(frozen=True, eq=False)
class Slopes:
    """f and its derivatives at k places."""

    value: Floats
    """(k,)"""
    slope: Floats
    """(k, 2) f_u, f_v"""
    bend: Floats
    """(k, 2, 2)"""
    units: Floats
    """(k, 2) that steps are measured by: |S_u|, |S_v|, or with much bend what makes it one"""

    def rows(self, rows: Numbers) -> "Slopes":
        """Some of these."""
        return Slopes(
            *(each.take(rows, axis=0) for each in (self.value, self.slope, self.bend, self.units))
        )

    def taken(self, other: "Slopes", where: Flags) -> "Slopes":
        """These, but the others in the rows `where`."""
        return Slopes(
            np.where(where, other.value, self.value),
            np.where(where[:, None], other.slope, self.slope),
            np.where(where[:, None, None], other.bend, self.bend),
            np.where(where[:, None], other.units, self.units),
        )


class Goal(Protocol):
    """What places of a surface shall come near to: m things at once."""

    def __len__(self) -> int: ...

    def from_balls(self, row: Numbers, balls: Balls, place: Numbers) -> Floats:
        """(k,) distances of the things `row` from the middles of the balls `place`."""
        ...

    def from_cells(self, row: Numbers, cells: Cells, place: Numbers) -> Floats:
        """(k,) the same from the triangles of cells."""
        ...

    def slopes(self, row: Numbers, places: Floats) -> Slopes:
        """f and its derivatives at places (k, 2), for the things of those numbers."""
        ...


@dataclass(frozen=True, eq=False)
class PointGoal:
    """Points (m, 3)."""

    surface: PlusSurface
    points: Floats

    def __len__(self) -> int:
        return len(self.points)

    def from_balls(self, row: Numbers, balls: Balls, place: Numbers) -> Floats:
        return lengths(balls.middles.take(place, axis=0) - self.points.take(row, axis=0))

    def from_cells(self, row: Numbers, cells: Cells, place: Numbers) -> Floats:
        return from_triangles(self.points.take(row, axis=0), cells.corners.take(place, axis=0))

    def slopes(self, row: Numbers, places: Floats) -> Slopes:
        at, *found = self.surface.derivatives_at(places)
        return _slopes(at - self.points.take(row, axis=0), found)


@dataclass(frozen=True, eq=False)
class RayGoal:
    """A ray from a point (3,) along a unit vector (3,), which the surface does not meet."""

    surface: PlusSurface
    origin: Floats
    heading: Floats

    def __len__(self) -> int:
        return 1

    def from_balls(self, row: Numbers, balls: Balls, place: Numbers) -> Floats:
        return from_ray(balls.middles.take(place, axis=0) - self.origin, self.heading)

    def from_cells(self, row: Numbers, cells: Cells, place: Numbers) -> Floats:
        corners = cells.corners.take(place, axis=0)
        first, last = (corners[:, ends].reshape(-1, 3) for ends in EDGES)
        distances, _ = segments_from_ray(first - self.origin, last - first, self.heading)
        least: Floats = distances.reshape(len(row), -1).min(axis=1)
        return least

    def slopes(self, row: Numbers, places: Floats) -> Slopes:
        at, *found = self.surface.derivatives_at(places)
        away = at - self.origin
        ahead = np.maximum(away @ self.heading, 0.0)
        away -= ahead[:, None] * self.heading
        along = np.stack([found[0] @ self.heading, found[1] @ self.heading], axis=1)
        along[ahead == 0.0] = 0.0
        return _slopes(away, found, along)


def _slopes(away: Floats, found: list[Floats], along: Floats | None = None) -> Slopes:
    du, dv, duu, duv, dvv = found
    tangents = np.stack([du, dv], axis=1)
    second = np.stack([np.stack([duu, duv], axis=1), np.stack([duv, dvv], axis=1)], axis=1)
    bend = np.einsum("kid,kjd->kij", tangents, tangents)
    squares = np.einsum("kii->ki", bend).copy()
    bend += np.einsum("kijd,kd->kij", second, away)
    if along is not None:
        bend -= along[:, :, None] * along[:, None, :]
    slope = np.einsum("kid,kd->ki", tangents, away)
    units = np.sqrt(np.maximum(squares, np.abs(np.einsum("kii->ki", bend))))
    return Slopes(np.einsum("kd,kd->k", away, away) / 2.0, slope, bend, units)


def least_in_boxes(
    goal: Goal, row: Numbers, low: Floats, high: Floats, start: Floats
) -> tuple[Floats, Floats]:
    """(k, 2) places from `low` to `high` (k, 2) where f is least, and (k,) f there.

    For the things of those numbers; `start` (k, 2) lies in the boxes. It is the least value near it
    if there are several.
    """
    # A knot belongs to the span on its right: in it the derivatives are others.
    inner = np.maximum(np.nextafter(high, low), low)
    at = np.clip(start, low, inner)
    now = goal.slopes(row, at)
    result, values, moving = at.copy(), now.value.copy(), np.arange(len(at))
    damping, first, last = np.zeros(len(at)), low, inner
    for _ in range(ROUNDS):
        ahead = np.clip(at + _step(now, damping, at <= first, at >= last), first, last)
        close = np.maximum(CLOSE * (last - first), 2.0 * np.spacing(last))
        is_there = (np.abs(ahead - at) - close).max(axis=1) <= 0.0
        result[moving], values[moving] = np.where(is_there[:, None], ahead, at), now.value
        going = np.flatnonzero(~is_there & (damping < HARDEST))
        if not len(going):
            break
        moving, now = moving[going], now.rows(going)
        at, ahead, damping, first, last = (
            each.take(going, axis=0) for each in (at, ahead, damping, first, last)
        )
        then = goal.slopes(row[moving], ahead)
        better = _is_better(then, now)
        at = np.where(better[:, None], ahead, at)
        now = now.taken(then, better)
        damping = np.where(better, damping / SHORTER**2, np.maximum(SHORTER * damping, DAMPED))
        damping[damping < LEAST_BEND] = 0.0
    return np.where(result >= inner, high, result), values


def _step(now: Slopes, damping: Floats, at_low: Flags, at_high: Flags) -> Floats:
    """(k, 2) Newton's step, of what may move."""
    slope = _off_ridges(now, at_low)
    stuck = (at_low & (slope > 0.0)) | (at_high & (slope < 0.0)) | (now.units == 0.0)
    unit = np.where(stuck, 1.0, now.units)
    slope = np.where(stuck, 0.0, slope / unit)
    bend = now.bend / unit[:, :, None] / unit[:, None, :]
    mixed = np.where(stuck.any(axis=1), 0.0, bend[:, 0, 1])
    first, second = (np.where(stuck[:, way], 1.0, bend[:, way, way]) for way in (0, 1))
    least = (first + second) / 2.0 - np.hypot((first - second) / 2.0, mixed)
    more = damping + np.where(least < LEAST_BEND, DAMPED - least, 0.0)
    # Of very unequal numbers the difference may be nothing but rounding.
    first, second = np.maximum(first + more, LEAST_BEND), np.maximum(second + more, LEAST_BEND)
    mixed = np.where(first * second > mixed * mixed, mixed, 0.0)
    below = first * second - mixed * mixed
    u = (mixed * slope[:, 1] - second * slope[:, 0]) / below
    v = (mixed * slope[:, 0] - first * slope[:, 1]) / below
    return np.stack([u, v], axis=1) / unit


def _off_ridges(now: Slopes, at_low: Flags) -> Floats:
    """(k, 2) the slopes, but some where there are none and f falls to both sides all the same.

    As where a surface turns back on itself.
    """
    distance = np.sqrt(2.0 * now.value)[:, None]
    level = np.abs(now.slope) <= LEVEL * now.units * distance
    ridge = level & (np.einsum("kii->ki", now.bend) < 0.0)
    return np.where(ridge, PUSH * now.units * np.where(at_low, -distance, distance), now.slope)


def _is_better(then: Slopes, now: Slopes) -> Flags:
    """Whether f is less, or as far as rounding allows to say the same and flatter."""
    even = np.abs(then.value - now.value) <= EVEN * now.value
    flatter = _steepness(then) < _steepness(now)
    better: Flags = np.where(even, flatter, then.value < now.value)
    return better


def _steepness(slopes: Slopes) -> Floats:
    steepness: Floats = np.abs(slopes.slope).sum(axis=1)
    return steepness
