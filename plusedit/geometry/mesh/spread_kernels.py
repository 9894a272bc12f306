"""Inner loops that bring planes to the nodes of a grid. Imported on request only.

Tables of planes and grids are those of `grid_kernels`; see `spreading` for the scheme.
"""

import numpy as np

from plusedit.geometry.mesh.compiling import compiled
from plusedit.geometry.mesh.grid_kernels import NUMBERS, Singles
from plusedit.geometry.mesh.lanes import exponential, fused, load, minus, plus, same, store, times
from plusedit.geometry.mesh.spreading import (
    AFTER,
    BEFORE,
    BINS,
    DEGREE,
    GUARD,
    MARGIN,
    ROW,
    TAPS,
    WIDTH,
)

SET = ROW * (DEGREE + 1)  # coefficients of one sigma
RAMP = 8  # numbers at the start of the work room: 0 to 7
HALF, ZERO = np.float32(0.5), np.float32(0.0)


@compiled
def spread(
    table: Singles,
    count: int,
    least: np.float32,
    bins: np.float32,
    weights: Singles,
    width: int,
    height: int,
    work: Singles,
    grid: Singles,
) -> None:
    """Add D and N of the table's first planes at the nodes of a grid, as they are before a blur.

    `least`, `bins` and `weights` are those of `Spreading`. The slope of the sum of lesser Gaussians
    by its center, times sigma^2, is the Gaussian times the way from there.
    """
    stride = table.size // NUMBERS
    low, past = GUARD + BEFORE, GUARD + TAPS - BEFORE
    high_u, high_v = width - past, height - past
    for i in range(count):
        cu, cv = table[i] + np.float32(MARGIN), table[stride + i] + np.float32(MARGIN)
        if not (cu >= low and cv >= low and cu < high_u and cv < high_v):
            continue
        square = HALF / table[2 * stride + i]
        place = (np.sqrt(square) - least) * bins
        chosen = min(max(int(place), 0), BINS - 1)
        share = same(place - np.float32(chosen))
        ju, jv = int(cu), int(cv)
        fu, fv = same(cu - np.float32(ju)), same(cv - np.float32(jv))
        at = SET * chosen
        first, second = load(weights, at), load(weights, at + 8)
        wu0 = wv0 = fused(share, minus(load(weights, at + SET), first), first)
        wu1 = wv1 = fused(share, minus(load(weights, at + SET + 8), second), second)
        du0 = du1 = dv0 = dv1 = same(ZERO)
        for _ in range(DEGREE):
            at += ROW
            first, second = load(weights, at), load(weights, at + 8)
            first = fused(share, minus(load(weights, at + SET), first), first)
            second = fused(share, minus(load(weights, at + SET + 8), second), second)
            du0, du1 = fused(du0, fu, wu0), fused(du1, fu, wu1)
            dv0, dv1 = fused(dv0, fv, wv0), fused(dv1, fv, wv1)
            wu0, wu1 = fused(wu0, fu, first), fused(wu1, fu, second)
            wv0, wv1 = fused(wv0, fv, first), fused(wv1, fv, second)
        weight = table[4 * stride + i]
        scaled, to = square * weight, RAMP
        store(work, to, times(same(weight), wv0))
        store(work, to + 8, times(same(weight), wv1))
        for k in range(3):
            p, a = (
                same(weight * table[(5 + k) * stride + i]),
                same(scaled * table[(8 + k) * stride + i]),
            )
            b = same(scaled * table[(11 + k) * stride + i])
            to += 2 * ROW
            store(work, to - ROW, fused(p, wv0, times(b, dv0)))
            store(work, to - ROW + 8, fused(p, wv1, times(b, dv1)))
            store(work, to, times(a, wv0))
            store(work, to + 8, times(a, wv1))
        at = 4 * WIDTH * (jv - BEFORE) + ju - BEFORE
        for row in range(RAMP, RAMP + TAPS):
            g = same(work[row])
            store(grid, at, fused(g, wu0, load(grid, at)))
            store(grid, at + 8, fused(g, wu1, load(grid, at + 8)))
            for k in range(3):
                to = at + (k + 1) * WIDTH
                p, a = same(work[row + (2 * k + 1) * ROW]), same(work[row + (2 * k + 2) * ROW])
                store(grid, to, fused(p, wu0, fused(a, du0, load(grid, to))))
                store(grid, to + 8, fused(p, wu1, fused(a, du1, load(grid, to + 8))))
            at += 4 * WIDTH


@compiled
def spread_directly(
    table: Singles,
    count: int,
    depth: np.float32,
    width: int,
    height: int,
    work: Singles,
    grid: Singles,
) -> None:
    """Add D and N of the table's first planes at the nodes of a grid that is not blurred.

    A Gaussian is a product of one by u and one by v, so that a plane costs as many exponentials as
    its rectangle of nodes has columns and rows. Beyond exponents of -`depth` it is left out.
    """
    edge = MARGIN - AFTER
    width, height = width - edge, height - edge
    ramp = load(work, 0)
    gu, gv = 8, 8 + 2 * WIDTH
    margin, stride = np.float32(MARGIN), table.size // NUMBERS
    for i in range(count):
        cu, cv = table[i] + margin, table[stride + i] + margin
        ku, kv = table[2 * stride + i], table[3 * stride + i]
        half_u, half_v = np.sqrt(depth / ku), np.sqrt(depth / kv)
        left, right = max(edge, int(np.ceil(cu - half_u))), min(width, int(cu + half_u) + 1)
        low, high = max(edge, int(np.ceil(cv - half_v))), min(height, int(cv + half_v) + 1)
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
def blurred(
    radius: int,
    weights: Singles,
    edge: int,
    width: int,
    height: int,
    between: Singles,
    grid: Singles,
) -> None:
    """Blur a grid but for some nodes at each edge, which are left as they are or worse.

    `weights` are those of a node and of the `radius` nodes to either side of it.
    """
    row, side = 4 * WIDTH, max(GUARD, edge - radius)
    # Down each column, so that what the next row needs is at hand.
    for j in range(side, width - side, 8):
        for r in range(edge, height - edge):
            blur_at(row * r + j, row, radius, weights, grid, between)
    for r in range(edge, height - edge):
        for j in range(edge, width - edge, 8):
            blur_at(row * r + j, 1, radius, weights, between, grid)


@compiled
def blur_at(
    at: int, step: int, radius: int, weights: Singles, source: Singles, target: Singles
) -> None:
    """Blur D and N of eight nodes in a row along steps of so many numbers, from grid to grid."""
    w = same(weights[0])
    x_at, y_at, z_at = at + WIDTH, at + 2 * WIDTH, at + 3 * WIDTH
    s, x = times(w, load(source, at)), times(w, load(source, x_at))
    y, z = times(w, load(source, y_at)), times(w, load(source, z_at))
    for t in range(1, radius + 1):
        w, away = same(weights[t]), step * t
        s = fused(w, plus(load(source, at - away), load(source, at + away)), s)
        x = fused(w, plus(load(source, x_at - away), load(source, x_at + away)), x)
        y = fused(w, plus(load(source, y_at - away), load(source, y_at + away)), y)
        z = fused(w, plus(load(source, z_at - away), load(source, z_at + away)), z)
    store(target, at, s)
    store(target, x_at, x)
    store(target, y_at, y)
    store(target, z_at, z)
