"""How the curvature of a curve runs, piece by piece: honest at knots, where it may jump.

The curvature vector k N points to the center of the osculating circle and is as long as 1 / radius.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.frames import curvature, space_curvature
from plusedit.geometry.pieces import breaks

GOLDEN = (np.sqrt(5.0) - 1.0) / 2.0
STEPS = 36  # of closing in on an extremum: beyond, equal values no longer tell where it is
SAMPLES, FEWEST = 32, 256  # to the piece and in all, among which extrema are looked for
FLAT = 1e-9  # of the largest curvature: smaller differences are rounding


@dataclass(frozen=True, eq=False)
class CurvaturePiece:
    """A stretch of a curve on which the curvature is continuous."""

    u: Floats
    """(m,) rising; the last one just before a knot"""
    points: Floats
    """(m, dim)"""
    vectors: Floats
    """(m, dim) curvature vectors k N; nan where the curve stands still"""
    curvatures: Floats
    """(m,) signed on plane curves, positive where they turn left; nan where the curve stands
    still"""


def curvature_profile(curve: PlusCurve, count: int) -> tuple[CurvaturePiece, ...]:
    """The pieces between the breaks of the basis, with about `count` samples in all.

    Every piece has 4 samples at least, its ends among them: the curvature at the end of one and
    at the start of the next tell how much it jumps.
    """
    ends = breaks(curve.basis)
    found = []
    for low, high in pairwise(ends):
        samples = max(4, round(count * (high - low)))
        u = np.linspace(low, high, samples)
        # At a knot the curvature is that of the piece to the right: just before, of the left.
        u[-1] = np.nextafter(high, 0.0)
        found.append(_piece(curve, u))
    return tuple(found)


def curvature_vectors(velocity: Floats, acceleration: Floats) -> Floats:
    """(m, dim) k N from first and second derivatives (m, dim); nan where the curve stands still."""
    tangent = unit(velocity)
    along = (acceleration * tangent).sum(axis=1, keepdims=True) * tangent
    speed = np.linalg.norm(velocity, axis=1, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        vectors: Floats = np.where(speed > 0.0, (acceleration - along) / speed / speed, np.nan)
    return vectors


def curvature_extrema(curve: PlusCurve) -> Floats:
    """(k,) parameters, rising, at which the curvature is largest or smallest among its neighbors.

    Of a plane curve its signed curvature, of a space curve its size. Ends, and knots at which it
    jumps, are none; stretches of equal curvature have none.
    """
    count = len(breaks(curve.basis)) - 1
    profile = curvature_profile(curve, max(SAMPLES * count, FEWEST))
    values = np.concatenate([piece.curvatures for piece in profile])
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    brackets = [bracket for piece in profile for bracket in _brackets(piece, FLAT * largest)]
    found = _peaks_at_knots(profile, largest)
    if brackets:
        signs, low, high = np.array(brackets).T
        found += _peaks(curve, signs, low, high).tolist()
    return np.array(sorted(found))


def _piece(curve: PlusCurve, u: Floats) -> CurvaturePiece:
    points, velocity, acceleration = curve.derivatives(u)
    signed = curvature if curve.dimension == 2 else space_curvature
    return CurvaturePiece(
        u, points, curvature_vectors(velocity, acceleration), signed(velocity, acceleration)
    )


def _brackets(piece: CurvaturePiece, least: float) -> list[tuple[float, float, float]]:
    """Sign, and the parameters about it, of every sample that is higher than its neighbors."""
    found = []
    for sign in (1.0, -1.0):
        height = sign * piece.curvatures
        before, at, after = height[:-2], height[1:-1], height[2:]
        # Two samples may be equally high, with the peak between them: the first is taken.
        is_peak = (at > before) & (at >= after) & (at - np.minimum(before, after) > least)
        rows = np.flatnonzero(is_peak)
        found += [(sign, float(piece.u[row]), float(piece.u[row + 2])) for row in rows]
    return found


def _peaks(curve: PlusCurve, signs: Floats, low: Floats, high: Floats) -> Floats:
    """(k,) where signs times the curvature are largest between parameters, by golden sections."""

    def height(u: Floats) -> Floats:
        value = signs * _piece(curve, u).curvatures
        return np.where(np.isfinite(value), value, -np.inf)

    left, right = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_left, at_right = height(left), height(right)
    for _ in range(STEPS):
        goes_on = at_left < at_right
        low, high = np.where(goes_on, left, low), np.where(goes_on, high, right)
        new = np.where(goes_on, low + GOLDEN * (high - low), high - GOLDEN * (high - low))
        value = height(new)
        left, right = np.where(goes_on, right, new), np.where(goes_on, new, left)
        at_left, at_right = (
            np.where(goes_on, at_right, value),
            np.where(goes_on, value, at_left),
        )
    middle: Floats = (low + high) / 2.0
    return middle


def _peaks_at_knots(profile: tuple[CurvaturePiece, ...], largest: float) -> list[float]:
    """Knots at which the curvature is continuous and has a peak, with slopes that differ."""
    found = []
    for before, after in pairwise(profile):
        left, right = before.curvatures, after.curvatures
        if not abs(left[-1] - right[0]) <= FLAT * largest:
            continue
        slopes = left[-1] - left[-2], right[1] - right[0]
        if slopes[0] * slopes[1] < 0.0 and min(map(abs, slopes)) > FLAT * largest:
            found.append(float(after.u[0]))
    return found
