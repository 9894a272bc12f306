"""The bending energy of a curve, the integral of its squared curvature by length."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.frames import space_curvature
from plusedit.geometry.length import arc_length
from plusedit.geometry.quadrature import integral


def bending_energy(curve: PlusCurve) -> float:
    """The integral of kappa^2 ds, in 1 / (unit of the points).

    What an elastic rod of that form would hold, but for its stiffness: a circle of radius r has
    2 pi / r, a straight line zero. Corners have none of their own; a cusp, at which the curvature
    has no bound, makes it infinite.
    """

    def density(u: Floats) -> Floats:
        _, velocity, acceleration = curve.derivatives(u)
        speed = np.linalg.norm(velocity, axis=1)
        found: Floats = space_curvature(velocity, acceleration) ** 2 * speed
        return found

    length = arc_length(curve)
    if length == 0.0:
        return 0.0
    with np.errstate(all="ignore"):
        energy = integral(curve, density, 0.0, 1.0, 1e-6 / length)
    return energy if np.isfinite(energy) else np.inf
