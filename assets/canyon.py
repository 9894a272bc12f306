"""A canyon that rivers have cut into layered rock: heights over a grid.

Water runs down to the outlet along the lowest ways out (priority-flood; Barnes, Lehman and Mulla
2014). Rivers then cut by the stream power law

    dh/dt = -K A^m dh/ds,    K = K(h) by layer,    A the area drained,

solved implicitly from the outlet upwards (Braun and Willett 2013). Slopes that are too steep slide
down; at last hard layers are drawn up to cliffs and soft ones down to benches.
"""

import heapq
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

Cells = NDArray[np.intp]

LAYERS = (
    (0.0, 1.0, 0.6), (2.0, 0.5, 2.6), (3.6, 1.3, 0.35), (5.4, 0.45, 2.8), (6.8, 1.4, 0.3),
    (8.4, 0.6, 2.4), (9.4, 1.2, 0.35), (10.6, 0.35, 3.0), (12.2, 1.0, 0.3),
)  # fmt: skip
"""From below: where a layer begins, how easily it is cut, and how steep it stands."""

AROUND = ((-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1))
PLATEAU = 12.6  # height of the land before
CUT = 0.26  # K of rock that is cut as easily as 1
STEPS = 40
UPSTREAM = 3000.0  # cells drained by the river where it enters
LEAST = 8.0  # cells that have to be drained before water cuts
BEARS = 0.5  # the steepest slope that does not slide


@dataclass(frozen=True)
class Ways:
    """How water runs."""

    order: Cells
    """(n,) cells from the outlet upwards"""
    below: Cells
    """(n,) the cell into which each one drains; the outlet into itself"""


def canyon(columns: int, rows: int, width: float) -> Floats:
    """(columns, rows) heights; x runs along the columns over `width`, y along the rows."""
    step = width / (columns - 1)
    heights = PLATEAU + 0.5 * noise(columns, rows, 6) + 0.3 * noise(columns, rows, 17)
    river = course(columns, rows)
    across = np.abs(np.arange(rows)[None, :] - river[:, None]) * step
    heights += 0.02 * across - 1.5 * np.exp(-((across / 3.0) ** 2))
    entry, outlet = round(river[0]), (columns - 1) * rows + round(river[-1])
    for number in range(STEPS):
        heights.ravel()[outlet] = (PLATEAU - 1.5) * (1.0 - min(1.0, 1.5 * (number + 1) / STEPS))
        ways = drained(heights, outlet)
        heights = cut(heights, ways, entry, step)
        heights = slid(heights, step)
    return terraced(heights)


def course(columns: int, rows: int) -> Floats:
    """(columns,) where the river runs at first."""
    t = np.linspace(0.0, 1.0, columns)
    bends = 0.5 + 0.16 * np.sin(2.0 * np.pi * (1.25 * t + 0.1)) + 0.06 * np.sin(15.0 * t + 1.0)
    found: Floats = bends * (rows - 1)
    return found


def noise(columns: int, rows: int, cells: int) -> Floats:
    """(columns, rows) smooth random heights between about -1 and 1, `cells` of them across."""
    values = np.random.default_rng(cells).uniform(-1.0, 1.0, (2 * cells + 3, 2 * cells + 3))
    x = np.arange(columns) / columns * cells
    y = np.arange(rows) / columns * cells
    columns_of, across = (values_of(position) for position in (x, y))
    low = columns_of[0][:, None], across[0][None, :]
    share = columns_of[1][:, None], across[1][None, :]
    total = np.zeros((columns, rows))
    for i in (0, 1):
        for j in (0, 1):
            part = (share[0] if i else 1.0 - share[0]) * (share[1] if j else 1.0 - share[1])
            total += part * values[low[0] + i, low[1] + j]
    return total


def values_of(position: Floats) -> tuple[Cells, Floats]:
    """The cell of each position, and how far in it, eased at both ends."""
    low = np.floor(position).astype(np.intp)
    share = position - low
    return low, share * share * (3.0 - 2.0 * share)


