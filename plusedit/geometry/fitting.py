"""A B-spline+ curve fitted to many points in their order.

The parameters of the points, by length at first, are moved to their feet on the curve of least
squares, and lines are added where it is still too far away. With the fewest lines that do, their
points may have to lie far from the curve; a few more than these are tried, so that they lie along
it. In the end, of the curves that are near enough, the one is taken whose lines stray least from
where they began.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.approximation import Task, approximated, curve_of_gradients, solved
from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve

__all__ = ["Fitted", "curve_of_gradients", "fit_bspline_plus", "parameters_by_length"]

FEET = 4  # steps toward the feet of the points in the end
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


def _fitted_open(data: Floats, tolerance: float, order: int, corners: list[int]) -> Fitted:
    data, corners = _with_edges_filled(data, corners, 2 * order)
    u = parameters_by_length(data)
    at, first = np.unique(u[corners], return_index=True)
    inner = [corners[i] for i in first[(at > 0.0) & (at < 1.0)]]
    task = Task(data, u, np.diff(u), (0, *inner, len(data) - 1))
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
    task = Task(data, u[:-1], np.diff(u), closed=True)
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
        self._fewest: tuple[PlusCurve, Task] | None = None
        """the first that is near enough, wherever its lines lie"""
        self._last: tuple[PlusCurve, Task] | None = None
        self.is_over = False

    def tried(self, basis: BSpline, task: Task) -> tuple[Task, Floats]:
        """The task with parameters corrected for that basis, and how far the points still are."""
        curve, task = approximated(basis, task, self._tolerance)
        self._last = curve, task
        distance = task.distances(curve)
        if distance.max() > self._tolerance:
            return task, distance
        if self._fewest is None:
            self._fewest = self._last
        distance = task.distances(solved(basis, task, EASY))
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


def _calmed(basis: BSpline, task: Task, enough: float) -> PlusCurve | None:
    """The curve that leaves its guess most unwillingly and is near enough; None if none is."""
    for reluctance in RELUCTANCES:
        curve = solved(basis, task, reluctance)
        if task.distances(curve).max() <= enough:
            return curve
    return None


def _judged(curve: PlusCurve, task: Task, tolerance: float) -> Fitted:
    enough = max(tolerance, float(task.distances(curve).max()))
    assert isinstance(curve.basis, BSpline)
    curve = _calmed(curve.basis, task, enough) or curve
    distance = task.distances(curve)
    for _ in range(FEET):
        task = task.nearer(curve)
        distance = np.minimum(distance, task.distances(curve))
    return Fitted(curve, float(distance.max()), float(np.sqrt((distance**2).mean())))


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
