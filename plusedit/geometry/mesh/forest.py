"""The planes of a mesh surface in trees, as the fast preview wants them.

All planes are in one tree, for small S, and again in groups of trees by their reaches, as grids
want them (`spreading`), for large S. Neither depends on S.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.foundation import Foundation
from plusedit.geometry.mesh.plane_tree import PlaneTree
from plusedit.geometry.mesh.planes import FacePlanes
from plusedit.geometry.mesh.spreading import least_sigmas

KEPT = 8

Counts = NDArray[np.int64]
Singles = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class Grove:
    """Some trees of planes, one after another."""

    trees: tuple[PlaneTree, ...]
    groups: Counts
    """(groups, 2) of the trees that share their grids the first, and the one after the last"""

    @cached_property
    def order(self) -> NDArray[np.intp]:
        """(n,) the face of every plane."""
        return np.concatenate([tree.order for tree in self.trees])

    @cached_property
    def boxes(self) -> Floats:
        """(nodes, 4)"""
        return np.concatenate([tree.boxes for tree in self.trees])

    @cached_property
    def largest(self) -> Floats:
        """(nodes,) the largest reach below."""
        return np.concatenate([tree.largest for tree in self.trees])

    @cached_property
    def centers(self) -> Floats:
        """(n, 2)"""
        return np.concatenate([tree.centers for tree in self.trees])

    @cached_property
    def reaches(self) -> Floats:
        """(n,)"""
        return np.concatenate([tree.reaches for tree in self.trees])

    @cached_property
    def least(self) -> Floats:
        """(trees,) the least reach in each."""
        return np.array([tree.reaches.min(initial=np.inf) for tree in self.trees])

    @cached_property
    def counts(self) -> Counts:
        """(trees, 4) of each its first node, its leaves, its first plane, its planes."""
        leaves = np.array([tree.leaf_count for tree in self.trees])
        planes = np.array([len(tree) for tree in self.trees])
        columns = [np.cumsum(2 * leaves) - 2 * leaves, leaves, np.cumsum(planes) - planes, planes]
        return np.stack(columns, axis=1).astype(np.int64)


class Forest:
    """The planes of a foundation, in one tree and in several."""

    def __init__(self, foundation: Foundation) -> None:
        self.foundation = foundation

    @cached_property
    def whole(self) -> Grove:
        """All planes in one tree."""
        return Grove((self.foundation.tree,), np.array([[0, 1]]))

    @cached_property
    def parted(self) -> Grove:
        """In groups of trees of planes with reaches of a kind."""
        tree = self.foundation.tree
        ranked = np.argsort(tree.reaches, kind="stable")
        sizes, ends = tree.reaches[ranked], least_sigmas()
        parts: list[PlaneTree] = []
        groups: list[tuple[int, int]] = []
        start = 0
        while start < len(ranked):
            first, least = len(parts), sizes[start]
            for end in ends[1:] / ends[0]:
                stop = int(np.searchsorted(sizes, end * least, side="right"))
                # Kept in the order of the tree, they need not be sorted by place again.
                parts.append(tree.taken(np.sort(ranked[start:stop])))
                start = stop
            groups.append((first, len(parts)))
        return Grove(tuple(parts), np.array(groups))

    @cached_property
    def middle(self) -> Floats:
        """(3,) what points are measured from."""
        low, high = self.foundation.parts.mesh.bounds
        return 0.5 * (low + high)

    @cached_property
    def size(self) -> float:
        """What points are measured by."""
        return self.foundation.parts.mesh.diagonal or 1.0


@lru_cache(maxsize=KEPT)
def forest(foundation: Foundation) -> Forest:
    """That of a foundation; the same for the same."""
    return Forest(foundation)


@lru_cache(maxsize=2 * KEPT)
def values(planes: FacePlanes, grove: Grove, of: Forest, scale: float) -> Singles:
    """(n, 10) W, P, A and B in the order of the trees, P from the middle and by the size.

    The gradients are by u and v in units of the scale.
    """
    rows = np.empty((len(grove.order), 10), dtype=np.float32)
    rows[:, 0] = planes.weights[grove.order]
    rows[:, 1:4] = (planes.points[grove.order] - of.middle) / of.size
    rows[:, 4:7] = planes.gradients_u[grove.order] * (scale / of.size)
    rows[:, 7:10] = planes.gradients_v[grove.order] * (scale / of.size)
    return rows
