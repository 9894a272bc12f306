"""Loops that look for planes near places, and for places near each other. Imported on request only.

A *tile* is a row of neighboring places together with the planes of one tree that reach them.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.compiling import compiled
from plusedit.geometry.mesh.grid_kernels import Singles
from plusedit.geometry.mesh.spreading import MARGIN, WIDTH, Spreading

Counts = NDArray[np.int64]

LEAF = 16  # planes
BLOCK = 64  # places that look for their planes together where no grid is used
DEEPEST_LEVEL = 104  # bits in the order of places
COLUMNS = 6
"""Of the list of tiles: group of trees, first place and the one after the last, leaves of planes, 1
if a grid may be used, and how many nodes that has at most, margins included."""


class Scene(NamedTuple):
    """Planes and what of them depends on the smoothness."""

    counts: Counts
    """(trees, 4) of each its first node, its leaves, its first plane, its planes"""
    boxes: Floats
    """(nodes, 4)"""
    node_halves: Floats
    """(nodes, 2) 1 / (2 sigma^2) of the widest plane below, by u and by v"""
    centers: Floats
    """(n, 2)"""
    halves: Floats
    """(n, 2) 1 / (2 sigma^2)"""
    heights: Singles
    """(n,) what planes taken for narrower than they are count more"""
    values: Singles
    """(n, 10) W, P, A, B for a scale of u and v"""
    groups: Counts
    """(groups, 2) of trees that share their grids the first, and the one after the last"""
    units: Floats
    """(groups,) the spacing of grids"""
    capped: NDArray[np.bool_]
    """(trees,) whether some sigma is cut down to its cap, and grids are not blurred"""
    spreading: Spreading
    shifts: Floats
    """(images, 2)"""
    signs: Floats
    """(images,)"""
    images: NDArray[np.bool_]
    """(trees, images) which may matter at all"""
    numbers: Floats
    """s, the depth (a plane counts where its exponent is above minus that), the scale"""


@compiled
def bring(box: Floats, shifts: Floats, signs: Floats, image: int, near: Floats) -> None:
    """near = the box brought from an image to the planes themselves."""
    for axis in range(2):
        shift = shifts[image, axis]
        if signs[image] > 0.0:
            near[axis], near[axis + 2] = box[axis] - shift, box[axis + 2] - shift
        else:
            near[axis], near[axis + 2] = shift - box[axis + 2], shift - box[axis]


@compiled
def next_leaf(
    boxes: Floats,
    halves: Floats,
    first: int,
    leaves: int,
    depth: float,
    near: Floats,
    stack: Counts,
) -> int:
    """The next leaf of which some plane may reach the box, or -1; stack[0] is its height."""
    top = stack[0]
    low_u, low_v, high_u, high_v = near[0], near[1], near[2], near[3]
    while top > 0:
        node = stack[top]
        top -= 1
        i = first + node
        du = max(max(low_u - boxes[i, 2], boxes[i, 0] - high_u), 0.0)
        dv = max(max(low_v - boxes[i, 3], boxes[i, 1] - high_v), 0.0)
        if not du * du * halves[i, 0] + dv * dv * halves[i, 1] <= depth:
            continue
        if node >= leaves:
            stack[0] = top
            leaf: int = node - leaves
            return leaf
        stack[top + 1], stack[top + 2] = 2 * node, 2 * node + 1
        top += 2
    stack[0] = top
    return -1


@compiled
def collect(
    scene: Scene,
    tree: int,
    box: Floats,
    unit: float,
    near: Floats,
    stack: Counts,
    table: Singles,
    filled: int,
) -> int:
    """Add planes that reach the box to those in the table, relative to its corner; how many then.

    The last of the stack is the image that is being looked through, and is left there for the next
    call, if the table is full; with all images looked through it is their number.
    """
    boxes, node_halves, centers, halves = (
        scene.boxes,
        scene.node_halves,
        scene.centers,
        scene.halves,
    )
    heights, values, signs, shifts = scene.heights, scene.values, scene.signs, scene.shifts
    magnitude, depth, scale = scene.numbers[0], scene.numbers[1], scene.numbers[2]
    first_node, leaves = scene.counts[tree, 0], scene.counts[tree, 1]
    first, count = scene.counts[tree, 2], scene.counts[tree, 3]
    room, last = table.shape[1], len(stack) - 1
    for image in range(stack[last], len(signs)):
        stack[last] = image
        if not scene.images[tree, image]:
            continue
        if stack[0] == -1:
            stack[0], stack[1] = 1, 1
        bring(box, shifts, signs, image, near)
        sign, along, across = signs[image], shifts[image, 0] - box[0], shifts[image, 1] - box[1]
        pull = np.float32(sign * magnitude * unit / scale)
        while True:
            if filled > room - LEAF:
                return filled
            leaf = next_leaf(boxes, node_halves, first_node, leaves, depth, near, stack)
            if leaf < 0:
                break
            for i in range(first + leaf * LEAF, first + min(leaf * LEAF + LEAF, count)):
                u, v = centers[i, 0], centers[i, 1]
                du = max(max(near[0] - u, u - near[2]), 0.0)
                dv = max(max(near[1] - v, v - near[3]), 0.0)
                if du * du * halves[i, 0] + dv * dv * halves[i, 1] > depth:
                    continue
                table[0, filled] = (sign * u + along) / unit
                table[1, filled] = (sign * v + across) / unit
                table[2, filled] = halves[i, 0] * unit * unit
                table[3, filled] = halves[i, 1] * unit * unit
                table[4, filled] = values[i, 0] * heights[i]
                for c in range(3):
                    table[5 + c, filled] = values[i, 1 + c]
                    table[8 + c, filled] = values[i, 4 + c] * pull
                    table[11 + c, filled] = values[i, 7 + c] * pull
                filled += 1
        stack[0] = -1
    stack[last] = len(signs)
    return filled


@compiled
def leaves_near(
    scene: Scene, tree: int, box: Floats, near: Floats, stack: Counts, most: int
) -> int:
    """How many leaves, of all images, may reach the box; no more are counted than `most`."""
    found = 0
    boxes, halves, depth = scene.boxes, scene.node_halves, scene.numbers[1]
    first, leaves = scene.counts[tree, 0], scene.counts[tree, 1]
    for image in range(len(scene.signs)):
        if not scene.images[tree, image]:
            continue
        bring(box, scene.shifts, scene.signs, image, near)
        stack[0], stack[1] = 1, 1
        while found < most and next_leaf(boxes, halves, first, leaves, depth, near, stack) >= 0:
            found += 1
    return found


@compiled
def tiles(
    scene: Scene,
    codes: NDArray[np.uint64],
    low: Floats,
    extent: float,
    most: int,
    out: Counts,
) -> int:
    """List the tiles, no larger than a grid may be or of at most so many places; their number.

    `codes` (m, 2) are the bits of the places in their order, and `low` and `extent` the square
    that they divide. Of more tiles than `out` has rows only the number is told.
    """
    box, near, stack = np.empty(4), np.empty(4), np.empty(160, np.int64)
    ranges, corners = np.empty((256, 3), np.int64), np.empty((256, 2))
    found = 0
    for group in range(len(scene.units)):
        unit = scene.units[group]
        side = unit * (WIDTH - 2 * MARGIN - 2)
        ranges[0, 0], ranges[0, 1], ranges[0, 2] = 0, len(codes), 0
        corners[0, 0], corners[0, 1] = low[0], low[1]
        waiting = 1
        while waiting > 0:
            waiting -= 1
            start, stop, level = ranges[waiting, 0], ranges[waiting, 1], ranges[waiting, 2]
            u, v = corners[waiting, 0], corners[waiting, 1]
            # v is halved first.
            side_u, side_v = extent * 0.5 ** (level // 2), extent * 0.5 ** ((level + 1) // 2)
            box[0], box[1], box[2], box[3] = u, v, u + side_u, v + side_v
            fits = side_u <= side and side_v <= side
            small = fits or stop - start <= most or level >= DEEPEST_LEVEL
            planes = 0
            for tree in range(scene.groups[group, 0], scene.groups[group, 1]):
                if small or planes == 0:
                    most_here = 1 << 30 if small else 1
                    planes += leaves_near(scene, tree, box, near, stack, most_here)
            if planes == 0:
                continue
            if small:
                if found < len(out):
                    out[found, 0], out[found, 1] = group, start
                    out[found, 2], out[found, 3] = stop, planes
                    out[found, 4] = 1 if fits else 0
                    out[found, 5] = grid_size(side_u / unit) * grid_size(side_v / unit)
                found += 1
                continue
            split = first_upper(codes, start, stop, level)
            over_u, over_v = (0.0, 0.5 * side_v) if level % 2 == 0 else (0.5 * side_u, 0.0)
            if split < stop:
                ranges[waiting, 0], ranges[waiting, 1], ranges[waiting, 2] = split, stop, level + 1
                corners[waiting, 0], corners[waiting, 1] = u + over_u, v + over_v
                waiting += 1
            if split > start:
                ranges[waiting, 0], ranges[waiting, 1], ranges[waiting, 2] = start, split, level + 1
                corners[waiting, 0], corners[waiting, 1] = u, v
                waiting += 1
    return found


@compiled
def grid_size(extent: float) -> int:
    """How many nodes a grid has in a row, where places are so many nodes wide."""
    return int(min(extent, 1e6)) + 2 * MARGIN + 2


@compiled
def first_upper(codes: NDArray[np.uint64], start: int, stop: int, level: int) -> int:
    """The first place in the upper half, where those from start to stop are halved at a level."""
    column = level // (DEEPEST_LEVEL // 2)
    place = np.uint64(DEEPEST_LEVEL // 2 - 1 - level % (DEEPEST_LEVEL // 2))
    while start < stop:
        middle = (start + stop) // 2
        if (codes[middle, column] >> place) & np.uint64(1):
            stop = middle
        else:
            start = middle + 1
    return start


@compiled
def bounds_of(places: Floats, start: int, stop: int, box: Floats) -> None:
    """box = least u, least v, largest u, largest v."""
    for axis in range(2):
        box[axis] = box[axis + 2] = places[start, axis]
        for p in range(start + 1, stop):
            box[axis] = min(box[axis], places[p, axis])
            box[axis + 2] = max(box[axis + 2], places[p, axis])


@compiled
def blocks(codes: NDArray[np.uint64], most: int, out: Counts) -> int:
    """(k, 2) rows of at most so many places in squares or halves of squares; how many there are.

    Of more than `out` has rows only the number is told.
    """
    ranges = np.empty((256, 3), np.int64)
    ranges[0, 0], ranges[0, 1], ranges[0, 2] = 0, len(codes), 0
    waiting, found = 1, 0
    while waiting > 0:
        waiting -= 1
        start, stop, level = ranges[waiting, 0], ranges[waiting, 1], ranges[waiting, 2]
        if start == stop:
            continue
        if stop - start <= most or level >= DEEPEST_LEVEL:
            if found < len(out):
                out[found, 0], out[found, 1] = start, stop
            found += 1
            continue
        split = first_upper(codes, start, stop, level)
        ranges[waiting, 0], ranges[waiting, 1], ranges[waiting, 2] = split, stop, level + 1
        ranges[waiting + 1, 0], ranges[waiting + 1, 1] = start, split
        ranges[waiting + 1, 2] = level + 1
        waiting += 2
    return found
