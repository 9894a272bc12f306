"""How the curvature of a curve runs, piece by piece: honest at knots, where it may jump.

The curvature vector k N points to the center of the osculating circle and is as long as 1 / radius.
"""

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.frames import curvature, curvature_at, space_curvature
from plusedit.geometry.pieces import breaks

PARTS, ROUNDS = 16, 3  # of a stretch with an extremum: how often it is cut, into how many
SAMPLES, FEWEST = 32, 256  # to the piece and in all, among which extrema are looked for
FLAT = 1e-9  # of the largest curvature: smaller differences are rounding


@dataclass(frozen=True, eq=False)
class CurvatureSamples:
    """The curvature at parameters of a curve."""

    u: Floats
    """(m,) rising"""
    points: Floats
    """(m, dim)"""
    vectors: Floats
    """(m, dim) curvature vectors k N; nan where the curve stands still"""
    curvatures: Floats
    """(m,) signed on plane curves, positive where they turn left; nan where the curve stands
    still"""


@dataclass(frozen=True, eq=False)
class CurvaturePiece(CurvatureSamples):
    """A stretch of a curve on which the curvature is continuous; at its end just before a knot."""


@dataclass(frozen=True, eq=False)
class CurvatureRun(CurvatureSamples):
    """All pieces of a curve, one after the other."""

    starts: NDArray[np.intp]
    """(p + 1,) the number of the first sample of each piece, and the number of all samples"""

    def pieces(self) -> tuple[CurvaturePiece, ...]:
        """The pieces, each by itself."""
        parts = (self.u, self.points, self.vectors, self.curvatures)
        return tuple(
            CurvaturePiece(*(part[low:high] for part in parts))
            for low, high in pairwise(self.starts.tolist())
        )


def curvature_profile(curve: PlusCurve, count: int) -> tuple[CurvaturePiece, ...]:
    """The pieces between the breaks of the basis, with about `count` samples in all.

    Every piece has 4 samples at least, its ends among them: the curvature at the end of one and
    at the start of the next tell how much it jumps.
    """
    return curvature_run(curve, count).pieces()


def curvature_run(curve: PlusCurve, count: int) -> CurvatureRun:
    """The same in one row, by cached matrices."""
    grid, starts = _grid(curve.basis, count)
    points, velocity, acceleration = curve.jets(grid)
    vectors = curvature_vectors(velocity, acceleration)
    signed = curvature if curve.dimension == 2 else space_curvature
    return CurvatureRun(grid.parameters, points, vectors, signed(velocity, acceleration), starts)


@lru_cache(maxsize=32)
def _grid(basis: Basis, count: int) -> tuple[Grid, NDArray[np.intp]]:
    """Samples of all pieces, and where each begins."""
    ends = breaks(basis)
    rows = []
    for low, high in pairwise(ends):
        u = np.linspace(low, high, max(4, round(count * (high - low))))
        # At a knot the curvature is that of the piece to the right: just before, of the left.
        u[-1] = np.nextafter(high, 0.0)
        rows.append(u)
    starts = np.cumsum([0, *map(len, rows)])
    return Grid(np.concatenate(rows)), starts


def curvature_vectors(velocity: Floats, acceleration: Floats) -> Floats:
    """(m, dim) k N from first and second derivatives (m, dim); nan where the curve stands still."""
    tangent = unit(velocity)
    along = (acceleration * tangent).sum(axis=1, keepdims=True) * tangent
    speed = np.linalg.norm(velocity, axis=1, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        vectors: Floats = np.where(speed > 0.0, (acceleration - along) / speed / speed, np.nan)
    return vectors


def curvature_extrema(curve: PlusCurve) -> Floats:
    """(k,) parameters, rising, at which the curvature is largest or smallest among its neighbors.

    Of a plane curve its signed curvature, of a space curve its size. Ends, and knots at which it
    jumps, are none; stretches of equal curvature have none.
    """
    count = len(breaks(curve.basis)) - 1
    run = curvature_run(curve, max(SAMPLES * count, FEWEST))
    least = FLAT * float(np.nanmax(np.abs(run.curvatures), initial=0.0))
    signs, low, high = _brackets(run, least)
    found = _peaks_at_knots(run, least)
    if len(signs):
        found = np.concatenate([found, _peaks(curve, signs, low, high)])
    return np.sort(found)


def _brackets(run: CurvatureRun, least: float) -> tuple[Floats, Floats, Floats]:
    """Signs, and the parameters about it, of every sample that is higher than its neighbors."""
    is_inside = np.ones(len(run.u), dtype=np.bool_)
    is_inside[run.starts[:-1]] = is_inside[run.starts[1:] - 1] = False
    rows, signs = [], []
    for sign in (1.0, -1.0):
        height = sign * run.curvatures
        before, at, after = height[:-2], height[1:-1], height[2:]
        # Two samples may be equally high, with the peak between them: the first is taken.
        is_peak = (at > before) & (at >= after) & (at - np.minimum(before, after) > least)
        rows.append(1 + np.flatnonzero(is_peak & is_inside[1:-1]))
        signs.append(np.full(len(rows[-1]), sign))
    row = np.concatenate(rows)
    return np.concatenate(signs), run.u[row - 1], run.u[row + 1]


def _peaks(curve: PlusCurve, signs: Floats, low: Floats, high: Floats) -> Floats:
    """(k,) where signs times the curvature are largest between parameters.

    Each stretch is sampled evenly and narrowed to what lies about the highest sample; in the end a
    parabola through three of them says where it is.
    """
    for _ in range(ROUNDS):
        u = np.linspace(low, high, PARTS + 1, axis=1)
        height = _heights(curve, u, signs)
        best = np.clip(np.argmax(height, axis=1), 1, PARTS - 1)
        rows = np.arange(len(u))
        low, high = u[rows, best - 1], u[rows, best + 1]
    before, at, after = (height[rows, best + step] for step in (-1, 0, 1))
    with np.errstate(invalid="ignore"):
        bend = before - 2.0 * at + after
        step = np.divide(0.5 * (before - after), bend, out=np.zeros(len(u)), where=bend < 0.0)
    middle: Floats = u[rows, best] + np.clip(np.nan_to_num(step), -1.0, 1.0) * (high - low) / 2.0
    return middle


def _heights(curve: PlusCurve, u: Floats, signs: Floats) -> Floats:
    """(k, m) signs (k,) times the curvature at parameters (k, m); lowest where there is none."""
    values = signs[:, None] * curvature_at(curve, u.ravel()).reshape(u.shape)
    return np.where(np.isfinite(values), values, -np.inf)


def _peaks_at_knots(run: CurvatureRun, least: float) -> Floats:
    """Knots at which the curvature is continuous and has a peak, with slopes that differ."""
    first = run.starts[1:-1]
    last, values = first - 1, run.curvatures
    is_even = np.abs(values[last] - values[first]) <= least
    before, after = values[last] - values[last - 1], values[first + 1] - values[first]
    is_peak = (before * after < 0.0) & (np.minimum(np.abs(before), np.abs(after)) > least)
    found: Floats = run.u[first[is_even & is_peak]]
    return found
