"""The sums of the fast preview, by grids and plane by plane. Imported on request only.

See `preview` for the scheme.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.compiling import compiled
from plusedit.geometry.mesh.grid_kernels import (
    EIGHT,
    NUMBERS,
    TAPS,
    WIDTH,
    Singles,
    add,
    gather,
    spread,
)
from plusedit.geometry.mesh.tile_kernels import BLOCK, Counts, Scene, bounds_of, collect

FEW = 4  # places that choose together among the planes found for a block
TABLE = 512  # planes collected at a time


@compiled
def by_grids(scene: Scene, places: Floats, weights: Singles, rows: Counts, sums: Singles) -> None:
    """Add D, N and their slopes at the places of these tiles, by way of a grid for each."""
    box, near, stack = np.empty(4), np.empty(4), np.empty(160, np.int64)
    table = np.empty(NUMBERS * TABLE, np.float32)
    numbers = table.reshape(NUMBERS, TABLE)
    work = np.empty(9 * WIDTH + 16, np.float32)
    for k in range(8):
        work[k] = k
    grid = np.empty(4 * WIDTH * WIDTH, np.float32)
    whole = np.empty_like(grid)
    depth = np.float32(scene.numbers[1])
    for t in range(len(rows)):
        tree, start, stop = rows[t, 0], rows[t, 1], rows[t, 2]
        unit = scene.units[tree]
        bounds_of(places, start, stop, box)
        width = max(int(np.ceil((box[2] - box[0]) / unit)), 1) + TAPS - 1
        height = max(int(np.ceil((box[3] - box[1]) / unit)), 1) + TAPS - 1
        size = 4 * WIDTH * height
        whole[:size] = np.float32(0.0)
        # The margins of the grid, which are interpolated from, need no planes of their own: beyond
        # the box their values are what the planes collected for it give.
        stack[0], stack[-1] = -1, 0
        while True:
            count = collect(scene, tree, box, unit, near, stack, numbers)
            if count == 0:
                break
            # Some hundred planes are added up by themselves: sums of thousands one by one lose
            # digits with every step.
            grid[:size] = np.float32(0.0)
            spread(table, count, depth, width, height, work, grid)
            for k in range(size):
                whole[k] += grid[k]
        gather(
            places,
            start,
            stop,
            box,
            unit,
            scene.numbers[2],
            width,
            height,
            weights,
            work,
            whole,
            sums,
        )


@compiled
def one_by_one(scene: Scene, places: Floats, rows: Counts, sums: Singles) -> None:
    """The same without grids, for tiles with few places or planes."""
    box, near, stack = np.empty(4), np.empty(4), np.empty(160, np.int64)
    table = np.empty(NUMBERS * TABLE, np.float32)
    numbers = table.reshape(NUMBERS, TABLE)
    bounds, chosen = np.empty((TABLE // EIGHT, 6)), np.empty(TABLE // EIGHT, np.int64)
    few, unit, depth = np.empty(4), scene.numbers[2], scene.numbers[1]
    for t in range(len(rows)):
        tree, first, last = rows[t, 0], rows[t, 1], rows[t, 2]
        for start in range(first, last, BLOCK):
            stop = min(start + BLOCK, last)
            bounds_of(places, start, stop, box)
            stack[0], stack[-1] = -1, 0
            while True:
                count = collect(scene, tree, box, unit, near, stack, numbers)
                if count == 0:
                    break
                eights = bounds_of_eights(numbers, count, bounds)
                for begin in range(start, stop, FEW):
                    end = min(begin + FEW, stop)
                    bounds_of(places, begin, end, few)
                    for axis in range(2):
                        few[axis] = (few[axis] - box[axis]) / unit
                        few[axis + 2] = (few[axis + 2] - box[axis]) / unit
                    found = eights_near(bounds, eights, few, depth, chosen)
                    for p in range(begin, end):
                        u, v = (places[p, 0] - box[0]) / unit, (places[p, 1] - box[1]) / unit
                        add(u, v, table, chosen, found, sums[p])


@compiled
def bounds_of_eights(table: Singles, count: int, bounds: Floats) -> int:
    """Of every eight planes their box and the least 1 / (2 sigma^2); how many eights there are.

    The last eight are filled up with planes without weight.
    """
    eights = (count + EIGHT - 1) // EIGHT
    for i in range(count, EIGHT * eights):
        for row in range(NUMBERS):
            table[row, i] = table[row, count - 1] if row < 4 else np.float32(0.0)
    for k in range(eights):
        for axis in range(2):
            low = high = table[axis, EIGHT * k]
            widest = table[2 + axis, EIGHT * k]
            for i in range(EIGHT * k + 1, EIGHT * (k + 1)):
                low, high = min(low, table[axis, i]), max(high, table[axis, i])
                widest = min(widest, table[2 + axis, i])
            bounds[k, axis], bounds[k, 2 + axis], bounds[k, 4 + axis] = low, high, widest
    return eights


@compiled
def eights_near(bounds: Floats, count: int, box: Floats, depth: float, chosen: Counts) -> int:
    """The numbers of the eights of which some plane may reach the box; how many."""
    found = 0
    for k in range(count):
        du = max(max(box[0] - bounds[k, 2], bounds[k, 0] - box[2]), 0.0)
        dv = max(max(box[1] - bounds[k, 3], bounds[k, 1] - box[3]), 0.0)
        chosen[found] = k
        # Without a branch, of which every second would be foretold wrongly.
        found += 1 if du * du * bounds[k, 4] + dv * dv * bounds[k, 5] <= depth else 0
    return found


@compiled
def finish(
    sums: Singles,
    order: NDArray[np.intp],
    least: float,
    middle: Floats,
    size: float,
    points: Singles,
    normals: Singles,
    weak: NDArray[np.bool_],
) -> None:
    """Points and unit normals from the sums, in the order that the places were given in.

    Where D is below `least` nothing is written, and `weak` becomes true.
    """
    for p in range(len(order)):
        total = np.float64(sums[p, 0])
        to = order[p]
        if not total >= least:
            weak[to] = True
            continue
        # In double precision: products of tiny sums, as of steep slopes, are none of single.
        x, y, z = sums[p, 1] / total, sums[p, 2] / total, sums[p, 3] / total
        points[to, 0] = middle[0] + size * x
        points[to, 1] = middle[1] + size * y
        points[to, 2] = middle[2] + size * z
        rate_u, rate_v = sums[p, 4] / total, sums[p, 8] / total
        ax, bx = sums[p, 5] / total - x * rate_u, sums[p, 9] / total - x * rate_v
        ay, by = sums[p, 6] / total - y * rate_u, sums[p, 10] / total - y * rate_v
        az, bz = sums[p, 7] / total - z * rate_u, sums[p, 11] / total - z * rate_v
        nx, ny, nz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        length = np.sqrt(nx * nx + ny * ny + nz * nz)
        if length > 0.0:
            normals[to, 0], normals[to, 1] = nx / length, ny / length
            normals[to, 2] = nz / length
