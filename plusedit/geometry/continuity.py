"""How smoothly a curve goes on at its knots and its seam, and two curves where they meet."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import inf

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.bases import Basis, is_local
from plusedit.geometry.blend import Grid
from plusedit.geometry.curvature_profile import curvature_vectors
from plusedit.geometry.curve import PlusCurve

SAME = 1e-9  # of the size: points nearer than that are one
STRAIGHT = 1e-7  # radians: less is no corner
EVEN = 1e-6  # of the larger curvature: less is no jump
SENSES = (1.0, -1.0, 1.0)  # of points and derivatives, where a curve is run backwards


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
    grid, count = _knots(curve.basis)
    jets = curve.jets(grid)
    before, after = ([rows[half] for rows in jets] for half in (slice(count), slice(count, None)))
    size = _size(curve)
    found = _joints(grid.parameters[count:], before, after, size)
    # The seam comes last; on an open curve it is one only where the ends meet.
    return found if curve.closed or found[-1].order >= 0 else found[:-1]


@lru_cache(maxsize=32)
def _knots(basis: Basis) -> tuple[Grid, int]:
    """All knots inside and the seam: just before each, then at each; and how many there are."""
    inner = basis.breaks[1:-1] if is_local(basis) else np.zeros(0)
    before = np.nextafter(np.append(inner, 1.0), -inf)
    return Grid(np.concatenate([before, inner, [0.0]])), len(before)


def meeting(first: PlusCurve, second: PlusCurve) -> tuple[Joint, ...]:
    """The joints where an end of one open curve lies on an end of another."""
    if first.closed or second.closed or first.dimension != second.dimension:
        return ()
    size = max(_size(first), _size(second))
    found: list[Joint] = []
    for end in (0.0, 1.0):
        leaving = first.derivatives([np.nextafter(end, -inf) if end else end])
        for start in (0.0, 1.0):
            going = second.derivatives([np.nextafter(start, -inf) if start else start])
            # At the start of a curve one leaves it against its sense, at its end goes on against.
            out = [rows if end else rows * sign for rows, sign in zip(leaving, SENSES, strict=True)]
            on = [rows * sign if start else rows for rows, sign in zip(going, SENSES, strict=True)]
            found += _joints(np.array([start]), out, on, size)
    return tuple(joint for joint in found if joint.order >= 0)


def _joints(
    u: Floats, before: Sequence[Floats], after: Sequence[Floats], size: float
) -> tuple[Joint, ...]:
    """The joints at parameters (m,), from points and derivatives (m, dim) on both sides."""
    angles = _angles(unit(before[1]), unit(after[1]))
    gaps = np.linalg.norm(after[0] - before[0], axis=1)
    bends = [
        np.nan_to_num(curvature_vectors(*jet[1:]), posinf=0.0, neginf=0.0)
        for jet in (before, after)
    ]
    rows = zip(u.tolist(), before[0], gaps.tolist(), angles.tolist(), *bends, strict=True)
    return tuple(
        Joint(at, point, gap, angle, one, other, size) for at, point, gap, angle, one, other in rows
    )


def _angles(one: Floats, other: Floats) -> Floats:
    """(m,) angles between unit vectors (m, dim); nan where there is none."""
    # Of sum and difference, which keep all digits where the arc cosine loses half of them.
    sides = np.linalg.norm(one - other, axis=1), np.linalg.norm(one + other, axis=1)
    is_still = ~(one.any(axis=1) & other.any(axis=1))
    return np.where(is_still, np.nan, 2.0 * np.arctan2(*sides))


def _size(curve: PlusCurve) -> float:
    return float(np.ptp(curve.lines.points, axis=0).max()) or 1.0
