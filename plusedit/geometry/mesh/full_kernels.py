"""Sums over the planes near a place, in machine code that numba makes. Imported on request only.

A block of neighboring places looks together for its planes: first for the least e that some plane
keeps below all over the block, then for all planes that come within 36 of it somewhere in the
block. These are collected a few hundred at a time, one number after another, and then every place
of the block goes through them. The least e that a place has found so far is taken off; where a
smaller one turns up, what has been summed is lowered accordingly.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.bend_kernels import add_bends, divide_bends
from plusedit.geometry.mesh.compiling import compiled, inlined

BLOCK = 16  # places
LEAF = 16  # planes
CHUNK = 256  # planes collected at a time
DEEPEST = 36.0
SMALLEST = -700.0  # exponent that a double still has a power for

CENTER, HALVES, HEIGHT, POINT, BY_U, BY_V, NUMBERS = 0, 2, 4, 5, 8, 11, 14
"""Rows of the table of planes: c, 1 / (2 sigma^2), W, P, s A, s B."""


@inlined
def exponential(y: float) -> float:
    """exp(y) for |y| <= 700, to 1e-14; unlike the library's it is done for many at once."""
    k = np.floor(y * 1.4426950408889634 + 0.5)
    r = y - k * 6.93145751953125e-1 - k * 1.42860682030941723212e-6
    p = 1 / 39916800 + r * (1 / 479001600)
    p = 1 / 3628800 + r * p
    p = 1 / 362880 + r * p
    p = 1 / 40320 + r * p
    p = 1 / 5040 + r * p
    p = 1 / 720 + r * p
    p = 1 / 120 + r * p
    p = 1 / 24 + r * p
    p = 1 / 6 + r * p
    p = 0.5 + r * p
    p = 1.0 + r * p
    p = 1.0 + r * p
    bits = (np.int64(k) + 1023) << 52
    return p * np.int64(bits).view(np.float64)  # type: ignore[no-any-return]


@compiled
def evaluate(
    places: Floats,
    boxes: Floats,
    largest: Floats,
    table: Floats,
    widths: Floats,
    shifts: Floats,
    signs: Floats,
    found: Floats,
) -> None:
    """found (m, 3, 9 or 18) = S and, if there is room, S_u, S_v and S_uu, S_uv, S_vv.

    At places (m, 2) in the cell. `boxes` and `largest` are those of the tree, `table` has the
    planes in its order, `widths` are S and the largest sigma by u and by v; `shifts` and `signs`
    are the images.
    """
    chunk, exponents = np.empty((NUMBERS, CHUNK)), np.empty(CHUNK)
    stack, box, near = np.empty(128, np.int64), np.empty(4), np.empty(4)
    sums = np.empty((BLOCK, 24 if found.shape[1] > 9 else 12))
    least, origin = np.empty(BLOCK), np.empty(3)
    leaves = len(largest) // 2
    for start in range(0, len(places), BLOCK):
        block = places[start : start + BLOCK]
        bounds_of(block, box)
        limit = np.inf
        for g in range(len(signs)):
            moved(box, shifts[g], signs[g], near)
            limit = everywhere_below(near, boxes, largest, table, widths, stack, limit, origin)
        sums[:] = 0.0
        least[:] = np.inf
        # Not the literal, for which all that follows would be compiled once more.
        count = min(0, leaves)
        for g in range(len(signs)):
            moved(box, shifts[g], signs[g], near)
            stack[0] = 1
            top = 1
            while top > 0:
                top -= 1
                node = stack[top]
                if lowest(boxes[node], near, largest[node], widths) > limit + DEEPEST:
                    continue
                if node < leaves:
                    stack[top] = 2 * node
                    stack[top + 1] = 2 * node + 1
                    top += 2
                    continue
                first = (node - leaves) * LEAF
                for i in range(first, min(first + LEAF, table.shape[1])):
                    du = apart(near[0], near[2], table[0, i])
                    dv = apart(near[1], near[3], table[1, i])
                    if du * du * table[2, i] + dv * dv * table[3, i] > limit + DEEPEST:
                        continue
                    take(table, i, shifts[g], signs[g], origin, chunk, count)
                    count += 1
                    if count == CHUNK:
                        absorb(block, chunk, count, exponents, sums, least, found.shape[1])
                        count = 0
        absorb(block, chunk, count, exponents, sums, least, found.shape[1])
        divide(sums, origin, found[start : start + BLOCK])


