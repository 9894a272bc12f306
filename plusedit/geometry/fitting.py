"""A B-spline+ curve fitted to many points in their order.

For given parameters of the points the curve is linear in its control points P and gradients g,
so both come from one least squares problem. Several P and g make the same curve (adding one
vector to all gradients changes nothing), and of those the nearest to

    P_i = f(x_i),   g_i = f'(x_i) / 2

is taken, f being the chain of the given points: exact for a quadratic f, and lines that can be
edited, for they lie along the curve. The parameters, by length at first, are then moved to the
feet of the points, and lines are added where the curve is still too far away. With the fewest lines
that do, their points may have to lie far from the curve; a few more than these are tried, so that
they lie along it. In the end, of the curves that are near enough, the one is taken whose lines
stray least from where they began.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.local_squares import LocalMatrix, normal_solver
from plusedit.geometry.magnitude import polygon_length

CORRECTIONS = 3  # of the parameters, for one set of knots
FEET = 4  # steps toward the feet of the points in the end
STRETCH = 3.0  # how much faster or slower than by length a parameter may run
REFINEMENTS = 3  # steps that make up for the reluctance where it is not asked for
RELUCTANCES = (1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5)  # to leave the guess, tried in turn
EASY = 1e-4  # a reluctance with which lines still lie along the curve
MORE = 1.5  # times as many lines as the fewest are given for that at most
WORST = 0.3  # of the largest distance: spans farther away than that are divided
FEWEST = 4  # points in a span that is divided
FIRST = 6  # lines of a closed curve tried first
ROUNDS = 200


@dataclass(frozen=True, eq=False)
class Fitted:
    """A curve, and how far the points it was made for are from it at most."""

    curve: PlusCurve
    largest: float
    """the largest distance"""
    rms: float
    """the square root of the mean square of the distances"""


def fit_bspline_plus(
    points: ArrayLike,
    *,
    tolerance: float,
    order: int = 4,
    closed: bool = False,
    corners: Sequence[int] | None = None,
) -> Fitted:
    """A B-spline+ curve that passes the points (m, dim) within the tolerance.

    Parameters
    ----------
    points
        In their order along the curve, close together where it bends. An open curve begins at
        the first and ends at the last.
    tolerance
        The largest distance, in the unit of the points. Where there are too few points for it,
        as in a noise that no curve follows, the distance that is left is larger.
    closed
        Whether the curve goes on from the last point to the first.
    corners
        Numbers of points at which the curve has a corner, and which it meets. A closed curve
        with corners is made from an open one that ends where it begins.

    Raises ValueError for fewer than two points, a tolerance that is not positive, an order
    below 2, or a corner that is none of the points.
    """
    data = frozen(points, shape=(None, None), name="points")
    if len(data) < 2 or data.shape[1] not in (2, 3):
        raise ValueError(f"points: expected at least 2 rows of 2 or 3, got {data.shape}")
    if not tolerance > 0.0:
        raise ValueError(f"tolerance: must be positive, got {tolerance}")
    if order < 2:
        raise ValueError(f"order: expected 2 or more, got {order}")
    at = sorted(set(corners or ()))
    if at and not 0 <= at[0] <= at[-1] < len(data):
        raise ValueError(f"corners: {len(data)} points have none of number {at[-1]} or {at[0]}")
    if not closed:
        return _fitted_open(data, tolerance, order, at)
    if (data[0] == data[-1]).all():
        data, at = data[:-1], [index for index in at if index < len(data) - 1]
    if at:
        round_again = np.roll(data, -at[0], axis=0)
        data = np.concatenate([round_again, round_again[:1]])
        return _fitted_open(data, tolerance, order, [index - at[0] for index in at])
    return _fitted_closed(data, tolerance, order)


@dataclass(frozen=True, eq=False)
class _Task:
    """Points, their parameters, and lines that are not free to leave theirs."""

    data: Floats
    u: Floats
    steps: Floats
    """of the parameters, when they are even in the length of the chain"""
    pinned: tuple[int, ...] = ()
    """numbers of the points that the curve meets at their parameters"""
    closed: bool = False


def _fitted_open(data: Floats, tolerance: float, order: int, corners: list[int]) -> Fitted:
    data, corners = _with_edges_filled(data, corners, 2 * order)
    u = parameters_by_length(data)
    at, first = np.unique(u[corners], return_index=True)
    inner = [corners[i] for i in first[(at > 0.0) & (at < 1.0)]]
    task = _Task(data, u, np.diff(u), (0, *inner, len(data) - 1))
    knots = np.repeat(u[inner], order - 1)
    search = _Search(tolerance)
    for _ in range(ROUNDS):
        clamped = np.concatenate([np.zeros(order), knots, np.ones(order)])
        basis = BSpline(len(knots) + order, order, knots=tuple(clamped.tolist()))
        task, distance = search.tried(basis, task)
        if search.is_over:
            break
        more = _divided(basis.breaks, task.u, distance, tolerance)
        if not len(more):
            break
        knots = np.sort(np.concatenate([knots, more]))
    return search.found()


def _fitted_closed(data: Floats, tolerance: float, order: int) -> Fitted:
    u = parameters_by_length(np.concatenate([data, data[:1]]))
    task = _Task(data, u[:-1], np.diff(u), closed=True)
    size = FIRST
    search = _Search(tolerance)
    for _ in range(ROUNDS):
        task, distance = search.tried(BSpline(size, order, closed=True), task)
        if search.is_over or 2 * size >= len(data):
            break
        # The distance falls with the power order + 1 of the number of lines.
        excess = float(distance.max()) / tolerance
        wanted = size * float(np.clip(excess ** (1.0 / (order + 1)), 1.1, 2.0))
        size = min(max(size + 1, round(wanted)), max(size + 1, len(data) // 2))
    return search.found()


class _Search:
    """For a curve within the tolerance, of few lines that lie along it."""

    def __init__(self, tolerance: float) -> None:
        self._tolerance = tolerance
        self._fewest: tuple[PlusCurve, _Task] | None = None
        """the first that is near enough, wherever its lines lie"""
        self._last: tuple[PlusCurve, _Task] | None = None
        self.is_over = False

    def tried(self, basis: BSpline, task: _Task) -> tuple[_Task, Floats]:
        """The task with parameters corrected for that basis, and how far the points still are."""
        curve, task = _fitted(basis, task, self._tolerance)
        self._last = curve, task
        distance = _distances(curve, task)
        if distance.max() > self._tolerance:
            return task, distance
        if self._fewest is None:
            self._fewest = self._last
        distance = _distances(_solved(basis, task, EASY), task)
        if distance.max() <= self._tolerance:
            self._fewest, self.is_over = self._last, True
        elif basis.size >= MORE * len(self._fewest[0].lines):
            self.is_over = True
        return task, distance

    def found(self) -> Fitted:
        """The curve to take: of no more lines than are of use."""
        taken = self._fewest or self._last
        assert taken is not None
        return _judged(*taken, self._tolerance)


def _calmed(basis: BSpline, task: _Task, enough: float) -> PlusCurve | None:
    """The curve that leaves its guess most unwillingly and is near enough; None if none is."""
    for reluctance in RELUCTANCES:
        curve = _solved(basis, task, reluctance)
        if _distances(curve, task).max() <= enough:
            return curve
    return None


def _judged(curve: PlusCurve, task: _Task, tolerance: float) -> Fitted:
    enough = max(tolerance, float(_distances(curve, task).max()))
    assert isinstance(curve.basis, BSpline)
    curve = _calmed(curve.basis, task, enough) or curve
    distance = _distances(curve, task)
    for _ in range(FEET):
        task = replace(task, u=_feet(curve, task))
        distance = np.minimum(distance, _distances(curve, task))
    return Fitted(curve, float(distance.max()), float(np.sqrt((distance**2).mean())))


def _fitted(basis: BSpline, task: _Task, tolerance: float) -> tuple[PlusCurve, _Task]:
    """The curve of that basis, and the task with parameters corrected for it."""
    curve = _solved(basis, task)
    for _ in range(CORRECTIONS):
        task = _corrected(curve, task)
        if _distances(curve, task).max() <= tolerance:
            break
        curve = _solved(basis, task)
    return curve, task


def _solved(basis: BSpline, task: _Task, reluctance: float | None = None) -> PlusCurve:
    """The curve of least squares for the parameters as they are.

    With a reluctance the lines stay nearer to their guess, and the curve farther from the points.
    """
    reach = _widths(basis)
    guess = _guess(basis, task, reach)
    pinned = [int(np.abs(basis.nodes - task.u[index]).argmin()) for index in task.pinned]
    guess[pinned, 0] = task.data[list(task.pinned)]
    matrix = _matrix(basis, task.u, reach)
    # A point that is pinned has no entries, and so no reason to leave the guess.
    held = np.zeros(matrix.count, dtype=np.bool_)
    held[2 * np.array(pinned, dtype=np.intp)] = True
    free = replace(matrix, entries=np.where(held[matrix.columns], 0.0, matrix.entries))
    solve = normal_solver(free) if reluctance is None else normal_solver(free, reluctance)
    unknowns = guess.reshape(matrix.count, -1)
    for _ in range(REFINEMENTS if reluctance is None else 1):
        unknowns = unknowns + solve(free.transposed_times(task.data - matrix @ unknowns))
    return curve_of_gradients(basis, unknowns[::2], unknowns[1::2] / reach[:, None])


def _matrix(basis: BSpline, u: Floats, reach: Floats) -> LocalMatrix:
    """What P_0, g_0, P_1, g_1, ... contribute to the points at u.

    A gradient counts as what it moves the curve by, g times reach: in the unit of the points.
    """
    values, reaches = basis.banded(u)
    pull = reaches.entries / reach[reaches.columns]
    columns = np.stack([2 * values.columns, 2 * values.columns + 1], axis=2)
    entries = np.stack([values.entries, pull], axis=2)
    shape = (len(u), 2 * basis.order)
    return LocalMatrix(columns.reshape(shape), entries.reshape(shape), 2 * basis.size, basis.closed)


def curve_of_gradients(basis: Basis, points: Floats, gradients: Floats) -> PlusCurve:
    """The curve with half the length of its polygon for s, as the scale of directions."""
    still = PlusCurve(basis, ControlLines.of(points, gradients))
    s = polygon_length(still) / 2.0 or 1.0
    return replace(still, lines=still.lines.with_directions(gradients / s), s=s)


def _widths(basis: BSpline) -> Floats:
    """(n,) how far a function reaches: the mean length of its spans."""
    if basis.closed:
        return np.full(basis.size, 1.0 / basis.size)
    knots, order = basis.knot_vector, basis.order
    widths: Floats = (knots[order:] - knots[:-order]) / order
    return widths


def _guess(basis: BSpline, task: _Task, reach: Floats) -> Floats:
    """(n, 2, dim) the points f(x_i) with the gradients f'(x_i) / 2 times the reach."""
    x = basis.nodes
    before, after = x - reach / 2.0, x + reach / 2.0
    if not task.closed:
        # On one side of a corner nothing is known of the other.
        bounds = task.u[list(task.pinned)]
        section = np.clip(np.searchsorted(bounds, x, side="right") - 1, 0, len(bounds) - 2)
        before, after = np.maximum(before, bounds[section]), np.minimum(after, bounds[section + 1])
    rise = _chain(task, after) - _chain(task, before)
    slopes = rise / (after - before)[:, None] / 2.0
    return np.stack([_chain(task, x), slopes * reach[:, None]], axis=1)


