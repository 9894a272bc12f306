"""Curves on a surface along which one parameter is constant, as plus curves.

With u fixed, the products of the surface by u (the matrices B and D of `blend`, one row of each)
can be carried out. What is left is the plus curve in v of the basis by v with

    w_j = sum_i B_i W_ij,
    w_j P_j = sum_i B_i W_ij P_ij + s D_i W_ij d^u_ij,    w_j d_j = sum_i B_i W_ij d^v_ij,

and the same s: exactly the surface's curve, for every family, closed or open, with any weights.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import blend_at, parameters_of
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.matrices import dense
from plusedit.geometry.surface import WAYS, PlusSurface, Way
from plusedit.geometry.surface_transforms import transposed


def iso_curve(surface: PlusSurface, way: Way, value: float) -> PlusCurve:
    """The curve of the surface where the parameter `way`, "u" or "v", has that value.

    It runs along the other one, parameter for parameter: for "u" C(v) = S(value, v). Where it
    is the curve of one row of planes, as at an end of most open surfaces, automatic directions
    stay automatic. ValueError if the value is not finite; outside [0, 1] it is clamped or wrapped.
    """
    if way != WAYS[0]:
        surface = transposed(surface)
    matrices = blend_at(surface.basis_u, parameters_of(value))
    shares, reaches = dense(matrices.values)[0], dense(matrices.reaches)[0]
    row = int(shares.argmax())
    if shares[row] == 1.0 and not reaches.any():
        return PlusCurve(surface.basis_v, _row(surface, row), surface.s)
    planes = surface.planes
    along_u, along_v = surface.directions
    weighted = shares[:, None] * planes.unit_weights
    below = weighted.sum(axis=0)
    weighted /= below
    # As a share of what the weights are measured by: shares may be 0 where reaches are not.
    pulls = reaches[:, None] * planes.unit_weights / below
    points = _summed(weighted, planes.points) + surface.s * _summed(pulls, along_u)
    weights = None if planes.weights is None else _kept(below * planes.weights.max())
    lines = ControlLines.of(points, list(_summed(weighted, along_v)), weights)
    return PlusCurve(surface.basis_v, lines, surface.s)


def boundary_curves(surface: PlusSurface) -> list[PlusCurve]:
    """The curves at u = 0, u = 1, v = 0 and v = 1, where the surface is open: 4, 2 or none."""
    return [
        iso_curve(surface, way, value)
        for way, closed in zip(WAYS, surface.closed, strict=True)
        if not closed
        for value in (0.0, 1.0)
    ]


def _row(surface: PlusSurface, row: int) -> ControlLines:
    """The planes (row, j) as lines along v."""
    planes = surface.planes
    weights = None if planes.weights is None else _kept(planes.weights[row])
    return ControlLines(planes.points[row], planes.given[1, row], planes.automatic[1, row], weights)


def _summed(shares: Floats, rows: Floats) -> Floats:
    """(n_v, 3) the sums along u of shares (n_u, n_v) of the rows (n_u, n_v, 3)."""
    summed: Floats = np.einsum("ij,ijd->jd", shares, rows)
    return summed


def _kept(weights: Floats) -> Floats | None:
    """The weights (n_v,), or None where they are all alike: then the curve needs none."""
    return None if (weights == weights[0]).all() else weights
