"""How much each control point and each direction moves one point of a curve or surface.

A shape is linear in its control points P and gradients g, so its point at one parameter is

    C = sum_i R_i P_i + sum_k sum_i E_ki g_ki,     E_ki = (u_k - x_ki) R_i,

with one direction k of a curve's lines and two of a surface's planes, those of a mesh among them.
The R_i sum to one.
"""

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import blend_at
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.matrices import dense
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.shares import shares
from plusedit.geometry.surface import PlusSurface

Place = tuple[float, ...]
"""(u,) of a curve, (u, v) of a surface."""

Linear: TypeAlias = PlusCurve | PlusSurface | MeshSurface
"""What is linear in its control points and gradients."""


@dataclass(frozen=True, eq=False)
class Influence:
    """The shares of all control lines or planes in one point of the shape."""

    values: Floats
    """(n,) R_i, of the control points"""
    reaches: Floats
    """(k, n) E_ki, of the gradients"""


def influence(geometry: Linear, place: Place) -> Influence:
    """The shares at a place of a curve or surface, weights included.

    ValueError where the place has not one parameter on a curve, or two on a surface.
    """
    wanted = 1 if isinstance(geometry, PlusCurve) else 2
    if len(place) != wanted:
        raise ValueError(f"place: expected {wanted} of a parameter each, got {len(place)}")
    if isinstance(geometry, MeshSurface):
        return Influence(*shares(geometry, (place[0], place[1])))
    if isinstance(geometry, PlusCurve):
        found = blend_at(geometry.basis, np.array(place))
        values, reaches = dense(found.values)[0], dense(found.reaches)
        weights = geometry.lines.unit_weights
    else:
        by_u, by_v = (
            blend_at(basis, np.array([at])) for basis, at in zip(geometry.bases, place, strict=True)
        )
        b, d = dense(by_u.values)[0], dense(by_u.reaches)[0]
        c, e = dense(by_v.values)[0], dense(by_v.reaches)[0]
        values = np.outer(b, c).ravel()
        reaches = np.stack([np.outer(d, c).ravel(), np.outer(b, e).ravel()])
        weights = geometry.planes.unit_weights.ravel()
    total = float(values @ weights)
    return Influence(values * weights / total, reaches * weights / total)
