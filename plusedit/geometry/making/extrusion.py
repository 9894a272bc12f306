"""A curve moved straight on: S(u, v) = C(u) + v e."""

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.making.compatible import in_space
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface

STRAIGHT = 1e-9  # of their length: points that are nowhere farther from a line lie on it


def extruded(curve: PlusCurve, by: ArrayLike, *, count: int = 2) -> PlusSurface:
    """The surface that the curve sweeps when it is moved by the vector (3,), exactly.

    u runs along the curve, in its basis, and v along the vector, in `count` rows of planes. At
    every v it is the curve with its own directions and s. The directions by v are the same along
    every row, and so leave the surface straight for any s. ValueError if the vector is zero.
    """
    way = frozen(by, shape=(3,), name="by")
    if not way.any():
        raise ValueError("A curve has to be moved by more than nothing to sweep a surface.")
    lines, basis_v = in_space(curve).lines, Bernstein(count)
    points = lines.points[:, None] + basis_v.nodes[:, None] * way
    given = np.zeros((2, *points.shape))
    given[0] = lines.given[:, None]
    automatic = np.ones((2, *points.shape[:2]), dtype=np.bool_)
    automatic[0] = lines.automatic[:, None]
    planes = ControlPlanes(points, given, automatic, columns(lines.weights, count))
    return PlusSurface(curve.basis, basis_v, planes, curve.s)


def columns(weights: Floats | None, count: int) -> Floats | None:
    """(n, count) the same weights (n,) in every column; None stays None."""
    return None if weights is None else np.repeat(weights[:, None], count, axis=1)


def normal_of(points: Floats) -> Floats:
    """(3,) the unit normal of the plane nearest to points (m, 3), its largest coordinate positive.

    Of points on a straight line, or in one place: z, or x where the line runs along z.
    """
    _, extents, axes = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)
    normal: Floats = axes[2]
    if extents[1] <= STRAIGHT * extents[0]:
        normal = np.array([0.0, 0.0, 1.0]) if abs(axes[0, 2]) < 0.9 else np.array([1.0, 0.0, 0.0])
    return normal if normal[np.abs(normal).argmax()] > 0.0 else -normal
