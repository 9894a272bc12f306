"""Places in an order in which neighbors in the plane mostly are neighbors in the row.

The order of Morton: by the bits of both coordinates in turn. Places as near to each other as
1e-15 of the whole extent are still told apart, because the limbs of a closed mesh are that small
in its map.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

BITS = 26  # of each coordinate in one key; two keys are what a double holds

Codes = NDArray[np.uint64]


def morton_order(places: Floats) -> NDArray[np.intp]:
    """(m,) the numbers of the places (m, 2) in that order."""
    if not len(places):
        return np.zeros(0, dtype=np.intp)
    low = places.min(axis=0)
    extent = float((places.max(axis=0) - low).max())
    scaled = (places - low) * ((1.0 - 1e-12) / extent if extent > 0.0 else 0.0)
    steps = np.floor(scaled * 2.0**BITS)
    rest = np.floor((scaled * 2.0**BITS - steps) * 2.0**BITS)
    coarse, fine = _interleaved(steps), _interleaved(rest)
    order: NDArray[np.intp] = np.argsort(coarse, kind="stable")
    ranked = coarse[order]
    if (ranked[1:] == ranked[:-1]).any():
        order = np.lexsort((fine, coarse))
    return order


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
