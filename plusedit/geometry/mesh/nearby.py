"""Which control planes can count at a few places, so that no others need to be looked at.

The places are taken in a few boxes. In each some plane bounds the least e = |x - c|^2 / (2 sigma^2)
from above, all over the box; planes with an e more than 36 above that do not count. Branches of the
tree of planes are kept or left out as a whole.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Images
from plusedit.geometry.mesh.plane_tree import LEAF, PlaneTree

DEEPEST = 36.0
FEW = 4096  # places, up to which looking for their planes takes less time than it saves
BOXES = 16
BRANCHES = 512
LOOKED_AT = 8  # branches, for planes near a box
MANY = 32  # images, of which with more most planes count
ROUNDING = 1e-9

Indices = NDArray[np.intp]


def nearby(
    tree: PlaneTree, places: Floats, smoothness: float, caps: Floats, images: Images
) -> PlaneTree:
    """The tree of the planes that may count at places (m, 2) in the cell, which are in order.

    No sigma is larger than the `caps` (2,) by u and by v; `images` are all that may matter. The
    tree itself where it has few planes or most of them count.
    """
    count = tree.leaf_count
    if count < BRANCHES or not 0 < len(places) <= FEW or len(images.signs) > MANY:
        return tree
    branches = np.flatnonzero(tree.largest[BRANCHES : 2 * BRANCHES] > 0.0)
    low, high = _brought(*_boxes(places), images)
    halves = _halves(smoothness * tree.largest[BRANCHES + branches], caps)
    apart = _apart(low, high, tree.boxes[BRANCHES + branches])
    # (boxes, images times branches)
    exponents = (apart**2 * halves).sum(axis=3).transpose(1, 0, 2).reshape(low.shape[1], -1)
    size = LEAF * count // BRANCHES
    nearest = np.argpartition(exponents, LOOKED_AT, axis=1)[:, :LOOKED_AT]
    image, branch = np.divmod(nearest, len(branches))
    planes = np.minimum(size * branches[branch][..., None] + np.arange(size), len(tree) - 1)
    boxes = np.arange(low.shape[1])[:, None]
    ends = low[image, boxes], high[image, boxes]
    limits = DEEPEST + _highest(tree, planes, *ends, smoothness, caps).min(axis=1)
    counts = exponents <= limits[:, None] * (1.0 + ROUNDING)
    kept = branches[counts.reshape(-1, len(branches)).any(axis=0)]
    if 2 * len(kept) > len(branches):
        return tree
    numbers = (size * kept[:, None] + np.arange(size)).ravel()
    return tree.taken(numbers[numbers < len(tree)])


def _boxes(places: Floats) -> tuple[Floats, Floats]:
    """(k, 2) the lower left and the upper right corners of boxes around neighboring places."""
    count = min(len(places), BOXES)
    starts = np.arange(count) * len(places) // count
    return np.minimum.reduceat(places, starts), np.maximum.reduceat(places, starts)


def _brought(low: Floats, high: Floats, images: Images) -> tuple[Floats, Floats]:
    """(images, k, 2) the corners of the boxes brought from each image to the planes themselves."""
    shifts, signs = images.shifts[:, None], images.signs[:, None, None]
    ends = signs * (low - shifts), signs * (high - shifts)
    return np.minimum(*ends), np.maximum(*ends)


def _apart(low: Floats, high: Floats, around: Floats) -> Floats:
    """(images, k, n, 2) how far boxes (images, k, 2) are from others (n, 4) by u and by v."""
    gaps = np.maximum(low[:, :, None] - around[:, 2:], around[:, :2] - high[:, :, None])
    return np.maximum(gaps, 0.0)


def _halves(sigmas: Floats, caps: Floats) -> Floats:
    """(..., 2) 1 / (2 sigma^2) by u and by v."""
    found: Floats = 0.5 / np.minimum(sigmas[..., None], caps) ** 2
    return found


def _highest(
    tree: PlaneTree, planes: Indices, low: Floats, high: Floats, smoothness: float, caps: Floats
) -> Floats:
    """(k, b) one of the planes (k, b, n) keeps its e below that all over its box (k, b, 2)."""
    centers, low, high = tree.centers[planes], low[:, :, None], high[:, :, None]
    far = np.maximum(np.abs(centers - low), np.abs(centers - high))
    halves = _halves(smoothness * tree.reaches[planes], caps)
    found: Floats = (far**2 * halves).sum(axis=3).min(axis=2)
    return found