def drained(heights: Floats, outlet: int) -> Ways:
    """The lowest ways to the outlet; water that stands in a hollow leaves it over its rim."""
    columns, rows = heights.shape
    level = heights.ravel().tolist()
    below = [-1] * len(level)
    below[outlet] = outlet
    order, open_cells = [], [(level[outlet], outlet)]
    while open_cells:
        height, cell = heapq.heappop(open_cells)
        order.append(cell)
        column, row = divmod(cell, rows)
        for across, along in AROUND:
            i, j = column + across, row + along
            if 0 <= i < columns and 0 <= j < rows and below[i * rows + j] < 0:
                other = i * rows + j
                below[other] = cell
                heapq.heappush(open_cells, (max(level[other], height + 1e-5), other))
    return Ways(np.array(order), steepest(heights, np.array(below), np.array(order)))


def steepest(heights: Floats, below: Cells, order: Cells) -> Cells:
    """The lowest neighbor of each cell that is nearer to the outlet, where one is lower."""
    columns, rows = heights.shape
    rank = np.empty(len(order), dtype=np.intp)
    rank[order] = np.arange(len(order))
    cells = np.arange(len(order)).reshape(columns, rows)
    best, slopes = below.copy(), np.zeros(len(order))
    for across, along in AROUND:
        here = cells[
            max(0, -across) : columns - max(0, across), max(0, -along) : rows - max(0, along)
        ]
        there = here + across * rows + along
        fall = (heights.ravel()[here] - heights.ravel()[there]) / np.hypot(across, along)
        better = (fall > slopes[here]) & (rank[there] < rank[here])
        best[here[better]], slopes[here[better]] = there[better], fall[better]
    return best


def cut(heights: Floats, ways: Ways, entry: int, step: float) -> Floats:
    """The heights after rivers have cut for a while."""
    columns, rows = heights.shape
    area = np.ones(heights.size)
    area[entry] += UPSTREAM
    for cell in ways.order[:0:-1].tolist():
        area[ways.below[cell]] += area[cell]
    ease = layered(heights, 1).ravel()
    cells = np.arange(heights.size)
    away = np.hypot(cells // rows - ways.below // rows, cells % rows - ways.below % rows) * step
    strength = np.sqrt(np.maximum(area - LEAST, 0.0))
    power = (CUT * ease * strength / np.maximum(away, step)).tolist()
    level, below = heights.ravel().tolist(), ways.below.tolist()
    for cell in ways.order[1:].tolist():
        lower = level[below[cell]]
        if lower < level[cell]:
            level[cell] = (level[cell] + power[cell] * lower) / (1.0 + power[cell])
    return np.array(level).reshape(columns, rows)


def slid(heights: Floats, step: float) -> Floats:
    """The heights after slopes that are too steep have slid."""
    for _ in range(6):
        moved = np.zeros_like(heights)
        for axis in (0, 1):
            fall = np.diff(heights, axis=axis)
            excess = np.sign(fall) * np.maximum(np.abs(fall) - BEARS * step, 0.0) / 4.0
            moved += np.diff(excess, axis=axis, prepend=0.0, append=0.0)
        heights = heights + moved
    return heights


def terraced(heights: Floats) -> Floats:
    """The heights with hard layers drawn up and soft ones down."""
    table = np.array(LAYERS)
    begins = np.append(table[:, 0], 2.0 * PLATEAU)
    tops = np.concatenate([[0.0], np.cumsum(np.diff(begins) * table[:, 2])])
    drawn: Floats = np.interp(heights, begins, tops)
    return drawn


def layered(heights: Floats, column: int) -> Floats:
    """A number of the layer in which each height lies."""
    table = np.array(LAYERS)
    numbers = np.searchsorted(table[:, 0], heights, side="right") - 1
    found: Floats = table[np.clip(numbers, 0, len(table) - 1), column]
    return found
