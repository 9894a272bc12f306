"""The terms that plus surfaces are made of, in single precision.

The products by v come first: they are of few rows. Those by u then add up long rows, (x, y, z)
after (x, y, z), which is what is drawn.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid, blend
from plusedit.geometry.matrices import dense
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.row_products import Singles, Taps, turned

CONTRAST = 1e4  # of weights: with more, what is lost in single precision could be seen
NUDGE = 0.05  # of the first step of a grid: how far beside a point the tangents are taken
POINT = 1e-9  # of the size of the surface: a border that short is a point

Bases = tuple[Basis, Basis]
Grids = tuple[Grid, Grid]
ORIGIN = np.zeros(3)
WHOLE = slice(None)


@dataclass(frozen=True, eq=False)
class BasisTaps:
    """B, D, and [B D] of a basis at the samples of a grid, or a derivative of them."""

    values: Taps
    reaches: Taps
    both: Taps


Part = tuple[int, int, int, int]
"""First and end of some samples, and of the control planes that reach them."""


@lru_cache(maxsize=48)
def basis_taps(
    basis: Basis, grid: Grid, derivative: int = 0, part: Part | None = None
) -> BasisTaps:
    """Those of all samples and planes, or of a part; the same object for equal arguments."""
    made = blend(basis, grid, derivative)
    values, reaches = dense(made.values), dense(made.reaches)
    if part is not None:
        first, end, lowest, beyond = part
        values, reaches = (each[first:end, lowest:beyond] for each in (values, reaches))
    return BasisTaps(Taps.of(values), Taps.of(reaches), Taps.of(np.hstack([values, reaches])))


@dataclass(frozen=True, eq=False)
class Terms:
    """What multiplies 1 and s, (m_u, 3 m_v) each, and what both are to be divided by."""

    base: Singles
    plus: Singles
    below: Singles | None
    """each number three times; None where all weights are one"""

    def divided(self) -> "Terms":
        """The terms of the points."""
        if self.below is None:
            return self
        return Terms(np.divide(self.base, self.below), np.divide(self.plus, self.below), self.below)

    def derived(self, at: "Terms") -> "Terms":
        """The terms of S_u = (A_u - w_u S) / w where these are A_u and w_u, and `at` S and w."""
        if self.below is None or at.below is None:
            return self
        base = np.divide(self.base - self.below * at.base, at.below)
        return Terms(base, np.divide(self.plus - self.below * at.plus, at.below), self.below)


@dataclass(frozen=True, eq=False)
class Nets:
    """Control planes, times their weights, (n_v, 3 n_u) each."""

    lines: Singles
    """(2 n_v, 3 n_u) first the points, then the directions by v"""
    along_u: Singles
    weights: Singles | None
    """each three times; None where all are one"""

    @classmethod
    def of(
        cls,
        bases: Bases,
        planes: ControlPlanes,
        *,
        s: float = 1.0,
        middle: Floats = ORIGIN,
        factor: float = 1.0,
        rows: slice = WHOLE,
    ) -> "Nets":
        """Directions times s, points measured from `middle`, and all lengths times `factor`.

        Of those `rows` of control planes only.
        """
        closed_u, closed_v = (basis.closed for basis in bases)
        points = planes.points[rows]
        along_u, along_v = planes.directions(closed_u=closed_u, closed_v=closed_v)[:, rows]
        weights = None
        if planes.weights is not None:
            shares = planes.unit_weights[rows, :, None]
            points, middle = shares * (points - middle), ORIGIN
            along_u, along_v = shares * along_u, shares * along_v
            weights = turned(np.repeat(shares, 3, axis=2), ORIGIN)
        count_u, count_v, _ = points.shape
        lines = np.empty((2 * count_v, 3 * count_u), dtype=np.float32)
        turned(points, middle, factor, out=lines[:count_v])
        turned(along_v, ORIGIN, factor * s, out=lines[count_v:])
        return cls(lines, turned(along_u, ORIGIN, factor * s), weights)

    @property
    def points(self) -> Singles:
        """(n_v, 3 n_u)"""
        return self.lines[: len(self.along_u)]

    @property
    def along_v(self) -> Singles:
        """(n_v, 3 n_u)"""
        return self.lines[len(self.along_u) :]

    def terms(self, by_u: BasisTaps, by_v: BasisTaps) -> Terms:
        """What multiplies 1 and s."""
        base = by_u.values.along(by_v.values.across(self.points))
        pulls = self._empty_lines(by_v)
        by_v.reaches.across(self.along_v, out=pulls[: len(pulls) // 2])
        by_v.values.across(self.along_u, out=pulls[len(pulls) // 2 :])
        plus = by_u.both.along(pulls)
        if self.weights is None:
            return Terms(base, plus, None)
        return Terms(base, plus, by_u.values.along(by_v.values.across(self.weights)))

    def lines_by_u(self, by_v: BasisTaps) -> Singles:
        """(2 n_u, 3 m_v) points, then directions, of the lines by u at the samples by v.

        Those times B and D are the numerator.
        """
        lines = self._empty_lines(by_v)
        by_v.both.across(self.lines, out=lines[: len(lines) // 2])
        by_v.values.across(self.along_u, out=lines[len(lines) // 2 :])
        return lines

    def _empty_lines(self, by_v: BasisTaps) -> Singles:
        rows = self.along_u.shape[1] // 3
        return np.empty((2 * rows, 3 * len(by_v.values)), dtype=np.float32)


def is_even(planes: ControlPlanes) -> bool:
    """Whether single precision will do for the weights."""
    return planes.weights is None or planes.unit_weights.min() * CONTRAST >= 1.0


def extent(planes: ControlPlanes) -> float:
    """The farthest that a coordinate of a control point is from that of the first of them."""
    return float(np.abs(planes.points - planes.points[0, 0]).max())


def beside_points(bases: Bases, planes: ControlPlanes, grids: Grids) -> Grids:
    """The grids for tangents: their ends moved inward where a border is drawn together to a point.

    A sphere has no tangents at its poles; those a little beside have nearly the normal there.
    """
    points, least = planes.points, POINT * extent(planes)
    by_u = _beside(bases[0], grids[0], (points[0], points[-1]), least)
    return by_u, _beside(bases[1], grids[1], (points[:, 0], points[:, -1]), least)


def _beside(basis: Basis, grid: Grid, borders: tuple[Floats, Floats], least: float) -> Grid:
    if basis.closed or len(grid) < 2:
        return grid
    first, last = (bool(np.abs(border - border[0]).max() <= least) for border in borders)
    return _nudged(grid, first, last) if first or last else grid


@lru_cache(maxsize=16)
def _nudged(grid: Grid, first: bool, last: bool) -> Grid:
    u = grid.parameters.copy()
    if first:
        u[0] += NUDGE * (u[1] - u[0])
    if last:
        u[-1] -= NUDGE * (u[-1] - u[-2])
    return Grid(u)
