"""Every vertex a mean of its neighbors: the sparse equations of a map, and their solution.

With weights w_ij > 0 and parameters x_i the equations are

    sum_j w_ij (image_ij x_j - x_i) = 0     for every vertex i that is not pinned.

On a domain that closes, the neighbor across a cut is seen at an image, sign x_j + shift. A `Chart`
says for every corner at which image its triangle has the vertex; signs and shifts are the same for
u and v up to the shifts, so one factorization serves both.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.dissection import elimination_places
from plusedit.geometry.mesh.flattening.sheet import Flags, Indices, Sheet
from plusedit.geometry.mesh.maps import Progress, silent
from plusedit.geometry.mesh.polygons import Kind

LEAST_SHARE = 1e-9  # of a vertex's weights: a neighbor that counts less would be lost in rounding
HOPELESS = "the faces of the part are too different in shape and size for its map to be calculated"


class Pins(NamedTuple):
    """Vertices that stay where they are put."""

    vertices: Indices
    """(k,)"""
    places: Floats
    """(k, d)"""


@dataclass(frozen=True, eq=False)
class Chart:
    """At which image a triangle has the parameters of its vertices: sign x + shift."""

    signs: Floats
    """(t, 3)"""
    shifts: Floats
    """(t, 3, 2)"""

    @classmethod
    def trivial(cls, sheet: Sheet) -> "Chart":
        """The parameters themselves everywhere."""
        count = len(sheet.triangles)
        return cls(np.ones((count, 3)), np.zeros((count, 3, 2)))

    def move(self, corners: Indices, sign: float, shift: tuple[float, float]) -> None:
        """Give these corners another image; for a chart that is being made."""
        self.signs.reshape(-1)[corners] = sign
        self.shifts.reshape(-1, 2)[corners] = shift

    def places(self, sheet: Sheet, parameters: Floats) -> Floats:
        """(t, 3, 2) parameters by corner from those by vertex (n, 2)."""
        seen: Floats = self.signs[:, :, None] * parameters[sheet.triangles] + self.shifts
        return seen


class _Terms(NamedTuple):
    """The summands of all equations."""

    rows: Indices
    """(k,) the vertex in whose equation each stands"""
    columns: Indices
    """(k,) the neighbor"""
    factors: Floats
    """(k,) its weight, with the sign of the image"""
    pulls: Floats
    """(k, d) its weight times the shift of the image"""


def solution(
    sheet: Sheet,
    weights: Floats,
    pins: Pins,
    chart: Chart | None = None,
    *,
    column: int | None = None,
    order: Indices | None = None,
    progress: Progress = silent,
) -> Floats:
    """(n, d) parameters of all vertices, those of unused ones zero.

    `weights` are (t, 3, 2) by corner, as of `flattening.weights`. There must be a pin, and every
    vertex must hang together with one. With a chart, d is 2, or 1 if a column of it is named.
    `order` (n,) gives all vertices their places in the order of elimination, if they have any
    already. `progress` is told what of this is done.
    ValueError where the numbers of the part are too far apart to calculate with.
    """
    found = np.zeros((len(sheet.points), pins.places.shape[1]))
    found[pins.vertices] = pins.places
    free = sheet.used.copy()
    free[pins.vertices] = False
    unknown = np.flatnonzero(free)
    if not len(unknown):
        return found
    terms = _terms(sheet, weights, chart, column, found.shape[1])
    progress(0.1, "ordering the equations")
    inner = free[terms.rows] & free[terms.columns]
    number: Indices = np.cumsum(free) - 1
    rows, columns = number[terms.rows[inner]], number[terms.columns[inner]]
    if order is None:
        once = rows < columns
        places = elimination_places(sheet.points[unknown], rows[once], columns[once])
    else:
        places = np.argsort(np.argsort(order[unknown]))
    progress(0.4, "solving the equations")
    sums = np.bincount(terms.rows, np.abs(terms.factors), minlength=len(found))
    diagonal = np.arange(len(unknown))
    found[unknown] = _solved(
        np.concatenate([-terms.factors[inner], sums[unknown]]),
        np.concatenate([rows, diagonal]),
        np.concatenate([columns, diagonal]),
        _right_sides(terms, free, found)[unknown],
        places,
    )
    return found


def _right_sides(terms: _Terms, free: Flags, found: Floats) -> Floats:
    """(n, d) what images and the pinned vertices, at the places `found`, add to the equations."""
    outer = free[terms.rows] & ~free[terms.columns]
    pulls = terms.pulls
    pulls[outer] += terms.factors[outer, None] * found[terms.columns[outer]]
    moved = np.flatnonzero(pulls.any(axis=1))
    at, count = terms.rows[moved], len(found)
    sides = [np.bincount(at, pull[moved], minlength=count) for pull in pulls.T]
    return np.stack(sides, axis=1)


def _terms(
    sheet: Sheet, weights: Floats, chart: Chart | None, column: int | None, width: int
) -> _Terms:
    triangles, count = sheet.triangles, len(sheet.points)
    rows, columns = np.repeat(triangles.ravel(), 2), _beside(triangles).ravel()
    shares = (
        weights.ravel() / np.bincount(triangles.ravel(), weights.sum(axis=2).ravel(), count)[rows]
    )
    shares = np.maximum(shares, LEAST_SHARE)
    if chart is None:
        return _Terms(rows, columns, shares, np.zeros((len(rows), width)))
    factors = shares * (chart.signs[:, :, None] * _beside(chart.signs)).ravel()
    shifts = _beside(chart.shifts) - chart.shifts[:, :, None]
    shifts = (chart.signs[:, :, None, None] * shifts).reshape(-1, 2)
    shifts = shifts if column is None else shifts[:, column : column + 1]
    return _Terms(rows, columns, factors, shares[:, None] * shifts)


def _beside(values: NDArray[Kind]) -> NDArray[Kind]:
    """(t, 3, 2, ...) what the corners (t, 3, ...) after and before each have."""
    return np.stack([np.roll(values, -1, axis=1), np.roll(values, 1, axis=1)], axis=2)


def _solved(
    entries: Floats, rows: Indices, columns: Indices, right: Floats, places: Indices | None
) -> Floats:
    """(k, d) the solution of sparse equations in which every row is diagonally dominant.

    They are eliminated in the order of their places (k,), or in any if there are none.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.linalg import splu

    at = places if places is not None else np.arange(len(right))
    matrix = coo_array((entries, (at[rows], at[columns])), (len(right), len(right))).tocsc()
    moved = np.empty_like(right)
    moved[at] = right
    try:
        # Dominant diagonals need no pivots, and so the order may be the one that is filled least.
        factors = splu(
            matrix,
            permc_spec="MMD_AT_PLUS_A" if places is None else "NATURAL",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True, "Equil": False},
        )
    except RuntimeError:
        raise ValueError(HOPELESS) from None
    solved = factors.solve(moved)
    solved += factors.solve(moved - matrix @ solved)
    if not np.isfinite(solved).all():
        raise ValueError(HOPELESS)
    return np.asarray(solved[at], dtype=np.float64)
