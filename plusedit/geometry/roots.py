"""Roots of a function between places where its signs differ, many of them at once.

Chandrupatla's method: the inverse parabola through the last three places where these lie so that it
can be trusted, else the middle. Some eight steps do for what bisection takes fifty.
T. R. Chandrupatla, A new hybrid quadratic/bisection algorithm, Adv. Eng. Software 28 (1997).
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

STEPS = 100


def roots(
    function: Callable[[Floats], Floats],
    ends: tuple[Floats, Floats],
    values: tuple[Floats, Floats],
) -> Floats:
    """(k,) roots of a function, or its jumps across zero, to the last digit or two.

    They lie between two ends (k,) each, at which it has the given values, of different sign. The
    function is asked for any number of places (m,) at once. Where ends are as near as that already
    it is the second of them.
    """
    found = np.array(ends[1], dtype=np.float64)
    row = np.flatnonzero(_is_wide(*ends))
    one, other = (np.array(end)[row] for end in ends)
    at_one, at_other = (np.array(value)[row] for value in values)
    share = np.full(len(row), 0.5)
    for _ in range(STEPS):
        if not len(row):
            break
        place = one + share * (other - one)
        value = function(place)
        is_beyond = np.sign(value) == np.sign(at_one)
        last, at_last = np.where(is_beyond, one, other), np.where(is_beyond, at_one, at_other)
        other, at_other = np.where(is_beyond, other, one), np.where(is_beyond, at_other, at_one)
        one, at_one = place, value
        found[row] = np.where(np.abs(at_one) < np.abs(at_other), one, other)
        going = _is_wide(one, other) & (value != 0.0)
        kept = (row, one, other, last, at_one, at_other, at_last)
        row, one, other, last, at_one, at_other, at_last = (rows[going] for rows in kept)
        share = _share(one, other, last, at_one, at_other, at_last)
        # Not an end again, but the number next to it at least.
        least = np.minimum(np.spacing(np.abs(found[row])) / np.abs(other - one), 0.5)
        share = np.clip(share, least, 1.0 - least)
    return found


def _is_wide(one: Floats, other: Floats) -> NDArray[np.bool_]:
    wide: NDArray[np.bool_] = np.abs(other - one) > 2.0 * np.spacing(
        np.maximum(np.abs(one), np.abs(other))
    )
    return wide


def _share(
    one: Floats, other: Floats, last: Floats, at_one: Floats, at_other: Floats, at_last: Floats
) -> Floats:
    """How far from one end to the other to look next, 0 to 1."""
    with np.errstate(all="ignore"):
        xi = (one - other) / (last - other)
        phi = (at_one - at_other) / (at_last - at_other)
        is_smooth = (phi**2 < xi) & ((1.0 - phi) ** 2 < 1.0 - xi)
        first = at_one / (at_other - at_one) * at_last / (at_other - at_last)
        second = (last - one) / (other - one) * at_one / (at_last - at_one)
        inverse = first + second * at_other / (at_last - at_other)
    return np.where(is_smooth & np.isfinite(inverse), inverse, 0.5)
