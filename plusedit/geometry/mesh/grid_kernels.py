"""Inner loops of the fast preview, eight numbers at a time. Imported on request only.

Planes come in a *table*, one row for each number, lengths in a unit and from an origin of the
table's own: in `spread` the spacing and the corner of the grid. What is summed over planes are
D = sum W G and N = sum W G L with their derivatives.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.compiling import compiled
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
)

Singles = NDArray[np.float32]

NUMBERS = 14
"""Rows of a table: c (2), 1 / (2 sigma^2) by u and by v, W, P (3), s A (3), s B (3)."""
EIGHT = 8  # planes or nodes worked on together
WIDTH = 64  # nodes in a row of a grid; four rows, of D and of N, follow each other
TAPS = 8  # nodes in a row that a place is interpolated from
MARGIN = 3  # nodes before the origin of a grid
DEGREE = 9  # of the weights as polynomials
ONE, TWO, ZERO = np.float32(1.0), np.float32(2.0), np.float32(0.0)


@compiled
def spread(
    table: Singles,
    count: int,
    depth: np.float32,
    width: int,
    height: int,
    work: Singles,
    grid: Singles,
) -> None:
    """Add D and N of the table's first planes at the nodes of a grid.

    A Gaussian is a product of one by u and one by v, so that a plane costs as many exponentials as
    its rectangle of nodes has columns and rows. Beyond exponents of -`depth` it is left out.
    """
    ramp = load(work, 0)
    gu, gv = 8, 8 + 2 * WIDTH
    margin, stride = np.float32(MARGIN), table.size // NUMBERS
    for i in range(count):
        cu, cv = table[i] + margin, table[stride + i] + margin
        ku, kv = table[2 * stride + i], table[3 * stride + i]
        half_u, half_v = np.sqrt(depth / ku), np.sqrt(depth / kv)
        left, right = max(0, int(np.ceil(cu - half_u))), min(width, int(cu + half_u) + 1)
        low, high = max(0, int(np.ceil(cv - half_v))), min(height, int(cv + half_v) + 1)
        if left >= right or low >= high:
            continue
        left &= ~7
        rate = same(-ku)
        for j in range(left, right, 8):
            d = plus(same(np.float32(j) - cu), ramp)
            g = exponential(times(times(d, d), rate))
            store(work, gu + j, g)
            store(work, gu + WIDTH + j, times(g, d))
        rate, weight = same(-kv), same(table[4 * stride + i])
        x, y, z = (
            same(table[5 * stride + i]),
            same(table[6 * stride + i]),
            same(table[7 * stride + i]),
        )
        ax, ay, az = (
            same(table[8 * stride + i]),
            same(table[9 * stride + i]),
            same(table[10 * stride + i]),
        )
        bx, by, bz = (
            same(table[11 * stride + i]),
            same(table[12 * stride + i]),
            same(table[13 * stride + i]),
        )
        for j in range(low & ~7, high, 8):
            d = plus(same(np.float32(j) - cv), ramp)
            g = times(weight, exponential(times(times(d, d), rate)))
            store(work, gv + j, g)
            store(work, gv + WIDTH + j, times(g, fused(d, bx, x)))
            store(work, gv + 2 * WIDTH + j, times(g, fused(d, by, y)))
            store(work, gv + 3 * WIDTH + j, times(g, fused(d, bz, z)))
            store(work, gv + 4 * WIDTH + j, times(g, ax))
            store(work, gv + 5 * WIDTH + j, times(g, ay))
            store(work, gv + 6 * WIDTH + j, times(g, az))
        for row in range(low, high):
            at_row = gv + row
            g, px, py = (
                same(work[at_row]),
                same(work[at_row + WIDTH]),
                same(work[at_row + 2 * WIDTH]),
            )
            pz, sx = same(work[at_row + 3 * WIDTH]), same(work[at_row + 4 * WIDTH])
            sy, sz = same(work[at_row + 5 * WIDTH]), same(work[at_row + 6 * WIDTH])
            for j in range(left, right, 8):
                a, b = load(work, gu + j), load(work, gu + WIDTH + j)
                at = 4 * WIDTH * row + j
                store(grid, at, fused(g, a, load(grid, at)))
                at += WIDTH
                store(grid, at, fused(px, a, fused(sx, b, load(grid, at))))
                at += WIDTH
                store(grid, at, fused(py, a, fused(sy, b, load(grid, at))))
                at += WIDTH
                store(grid, at, fused(pz, a, fused(sz, b, load(grid, at))))


@compiled
def gather(
    places: Floats,
    start: int,
    stop: int,
    origin: Floats,
    unit: float,
    rate: float,
    width: int,
    height: int,
    weights: Singles,
    work: Singles,
    grid: Singles,
    sums: Singles,
) -> None:
    """Add what the grid has at the places, interpolated, and its slopes times `rate` / unit."""
    steep = np.float32(rate / unit)
    for p in range(start, stop):
        tu, tv = (places[p, 0] - origin[0]) / unit, (places[p, 1] - origin[1]) / unit
        i, j = min(max(int(tu), 0), width - TAPS), min(max(int(tv), 0), height - TAPS)
        f, g = same(np.float32(tu - i)), same(np.float32(tv - j))
        wu, wv = load(weights, 0), load(weights, 0)
        du, dv = same(ZERO), same(ZERO)
        for d in range(1, DEGREE + 1):
            c = load(weights, 8 * d)
            du, dv = fused(du, f, wu), fused(dv, g, wv)
            wu, wv = fused(wu, f, c), fused(wv, g, c)
        store(work, 8, wv)
        store(work, 16, dv)
        for k in range(4):
            at = by_v = same(ZERO)
            for r in range(TAPS):
                row = load(grid, (4 * (j + r) + k) * WIDTH + i)
                at = fused(row, same(work[8 + r]), at)
                by_v = fused(row, same(work[16 + r]), by_v)
            sums[p, k] += total(times(wu, at))
            sums[p, 4 + k] += steep * total(times(du, at))
            sums[p, 8 + k] += steep * total(times(wu, by_v))


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
