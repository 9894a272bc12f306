"""Where a plane curve changes from turning left to turning right, or back.

The sign of det(C', C'') is watched at samples, on both sides of every knot. A change of sign
inside a smooth piece is narrowed down to a root; one across a knot, where C'' may jump, is an
inflection at the knot. Two roots may lie between two samples, where no sign shows them: places
where the determinant comes near zero are therefore sampled again more finely.
"""

from functools import lru_cache

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.pieces import pieces
from plusedit.geometry.roots import roots

SAMPLES = 17  # to the piece; the determinant has some ten roots there at most
STRAIGHT = 1e-9  # radians turned in a unit of the parameter: less is rounding
CLOSER_LOOKS = 3


def inflections(curve: PlusCurve) -> Floats:
    """(k,) the parameters in [0, 1], rising, at which the curvature changes its sign.

    A straight stretch between a left and a right turn counts once. A cusp at which the sense
    of turning stays is none. Raises ValueError if the curve is not plane.
    """
    if curve.dimension != 2:
        raise ValueError("inflections: only a plane curve has them, this one is in space")
    grid = _samples(pieces(curve))
    u, jets = grid.parameters, curve.jets(grid)
    fastest = float(np.abs(jets[1]).max())
    value = _clear(*_turning(jets, fastest))
    for _ in range(CLOSER_LOOKS):
        more = _looked_closer(u, value)
        if len(more) == len(u):
            break
        u, value = more, _clear(*_turning(curve.derivatives(more), fastest))
    u, value = u[value != 0.0], value[value != 0.0]
    if curve.closed:
        u, value = np.append(u, u[:1] + 1.0), np.append(value, value[:1])
    change = np.flatnonzero(value[:-1] * value[1:] < 0.0)
    at = roots(
        lambda u: _turning(curve.derivatives(u), fastest)[0],
        (u[change], u[change + 1]),
        (value[change], value[change + 1]),
    )
    return np.unique(at - np.floor(at) if curve.closed else at)


@lru_cache(maxsize=32)
def _samples(parts: Grid) -> Grid:
    """Samples of all pieces; where one ends, the number before its end and the end itself."""
    ends = parts.parameters
    inside = np.linspace(ends[:-1], ends[1:], SAMPLES, axis=1)
    # C'' is that of the piece to the right at a knot: just before it, it is that of the left.
    inside[:, -1] = np.nextafter(ends[1:], 0.0)
    return Grid(np.unique(inside))


def _turning(jets: tuple[Floats, ...], fastest: float) -> tuple[Floats, Floats]:
    """det(C', C'') in units in which the fastest speed is one, and what it may be by rounding."""
    scale = fastest or 1.0
    _, velocity, acceleration = jets
    velocity, acceleration = velocity / scale, acceleration / scale
    value = velocity[:, 0] * acceleration[:, 1] - velocity[:, 1] * acceleration[:, 0]
    speed, change = np.linalg.norm(velocity, axis=1), np.linalg.norm(acceleration, axis=1)
    return value, STRAIGHT * speed * (1.0 + change)


def _clear(value: Floats, rounding: Floats) -> Floats:
    """The values, zero where they may be but rounding."""
    return np.where(np.abs(value) <= rounding, 0.0, value)


def _looked_closer(u: Floats, value: Floats) -> Floats:
    """The samples, and more of them about those next to which zero is nearest."""
    before, at, after = value[:-2], value[1:-1], value[2:]
    same = (before * at > 0.0) & (at * after > 0.0)
    # A parabola through the three reaches zero between them only if it bends that much.
    bends = np.abs(at) <= np.abs(before - 2.0 * at + after)
    lowest = (np.abs(at) <= np.abs(before)) & (np.abs(at) <= np.abs(after))
    near = 1 + np.flatnonzero(same & lowest & bends)
    if not len(near):
        return u
    return np.union1d(u, np.linspace(u[near - 1], u[near + 1], 2 * SAMPLES - 1))
