"""The functions that blend control lines, as a shape with its weights has them.

    R_i(u) = W_i b_i(u) / sum_k W_k b_k(u),     E_i(u) = (u - x_i) R_i(u),

so that C(u) = sum_i P_i R_i(u) + s sum_i d_i E_i(u). On a surface they are those of the curve with
the other parameter fixed: there the weight of a row is sum_j W_ij c_j(v).
"""

from dataclasses import dataclass

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import blend_at
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.matrices import dense
from plusedit.geometry.surface import WAYS, PlusSurface, Way


@dataclass(frozen=True, eq=False)
class BlendingFunctions:
    """All functions of a basis with weights, at some parameters."""

    u: Floats
    """(m,)"""
    values: Floats
    """(m, n) R_i"""
    reaches: Floats
    """(m, n) E_i; of a closed basis over all images, each with its own node"""


def functions_at(basis: Basis, u: Floats, weights: Floats | None = None) -> BlendingFunctions:
    """The functions at parameters u (m,), with weights (n,) where they are not all one."""
    found = blend_at(basis, u)
    values, reaches = dense(found.values), dense(found.reaches)
    if weights is not None:
        below = (values @ weights)[:, None]
        values, reaches = values * weights / below, reaches * weights / below
    return BlendingFunctions(u, values, reaches)


def curve_functions(curve: PlusCurve, u: Floats) -> BlendingFunctions:
    """Those of a curve."""
    weights = None if curve.lines.weights is None else curve.lines.unit_weights
    return functions_at(curve.basis, u, weights)


def row_functions(
    surface: PlusSurface, way: Way, at: Floats, other: float = 0.5
) -> BlendingFunctions:
    """Those of the rows of a surface along `way`, where the other parameter is `other`.

    Without weights they are the same for every value of the other parameter.
    """
    basis = surface.basis_u if way == WAYS[0] else surface.basis_v
    return functions_at(basis, at, row_weights(surface, way, other))


def row_weights(surface: PlusSurface, way: Way, other: float) -> Floats | None:
    """(n,) the weights of the rows along `way` for that value of the other parameter.

    None where the surface has none.
    """
    planes = surface.planes
    if planes.weights is None:
        return None
    weights = planes.unit_weights if way == WAYS[0] else planes.unit_weights.T
    across = surface.basis_v if way == WAYS[0] else surface.basis_u
    shares = dense(blend_at(across, np.array([other])).values)[0]
    found: Floats = weights @ shares
    return found
