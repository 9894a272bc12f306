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
"""Lower left and upper right corner, (2,) each."""


def _interpolation() -> Floats:
    """(5, 15) from values at SAMPLED to those of the polynomial through them at BETWEEN."""
    return np.asarray(np.linalg.solve(np.vander(SAMPLED).T, np.vander(BETWEEN, 5).T), np.float64)


INTERPOLATION = _interpolation()


def tessellation(
    curve: PlusCurve,
    tolerance: float,
    *,
    window: Window | None = None,
    axes: tuple[int, int] = (0, 1),
) -> Grid:
    """Parameters whose chords stay within `tolerance` of the curve inside `window`.

    They increase from 0 to 1, hold every knot, and are at most 20000. `tolerance` is in the
    unit of the points and is measured as the curve is seen along `axes`; a plane curve lies in
    z = 0. Without a window all of the curve counts.

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
    axes: tuple[int, int] = (0, 1),
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


def seen_along(points: Floats, axes: tuple[int, int]) -> Floats:
    """(m, 2) the two coordinates that are seen; a plane curve lies in z = 0."""
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
    points: Floats, window: Window | None, axes: tuple[int, int]
) -> tuple[Floats, NDArray[np.bool_], float]:
    """How far each interval strays from its chord, whether it may be seen, and the rounding.

    `points` (5 m, dim) are those of the curve at the parameters of `_within`.
    """
    x, y = seen_along(points, axes).T.reshape(2, -1, len(SAMPLED))
    rounding = 16.0 * float(np.finfo(np.float64).eps * max(np.abs(x).max(), np.abs(y).max()))
    inside_x, inside_y = x @ INTERPOLATION, y @ INTERPOLATION
    ends = (x[:, 0], y[:, 0]), (x[:, -1], y[:, -1])
    strays = _distances(inside_x, inside_y, *ends).max(axis=1)
    if window is None:
        return strays, np.ones(len(x), dtype=np.bool_), rounding
    across, up = np.concatenate([inside_x, x], axis=1), np.concatenate([inside_y, y], axis=1)
    return strays, _near(across, up, window), rounding


def _distances(x: Floats, y: Floats, a: tuple[Floats, Floats], b: tuple[Floats, Floats]) -> Floats:
    """(m, k) of the points (x, y), (m, k) each, from the segments a b, (m,) each."""
    across, up = (b[0] - a[0])[:, None], (b[1] - a[1])[:, None]
    length = np.hypot(across, up)
    safe = np.where(length > 0.0, length, 1.0)
    across, up = across / safe, up / safe
    x, y = x - a[0][:, None], y - a[1][:, None]
    along = np.clip(x * across + y * up, 0.0, length)
    distances: Floats = np.hypot(x - along * across, y - along * up)
    return distances


def _near(x: Floats, y: Floats, window: Window) -> NDArray[np.bool_]:
    """(m,) whether the boxes of the points (m, k), a little enlarged, reach into the window."""
    left, right, below, above = x.min(axis=1), x.max(axis=1), y.min(axis=1), y.max(axis=1)
    more = MARGIN * np.maximum(right - left, above - below)
    (x0, y0), (x1, y1) = window
    beside = (left - more > x1) | (right + more < x0)
    near: NDArray[np.bool_] = ~(beside | (below - more > y1) | (above + more < y0))
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
