"""Products of matrices with rows of numbers in single precision, for what is drawn.

The matrix of a local basis has few nonzero entries in each row; a product with it adds up that
many rows. Compiled loops do so several times faster than numpy, and without ever waiting for
another thread; matrices that are nearly full are better left to BLAS. The loops take numba a
while to load, and some seconds to compile when they are needed for the first time. So nothing
loads them unasked: before `load_kernels`, and without numba, BLAS does all of it.
"""

from dataclasses import dataclass
from functools import cache, cached_property
from importlib import import_module
from threading import Thread, main_thread
from types import ModuleType

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

Singles = NDArray[np.float32]

LARGEST = 1e30  # of what is drawn: what is calculated from it still fits single precision
NEGLIGIBLE = 1e-12  # of the largest entry of a matrix
FOUR = 4  # rows are added up four at a time
THREADLESS = 1 << 18  # multiplications up to which OpenBLAS works without a second thread
HEIGHT = 16  # rows for which a product with BLAS is at least made

_kernels: ModuleType | None = None


def load_kernels() -> bool:
    """Load the compiled loops, compile them if need be; whether they are there."""
    global _kernels
    if _kernels is None:
        try:
            kernels = import_module("plusedit.geometry.row_kernels")
        except ImportError:
            return False
        _try_out(kernels)
        _kernels = kernels
    return True


@cache
def load_kernels_in_background() -> Thread:
    """The same on a thread, the first time this is asked; till it is done BLAS makes products."""
    thread = Thread(target=load_kernels, name="kernels")
    thread.start()
    return thread


def _try_out(kernels: ModuleType) -> None:
    """Have everything compiled for the types that occur."""
    taps = Taps.of(np.eye(2))
    rows, out = np.ones((2, 6), dtype=np.float32), np.empty((2, 6), dtype=np.float32)
    calls = [
        (kernels.along, (taps.columns, taps.entries, rows, out)),
        (kernels.across, (taps.columns, taps.entries, rows, out)),
        (kernels.turned, (np.ones((2, 2, 3)), np.zeros(3), 1.0, LARGEST, out)),
        (kernels.crossed, (rows[0], rows[1], np.float32(1.0), out[0])),
    ]
    for kernel, arguments in calls:
        if not main_thread().is_alive():  # the program ends, and would wait for this
            return
        try:
            kernel(*arguments)
        except OSError:  # what was compiled could not be kept; it is there all the same
            kernel(*arguments)


@dataclass(frozen=True, eq=False)
class Taps:
    """A matrix (m, n) by its nonzero entries, the same number in each row."""

    columns: NDArray[np.intp]
    """(m, k) the column of each entry, k divisible by four"""
    entries: Singles
    """(m, k); some may be zero"""
    width: int
    """n"""

    @classmethod
    def of(cls, matrix: Floats) -> "Taps":
        """Those of a matrix given with its zeros."""
        needed = np.abs(matrix) > NEGLIGIBLE * np.abs(matrix).max(initial=0.0)
        rows, width = matrix.shape
        count = min(width, FOUR * -(-int(needed.sum(axis=1).max(initial=1)) // FOUR))
        first = np.argsort(~needed, axis=1, kind="stable")[:, :count]
        columns = np.zeros((rows, FOUR * -(-count // FOUR)), dtype=np.intp)
        entries = np.zeros(columns.shape, dtype=np.float32)
        columns[:, :count] = first
        entries[:, :count] = np.take_along_axis(matrix, first, axis=1)
        return cls(columns, entries, width)

    def __len__(self) -> int:
        return len(self.columns)

    @cached_property
    def matrix(self) -> Singles:
        """(m, n) with its zeros."""
        matrix = np.zeros((len(self), self.width), dtype=np.float32)
        rows = np.arange(len(self))
        for column, entry in zip(self.columns.T, self.entries.T, strict=True):
            matrix[rows, column] += entry
        return matrix

    @property
    def is_sparse(self) -> bool:
        """Whether adding up rows one by one is quicker than BLAS is with all of them."""
        return _kernels is not None and FOUR * self.columns.shape[1] <= self.width + 24

    def along(self, net: Singles, rows: slice = slice(None)) -> Singles:
        """(rows, w) those rows of the product with a net (n, w)."""
        columns, entries = self.columns[rows], self.entries[rows]
        out = np.empty((len(columns), net.shape[1]), dtype=np.float32)
        if _kernels is not None and self.is_sparse:
            _kernels.along(columns, entries, net, out)
        else:
            _by_blas(self.matrix[rows], net, out)
        return out

    def across(self, net: Singles, out: Singles | None = None) -> Singles:
        """(w / 3, 3 m) the product with a net (n, w), triples of numbers turned round."""
        if out is None:
            out = np.empty((net.shape[1] // 3, 3 * len(self)), dtype=np.float32)
        if _kernels is not None and self.is_sparse:
            _kernels.across(self.columns, self.entries, net, out)
        else:
            product = np.empty((len(self), net.shape[1]), dtype=np.float32)
            _by_blas(self.matrix, net, product)
            out.reshape(len(out), -1, 3)[...] = product.reshape(len(self), -1, 3).swapaxes(0, 1)
        return out


def turned(net: Floats, middle: Floats, factor: float = 1.0, out: Singles | None = None) -> Singles:
    """(n_v, 3 n_u) factor (net - middle) of a net (n_u, n_v, 3); cut where it is too large."""
    if out is None:
        out = np.empty((net.shape[1], 3 * net.shape[0]), dtype=np.float32)
    if _kernels is not None:
        _kernels.turned(net, middle, factor, LARGEST, out)
    else:
        moved = single(factor * (net - middle))
        out.reshape(net.shape[1], -1, 3)[...] = moved.swapaxes(0, 1)
    return out


def single(values: Floats) -> Singles:
    """The same in single precision; cut where that holds no such number."""
    return np.clip(values, -LARGEST, LARGEST).astype(np.float32)


def crossed(first: Singles, second: Singles, least: float, out: Singles) -> None:
    """out (m, w) = unit vectors of first x second, triples each; shorter where below `least`."""
    if _kernels is not None:
        _kernels.crossed(first.ravel(), second.ravel(), np.float32(least), out.reshape(-1))
        return
    x1, y1, z1 = np.ascontiguousarray(first.reshape(-1, 3).T)
    x2, y2, z2 = np.ascontiguousarray(second.reshape(-1, 3).T)
    across = np.stack([y1 * z2 - z1 * y2, z1 * x2 - x1 * z2, x1 * y2 - y1 * x2])
    length = np.sqrt((across * across).sum(axis=0))
    out.reshape(-1, 3)[...] = (across / np.maximum(length, np.float32(least))).T


def _by_blas(matrix: Singles, net: Singles, out: Singles) -> None:
    """out = matrix @ net in parts so small that no thread has to be waited for."""
    step = max(64, THREADLESS // (HEIGHT * max(1, len(net))))
    for top in range(0, len(matrix), HEIGHT):
        rows = slice(top, top + HEIGHT)
        for left in range(0, net.shape[1], step):
            columns = slice(left, left + step)
            np.matmul(matrix[rows], net[:, columns], out=out[rows, columns])
