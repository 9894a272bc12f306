"""What the ways of the fast preview cost, to choose the one that is quickest.

In nanoseconds, as measured once: only their ratios count.
"""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.spreading import MARGIN, WIDTH

if TYPE_CHECKING:
    from plusedit.geometry.mesh.tile_kernels import Scene

PER_PAIR = 3.0  # a plane at a place
PER_PLANE = 180.0  # a plane found and spread
PER_DIRECT = 600.0  # a plane found and added to every node
PER_NODE = 18.0  # a node blurred
PER_PLACE = 60.0  # a place at a grid
PER_VISIT = 150.0  # a place at planes, one by one
PAIRS = 2.4  # planes that are looked at for every one that counts
MORE = 100.0  # planes that are looked at anyhow
LEAST = 400.0  # planes, of which the errors of a grid make up for each other

Counts = NDArray[np.int64]


def of_tiles(scene: "Scene", rows: Counts, window: float) -> tuple[Floats, NDArray[np.bool_]]:
    """(k,) what tiles cost, given the nodes within reach of the narrowest plane, and whether a
    grid makes them cheaper."""
    places, planes = (rows[:, 2] - rows[:, 1]).astype(np.float64), 16.0 * rows[:, 3]
    direct = _direct(scene)[rows[:, 0]]
    per_plane = np.where(direct, PER_DIRECT, PER_PLANE)
    grid = rows[:, 5] * PER_NODE + planes * per_plane + places * PER_PLACE
    # Of the planes around a tile those around a block of sixteen places.
    width = np.sqrt(rows[:, 5]) - 2 * MARGIN
    block = width * np.sqrt(np.minimum(16.0 / places, 1.0))
    seen = planes * ((block + 1.5 * window) / (width + 1.5 * window)) ** 2
    seen = np.maximum(seen, np.minimum(planes, MORE))
    pairs = places * (seen * PER_PAIR + PER_VISIT)
    suits = (rows[:, 4] > 0) & (planes >= LEAST) & (grid < pairs)
    return np.where(suits, grid, pairs), suits


def grids_pay(scene: "Scene", box: Floats, places: int, reach: float) -> bool:
    """Whether it is worth the while to look for tiles, given the box (2, 2) of all places."""
    starts = scene.groups[:, 0]
    planes = np.add.reduceat(scene.counts[:, 3], starts)
    extent, sigmas = box[1] - box[0], scene.units * reach
    around = extent + 2.0 * sigmas[:, None]
    images = np.maximum.reduceat(scene.images.sum(axis=1), starts)
    images = np.minimum(images, (around / np.maximum(extent, sigmas[:, None])).prod(axis=1))
    found = planes * images
    seen = found * np.minimum(1.0, np.pi * sigmas**2 / np.maximum(around.prod(axis=1), 1e-300))
    pairs = places * PER_PAIR * PAIRS * seen
    inner = WIDTH - 2 * MARGIN
    tiles = np.ceil(extent / scene.units[:, None] / inner)
    nodes = ((extent / scene.units[:, None]) + 2 * MARGIN * tiles).prod(axis=1)
    per_plane = np.where(_direct(scene), PER_DIRECT, PER_PLANE)
    grids = nodes * PER_NODE + found * per_plane + places * PER_PLACE
    together = float(pairs.sum()) + places * PER_PAIR * MORE
    return float(np.minimum(pairs + places * PER_PAIR * MORE / 4.0, grids).sum()) < together


def _direct(scene: "Scene") -> NDArray[np.bool_]:
    """(groups,) whether some plane is as wide as planes may be."""
    found: NDArray[np.bool_] = np.logical_or.reduceat(scene.capped, scene.groups[:, 0])
    return found
