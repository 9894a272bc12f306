"""Matrices with a few non-zero entries in every row, as B-splines make them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats


@dataclass(frozen=True, eq=False)
class Banded:
    """A matrix (m, n) given by k entries a row; entries of the same column add up."""

    columns: NDArray[np.intp]
    """(m, k) the column of each entry"""
    entries: Floats
    """(m, k)"""
    width: int
    """n, the number of columns"""

    def __matmul__(self, rows: Floats) -> Floats:
        """(m, dim) the product with (n, dim), or (m,) with (n,).

        k products of m numbers: for hundreds of control lines much less than the dense m x n.
        """
        if rows.ndim == 1:
            product: Floats = np.einsum("mk,mk->m", self.entries, rows[self.columns])
        else:
            product = np.einsum("mk,mkd->md", self.entries, rows[self.columns])
        return product

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
