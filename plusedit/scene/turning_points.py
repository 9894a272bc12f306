"""Inflections of curves and the places of extremal curvature, found once for each curve."""

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curvature_profile import curvature_extrema, curvature_vectors
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.frames import curvature_at
from plusedit.geometry.inflections import inflections


@dataclass(frozen=True, eq=False)
class TurningPoints:
    """Where a curve changes how it bends."""

    inflections: Floats
    """(k, dim) points; none of curves in space, which have no sense of turning"""
    extrema: Floats
    """(m, dim) points at which the curvature is extremal among its neighbors"""
    curvatures: Floats
    """(m,) there, signed on plane curves"""
    outward: Floats
    """(m, dim) of length one, away from the centers of curvature; zero where there is none"""


_KEPT: "WeakKeyDictionary[PlusCurve, TurningPoints]" = WeakKeyDictionary()


def turning_points(curve: PlusCurve) -> TurningPoints:
    """Those of a curve; the same arrays for the same curve."""
    found = _KEPT.get(curve)
    if found is None:
        turns = inflections(curve) if curve.dimension == 2 else np.zeros(0)
        extrema = curvature_extrema(curve)
        points, velocity, acceleration = curve.derivatives(extrema)
        vectors = np.nan_to_num(curvature_vectors(velocity, acceleration))
        found = _KEPT[curve] = TurningPoints(
            curve.at(turns), points, curvature_at(curve, extrema), -unit(vectors)
        )
    return found