@compiled
def bounds_of(block: Floats, box: Floats) -> None:
    """box = least u, least v, largest u, largest v."""
    for axis in range(2):
        box[axis] = box[axis + 2] = block[0, axis]
        for p in range(1, len(block)):
            box[axis] = min(box[axis], block[p, axis])
            box[axis + 2] = max(box[axis + 2], block[p, axis])


@compiled
def moved(box: Floats, shift: Floats, sign: float, near: Floats) -> None:
    """near = the box brought from an image to the planes themselves."""
    for axis in range(2):
        if sign > 0.0:
            near[axis], near[axis + 2] = box[axis] - shift[axis], box[axis + 2] - shift[axis]
        else:
            near[axis], near[axis + 2] = shift[axis] - box[axis + 2], shift[axis] - box[axis]


@inlined
def apart(low: float, high: float, value: float) -> float:
    """How far a value is outside of an interval."""
    return max(max(low - value, value - high), 0.0)


@compiled
def halves_of(reach: float, widths: Floats, axis: int) -> float:
    """1 / (2 sigma^2) of the widest plane of a node."""
    sigma: float = min(widths[0] * reach, widths[1 + axis])
    return 0.5 / (sigma * sigma)


@compiled
def lowest(around: Floats, near: Floats, reach: float, widths: Floats) -> float:
    """No e of a plane with its center in a node's box is less anywhere in the block."""
    if reach == 0.0:
        return np.inf
    total = 0.0
    for axis in range(2):
        gap = max(max(near[axis] - around[axis + 2], around[axis] - near[axis + 2]), 0.0)
        total += gap * gap * halves_of(reach, widths, axis)
    return total


@compiled
def lowest_highest(around: Floats, near: Floats, reach: float, widths: Floats) -> float:
    """No plane with its center in a node's box has all its e in the block below that."""
    if reach == 0.0:
        return np.inf
    total = 0.0
    for axis in range(2):
        middle, width = 0.5 * (near[axis] + near[axis + 2]), 0.5 * (near[axis + 2] - near[axis])
        far = width + max(max(around[axis] - middle, middle - around[axis + 2]), 0.0)
        total += far * far * halves_of(reach, widths, axis)
    return total


@compiled
def everywhere_below(
    near: Floats,
    boxes: Floats,
    largest: Floats,
    table: Floats,
    widths: Floats,
    stack: NDArray[np.int64],
    limit: float,
    origin: Floats,
) -> float:
    """The least limit that the e of some plane keep all over the block; its P becomes the origin.

    `limit` and `origin` are those found before.
    """
    leaves = len(largest) // 2
    stack[0] = 1
    top = 1
    while top > 0:
        top -= 1
        node = stack[top]
        if lowest_highest(boxes[node], near, largest[node], widths) >= limit:
            continue
        if node < leaves:
            one, other = 2 * node, 2 * node + 1
            if lowest_highest(boxes[one], near, largest[one], widths) < lowest_highest(
                boxes[other], near, largest[other], widths
            ):
                one, other = other, one
            stack[top], stack[top + 1] = one, other
            top += 2
            continue
        first = (node - leaves) * LEAF
        for i in range(first, min(first + LEAF, table.shape[1])):
            du = max(abs(near[0] - table[0, i]), abs(near[2] - table[0, i]))
            dv = max(abs(near[1] - table[1, i]), abs(near[3] - table[1, i]))
            highest = du * du * table[2, i] + dv * dv * table[3, i]
            if highest < limit:
                limit = highest
                for c in range(3):
                    origin[c] = table[POINT + c, i]
    return limit


@compiled
def take(
    table: Floats, i: int, shift: Floats, sign: float, origin: Floats, chunk: Floats, j: int
) -> None:
    """Column j of the chunk is to be the image of plane i, with P measured from the origin."""
    for axis in range(2):
        chunk[axis, j] = sign * table[axis, i] + shift[axis]
    for row in range(HALVES, POINT):
        chunk[row, j] = table[row, i]
    for c in range(3):
        chunk[POINT + c, j] = table[POINT + c, i] - origin[c]
        chunk[BY_U + c, j] = sign * table[BY_U + c, i]
        chunk[BY_V + c, j] = sign * table[BY_V + c, i]


