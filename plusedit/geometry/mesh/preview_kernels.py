"""The sums of the fast preview, by grids and plane by plane. Imported on request only.

See `preview` for the scheme.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.compiling import compiled
from plusedit.geometry.mesh.grid_kernels import EIGHT, NUMBERS, Singles, add, gather
from plusedit.geometry.mesh.spread_kernels import RAMP, blurred, spread, spread_directly
from plusedit.geometry.mesh.spreading import AFTER, MARGIN, WIDTH
from plusedit.geometry.mesh.tile_kernels import (
    BLOCK,
    LEAF,
    Counts,
    Scene,
    bounds_of,
    collect,
    grid_size,
)

FEW = 4  # places that choose together among the planes found for a block
TABLE = 512  # planes collected at a time
LONG_TABLE = 1024  # the same, for a grid
MANY = 256  # planes, from which on they are added up by themselves


@compiled
def by_grids(scene: Scene, places: Floats, weights: Singles, rows: Counts, sums: Singles) -> None:
    """Add D, N and their slopes at the places of these tiles, by way of a grid for each."""
    box = np.empty(4)
    work = np.empty(9 * WIDTH + RAMP, np.float32)
    for k in range(RAMP):
        work[k] = k
    grid = np.empty(4 * WIDTH * WIDTH, np.float32)
    between = np.empty_like(grid)
    for t in range(len(rows)):
        group, start, stop = rows[t, 0], rows[t, 1], rows[t, 2]
        unit = scene.units[group]
        bounds_of(places, start, stop, box)
        width, height = grid_size((box[2] - box[0]) / unit), grid_size((box[3] - box[1]) / unit)
        grid[: 4 * WIDTH * height] = np.float32(0.0)
        between[: 4 * WIDTH * height] = np.float32(0.0)
        if fill(scene, group, box, width, height, work, between, grid):
            rate = scene.numbers[2]
            gather(places, start, stop, box, unit, rate, weights, work, grid, sums)


@compiled
def fill(
    scene: Scene,
    group: int,
    box: Floats,
    width: int,
    height: int,
    work: Singles,
    between: Singles,
    grid: Singles,
) -> bool:
    """Bring the planes of a group to a grid that is zero; whether there are any.

    The margins of the grid need no planes of their own: beyond the box their values are what the
    planes found for it give.
    """
    near, stack = np.empty(4), np.empty(160, np.int64)
    table = np.empty(NUMBERS * LONG_TABLE, np.float32)
    numbers = table.reshape(NUMBERS, LONG_TABLE)
    size = 4 * WIDTH * height
    known, unit, depth = scene.spreading, scene.units[group], np.float32(scene.numbers[1])
    first, last = scene.groups[group, 0], scene.groups[group, 1]
    filled = False
    # Blurs come first: they are for all that is on the grid.
    for direct in (False, True):
        for tree in range(last - 1, first - 1, -1):
            step = tree - first
            stack[0], stack[-1] = -1, 0
            while scene.capped[tree] == direct and stack[-1] < len(scene.signs):
                count = collect(scene, tree, box, unit, near, stack, numbers, 0)
                filled = filled or count > 0
                if direct:
                    spread_directly(table, count, depth, width, height, work, grid)
                    continue
                least, bins, weights = known.least[step], known.bins[step], known.weights[step]
                if count < MANY:
                    spread(table, count, least, bins, weights, width, height, work, grid)
                    continue
                # Sums of thousands one by one lose digits with every step.
                between[:size] = np.float32(0.0)
                spread(table, count, least, bins, weights, width, height, work, between)
                for k in range(size):
                    grid[k] += between[k]
            if filled and not direct:
                radius, edge = known.radii[step, 0], MARGIN - AFTER - known.radii[step, 1]
                blurred(radius, known.blurs[step], edge, width, height, between, grid)
    return filled


@compiled
def one_by_one(scene: Scene, places: Floats, rows: Counts, sums: Singles) -> None:
    """The same without grids, for tiles with few places or planes."""
    box, near, stack = np.empty(4), np.empty(4), np.empty(160, np.int64)
    table = np.empty(NUMBERS * TABLE, np.float32)
    numbers = table.reshape(NUMBERS, TABLE)
    bounds, chosen = np.empty((TABLE // EIGHT, 6)), np.empty(TABLE // EIGHT, np.int64)
    few, unit, depth = np.empty(4), scene.numbers[2], scene.numbers[1]
    for t in range(len(rows)):
        group, first, last = rows[t, 0], rows[t, 1], rows[t, 2]
        for start in range(first, last, BLOCK):
            stop = min(start + BLOCK, last)
            bounds_of(places, start, stop, box)
            count, tree = 0, scene.groups[group, 0]
            stack[0], stack[-1] = -1, 0
            while tree < scene.groups[group, 1]:
                count = collect(scene, tree, box, unit, near, stack, numbers, count)
                if stack[-1] == len(scene.signs):
                    tree += 1
                    stack[0], stack[-1] = -1, 0
                    if tree < scene.groups[group, 1] and count <= TABLE - LEAF:
                        continue
                eights = bounds_of_eights(numbers, count, bounds)
                count = 0
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
