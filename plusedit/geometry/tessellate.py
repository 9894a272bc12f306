"""Parameters at which a curve looks smooth when its points are joined by straight lines.

Between two parameters the curve is sampled at five; the polynomial of degree four through them
says how far it strays from the chord, also between the samples. An interval that strays too far
is cut into as many parts as its error asks for (the error falls with the square of the length),
all intervals of one round together. What does not come near the window is left coarse.
"""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.pieces import pieces

MOST = 20000  # parameters; no screen shows more
ROUNDS = 60  # a jump between two neighbouring doubles is found in 52 halvings
PARTS = 8  # at most, of one interval in one round
SAFE = 0.9  # of the tolerance: the polynomial of degree four is not quite the curve
MARGIN = 0.1  # of the extent of an interval, added to its box for the same reason

SAMPLED = np.linspace(0.0, 1.0, 5)
BETWEEN = np.linspace(0.0, 1.0, 17)[1:-1]

Window = tuple[Floats, Floats]
"""Lower left and upper right corner, (2,) each; (3,) each where all of space is measured."""

Axes = tuple[int, int] | None
"""Along which two coordinates a curve is seen; None: along all it has."""


def _interpolation() -> Floats:
    """(5, 15) from values at SAMPLED to those of the polynomial through them at BETWEEN."""
    return np.asarray(np.linalg.solve(np.vander(SAMPLED).T, np.vander(BETWEEN, 5).T), np.float64)


INTERPOLATION = _interpolation()


def tessellation(
    curve: PlusCurve,
    tolerance: float,
    *,
    window: Window | None = None,
    axes: Axes = (0, 1),
) -> Grid:
    """Parameters whose chords stay within `tolerance` of the curve inside `window`.

    They increase from 0 to 1, hold every knot, and are at most 20000. `tolerance` is in the
    unit of the points and is measured as the curve is seen along `axes`, or with None in space;
    a plane curve lies in z = 0. Without a window all of the curve counts.

    Raises ValueError if the tolerance is not positive.
    """
    if not tolerance > 0.0:
        raise ValueError(f"tolerance: must be positive, got {tolerance}")
    start = pieces(curve).parameters
    low, high = start[:-1], start[1:]
    done = [low[:0]]
    count = len(start)
    points = curve.sample(_sampled(pieces(curve)))
    for _ in range(ROUNDS):
        strays, seen, rounding = _judged(points, window, axes)
        allowed = max(SAFE * tolerance, rounding)
        narrow = high - low <= 4.0 * np.spacing(high)
        split = seen & (strays > allowed) & ~narrow
        parts = np.where(split, _parts(strays, allowed), 1)
        parts = _afforded(parts, strays, MOST - count)
        split = parts > 1
        done.append(low[~split])
        if not split.any():
            break
        count += int((parts[split] - 1).sum())
        low, high = _cut(low[split], high[split], parts[split])
        points = curve.at(_within(low, high))
    else:
        done.append(low)
    return Grid(np.unique(np.concatenate([*done, [1.0]])))


def is_fine(
    curve: PlusCurve,
    grid: Grid,
    tolerance: float,
    window: Window | None = None,
    axes: Axes = (0, 1),
) -> bool:
    """Whether a grid made for another curve, or another window, does for this one.

    False for a grid without the knots of the curve. Costs five samples to the interval, by
    matrices that are kept from one frame to the next.
    """
    u = grid.parameters
    start = pieces(curve).parameters
    if len(u) < len(start) or (u[np.searchsorted(u[:-1], start)] != start).any():
        return False
    strays, seen, rounding = _judged(curve.sample(_sampled(grid)), window, axes)
    return not bool((seen & (strays > max(tolerance, rounding))).any())


def seen_along(points: Floats, axes: Axes) -> Floats:
    """(m, 2) the two coordinates that are seen, or (m, dim) all; a plane curve lies in z = 0."""
    if axes is None:
        return points
    if points.shape[1] == 2:
        if axes == (0, 1):
            return points
        points = np.column_stack([points, np.zeros(len(points))])
    return points[:, list(axes)]


