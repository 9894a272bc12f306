"""Integrals along a curve, by rules of Gauss and Legendre between its breaks.

Parts are halved until two halves agree with the whole.
"""

from collections.abc import Callable

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.pieces import pieces

# Of the whole integral, what the rule may differ by from that for two halves.
# Not of the part: the rounding in a short part is large beside it, however short it gets.
ACCURACY = 1e-12
ROUNDS = 50
MOST = 4096  # parts worked on at a time: where there are more, the integrand has a pole

NODES, WEIGHTS = (row / 2.0 for row in np.polynomial.legendre.leggauss(12))


def integral(
    curve: PlusCurve, integrand: Callable[[Floats], Floats], a: float, b: float, least: float
) -> float:
    """The integral of `integrand` (m,) -> (m,) over parameters from a to b, 0 <= a <= b <= 2.

    To 1e-12 of its value, or of `least` if that is more; infinite where it does not settle.
    """
    ends = pieces(curve).parameters
    ends = np.concatenate([ends, 1.0 + ends[1:]])
    ends = np.concatenate([[a], ends[(ends > a) & (ends < b)], [b]])
    low, high = ends[:-1], ends[1:]
    whole = _by_rule(integrand, low, high)
    total, allowed = 0.0, ACCURACY * max(float(np.abs(whole).sum()), least)
    for _ in range(ROUNDS):
        middle = (low + high) / 2.0
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
        halves = _by_rule(integrand, low, high)
        both = halves[: len(whole)] + halves[len(whole) :]
        rough = ~(np.abs(both - whole) <= allowed)
        total += float(both[~rough].sum())
        if not rough.any():
            return total
        if not np.isfinite(both).all() or rough.sum() > MOST:
            return np.inf
        again = np.tile(rough, 2)
        low, high, whole = low[again], high[again], halves[again]
    return total + float(whole.sum())


def _by_rule(integrand: Callable[[Floats], Floats], low: Floats, high: Floats) -> Floats:
    """(m,) integrals from `low` to `high` (m,) by one rule each."""
    width = high - low
    u = (low + high)[:, None] / 2.0 + width[:, None] * NODES
    integrals: Floats = width * (integrand(u.ravel()).reshape(u.shape) @ WEIGHTS)
    return integrals