def _chain(task: _Task, x: Floats) -> Floats:
    """(n, dim) f: the chain of the points, at parameters x."""
    period = 1.0 if task.closed else None
    rows = [np.interp(x, task.u, coordinate, period=period) for coordinate in task.data.T]
    return np.stack(rows, axis=1)


def _corrected(curve: PlusCurve, task: _Task) -> _Task:
    """The task with parameters moved toward the feet of the points, in the same order."""
    u = _feet(curve, task)
    if task.closed:
        steps = _tamed(np.diff(u, append=u[0] + 1.0), task.steps)
        return replace(task, u=u[0] + np.concatenate([[0.0], np.cumsum(steps[:-1])]))
    for start, stop in pairwise(task.pinned):
        steps = _tamed(np.diff(u[start : stop + 1]), task.steps[start:stop])
        u[start + 1 : stop] = u[start] + np.cumsum(steps[:-1])
    return replace(task, u=u)


def _feet(curve: PlusCurve, task: _Task) -> Floats:
    """(m,) parameters nearer to the feet of the points; the pinned ones as they are."""
    at, velocity = curve.derivatives(task.u, highest=1)
    speed = (velocity * velocity).sum(axis=1)
    ahead = ((task.data - at) * velocity).sum(axis=1)
    u: Floats = task.u + np.divide(ahead, speed, out=np.zeros_like(ahead), where=speed > 0.0)
    pinned = list(task.pinned)
    u[pinned] = task.u[pinned]
    return u


