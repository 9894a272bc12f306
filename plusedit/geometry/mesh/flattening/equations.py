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

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.sheet import Indices, Sheet

LEAST_SHARE = 1e-9  # of a vertex's weights: a neighbor that counts less would be lost in rounding


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


def solution(
    sheet: Sheet, weights: Floats, pins: Pins, chart: Chart | None = None, column: int | None = None
) -> Floats:
    """(n, d) parameters of all vertices, those of unused ones zero.

    `weights` are (t, 3, 2) by corner, as of `flattening.weights`. There must be a pin, and every
    vertex must hang together with one. With a chart, d is 2, or 1 if a column of it is named.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.linalg import splu

    count, width = len(sheet.points), pins.places.shape[1]
    found = np.zeros((count, width))
    found[pins.vertices] = pins.places
    free = sheet.used.copy()
    free[pins.vertices] = False
    unknown = np.flatnonzero(free)
    if not len(unknown):
        return found
    rows, columns, values, known = _terms(sheet, weights, chart, column, width)
    sums = np.bincount(rows, np.abs(values), minlength=count)
    shares = np.maximum(np.abs(values) / sums[rows], LEAST_SHARE)
    values = np.copysign(shares, values)
    sums = np.bincount(rows, shares, minlength=count)
    right = _right_side(rows, shares, known, (count, width))
    number = np.full(count, -1)
    number[unknown] = np.arange(len(unknown))
    to_pinned = free[rows] & ~free[columns]
    at = rows[to_pinned]
    for axis in range(width):
        pulled = values[to_pinned] * found[columns[to_pinned], axis]
        right[:, axis] += np.bincount(at, pulled, minlength=count)
    inner = free[rows] & free[columns]
    diagonal = np.arange(len(unknown))
    entries = np.concatenate([-values[inner], sums[unknown]])
    places = (
        np.concatenate([number[rows[inner]], diagonal]),
        np.concatenate([number[columns[inner]], diagonal]),
    )
    matrix = coo_array((entries, places), shape=(len(unknown), len(unknown))).tocsc()
    # Rows are diagonally dominant: no pivots are needed, and an order that keeps the pattern
    # symmetric fills in least.
    factors = splu(
        matrix,
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True, "Equil": False},
    )
    solved = factors.solve(right[unknown])
    solved += factors.solve(right[unknown] - matrix @ solved)
    found[unknown] = solved
    return found


def _terms(
    sheet: Sheet, weights: Floats, chart: Chart | None, column: int | None, width: int
) -> tuple[Indices, Indices, Floats, Floats | None]:
    """Rows, columns and signed weights of all summands, and the shift that each adds (k, d)."""
    triangles = sheet.triangles
    rows = np.repeat(triangles.ravel(), 2)
    neighbors = np.stack([np.roll(triangles, -1, axis=1), np.roll(triangles, 1, axis=1)], axis=2)
    values = weights.ravel()
    if chart is None:
        return rows, neighbors.ravel(), values, None
    signs = np.stack([np.roll(chart.signs, -1, axis=1), np.roll(chart.signs, 1, axis=1)], axis=2)
    values = values * (chart.signs[:, :, None] * signs).ravel()
    shifts = np.stack([np.roll(chart.shifts, -1, axis=1), np.roll(chart.shifts, 1, axis=1)], axis=2)
    known = chart.signs[:, :, None, None] * (shifts - chart.shifts[:, :, None])
    known = known if column is None else known[..., column : column + 1]
    return rows, neighbors.ravel(), values, known.reshape(-1, width)


def _right_side(
    rows: Indices, shares: Floats, known: Floats | None, shape: tuple[int, int]
) -> Floats:
    """(n, d) what the shifts of the images pull at every vertex."""
    if known is None:
        return np.zeros(shape)
    moved = np.flatnonzero(known.any(axis=1))
    return np.stack(
        [
            np.bincount(rows[moved], shares[moved] * axis[moved], minlength=shape[0])
            for axis in known.T
        ],
        axis=1,
    )
