"""Those of very many points that tell where all of them reach."""

from functools import lru_cache
from itertools import product

import numpy as np

from plusedit.geometry.arrays import Floats

FEW = 8192  # points that are taken as they are


def telling(points: Floats) -> Floats:
    """(k, dim) points that frame about the same as all of points (m, dim) do.

    Up to `FEW` all of them; of more, those that lie farthest in some directions, and a share of the
    others at even steps. Along the axes nothing is lost. Points that are not finite never tell.
    """
    if len(points) <= FEW:
        return points
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        return points
    along = _directions(points.shape[1]) @ points.T
    farthest = np.concatenate([along.argmin(axis=1), along.argmax(axis=1)])
    return np.concatenate([points[farthest], points[:: -(-len(points) // FEW)]])


@lru_cache(maxsize=2)
def _directions(dim: int) -> Floats:
    """To the middles of the sides, edges and corners of a cube; of opposite ones to one."""
    all_ways = np.array(list(product((-1.0, 0.0, 1.0), repeat=dim)))
    return all_ways[: len(all_ways) // 2]
