"""Families of curves compared by how well they come near the same points.

A curve of any family is linear in its control points P and gradients g, so for given parameters of
the points both come from one problem of least squares,

    minimize  | S (B P + D g - F) |,    g = 0 for classical curves,

with the ends of the curve at the ends of the points. S is the identity at first. Then the
parameters move to the feet of the points and it is solved anew, distances along the curve counting
for less and less in S, as what is along can be made up for by the parameters: so it converges as
the method of Gauss and Newton does. All families are treated alike: even knots, the same order,
the same parameters to begin with.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, TypeAlias, get_args

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.blend import blends_at
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.fitting import curve_of_gradients, parameters_by_length
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.matrices import dense
from plusedit.geometry.storage import stored_numbers
from plusedit.geometry.surface import PlusSurface

Kind: TypeAlias = Literal["bezier", "bezier+", "bspline", "bspline+"]
KINDS: tuple[Kind, ...] = get_args(Kind)

TRIED = 2  # fits before, of which the parameters are tried
TRIAL = 8  # steps from each of several beginnings
STEPS = 60  # at most, from where these led to the best
FEET = 2  # steps toward the feet of the points, each time
GAIN = 2e-3  # of the distances: a step that brings less is in vain
MISSES = 6  # so many steps in vain are the last
ENOUGH = 1e-10  # of the size of the points: distances that need not be any less
CLOSEST = 1e-3  # of even steps: parameters are that far apart at least
RELUCTANCE = 1e-12  # how unwillingly unknowns move, of how willingly at most
EASED = 0.4  # times what distances along the curve count after a step that helped
RANK = 1e-11  # of the largest singular value: smaller ones are taken to be zero
TAMER = 1.02  # times the distance that has to be, for control elements that are better to edit
SPREAD = 0.25  # of the spacing of nodes, over which slopes of the points are taken

Check: TypeAlias = Callable[[], object]
"""Called now and then; what it raises ends the work."""


@dataclass(frozen=True, eq=False)
class Fit:
    """A curve or surface of one family, and how near it comes to its points."""

    kind: Kind
    shape: PlusCurve | PlusSurface
    largest: float
    """the largest distance of a point"""
    rms: float
    """the root of the mean square of the distances"""

    u: Floats | None = None
    """(m,) the parameters of the points, where they were free"""

    @property
    def elements(self) -> int:
        """How many control points, lines or planes it has."""
        return len(self.shape.net)

    @property
    def numbers(self) -> int:
        """How many numbers are stored of it: a line counts twice a point, a plane three times."""
        return stored_numbers(self.shape)


def is_plus(kind: Kind) -> bool:
    """Whether the control elements of a family are lines or planes."""
    return kind.endswith("+")


def basis_of(kind: Kind, size: int, order: int) -> Basis:
    """The basis of a family for that many control elements; even knots."""
    return Bernstein(size) if kind.startswith("bezier") else BSpline(size, min(order, size))


def curve_fits(
    points: Floats,
    sizes: Sequence[int],
    *,
    kinds: Sequence[Kind] = KINDS,
    order: int = 4,
    check: Check = lambda: None,
) -> Iterator[Fit]:
    """Curves of those families with so many control elements each, one after the other.

    Fitted to points (m, dim) in their order, two at least.
    """
    latest: dict[Kind, Fit] = {}
    for size in sizes:
        for kind in kinds:
            # What was good for one family is worth a try for all.
            best = sorted(latest.values(), key=lambda fit: (fit.kind != kind, fit.rms))[:TRIED]
            before = [fit.u for fit in best if fit.u is not None]
            latest[kind] = fit_curve(points, kind, size, order=order, before=before, check=check)
            yield latest[kind]


def fit_curve(
    points: Floats,
    kind: Kind,
    size: int,
    *,
    order: int = 4,
    before: Sequence[Floats] = (),
    check: Check = lambda: None,
) -> Fit:
    """The curve of that family with so many control elements that is nearest to the points.

    It begins at the first of the points (m, dim) and ends at the last. Parameters (m,) that other
    fits have found `before` are tried, too. Distances are those of the points from their feet on
    the curve, in the same order: where it leaves out a loop, it is far away.
    """
    task = _Task(basis_of(kind, size, order), is_plus(kind), points)
    starts = [task.state(task.first(u), u) for u in (parameters_by_length(points), *before)]
    tried = [_descended(task, start, TRIAL, check) for start in starts]
    best = _descended(task, min(tried, key=lambda state: state.rms), STEPS, check)
    tame = task.state(task.first(best.u), best.u)
    best = tame if tame.rms <= max(TAMER * best.rms, task.enough) else best
    largest = float(np.linalg.norm(best.away, axis=1).max())
    return Fit(kind, task.curve(best.unknowns), largest, best.rms, best.u)


def even_points(curve: PlusCurve, count: int) -> Floats:
    """(count, dim) points of a curve, about even in its length, from its beginning to its end."""
    fine = np.linspace(0.0, 1.0, max(16 * count, 4097))
    length = parameters_by_length(curve.at(fine))
    return curve.at(np.interp(np.linspace(0.0, 1.0, count), length, fine))


def row_matrix(u: Floats, at: Floats) -> Floats:
    """(k, m) what takes values at parameters u (m,), by straight lines between them, to others."""
    return np.stack([np.interp(at, u, unit) for unit in np.eye(len(u))], axis=1)


def least_moves(matrix: Floats, goal: Floats) -> Floats:
    """(k, dim) x with | matrix x - goal | as small as can be but for some percent.

    For that as few singular values count as will do: where the goal hardly asks for a change,
    there is none.
    """
    left, sizes, right = np.linalg.svd(matrix, full_matrices=False)
    kept = max(1, int(np.count_nonzero(sizes > RANK * sizes[0])))
    shares = left[:, :kept].T @ goal
    falls = np.cumsum((shares * shares).sum(axis=1))
    whole = float((goal * goal).sum())
    least = max(whole - float(falls[-1]), 0.0)
    enough = whole - (TAMER**2 * least + ENOUGH**2 * whole)
    count = min(int(np.searchsorted(falls, enough)) + 1, kept)
    moves: Floats = right[:count].T @ (shares[:count] / sizes[:count, None])
    return moves


def reaches_of(values: Floats, reaches: Floats) -> Floats:
    """(n,) how far about the gradients move a curve: by that they are of the unit of the points."""
    moved = np.sqrt((reaches**2).sum(axis=0) / np.maximum((values**2).sum(axis=0), 1e-300))
    return np.where(moved > 0.0, moved, 1.0)


@dataclass(frozen=True, eq=False)
class _Task:
    """Points to come near to, and what with.

    Unknowns (k, dim) are the inner control points, and of plus curves the gradients of all lines.
    """

    basis: Basis
    is_plus: bool
    points: Floats

    @cached_property
    def enough(self) -> float:
        """Distances below that are as good as none."""
        return ENOUGH * float(np.ptp(self.points, axis=0).max())

    def columns(self, u: Floats) -> Floats:
        """(m, k) what the unknowns contribute to the points at u."""
        values, reaches = _matrices(self.basis, u)
        inner = values[:, 1:-1]
        return np.hstack([inner, reaches]) if self.is_plus else inner

    def wanted(self, u: Floats) -> Floats:
        """(m, dim) what they have to make up: the points without the share of both ends."""
        values, _ = _matrices(self.basis, u)
        return self.points - values[:, [0, -1]] @ self.points[[0, -1]]

    def curve(self, unknowns: Floats) -> PlusCurve:
        """The curve that they make."""
        inner = self.basis.size - 2
        at = np.concatenate([self.points[:1], unknowns[:inner], self.points[-1:]])
        if not self.is_plus:
            return PlusCurve(self.basis, ControlLines.of(at), s=0.0)
        return curve_of_gradients(self.basis, at, unknowns[inner:])

    def first(self, u: Floats) -> Floats:
        """Unknowns of least squares for those parameters; of several the likeliest.

        That are those nearest to P_i = f(x_i), g_i = f'(x_i) / 2, f the chain of the points.
        """
        x, width = self.basis.nodes, SPREAD / self.basis.size
        low, high = np.clip(x - width, 0.0, 1.0), np.clip(x + width, 0.0, 1.0)
        rise = (row_matrix(u, high) - row_matrix(u, low)) @ self.points
        slopes = rise / (high - low)[:, None] / 2.0
        inner = (row_matrix(u, x) @ self.points)[1:-1]
        guess = np.concatenate([inner, slopes]) if self.is_plus else inner
        columns = self.columns(u)
        scale = _sizes(columns)
        left = self.wanted(u) - columns @ guess
        first: Floats = guess + least_moves(columns / scale, left) / scale[:, None]
        return first

    def feet(self, unknowns: Floats, u: Floats) -> "_State":
        """The parameters moved to the feet of the points, in the same order, from 0 to 1."""
        curve = self.curve(unknowns)
        for _ in range(FEET):
            at, velocity, bend = curve.derivatives(u)
            away = self.points - at
            speed = (velocity * velocity).sum(axis=1)
            # Where the curve bends away faster than the point is far, Newton's step leads astray.
            slope = np.maximum(speed - (away * bend).sum(axis=1), 0.5 * speed)
            ahead = (away * velocity).sum(axis=1)
            u = u + np.divide(ahead, slope, out=np.zeros_like(ahead), where=slope > 0.0)
            u[0], u[-1] = 0.0, 1.0
            steps = np.maximum(np.diff(u), CLOSEST / len(u))
            u = np.concatenate([[0.0], np.cumsum(steps[:-1]) / steps.sum(), [1.0]])
        return self.state(unknowns, u)

    def state(self, unknowns: Floats, u: Floats) -> "_State":
        """The curve with the parameters as they are."""
        at, velocity = self.curve(unknowns).derivatives(u, highest=1)
        return _State(unknowns, u, self.points - at, unit(velocity))


@dataclass(frozen=True, eq=False)
class _State:
    """A curve with the parameters of its points."""

    unknowns: Floats
    u: Floats
    away: Floats
    """(m, dim) from the curve to the points"""
    headings: Floats
    """(m, dim) unit vectors along the curve"""

    @cached_property
    def rms(self) -> float:
        """The root of the mean square of the distances."""
        return float(np.sqrt((self.away * self.away).sum(axis=1).mean()))


def _descended(task: _Task, start: _State, steps: int, check: Check) -> _State:
    """The state that so many steps lead to."""
    best, along, misses = start, 1.0, 0
    for _ in range(steps):
        check()
        moves = _step(task.columns(best.u), best, along)
        state = task.feet(best.unknowns + moves, best.u)
        gain = 1.0 - state.rms / best.rms if best.rms > 0.0 else 0.0
        misses = 0 if gain > GAIN else misses + 1
        if gain > 0.0:
            best, along = state, along * EASED
        else:
            along = min(along / EASED**2, 1.0)
        if misses == MISSES or best.rms <= task.enough:
            break
    return best


def _step(columns: Floats, state: _State, along: float) -> Floats:
    """(k, dim) how unknowns move so that distances fall, those along the curve as counted."""
    count, dimension = columns.shape[1], state.away.shape[1]
    scale = _sizes(columns)
    less = (1.0 - along) * state.headings[:, :, None] * state.headings[:, None, :]
    counted = np.eye(dimension) - less
    matrix = np.einsum("mab,mk->makb", counted, columns / scale).reshape(-1, count * dimension)
    goal = np.einsum("mab,mb->ma", counted, state.away).ravel()
    square = matrix.T @ matrix
    square[np.diag_indices(len(square))] += RELUCTANCE
    found = np.linalg.solve(square, matrix.T @ goal).reshape(count, dimension)
    moves: Floats = found / scale[:, None]
    return moves


def _sizes(columns: Floats) -> Floats:
    """(k,) how much the points feel of each unknown; one where they feel nothing."""
    sizes: Floats = np.linalg.norm(columns, axis=0)
    return np.where(sizes > 0.0, sizes, 1.0)


def _matrices(basis: Basis, u: Floats) -> tuple[Floats, Floats]:
    both = blends_at(basis, u, 0)[0]
    return dense(both.values), dense(both.reaches)
