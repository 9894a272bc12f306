"""How smoothly a curve goes on at its knots and its seam, and two curves where they meet."""

from dataclasses import dataclass
from math import atan2, inf

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.bases import is_local
from plusedit.geometry.curvature_profile import curvature_vectors
from plusedit.geometry.curve import PlusCurve

SAME = 1e-9  # of the size: points nearer than that are one
STRAIGHT = 1e-7  # radians: less is no corner
EVEN = 1e-6  # of the larger curvature: less is no jump


@dataclass(frozen=True, eq=False)
class Joint:
    """A place where two pieces meet."""

    u: float
    """of the curve that goes on"""
    point: Floats
    """(dim,) where the piece before ends"""
    gap: float
    """the distance to where the next begins"""
    angle: float
    """radians between the tangents, 0 to pi; nan where a piece stands still there"""
    before: Floats
    """(dim,) the curvature vector on the side before"""
    after: Floats
    size: float
    """of the curves: what is small beside it is rounding"""

    @property
    def jump(self) -> float:
        """How much the curvature vector changes, in 1 / (unit of the points)."""
        return float(np.linalg.norm(self.after - self.before))

    @property
    def order(self) -> int:
        """2 where curvature goes on (G2), 1 where the tangent does (G1), 0 where the place does
        (G0), -1 where there is a gap."""
        if self.gap > SAME * self.size:
            return -1
        if not self.angle <= STRAIGHT:
            return 0
        largest = max(float(np.linalg.norm(bend)) for bend in (self.before, self.after))
        return 2 if self.jump <= EVEN * largest + SAME / self.size else 1


def joints(curve: PlusCurve) -> tuple[Joint, ...]:
    """The joints at the knots of a curve, at the seam too where its ends meet."""
    basis = curve.basis
    inner = basis.breaks[1:-1].tolist() if is_local(basis) else []
    found = [_joint(curve, u, curve, u) for u in inner]
    if curve.closed:
        found.append(_joint(curve, 1.0, curve, 0.0))
    else:
        seam = _joint(curve, 1.0, curve, 0.0)
        if seam.order >= 0:
            found.append(seam)
    return tuple(found)


def meeting(first: PlusCurve, second: PlusCurve) -> tuple[Joint, ...]:
    """The joints where an end of one open curve lies on an end of another."""
    if first.closed or second.closed or first.dimension != second.dimension:
        return ()
    found = []
    for end in (0.0, 1.0):
        for start in (0.0, 1.0):
            joint = _joint(first, end, second, start)
            if joint.order >= 0:
                found.append(joint)
    return tuple(found)


def _joint(first: PlusCurve, end: float, second: PlusCurve, start: float) -> Joint:
    """Where `first` is left at a parameter and `second` is gone along from another.

    At the start of an open curve, one leaves it against its sense; at its end, goes along it so.
    """
    inner = first is second
    leaving = _jet(first, end, before=inner or end > 0.0)
    going = _jet(second, start, before=not inner and start > 0.0)
    way_out = unit(leaving[1])[0] * (1.0 if inner or end > 0.0 else -1.0)
    way_on = unit(going[1])[0] * (1.0 if inner or start == 0.0 else -1.0)
    size = max(float(np.ptp(c.lines.points, axis=0).max()) for c in (first, second)) or 1.0
    bends = (curvature_vectors(jet[1], jet[2])[0] for jet in (leaving, going))
    before, after = (np.where(np.isfinite(bend), bend, 0.0) for bend in bends)
    return Joint(
        start,
        leaving[0][0],
        float(np.linalg.norm(going[0][0] - leaving[0][0])),
        _angle(way_out, way_on),
        before,
        after,
        size,
    )


def _jet(curve: PlusCurve, u: float, *, before: bool) -> tuple[Floats, ...]:
    """Point and derivatives on one side of a parameter."""
    at = np.nextafter(u, -inf) if before and 0.0 < u <= 1.0 else u
    return curve.derivatives([at])


def _angle(one: Floats, other: Floats) -> float:
    if not (one.any() and other.any()):
        return float("nan")
    # Of sum and difference, which keep all digits where the arc cosine loses half of them.
    return 2.0 * atan2(float(np.linalg.norm(one - other)), float(np.linalg.norm(one + other)))
