"""Inner loops of the fast preview, eight numbers at a time. Imported on request only.

Planes come in a *table*, one row for each number, lengths in a unit and from an origin of the
table's own: for grids the spacing and the corner of the places. What is summed over planes are
D = sum W G and N = sum W G L with their derivatives. Of each row of a grid there are four, of D
and of N, after each other.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.compiling import compiled
from plusedit.geometry.mesh.interpolation import DEGREE, TAPS
from plusedit.geometry.mesh.lanes import (
    exponential,
    fused,
    load,
    minus,
    plus,
    same,
    store,
    times,
    total,
    totals,
)
from plusedit.geometry.mesh.spreading import AFTER, MARGIN, WIDTH

Singles = NDArray[np.float32]

NUMBERS = 14
"""Rows of a table: c (2), 1 / (2 sigma^2) by u and by v, W, P (3), s A (3), s B (3)."""
EIGHT = 8  # planes or nodes worked on together
TWO, ZERO = np.float32(2.0), np.float32(0.0)


@compiled
def gather(
    places: Floats,
    start: int,
    stop: int,
    origin: Floats,
    unit: float,
    rate: float,
    weights: Singles,
    work: Singles,
    grid: Singles,
    sums: Singles,
) -> None:
    """Add what the grid has at the places, interpolated, and its slopes times `rate` / unit."""
    steep = np.float32(rate / unit)
    for p in range(start, stop):
        tu, tv = (places[p, 0] - origin[0]) / unit, (places[p, 1] - origin[1]) / unit
        i, j = int(tu), int(tv)
        f, g = same(np.float32(tu - i)), same(np.float32(tv - j))
        i, j = i + MARGIN + 1 - AFTER, j + MARGIN + 1 - AFTER
        wu, wv = load(weights, 0), load(weights, 0)
        du, dv = same(ZERO), same(ZERO)
        for d in range(1, DEGREE + 1):
            c = load(weights, 8 * d)
            du, dv = fused(du, f, wu), fused(dv, g, wv)
            wu, wv = fused(wu, f, c), fused(wv, g, c)
        store(work, 8, wv)
        store(work, 16, dv)
        first = 4 * WIDTH * j + i
        s = x = y = z = sv = xv = yv = zv = same(ZERO)
        for r in range(TAPS):
            w, d = same(work[8 + r]), same(work[16 + r])
            row = load(grid, first)
            s, sv = fused(row, w, s), fused(row, d, sv)
            row = load(grid, first + WIDTH)
            x, xv = fused(row, w, x), fused(row, d, xv)
            row = load(grid, first + 2 * WIDTH)
            y, yv = fused(row, w, y), fused(row, d, yv)
            row = load(grid, first + 3 * WIDTH)
            z, zv = fused(row, w, z), fused(row, d, zv)
            first += 4 * WIDTH
        store(work, 24, totals(times(wu, s), times(wu, x), times(wu, y), times(wu, z)))
        store(work, 32, totals(times(du, s), times(du, x), times(du, y), times(du, z)))
        store(work, 40, totals(times(wu, sv), times(wu, xv), times(wu, yv), times(wu, zv)))
        for k in range(4):
            sums[p, k] += work[24 + k]
            sums[p, 4 + k] += steep * work[32 + k]
            sums[p, 8 + k] += steep * work[40 + k]


@compiled
def add(
    u: float, v: float, table: Singles, chosen: NDArray[np.int64], count: int, sums: Singles
) -> None:
    """Add D and N of some planes at one place, and their slopes, one by one.

    The first `count` of `chosen` are the numbers of eights of planes in the table.
    """
    stride = table.size // NUMBERS
    at_u, at_v, minus_two, floor = same(np.float32(u)), same(np.float32(v)), same(-TWO), same(ZERO)
    s = x = y = z = su = xu = yu = zu = sv = xv = yv = zv = same(ZERO)
    for k in range(count):
        i = EIGHT * chosen[k]
        du, dv = minus(at_u, load(table, i)), minus(at_v, load(table, stride + i))
        tu, tv = times(du, load(table, 2 * stride + i)), times(dv, load(table, 3 * stride + i))
        g = exponential(minus(floor, fused(du, tu, times(dv, tv))))
        g = times(g, load(table, 4 * stride + i))
        steep = times(minus_two, g)
        gu, gv = times(steep, tu), times(steep, tv)
        s, su, sv = plus(s, g), plus(su, gu), plus(sv, gv)
        a, b = load(table, 8 * stride + i), load(table, 11 * stride + i)
        value = fused(dv, b, fused(du, a, load(table, 5 * stride + i)))
        x = fused(g, value, x)
        xu, xv = fused(g, a, fused(gu, value, xu)), fused(g, b, fused(gv, value, xv))
        a, b = load(table, 9 * stride + i), load(table, 12 * stride + i)
        value = fused(dv, b, fused(du, a, load(table, 6 * stride + i)))
        y = fused(g, value, y)
        yu, yv = fused(g, a, fused(gu, value, yu)), fused(g, b, fused(gv, value, yv))
        a, b = load(table, 10 * stride + i), load(table, 13 * stride + i)
        value = fused(dv, b, fused(du, a, load(table, 7 * stride + i)))
        z = fused(g, value, z)
        zu, zv = fused(g, a, fused(gu, value, zu)), fused(g, b, fused(gv, value, zv))
    sums[0] += total(s)
    sums[1] += total(x)
    sums[2] += total(y)
    sums[3] += total(z)
    sums[4] += total(su)
    sums[5] += total(xu)
    sums[6] += total(yu)
    sums[7] += total(zu)
    sums[8] += total(sv)
    sums[9] += total(xv)
    sums[10] += total(yv)
    sums[11] += total(zv)