@lru_cache(maxsize=64)
def _sampled(grid: Grid) -> Grid:
    return Grid(_within(grid.parameters[:-1], grid.parameters[1:]))


def _within(low: Floats, high: Floats) -> Floats:
    """(5 m,) the SAMPLED fractions of each interval, one interval after another."""
    u = low[:, None] + (high - low)[:, None] * SAMPLED
    u[:, -1] = high
    return u.ravel()


def _judged(
    points: Floats, window: Window | None, axes: Axes
) -> tuple[Floats, NDArray[np.bool_], float]:
    """How far each interval strays from its chord, whether it may be seen, and the rounding.

    `points` (5 m, dim) are those of the curve at the parameters of `_within`.
    """
    seen = seen_along(points, axes)
    at = seen.T.reshape(seen.shape[1], -1, len(SAMPLED))
    rounding = 16.0 * float(np.finfo(np.float64).eps * np.abs(at).max())
    inside = at @ INTERPOLATION
    strays = _distances(inside, at[..., 0], at[..., -1]).max(axis=1)
    if window is None:
        return strays, np.ones(len(strays), dtype=np.bool_), rounding
    return strays, _near(np.concatenate([inside, at], axis=2), window), rounding


def _distances(points: Floats, a: Floats, b: Floats) -> Floats:
    """(m, k) of the points (dim, m, k) from the segments from a to b, (dim, m) each."""
    length = _lengths(b - a)
    heading = ((b - a) / np.where(length > 0.0, length, 1.0))[..., None]
    away = points - a[..., None]
    along = np.einsum("dmk,dmk->mk", away, np.broadcast_to(heading, away.shape))
    away -= np.clip(along, 0.0, length[:, None]) * heading
    return _lengths(away)


def _lengths(vectors: Floats) -> Floats:
    """(...) of the vectors (dim, ...), of whatever size."""
    lengths: Floats = np.hypot(vectors[0], vectors[1])
    return np.hypot(lengths, vectors[2]) if len(vectors) == 3 else lengths


def _near(points: Floats, window: Window) -> NDArray[np.bool_]:
    """(m,) whether the boxes of points (dim, m, k), a little enlarged, reach into the window."""
    low, high = points.min(axis=2), points.max(axis=2)
    more = MARGIN * (high - low).max(axis=0)
    first, last = (np.asarray(corner)[:, None] for corner in window)
    near: NDArray[np.bool_] = ((low - more <= last) & (high + more >= first)).all(axis=0)
    return near


def _parts(strays: Floats, allowed: float) -> NDArray[np.intp]:
    with np.errstate(over="ignore"):
        asked = np.ceil(np.sqrt(strays / allowed))
    return np.clip(asked, 2, PARTS).astype(np.intp)


def _afforded(parts: NDArray[np.intp], strays: Floats, left: int) -> NDArray[np.intp]:
    """The same numbers of parts, but for the smallest errors 1, so that no more are added."""
    if int((parts - 1).sum()) <= left:
        return parts
    worst = np.argsort(-strays)
    affordable = np.cumsum(parts[worst] - 1) <= left
    afforded = np.ones_like(parts)
    afforded[worst[affordable]] = parts[worst[affordable]]
    return afforded


def _cut(low: Floats, high: Floats, parts: NDArray[np.intp]) -> tuple[Floats, Floats]:
    """The ends of the parts of each interval, one after another."""
    first = np.repeat(np.cumsum(parts) - parts, parts)
    step = np.arange(len(first)) - first
    count = np.repeat(parts, parts)
    start, width = np.repeat(low, parts), np.repeat(high - low, parts)
    ends = np.where(step + 1 == count, np.repeat(high, parts), start + width * (step + 1) / count)
    return start + width * step / count, ends
