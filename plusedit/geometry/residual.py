"""How far points are from a curve that goes along them."""

from dataclasses import dataclass

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.nearest import nearest_parameters


@dataclass(frozen=True, eq=False)
class Residual:
    """Points and their feet on a curve."""

    points: Floats
    """(m, dim)"""
    feet: Floats
    """(m, dim) the nearest points of the curve"""

    @property
    def distances(self) -> Floats:
        """(m,)"""
        lengths: Floats = np.linalg.norm(self.points - self.feet, axis=1)
        return lengths

    @property
    def largest(self) -> float:
        """The largest distance."""
        return float(self.distances.max())

    @property
    def rms(self) -> float:
        """The root of the mean square of the distances."""
        return float(np.sqrt(np.mean(self.distances**2)))


def residual(curve: PlusCurve, points: Floats) -> Residual:
    """The points (m, dim) with the points of the curve that are nearest to them."""
    return Residual(points, curve.at(nearest_parameters(curve, points)))
