"""Sums of rows, and cross products, in machine code that numba makes. Imported on request only.

Inner loops run along rows that lie in memory one number after another, four rows at a time:
that is what compiles to instructions on many numbers at once. One thread works here: for less
than half a millisecond of work a second one costs more than it gains.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.compiling import compiled, inlined

Columns = NDArray[np.intp]
Singles = NDArray[np.float32]

STRETCH = 768  # numbers of a row at a time: with those of its neighbors they stay in the cache
TILE = 16  # rows turned into columns at a time


@inlined
def combine(
    columns: Columns, entries: Singles, rows: Singles, start: int, stop: int, out: Singles
) -> None:
    """out = sum_k entries[k] rows[columns[k], start:stop]; the k are a multiple of four."""
    for k in range(0, len(columns), 4):
        a, b, c, d = entries[k], entries[k + 1], entries[k + 2], entries[k + 3]
        p, q = rows[columns[k]][start:stop], rows[columns[k + 1]][start:stop]
        r, s = rows[columns[k + 2]][start:stop], rows[columns[k + 3]][start:stop]
        if k == 0:
            for x in range(stop - start):
                out[x] = a * p[x] + b * q[x] + c * r[x] + d * s[x]
        else:
            for x in range(stop - start):
                out[x] += a * p[x] + b * q[x] + c * r[x] + d * s[x]


@compiled
def along(columns: Columns, entries: Singles, rows: Singles, out: Singles) -> None:
    """out (m, w) = M rows, for rows (n, w) and the matrix M (m, n) of those entries."""
    width = out.shape[1]
    for start in range(0, width, STRETCH):
        stop = min(start + STRETCH, width)
        for a in range(len(out)):
            combine(columns[a], entries[a], rows, start, stop, out[a][start:stop])


@compiled
def across(columns: Columns, entries: Singles, rows: Singles, out: Singles) -> None:
    """out (n, 3 m) = M rows turned round: out[i, 3 b + c] = (M rows)[b, 3 i + c]."""
    count, width = len(columns), rows.shape[1]
    tile = np.empty((TILE, width), rows.dtype)
    for start in range(0, count, TILE):
        stop = min(start + TILE, count)
        for b in range(start, stop):
            combine(columns[b], entries[b], rows, 0, width, tile[b - start])
        for i in range(len(out)):
            for b in range(start, stop):
                for c in range(3):
                    out[i, 3 * b + c] = tile[b - start, 3 * i + c]


@compiled
def turned(net: Floats, middle: Floats, factor: float, largest: float, out: Singles) -> None:
    """out (n_v, 3 n_u) = factor (net - middle), for a net (n_u, n_v, 3); no more than `largest`."""
    for i in range(net.shape[0]):
        for j in range(net.shape[1]):
            for c in range(3):
                value = factor * (net[i, j, c] - middle[c])
                out[j, 3 * i + c] = min(max(value, -largest), largest)


@compiled
def crossed(first: Singles, second: Singles, least: np.float32, out: Singles) -> None:
    """out (3 m,) = first x second as unit vectors; shorter where it is below `least`."""
    one = least / least
    for b in range(len(out) // 3):
        x = first[3 * b + 1] * second[3 * b + 2] - first[3 * b + 2] * second[3 * b + 1]
        y = first[3 * b + 2] * second[3 * b] - first[3 * b] * second[3 * b + 2]
        z = first[3 * b] * second[3 * b + 1] - first[3 * b + 1] * second[3 * b]
        factor = one / np.sqrt(max(x * x + y * y + z * z, least * least))
        out[3 * b], out[3 * b + 1], out[3 * b + 2] = x * factor, y * factor, z * factor
