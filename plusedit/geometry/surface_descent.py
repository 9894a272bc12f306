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
from plusedit.geometry.net import Flags
from plusedit.geometry.surface import PlusSurface

ROUNDS = 60
LEAST_BEND = 1e-6  # as in the units of the tangents: with less, a step leads nowhere
SHORTER = 16.0  # the factor of the damping after a step that did not go down
DAMPED = 0.1  # the first damping
HARDEST = 1e12  # damping with which steps are rounding
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
    speeds: Floats
    """(k, 2) |S_u|, |S_v|"""

    def taken(self, other: "Slopes", where: Flags) -> "Slopes":
        """These, but the others in the rows `where`."""
        return Slopes(
            np.where(where, other.value, self.value),
            np.where(where[:, None], other.slope, self.slope),
            np.where(where[:, None, None], other.bend, self.bend),
            np.where(where[:, None], other.speeds, self.speeds),
        )


class Goal(Protocol):
    """What places of a surface shall come near to."""

    def slopes(self, places: Floats) -> Slopes:
        """f and its derivatives at places (k, 2)."""
        ...


@dataclass(frozen=True, eq=False)
class PointGoal:
    """A point (3,)."""

    surface: PlusSurface
    point: Floats

    def slopes(self, places: Floats) -> Slopes:
        at, *found = self.surface.derivatives_at(places)
        return _slopes(at - self.point, found)


@dataclass(frozen=True, eq=False)
class RayGoal:
    """A ray from a point (3,) along a unit vector (3,)."""

    surface: PlusSurface
    origin: Floats
    heading: Floats

    def slopes(self, places: Floats) -> Slopes:
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
    speeds = np.sqrt(np.einsum("kii->ki", bend))
    bend += np.einsum("kijd,kd->kij", second, away)
    if along is not None:
        bend -= along[:, :, None] * along[:, None, :]
    slope = np.einsum("kid,kd->ki", tangents, away)
    return Slopes(np.einsum("kd,kd->k", away, away) / 2.0, slope, bend, speeds)


def least_in_boxes(goal: Goal, low: Floats, high: Floats, start: Floats) -> tuple[Floats, Floats]:
    """(k, 2) places from `low` to `high` (k, 2) where f is least, and (k,) f there.

    `start` (k, 2) lies in the boxes. It is the least value near it if there are several.
    """
    # A knot belongs to the span on its right: in it the derivatives are others.
    inner = np.maximum(np.nextafter(high, low), low)
    at = np.clip(start, low, inner)
    now = goal.slopes(at)
    damping = np.zeros(len(at))
    for _ in range(ROUNDS):
        ahead = np.clip(at + _step(now, damping, at <= low, at >= inner), low, inner)
        going = (np.abs(ahead - at) > 2.0 * np.spacing(high)).any(axis=1) & (damping < HARDEST)
        if not going.any():
            break
        then = goal.slopes(ahead)
        better = going & _is_better(then, now)
        at = np.where(better[:, None], ahead, at)
        now = now.taken(then, better)
        damping = np.where(better, damping / SHORTER**2, np.maximum(SHORTER * damping, DAMPED))
        damping[damping < LEAST_BEND] = 0.0
    return np.where(at >= inner, high, at), now.value


def _step(now: Slopes, damping: Floats, at_low: Flags, at_high: Flags) -> Floats:
    """(k, 2) Newton's step, of what may move, in the metric of the tangents."""
    stuck = (at_low & (now.slope > 0.0)) | (at_high & (now.slope < 0.0)) | (now.speeds == 0.0)
    unit = np.where(stuck, 1.0, now.speeds)
    slope = np.where(stuck, 0.0, now.slope / unit)
    bend = now.bend / unit[:, :, None] / unit[:, None, :]
    mixed = np.where(stuck.any(axis=1), 0.0, bend[:, 0, 1])
    first, second = (np.where(stuck[:, way], 1.0, bend[:, way, way]) for way in (0, 1))
    least = (first + second) / 2.0 - np.hypot((first - second) / 2.0, mixed)
    more = damping + np.where(least < LEAST_BEND, DAMPED - least, 0.0)
    first, second = first + more, second + more
    below = first * second - mixed * mixed
    u = (mixed * slope[:, 1] - second * slope[:, 0]) / below
    v = (mixed * slope[:, 0] - first * slope[:, 1]) / below
    return np.stack([u, v], axis=1) / unit


def _is_better(then: Slopes, now: Slopes) -> Flags:
    """Whether f is less, or as far as rounding allows to say the same and flatter."""
    even = np.abs(then.value - now.value) <= EVEN * now.value
    flatter = _steepness(then) < _steepness(now)
    better: Flags = np.where(even, flatter, then.value < now.value)
    return better


def _steepness(slopes: Slopes) -> Floats:
    steepness: Floats = np.abs(slopes.slope).sum(axis=1)
    return steepness
