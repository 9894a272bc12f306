"""Least squares for unknowns each of which meets only its neighbors, as on a B-spline.

Every row of the matrix M has few entries, in consecutive columns; on a closed curve those go on
from the last column to the first. The normal matrix M^T M + a I is then banded. It is cut into
blocks D_i that meet only the next one, by U_i, and eliminated block by block,

    S_0 = D_0,   S_i = D_i - U_{i-1}^T S_{i-1}^-1 U_{i-1},

in a time in proportion to the number of unknowns. On a closed curve the last few unknowns are
set apart first; without them the rest is open.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

RELUCTANCE = 1e-10  # a, of the largest diagonal entry: how unwillingly unknowns leave zero
DENSE_UP_TO = 96  # unknowns; fewer are solved faster in one piece
BLOCK = 16  # unknowns to a block, at least

Solver = Callable[[Floats], Floats]
Indices = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class LocalMatrix:
    """A matrix (m, count) of which every row has w entries in consecutive columns."""

    columns: Indices
    """(m, w); if `cyclic`, the first column follows the last"""
    entries: Floats
    """(m, w); entries of the same column add up"""
    count: int
    cyclic: bool = False

    def __matmul__(self, x: Floats) -> Floats:
        """(m, dim) the product with x (count, dim)."""
        product: Floats = np.einsum("mw,mwd->md", self.entries, x[self.columns])
        return product

    def transposed_times(self, y: Floats) -> Floats:
        """(count, dim) the product of the transpose with y (m, dim)."""
        places = self.columns.ravel()
        rows = [
            np.bincount(places, (self.entries * row[:, None]).ravel(), self.count) for row in y.T
        ]
        return np.stack(rows, axis=1)


def normal_solver(matrix: LocalMatrix, reluctance: float = RELUCTANCE) -> Solver:
    """The function that solves (M^T M + a I) x = y for y (count, dim).

    a is the `reluctance` times the largest diagonal entry.
    """
    rows, columns = np.broadcast_arrays(matrix.columns[:, :, None], matrix.columns[:, None, :])
    product = _Entries(
        rows.ravel(),
        columns.ravel(),
        (matrix.entries[:, :, None] * matrix.entries[:, None, :]).ravel(),
    )
    diagonal = product.sums(product.rows == product.columns, product.rows, matrix.count)
    damping = reluctance * (float(diagonal.max()) or 1.0)
    width = matrix.columns.shape[1]
    if matrix.count <= max(DENSE_UP_TO, 4 * width):
        inverse = np.linalg.inv(product.corner(0, 0, matrix.count, matrix.count, damping))
        return lambda y: inverse @ y
    size = max(BLOCK, width)
    if not matrix.cyclic:
        return _eliminated(product, matrix.count, size, damping)
    return _bordered(product, matrix.count - width, matrix.count, size, damping)


@dataclass(frozen=True, eq=False)
class _Entries:
    """Entries of a square matrix, any number of them at the same place."""

    rows: Indices
    columns: Indices
    values: Floats

    def sums(self, chosen: NDArray[np.bool_], places: Indices, count: int) -> Floats:
        """(count,) the sums of the chosen values by their places."""
        sums: Floats = np.bincount(places[chosen], self.values[chosen], count).astype(np.float64)
        return sums

    def corner(self, row: int, column: int, height: int, width: int, damping: float) -> Floats:
        """(height, width) the part that begins at `row` and `column`, damped on the diagonal."""
        down, across = self.rows - row, self.columns - column
        inside = (down >= 0) & (down < height) & (across >= 0) & (across < width)
        part = self.sums(inside, down * width + across, height * width).reshape(height, width)
        if row == column:
            part[np.diag_indices(min(part.shape))] += damping
        return part


def _eliminated(product: _Entries, count: int, size: int, damping: float) -> Solver:
    """The solver of the first `count` rows and columns, which are banded."""
    number = -(-count // size)
    block, beside = product.rows // size, product.columns // size - product.rows // size
    kept = (product.rows < count) & (product.columns < count) & (beside >= 0)
    place = (product.rows % size) * 2 * size + beside * size + product.columns % size
    entries = product.sums(kept, block * 2 * size**2 + place, number * 2 * size**2)
    blocks = entries.reshape(number, size, 2 * size)
    diagonal = np.arange(size)
    blocks[:, diagonal, diagonal] += damping
    inverses, gains = np.empty((number, size, size)), np.zeros((number, size, size))
    for i, (here, ahead) in enumerate(zip(blocks[:, :, :size], blocks[:, :, size:], strict=True)):
        reduced = here - blocks[i - 1, :, size:].T @ gains[i - 1] if i else here
        inverses[i] = np.linalg.inv(reduced)
        gains[i] = inverses[i] @ ahead

    def solve(y: Floats) -> Floats:
        flat = np.zeros((number * size, y.shape[1]))
        flat[:count] = y
        x = flat.reshape(number, size, -1)
        for i in range(1, number):
            x[i] -= gains[i - 1].T @ x[i - 1]
        x = inverses @ x
        for i in range(number - 2, -1, -1):
            x[i] -= gains[i] @ x[i + 1]
        solved: Floats = x.reshape(number * size, -1)[:count]
        return solved

    return solve


def _bordered(product: _Entries, inner: int, count: int, size: int, damping: float) -> Solver:
    """The solver of a cyclic matrix, of which the rows from `inner` on are set apart."""
    solve_inner = _eliminated(product, inner, size, damping)
    border = product.corner(0, inner, inner, count - inner, 0.0)
    reach = solve_inner(border)
    apart = product.corner(inner, inner, count - inner, count - inner, damping)
    inverse = np.linalg.inv(apart - border.T @ reach)

    def solve(y: Floats) -> Floats:
        alone = solve_inner(y[:inner])
        rest = inverse @ (y[inner:] - border.T @ alone)
        return np.concatenate([alone - reach @ rest, rest])

    return solve
