"""Points that are written once for every face: each place becomes one vertex."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

MIXERS = np.array([0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9], dtype=np.uint64)
SHIFT = np.uint64(29)


class Welded(NamedTuple):
    """Places that differ, in the order in which they first occur."""

    points: Floats
    """(k, 3)"""
    numbers: NDArray[np.int64]
    """(n,) where each of the points given is among them"""


def welded(points: Floats) -> Welded:
    """Points (n, 3) with exactly equal ones made one; those that are not finite stay apart."""
    keys = _keys(points)
    order = np.argsort(keys)
    columns = [points[order, axis] for axis in range(3)]
    differs = _differs(*columns)
    if (differs & (keys[order[1:]] == keys[order[:-1]])).any():  # equal keys of different points
        order = np.lexsort(points.T[::-1])
        differs = _differs(*(points[order, axis] for axis in range(3)))
    begins = np.concatenate([np.ones(min(1, len(points)), dtype=np.bool_), differs])
    firsts = np.minimum.reduceat(order, np.flatnonzero(begins)) if len(points) else order
    by_first = np.argsort(firsts)
    places = np.empty_like(by_first)
    places[by_first] = np.arange(len(by_first))
    numbers = np.empty(len(points), dtype=np.int64)
    numbers[order] = places[np.cumsum(begins) - 1]
    return Welded(points[firsts[by_first]], numbers)


def _differs(x: Floats, y: Floats, z: Floats) -> NDArray[np.bool_]:
    """(n - 1,) whether each point is another than the one before."""
    differs: NDArray[np.bool_] = (x[1:] != x[:-1]) | (y[1:] != y[:-1]) | (z[1:] != z[:-1])
    return differs


def _keys(points: Floats) -> NDArray[np.uint64]:
    """(n,) numbers that are equal for equal points, and hardly ever for others."""
    bits = (points + 0.0).view(np.uint64)  # minus zero is zero
    keys = np.zeros(len(points), dtype=np.uint64)
    for axis in range(3):
        keys = (keys ^ bits[:, axis]) * MIXERS[axis]
        keys ^= keys >> SHIFT
    return keys
