"""A curve turned about an axis: S(u, v) = R(u) C(v), with circles exactly.

With the quadratic rational functions R_i of a circle and its control points, each point and
direction x of the profile has the images T_i x, T_i a turn that on every second i also stretches
what is off the axis, by 1 / cos of half the angle of a piece; R(u) = sum_i R_i(u) T_i. The weights
are products w_i W_j, so the sums over i and j part, and S is R(u) times the profile for every s.
That asks for zero directions by u: any others would leave the circle.
"""

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.making.compatible import in_space
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.standard import elliptic_arc
from plusedit.geometry.surface import PlusSurface

WHOLE = 2.0 * np.pi
ON_AXIS = 1e-9  # of the extent: a profile that is nowhere farther from the axis makes no surface


def revolved(
    curve: PlusCurve, point: ArrayLike, axis: ArrayLike, angle: float = WHOLE
) -> PlusSurface:
    """The surface that the curve sweeps when it is turned about an axis, exactly.

    Parameters
    ----------
    point, axis
        (3,) a point of the axis, and its direction, of any length.
    angle
        In radians, counterclockwise as seen from where the axis points to; up to one turn, either
        way.

    u runs around, in quarters with double knots between them, and v along the curve, in its basis,
    with its directions and s. After a whole turn the last planes lie where the first ones do.
    ValueError for an axis of length zero, an angle of zero or of more than one turn, and for a
    curve that lies on the axis.
    """
    center, along = frozen(point, shape=(3,), name="point"), frozen(axis, shape=(3,), name="axis")
    if not along.any():
        raise ValueError("An axis needs a direction.")
    if not 0.0 < abs(angle) <= WHOLE * (1.0 + 1e-12):
        raise ValueError("A curve can be turned by up to 360 degrees, and by more than none.")
    along = along / np.linalg.norm(along)
    profile = in_space(curve)
    points, vectors = profile.lines.points - center, profile.directions
    _check_off_axis(profile.at(np.linspace(0.0, 1.0, 65)) - center, along)
    circle = elliptic_arc((0.0, 0.0), (1.0, 0.0), (0.0, 1.0), sweep=angle)
    turns = _turns(circle.lines.points, along)
    given = np.zeros((2, len(turns), *points.shape))
    given[1] = np.einsum("iab,jb->ija", turns, vectors)
    weights = circle.lines.unit_weights[:, None] * profile.lines.unit_weights
    planes = ControlPlanes(
        center + np.einsum("iab,jb->ija", turns, points),
        given,
        np.zeros(given.shape[:3], dtype=np.bool_),
        weights,
    )
    return PlusSurface(circle.basis, profile.basis, planes, profile.s)


def _turns(circle: Floats, along: Floats) -> Floats:
    """(n, 3, 3) for every control point (cos, sin) of the circle what it makes of the profile.

    Along the axis it leaves all as it is; across, it turns, and stretches by the point's distance.
    """
    kept = np.outer(along, along)
    across = np.eye(3) - kept
    x, y, z = along
    quarter = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    cos, sin = circle.T[:, :, None, None]
    turns: Floats = kept + cos * across + sin * quarter
    return turns


def _check_off_axis(points: Floats, along: Floats) -> None:
    off = points - np.outer(points @ along, along)
    extent = max(float(np.ptp(points, axis=0).max()), float(np.abs(points).max()))
    if np.abs(off).max() <= ON_AXIS * extent:
        raise ValueError("The curve lies on the axis; turned about it, it makes no surface.")
