"""The places of control planes as a tree of boxes.

Depends on the centers and reaches r alone: neither on the smoothness S nor on what the planes are,
so that one tree serves as long as a mesh keeps its parameters.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.ordering import morton_order

LEAF = 16  # planes


@dataclass(frozen=True, eq=False)
class PlaneTree:
    """Planes in Morton order, sixteen to a leaf, and boxes around the leaves of every branch.

    Node 1 is the root, the children of node k are 2 k and 2 k + 1, and leaf i is node
    `leaf_count` + i. Boxes of nodes without planes are inverted, infinitely far from everything.
    """

    order: NDArray[np.intp]
    """(n,) the face of every plane"""
    centers: Floats
    """(n, 2) between zero and the periods of the domain"""
    reaches: Floats
    """(n,) positive"""
    boxes: Floats
    """(2 leaf_count, 4) least u, least v, largest u, largest v of the centers"""
    largest: Floats
    """(2 leaf_count,) the largest reach; zero where there are no planes"""

    @classmethod
    def of(cls, centers: Floats, reaches: Floats, faces: NDArray[np.intp]) -> "PlaneTree":
        """The tree of those faces, given the centers and reaches of all."""
        order = faces[morton_order(centers[faces])]
        return cls._of_ordered(order, centers[order], reaches[order])

    def taken(self, numbers: NDArray[np.intp]) -> "PlaneTree":
        """The tree of those planes, given by their rising numbers in the order of this one."""
        return self._of_ordered(self.order[numbers], self.centers[numbers], self.reaches[numbers])

    @classmethod
    def _of_ordered(cls, order: NDArray[np.intp], centers: Floats, reaches: Floats) -> "PlaneTree":
        leaves = 1 << max(0, (-(-len(order) // LEAF) - 1).bit_length())
        boxes = np.tile([np.inf, np.inf, -np.inf, -np.inf], (2 * leaves, 1))
        largest = np.zeros(2 * leaves)
        starts = np.arange(0, len(order), LEAF)
        if len(order):
            filled = slice(leaves, leaves + len(starts))
            boxes[filled, :2] = np.minimum.reduceat(centers, starts)
            boxes[filled, 2:] = np.maximum.reduceat(centers, starts)
            largest[filled] = np.maximum.reduceat(reaches, starts)
        level = leaves
        while level > 1:
            children = boxes[level : 2 * level].reshape(-1, 2, 4)
            level //= 2
            boxes[level : 2 * level, :2] = children[:, :, :2].min(axis=1)
            boxes[level : 2 * level, 2:] = children[:, :, 2:].max(axis=1)
            pairs = largest[2 * level : 4 * level].reshape(-1, 2)
            largest[level : 2 * level] = pairs.max(axis=1)
        return cls(order, centers, reaches, boxes, largest)

    @property
    def leaf_count(self) -> int:
        return len(self.largest) // 2

    def __len__(self) -> int:
        return len(self.order)
