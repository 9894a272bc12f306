"""Two curves joined by straight lines: S(u, v) = (1 - v) C_0(u) + v C_1(u)."""

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.making.compatible import compatible
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface


def ruled(first: PlusCurve, second: PlusCurve, *, tolerance: float | None = None) -> PlusSurface:
    """The surface of straight lines from each point of one curve to that of the other.

    u runs along the curves, v from the first to the second. Both are met with their directions
    and s, exactly unless they had to be fitted: see `compatible`, and its `tolerance`. The lines
    are straight for every s, also between curves of different weights.
    """
    alike = compatible([first, second], tolerance=tolerance).curves
    lines = [curve.lines for curve in alike]
    points = np.stack([of.points for of in lines], axis=1)
    given, automatic = np.zeros((2, *points.shape)), np.ones((2, *points.shape[:2]), dtype=np.bool_)
    given[0] = np.stack([of.given for of in lines], axis=1)
    automatic[0] = np.stack([of.automatic for of in lines], axis=1)
    weights = _weights(lines)
    if weights is not None:
        # With W d^v alike at both ends, what s adds by v falls away.
        means = np.sqrt(weights[:, :1] * weights[:, 1:])
        ahead = unit(points[:, 1] - points[:, 0])[:, None]
        given[1], automatic[1] = (means / weights)[..., None] * ahead, False
    planes = ControlPlanes(points, given, automatic, weights)
    return PlusSurface(alike[0].basis, Bernstein(2), planes, alike[0].s)


def _weights(lines: list[ControlLines]) -> Floats | None:
    if all(of.weights is None for of in lines):
        return None
    return np.stack([of.unit_weights for of in lines], axis=1)
