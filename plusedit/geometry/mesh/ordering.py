"""Places in an order in which neighbors in the plane mostly are neighbors in the row.

The order of Morton: by the bits of both coordinates in turn. Places as near to each other as
1e-15 of the whole extent are still told apart, because the limbs of a closed mesh are that small
in its map.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

BITS = 26  # of each coordinate in one key; two keys are what a double holds
ROOM = 1e-12  # of the extent, so that the last place is within the square

Codes = NDArray[np.uint64]


class Ordered(NamedTuple):
    """Places in the order of Morton, and the square that their keys divide."""

    order: NDArray[np.intp]
    """(m,) the numbers of the places"""
    codes: Codes
    """(m, 2) two keys of every place in that order, the coarse one first; v has the higher bits"""
    low: Floats
    """(2,) the lower left corner"""
    extent: float
    """the side of the square"""


def morton_order(places: Floats) -> NDArray[np.intp]:
    """(m,) the numbers of the places (m, 2) in that order."""
    return ordered(places).order


def ordered(places: Floats) -> Ordered:
    """The places (m, 2) in order."""
    if not len(places):
        return Ordered(np.zeros(0, np.intp), np.zeros((0, 2), np.uint64), np.zeros(2), 1.0)
    low = places.min(axis=0)
    extent = float((places.max(axis=0) - low).max()) or 1.0
    scaled = (places - low) * ((1.0 - ROOM) / extent)
    steps = np.floor(scaled * 2.0**BITS)
    rest = np.floor((scaled * 2.0**BITS - steps) * 2.0**BITS)
    coarse, fine = _interleaved(steps), _interleaved(rest)
    order: NDArray[np.intp] = np.argsort(coarse, kind="stable")
    ranked = coarse[order]
    if (ranked[1:] == ranked[:-1]).any():
        order = np.lexsort((fine, coarse))
    codes = np.stack([coarse[order], fine[order]], axis=1)
    return Ordered(order, codes, low, extent / (1.0 - ROOM))


def _interleaved(steps: Floats) -> Codes:
    """The bits of both columns in turn, from whole numbers below 2**32."""
    u, v = (_spread(column.astype(np.uint64)) for column in steps.T)
    codes: Codes = u | (v << np.uint64(1))
    return codes


def _spread(numbers: Codes) -> Codes:
    """Every bit moved to twice its place (Morton's dilated integers)."""
    for shift, mask in (
        (16, 0x0000FFFF0000FFFF),
        (8, 0x00FF00FF00FF00FF),
        (4, 0x0F0F0F0F0F0F0F0F),
        (2, 0x3333333333333333),
        (1, 0x5555555555555555),
    ):
        numbers = (numbers | (numbers << np.uint64(shift))) & np.uint64(mask)
    return numbers
