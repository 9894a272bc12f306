"""What velocity and acceleration say of a curve, whatever its parameter."""

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve


def curvature(velocity: Floats, acceleration: Floats) -> Floats:
    """Signed curvature of a plane curve at sampled parameters.

    Parameters
    ----------
    velocity, acceleration
        (m, 2) first and second derivatives by the same parameter; which one does not matter.

    Returns
    -------
    (m,) curvature in 1 / (unit of the points): positive where the curve turns left, zero on a
    straight piece, nan where it stands still (there it may have a cusp).

    Raises
    ------
    ValueError
        If the curve is not plane. In space curvature has no sign; use `space_curvature`.

    Notes
    -----
    det(C', C'') / |C'|**3, which is the same for every parameter of the curve.
    """
    if velocity.shape[-1] != 2:
        raise ValueError(f"velocity: signed curvature is of plane curves, got {velocity.shape}")
    (x1, y1), (x2, y2) = unit(velocity).T, acceleration.T
    return _over_speed_squared(x1 * y2 - y1 * x2, velocity)


def space_curvature(velocity: Floats, acceleration: Floats) -> Floats:
    """(m,) curvature of a plane or space curve, never negative; nan where it stands still.

    The part of the acceleration (m, dim) across the velocity (m, dim), over the square of the
    speed: |C' x C''| / |C'|**3.
    """
    tangent = unit(velocity)
    along = (acceleration * tangent).sum(axis=1, keepdims=True) * tangent
    return _over_speed_squared(np.linalg.norm(acceleration - along, axis=1), velocity)


def curvature_at(curve: PlusCurve, u: ArrayLike) -> Floats:
    """(m,) curvature of the curve at u: signed if it is plane, else `space_curvature`."""
    _, velocity, acceleration = curve.derivatives(u)
    if curve.dimension == 2:
        return curvature(velocity, acceleration)
    return space_curvature(velocity, acceleration)


def _over_speed_squared(across: Floats, velocity: Floats) -> Floats:
    speed = np.linalg.norm(velocity, axis=1)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        # Divided twice: the square of a very small speed would be zero.
        quotient: Floats = np.where(speed > 0.0, across / speed / speed, np.nan)
    return quotient
