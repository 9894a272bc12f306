"""The length of a curve, the integral of its speed."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.pieces import pieces

# Of the whole length, what the rule of Gauss and Legendre may differ by from that for two halves.
# Not of the part: the rounding in a short part is large beside it, however short it gets.
ACCURACY = 1e-12
ROUNDS = 50

NODES, WEIGHTS = (row / 2.0 for row in np.polynomial.legendre.leggauss(12))


def arc_length(curve: PlusCurve, a: float = 0.0, b: float = 1.0) -> float:
    """The length of the curve from the parameter a to b; negative where b is below a.

    To 1e-10 of the length. A closed curve goes round as often as a and b say; an open one ends
    at 0 and 1. Raises ValueError if a or b is not finite.
    """
    if not (np.isfinite(a) and np.isfinite(b)):
        raise ValueError(f"arc_length: expected finite parameters, got {a} and {b}")
    if b < a:
        return -arc_length(curve, b, a)
    if curve.closed:
        rounds, b = divmod(b - a, 1.0)
        a -= np.floor(a)
        whole = rounds * _between(curve, 0.0, 1.0) if rounds else 0.0
        return whole + _between(curve, a, a + b)
    return _between(curve, float(np.clip(a, 0.0, 1.0)), float(np.clip(b, 0.0, 1.0)))


def _between(curve: PlusCurve, a: float, b: float) -> float:
    """The length from a to b, where 0 <= a <= b <= 2."""
    ends = pieces(curve).parameters
    ends = np.concatenate([ends, 1.0 + ends[1:]])
    ends = np.concatenate([[a], ends[(ends > a) & (ends < b)], [b]])
    low, high = ends[:-1], ends[1:]
    whole = _by_rule(curve, low, high)
    # A curve that stays in one place moves by rounding; that length is not worth dividing.
    size = np.abs(curve.lines.points).max() + np.abs(curve.gradients).max()
    total, allowed = 0.0, ACCURACY * max(float(whole.sum()), 1e-3 * float(size))
    for _ in range(ROUNDS):
        middle = (low + high) / 2.0
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
        halves = _by_rule(curve, low, high)
        both = halves[: len(whole)] + halves[len(whole) :]
        rough = np.abs(both - whole) > allowed
        total += float(both[~rough].sum())
        if not rough.any():
            return total
        again = np.tile(rough, 2)
        low, high, whole = low[again], high[again], halves[again]
    return total + float(whole.sum())


def _by_rule(curve: PlusCurve, low: Floats, high: Floats) -> Floats:
    """(m,) lengths from `low` to `high` (m,) by one rule each."""
    width = high - low
    u = (low + high)[:, None] / 2.0 + width[:, None] * NODES
    velocity = curve.derivatives(u.ravel(), highest=1)[1]
    speed = np.linalg.norm(velocity, axis=1).reshape(u.shape)
    lengths: Floats = width * (speed @ WEIGHTS)
    return lengths
