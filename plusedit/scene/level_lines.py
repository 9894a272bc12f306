"""Lines on surfaces along which a value stays the same, straight within triangles."""

from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.scene.silhouettes import TRIANGLES

Triples: TypeAlias = NDArray[np.integer]


@lru_cache(maxsize=16)
def triangles_of_grid(rows: int, columns: int) -> Triples:
    """(k, 3) numbers of the samples, row by row, that each half of a cell has at its corners."""
    cells = np.indices((rows - 1, columns - 1)).reshape(2, -1).T
    found: Triples = ((cells[:, None, None] + TRIANGLES) @ np.array([columns, 1])).reshape(-1, 3)
    return found


def level_segments(
    points: Floats, triangles: Triples, values: Floats, levels: Iterable[float]
) -> Iterator[tuple[Floats, Floats]]:
    """(k, 3) starts and (k, 3) ends for each level: the lines where values (n,) are that.

    In triangles with a corner that has no value there are none.
    """
    corners = values[triangles]
    known = np.isfinite(corners).all(axis=1)
    triangles, corners = triangles[known], corners[known]
    low, high = corners.min(axis=1, initial=np.inf), corners.max(axis=1, initial=-np.inf)
    for level in levels:
        # A value that is just the level counts as below it: so no line is drawn twice.
        crossed = (low <= level) & (high > level)
        chosen, sides = triangles[crossed], corners[crossed] > level
        changes = sides != np.roll(sides, -1, axis=1)
        starts, ends = chosen[changes], np.roll(chosen, -1, axis=1)[changes]
        share = ((level - values[starts]) / (values[ends] - values[starts]))[:, None]
        places = (1.0 - share) * points[starts] + share * points[ends]
        yield places[::2], places[1::2]
