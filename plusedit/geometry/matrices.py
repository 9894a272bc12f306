"""Matrices with a few non-zero entries in every row, as B-splines make them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

WIDE = 48  # coordinates from which on BLAS is quicker
HEIGHT = 16  # rows that it is given at once


@dataclass(frozen=True, eq=False)
class Banded:
    """A matrix (m, n) given by k entries a row; entries of the same column add up.

    Best as transposes of contiguous (k, m) arrays: products go along the m.
    """

    columns: NDArray[np.intp]
    """(m, k) the column of each entry"""
    entries: Floats
    """(m, k)"""
    width: int
    """n, the number of columns"""

    def __matmul__(self, rows: Floats) -> Floats:
        """(m, dim) the product with (n, dim), or (m,) with (n,).

        k products of m numbers for each coordinate, one coordinate after the other in memory;
        or, of many coordinates, dense products of a few rows at a time.
        """
        if rows.ndim == 2 and rows.shape[1] >= WIDE:
            return self._by_parts(rows)
        columns, entries = self.columns.T, self.entries.T
        if rows.ndim == 1:
            product: Floats = np.einsum("km,km->m", entries, rows[columns])
            return product
        planar = np.take(np.ascontiguousarray(rows.T), columns, axis=1)
        product = np.einsum("km,dkm->dm", entries, planar)
        return product.T

    def _by_parts(self, rows: Floats) -> Floats:
        product = np.empty((len(self.entries), rows.shape[1]))
        for part, columns, few in self._parts:
            np.matmul(few, rows[columns], out=product[part])
        return product

    @cached_property
    def _parts(self) -> list[tuple[slice, slice, Floats]]:
        """Some rows each; of neighboring ones the entries lie together, so that few are zero."""
        parts = []
        for start in range(0, len(self.entries), HEIGHT):
            part = slice(start, start + HEIGHT)
            columns = self.columns[part]
            first, last = int(columns.min()), int(columns.max()) + 1
            few = Banded(columns - first, self.entries[part], last - first).dense()
            parts.append((part, slice(first, last), few))
        return parts

    dot = __matmul__  # as arrays have it, and for them it is the quicker of both

    def dense(self) -> Floats:
        """The same matrix as an array (m, n)."""
        matrix = np.zeros((len(self.entries), self.width))
        rows = np.arange(len(self.entries))
        for column, entry in zip(self.columns.T, self.entries.T, strict=True):
            matrix[rows, column] += entry
        return matrix


Matrix = Floats | Banded
"""What turns control data into points by `@`."""


def dense(matrix: Matrix) -> Floats:
    """The matrix as an array, whichever it is."""
    return matrix.dense() if isinstance(matrix, Banded) else matrix