def _tamed(steps: Floats, usual: Floats) -> Floats:
    """Steps of the parameter, none much shorter or longer than by length, with the same sum.

    The feet on a curve that is still far away would bring whole stretches of points together.
    """
    tamed: Floats = np.clip(steps, usual / STRETCH, usual * STRETCH)
    total = float(tamed.sum())
    if total > 0.0:
        tamed *= float(steps.sum()) / total
    return tamed


def _distances(curve: PlusCurve, task: _Task) -> Floats:
    distances: Floats = np.linalg.norm(curve.at(task.u) - task.data, axis=1)
    return distances


def _divided(breaks: Floats, u: Floats, distance: Floats, tolerance: float) -> Floats:
    """New knots, one in each span that is too far from its points and has enough of them."""
    enough = max(tolerance, WORST * float(distance.max()))
    knots = []
    for low, high in pairwise(breaks):
        inside = np.flatnonzero((u >= low) & (u <= high))
        if len(inside) < FEWEST or distance[inside].max() <= enough:
            continue
        error = np.cumsum(distance[inside] ** 2)
        middle = inside[np.searchsorted(error, error[-1] / 2.0)]
        knot = np.clip(u[middle], 0.75 * low + 0.25 * high, 0.25 * low + 0.75 * high)
        if (u[inside] < knot).sum() > 1 < (u[inside] > knot).sum():
            knots.append(knot)
    return np.array(knots)


def parameters_by_length(data: Floats) -> Floats:
    """(m,) parameters from 0 to 1, even in the length of the chain."""
    lengths = np.linalg.norm(np.diff(data, axis=0), axis=1)
    so_far = np.concatenate([[0.0], np.cumsum(lengths)])
    if so_far[-1] == 0.0:
        return np.linspace(0.0, 1.0, len(data))
    parameters: Floats = so_far / so_far[-1]
    return parameters


def _with_edges_filled(data: Floats, corners: list[int], count: int) -> tuple[Floats, list[int]]:
    """The points, with more of them on straight edges, where corner follows corner."""
    ends = sorted({0, *corners, len(data) - 1})
    rows: list[Floats] = []
    moved: list[int] = []
    for start, stop in pairwise(ends):
        moved.append(sum(map(len, rows)))
        if stop == start + 1 and corners:
            rows.append(np.linspace(data[start], data[stop], count, endpoint=False))
        else:
            rows.append(data[start:stop])
    return np.concatenate([*rows, data[-1:]]), moved[1:]
