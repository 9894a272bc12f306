"""The B-spline+ curve of least squares for points at parameters, and better parameters for them.

For given parameters of the points the curve is linear in its control points P and gradients g,
so both come from one least squares problem. Several P and g make the same curve (adding one
vector to all gradients changes nothing), and of those the nearest to

    P_i = f(x_i),   g_i = f'(x_i) / 2

is taken, f being the chain of the given points: exact for a quadratic f, and lines that can be
edited, for they lie along the curve. The parameters are then moved to the feet of the points.
"""

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.local_squares import LocalMatrix, normal_solver
from plusedit.geometry.magnitude import polygon_length

CORRECTIONS = 3  # of the parameters, for one set of knots
STRETCH = 3.0  # how much faster or slower than by length a parameter may run
REFINEMENTS = 3  # steps that make up for the reluctance where it is not asked for


@dataclass(frozen=True, eq=False)
class Task:
    """Points, their parameters, and lines that are not free to leave theirs."""

    data: Floats
    u: Floats
    steps: Floats
    """of the parameters, when they are even in the length of the chain"""
    pinned: tuple[int, ...] = ()
    """numbers of the points that the curve meets at their parameters"""
    closed: bool = False

    def distances(self, curve: PlusCurve) -> Floats:
        """(m,) of the points from those of a curve at their parameters."""
        distances: Floats = np.linalg.norm(curve.at(self.u) - self.data, axis=1)
        return distances

    def nearer(self, curve: PlusCurve) -> "Task":
        """The same at parameters nearer to the feet of the points, but for the pinned ones."""
        at, velocity = curve.derivatives(self.u, highest=1)
        speed = (velocity * velocity).sum(axis=1)
        ahead = ((self.data - at) * velocity).sum(axis=1)
        u = self.u + np.divide(ahead, speed, out=np.zeros_like(ahead), where=speed > 0.0)
        pinned = list(self.pinned)
        u[pinned] = self.u[pinned]
        return replace(self, u=u)


def approximated(basis: BSpline, task: Task, tolerance: float) -> tuple[PlusCurve, Task]:
    """The curve of that basis, and the task with parameters corrected for it."""
    curve = solved(basis, task)
    for _ in range(CORRECTIONS):
        task = _corrected(curve, task)
        if task.distances(curve).max() <= tolerance:
            break
        curve = solved(basis, task)
    return curve, task


def solved(basis: BSpline, task: Task, reluctance: float | None = None) -> PlusCurve:
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


def _guess(basis: BSpline, task: Task, reach: Floats) -> Floats:
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


def _chain(task: Task, x: Floats) -> Floats:
    """(n, dim) f: the chain of the points, at parameters x."""
    period = 1.0 if task.closed else None
    rows = [np.interp(x, task.u, coordinate, period=period) for coordinate in task.data.T]
    return np.stack(rows, axis=1)


def _corrected(curve: PlusCurve, task: Task) -> Task:
    """The task with parameters moved toward the feet of the points, in the same order."""
    u = task.nearer(curve).u
    if task.closed:
        steps = _tamed(np.diff(u, append=u[0] + 1.0), task.steps)
        return replace(task, u=u[0] + np.concatenate([[0.0], np.cumsum(steps[:-1])]))
    for start, stop in pairwise(task.pinned):
        steps = _tamed(np.diff(u[start : stop + 1]), task.steps[start:stop])
        u[start + 1 : stop] = u[start] + np.cumsum(steps[:-1])
    return replace(task, u=u)


def _tamed(steps: Floats, usual: Floats) -> Floats:
    """Steps of the parameter, none much shorter or longer than by length, with the same sum.

    The feet on a curve that is still far away would bring whole stretches of points together.
    """
    tamed: Floats = np.clip(steps, usual / STRETCH, usual * STRETCH)
    total = float(tamed.sum())
    if total > 0.0:
        tamed *= float(steps.sum()) / total
    return tamed
