"""The length of a curve, the integral of its speed."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.quadrature import integral


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

    def speed(u: Floats) -> Floats:
        speeds: Floats = np.linalg.norm(curve.derivatives(u, highest=1)[1], axis=1)
        return speeds

    # A curve that stays in one place moves by rounding; that length is not worth dividing.
    size = np.abs(curve.lines.points).max() + np.abs(curve.gradients).max()
    return integral(curve, speed, a, b, 1e-3 * float(size))