@compiled
def absorb(
    block: Floats,
    chunk: Floats,
    count: int,
    exponents: Floats,
    sums: Floats,
    least: Floats,
    width: int,
) -> None:
    """Add the first `count` planes of the chunk to the sums of every place of the block."""
    if count == 0:
        return
    for p in range(len(block)):
        u, v = block[p, 0], block[p, 1]
        lowest_here = np.inf
        for j in range(count):
            du, dv = u - chunk[0, j], v - chunk[1, j]
            exponents[j] = du * du * chunk[2, j] + dv * dv * chunk[3, j]
            lowest_here = min(lowest_here, exponents[j])
        if lowest_here < least[p]:
            lowered = np.exp(lowest_here - least[p])
            for k in range(sums.shape[1]):
                sums[p, k] *= lowered
            least[p] = lowest_here
        base = least[p]
        for j in range(count):
            exponents[j] = chunk[4, j] * exponential(max(base - exponents[j], SMALLEST))
        add_points(u, v, chunk, count, exponents, sums[p])
        if width > 3:
            add_slopes(u, v, chunk, count, exponents, sums[p])
        if width > 9:
            add_bends(u, v, chunk, count, exponents, sums[p])


@compiled
def add_points(u: float, v: float, chunk: Floats, count: int, shares: Floats, sums: Floats) -> None:
    """sums[0:4] += sum_j shares[j] (1, L_j)."""
    total = x = y = z = 0.0
    for j in range(count):
        share, du, dv = shares[j], u - chunk[0, j], v - chunk[1, j]
        total += share
        x += share * (chunk[5, j] + du * chunk[8, j] + dv * chunk[11, j])
        y += share * (chunk[6, j] + du * chunk[9, j] + dv * chunk[12, j])
        z += share * (chunk[7, j] + du * chunk[10, j] + dv * chunk[13, j])
    sums[0] += total
    sums[1] += x
    sums[2] += y
    sums[3] += z


@compiled
def add_slopes(u: float, v: float, chunk: Floats, count: int, shares: Floats, sums: Floats) -> None:
    """sums[4:12] += sum_j shares[j] (z_u, z_v, z_u L_j + s A_j, z_v L_j + s B_j), z = dG / G."""
    zu = zv = xu = yu = zzu = xv = yv = zzv = 0.0
    for j in range(count):
        share, du, dv = shares[j], u - chunk[0, j], v - chunk[1, j]
        by_u, by_v = -2.0 * du * chunk[2, j] * share, -2.0 * dv * chunk[3, j] * share
        x = chunk[5, j] + du * chunk[8, j] + dv * chunk[11, j]
        y = chunk[6, j] + du * chunk[9, j] + dv * chunk[12, j]
        z = chunk[7, j] + du * chunk[10, j] + dv * chunk[13, j]
        zu += by_u
        zv += by_v
        xu += by_u * x + share * chunk[8, j]
        yu += by_u * y + share * chunk[9, j]
        zzu += by_u * z + share * chunk[10, j]
        xv += by_v * x + share * chunk[11, j]
        yv += by_v * y + share * chunk[12, j]
        zzv += by_v * z + share * chunk[13, j]
    for k, term in enumerate((zu, zv, xu, yu, zzu, xv, yv, zzv)):
        sums[4 + k] += term


@compiled
def divide(sums: Floats, origin: Floats, found: Floats) -> None:
    """S = N / D and its derivatives (N' - S D') / D."""
    for p in range(len(found)):
        for c in range(3):
            share = sums[p, 1 + c] / sums[p, 0]
            found[p, c] = origin[c] + share
            if found.shape[1] > 3:
                found[p, 3 + c] = (sums[p, 6 + c] - share * sums[p, 4]) / sums[p, 0]
                found[p, 6 + c] = (sums[p, 9 + c] - share * sums[p, 5]) / sums[p, 0]
    if found.shape[1] > 9:
        divide_bends(sums, found)
