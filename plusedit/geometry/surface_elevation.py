"""Plus surfaces in standard form: the same surface as B-splines or NURBS of bidegree one more.

What raises the degree of a curve, Q = E P + M g, raises that of a surface way by way:

    Q = E_u P E_v' + M_u A E_v' + E_u B M_v',   A = s d^u,  B = s d^v,

with weights of W P, W A and W B, divided by E_u W E_v'. The parameters stay what they were.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.elevation import cutting, elevation
from plusedit.geometry.matrices import Banded
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_jets import sandwich


@dataclass(frozen=True, eq=False)
class BezierPatches:
    """A surface cut into Bezier surfaces of one bidegree along its knots."""

    points: Floats
    """(p_u, p_v, order_u, order_v, 3)"""
    weights: Floats | None
    """(p_u, p_v, order_u, order_v), or None where all are one"""
    breaks_u: Floats
    """(p_u + 1,) patch (i, j) lies over breaks_u[i] to [i + 1] and breaks_v[j] to [j + 1]"""
    breaks_v: Floats
    """(p_v + 1,)"""


@dataclass(frozen=True, eq=False)
class StandardSurface:
    """A clamped B-spline surface, or NURBS, on the square from 0 to 1."""

    order_u: int
    order_v: int
    knots_u: Floats
    """(n_u + order_u,) rising from `order_u` zeros to `order_u` ones"""
    knots_v: Floats
    """(n_v + order_v,)"""
    points: Floats
    """(n_u, n_v, 3)"""
    weights: Floats | None = None
    """(n_u, n_v) positive, or None where all are one"""

    def __post_init__(self) -> None:
        points = frozen(self.points, shape=(None, None, 3), name="points")
        rows, columns = points.shape[:2]
        knots_u = frozen(self.knots_u, shape=(rows + self.order_u,), name="knots_u")
        knots_v = frozen(self.knots_v, shape=(columns + self.order_v,), name="knots_v")
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "knots_u", knots_u)
        object.__setattr__(self, "knots_v", knots_v)
        if self.weights is not None:
            weights = frozen(self.weights, shape=(rows, columns), name="weights")
            object.__setattr__(self, "weights", weights)

    @property
    def degrees(self) -> tuple[int, int]:
        """By u and by v, each its order less one."""
        return self.order_u - 1, self.order_v - 1

    def at(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """(m_u, m_v, 3) points at every pair of parameters, which are clamped to [0, 1]."""
        return self._surface.at(u, v)

    def derivatives(self, u: ArrayLike, v: ArrayLike, *, highest: int = 2) -> tuple[Floats, ...]:
        """(S, S_u, S_v, S_uu, S_uv, S_vv), (m_u, m_v, 3) each, up to order `highest`."""
        return self._surface.derivatives(u, v, highest=highest)

    def bezier_patches(self) -> BezierPatches:
        """The surface between neighboring distinct knots as Bezier surfaces."""
        (cut_u, breaks_u), (cut_v, breaks_v) = (
            cutting(self.order_u, self.knots_u),
            cutting(self.order_v, self.knots_v),
        )
        points, weights = _projected(cut_u, cut_v, self.points, self.weights)
        parts = (len(breaks_u) - 1, self.order_u, len(breaks_v) - 1, self.order_v)
        patches = points.reshape(*parts, 3).transpose(0, 2, 1, 3, 4).copy()
        # Equal but for rounding; now neighbors touch exactly.
        patches[1:, :, 0] = patches[:-1, :, -1]
        patches[:, 1:, :, 0] = patches[:, :-1, :, -1]
        if weights is not None:
            weights = weights.reshape(parts).transpose(0, 2, 1, 3)
        return BezierPatches(patches, weights, breaks_u, breaks_v)

    @cached_property
    def _surface(self) -> PlusSurface:
        rows, columns = self.points.shape[:2]
        basis_u = BSpline(rows, self.order_u, knots=tuple(self.knots_u.tolist()))
        basis_v = BSpline(columns, self.order_v, knots=tuple(self.knots_v.tolist()))
        still = np.zeros((2, *self.points.shape))
        automatic = np.zeros((2, rows, columns), dtype=np.bool_)
        planes = ControlPlanes(self.points, still, automatic, self.weights)
        return PlusSurface(basis_u, basis_v, planes, s=0.0)


def elevated_surface(surface: PlusSurface) -> StandardSurface:
    """The same surface, parameters for parameters, as one B-spline or NURBS surface.

    Each degree is one more; where the surface closes it is cut open at u = 0 or v = 0. Raises
    ValueError where a family has no such form.
    """
    by_u, by_v = (elevation(basis) for basis in surface.bases)
    planes = surface.planes
    along_u, along_v = surface.gradients
    if planes.weights is None:
        points, weights = sandwich(by_u.values, planes.points, by_v.values), None
        points += sandwich(by_u.reaches, along_u, by_v.values)
        points += sandwich(by_u.values, along_v, by_v.reaches)
    else:
        share = planes.unit_weights[..., None]
        below = sandwich(by_u.values, share, by_v.values)
        points = sandwich(by_u.values, share * planes.points, by_v.values)
        points += sandwich(by_u.reaches, share * along_u, by_v.values)
        points += sandwich(by_u.values, share * along_v, by_v.reaches)
        points /= below
        weights = below[..., 0] * planes.weights.max()
    return StandardSurface(by_u.order, by_v.order, by_u.knots, by_v.knots, points, weights)


def _projected(
    left: Banded, right: Banded, points: Floats, weights: Floats | None
) -> tuple[Floats, Floats | None]:
    """The points and weights that the matrices make, by way of homogeneous coordinates."""
    if weights is None:
        return sandwich(left, points, right), None
    largest = weights.max()  # divided out: products of great weights and coordinates overflow
    share = weights[..., None] / largest
    below = sandwich(left, share, right)
    return sandwich(left, share * points, right) / below, below[..., 0] * largest
