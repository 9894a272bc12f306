"""Plus surfaces.

    S(u, v) = sum_ij W_ij L_ij(u, v) b_i(u) c_j(v) / sum_ij W_ij b_i(u) c_j(v),
    L_ij(u, v) = P_ij + s ((u - x_i) d^u_ij + (v - y_j) d^v_ij).

With B, D the matrices of the basis by u and C, E those of the one by v (`blend`), numerator and
denominator are products from both sides,

    A = B (W P) C' + s (D (W d^u) C' + B (W d^v) E'),    w = B W C',

so the surface is linear in the points and the directions, and affine in s: S = base + s plus.
"""

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import LARGEST, Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Blend, Grid, blend_at, blends_at, parameters_of
from plusedit.geometry.net import ControlNet
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface_jets import at_places, on_grid, quotients, sandwich

Way: TypeAlias = Literal["u", "v"]
"""One of the two directions of a surface."""

WAYS: tuple[Way, Way] = ("u", "v")


@dataclass(frozen=True, eq=False)
class PlusSurface:
    """Two bases, control planes and the magnitude s; an immutable value, compared by identity."""

    basis_u: Basis
    basis_v: Basis
    planes: ControlPlanes
    s: float = 1.0
    """a length per unit of parameter; any finite number, 0 for the classical surface"""

    def __post_init__(self) -> None:
        rows, columns = self.planes.shape
        if (rows, columns) != (self.basis_u.size, self.basis_v.size):
            raise ValueError(
                f"points: {rows} x {columns} control planes for bases of {self.basis_u.size} x "
                f"{self.basis_v.size}"
            )
        if not abs(self.s) <= LARGEST:
            raise ValueError(f"s: must be a finite number up to {LARGEST:g}, got {self.s}")

    @property
    def dimension(self) -> int:
        """3, as of every surface."""
        return 3

    @property
    def closed(self) -> tuple[bool, bool]:
        """Whether it closes by u, and by v: a sheet, a tube or a torus."""
        return self.basis_u.closed, self.basis_v.closed

    @property
    def bases(self) -> tuple[Basis, Basis]:
        """By u and by v."""
        return self.basis_u, self.basis_v

    @property
    def directions(self) -> Floats:
        """(2, n_u, n_v, 3) d^u and d^v, automatic ones worked out."""
        closed_u, closed_v = self.closed
        return self.planes.directions(closed_u=closed_u, closed_v=closed_v)

    @property
    def gradients(self) -> Floats:
        """(2, n_u, n_v, 3) s d^u and s d^v."""
        return self.s * self.directions

    @property
    def net(self) -> ControlPlanes:
        """The control planes, as edits see them."""
        return self.planes

    @property
    def vectors(self) -> Floats:
        """(2, n, 3) the directions in the order of the planes' numbers."""
        return self.directions.reshape(2, -1, 3)

    def with_net(self, net: ControlNet) -> "PlusSurface":
        """The same bases and s with other control planes."""
        if not isinstance(net, ControlPlanes):
            raise TypeError("a surface has control planes")
        return replace(self, planes=net)

    @cached_property
    def classical(self) -> "PlusSurface":
        """The surface of the control points alone, s = 0."""
        return replace(self, s=0.0)

    @property
    def spacings(self) -> tuple[float, float]:
        """h_u and h_v, the mean distances of nodes: 1 / (n - 1) where open, 1 / n where closed."""
        h_u, h_v = (1.0 / (b.size if b.closed else b.size - 1) for b in self.bases)
        return h_u, h_v

    def sample(self, grid_u: Grid, grid_v: Grid) -> Floats:
        """(m_u, m_v, 3) points at every pair of parameters of two grids, by cached matrices."""
        base, plus = terms(self.basis_u, self.basis_v, self.planes, grid_u, grid_v)
        points: Floats = self.s * plus
        points += base
        return points

    def at(self, u: ArrayLike, v: ArrayLike) -> Floats:
        """(m_u, m_v, 3) points at every pair of parameters u (m_u,) and v (m_v,)."""
        return self.derivatives(u, v, highest=0)[0]

    def derivatives(self, u: ArrayLike, v: ArrayLike, *, highest: int = 2) -> tuple[Floats, ...]:
        """(S, S_u, S_v, S_uu, S_uv, S_vv) up to order `highest`, at every pair of parameters.

        Each is (m_u, m_v, 3). At a knot where a derivative jumps it is that of the span to the
        right, at 1 that of the last span. Outside [0, 1] open directions are clamped, closed wrap.
        """
        by_u = blends_at(self.basis_u, parameters_of(u), highest)
        by_v = blends_at(self.basis_v, parameters_of(v), highest)
        return quotients(on_grid(self._net, by_u, by_v))

    def derivatives_at(self, places: ArrayLike, *, highest: int = 2) -> tuple[Floats, ...]:
        """The same at scattered parameters (k, 2), rows of u and v; each is (k, 3)."""
        rows = np.asarray(places, dtype=np.float64).reshape(-1, 2)
        by_u = blends_at(self.basis_u, parameters_of(rows[:, 0]), highest)
        by_v = blends_at(self.basis_v, parameters_of(rows[:, 1]), highest)
        return quotients(at_places(self._net, by_u, by_v))

    @cached_property
    def _net(self) -> Floats:
        """(n_u, n_v, 9 or 10) what is summed up, as `surface_jets` has it."""
        along_u, along_v = self.gradients
        if self.planes.weights is None:
            return np.concatenate([self.planes.points, along_u, along_v], axis=2)
        weights = self.planes.unit_weights[..., None]
        ones = np.ones_like(weights)
        net: Floats = np.concatenate([self.planes.points, ones, along_u, along_v], axis=2)
        net *= weights
        return net


@lru_cache(maxsize=48)
def _blend(basis: Basis, grid: Grid, derivative: int = 0) -> Blend:
    """As `blend`, but of local bases always banded: the products here are with wide rows."""
    return blend_at(basis, grid.parameters, derivative)


@lru_cache(maxsize=8)
def terms(
    basis_u: Basis, basis_v: Basis, planes: ControlPlanes, grid_u: Grid, grid_v: Grid
) -> tuple[Floats, Floats]:
    """The two terms that s weighs, (m_u, m_v, 3) each: the classical surface and the plus term."""
    by_u, by_v = _blend(basis_u, grid_u), _blend(basis_v, grid_v)
    along_u, along_v = planes.directions(closed_u=basis_u.closed, closed_v=basis_v.closed)
    if planes.weights is None:
        base = sandwich(by_u.values, planes.points, by_v.values)
        plus = sandwich(by_u.reaches, along_u, by_v.values)
        plus += sandwich(by_u.values, along_v, by_v.reaches)
        return base, plus
    weights = planes.unit_weights[..., None]
    below = sandwich(by_u.values, weights, by_v.values)
    base = sandwich(by_u.values, weights * planes.points, by_v.values) / below
    plus = sandwich(by_u.reaches, weights * along_u, by_v.values)
    plus += sandwich(by_u.values, weights * along_v, by_v.reaches)
    return base, plus / below


@dataclass(frozen=True, eq=False)
class TangentTerms:
    """Points and first derivatives as two terms each: S_u = base_u + s plus_u, and so on."""

    base: Floats
    """(m_u, m_v, 3), as all of them"""
    plus: Floats
    base_u: Floats
    plus_u: Floats
    base_v: Floats
    plus_v: Floats


@lru_cache(maxsize=8)
def tangent_terms(
    basis_u: Basis, basis_v: Basis, planes: ControlPlanes, grid_u: Grid, grid_v: Grid
) -> TangentTerms:
    """What points, tangents and normals are made of at every pair of parameters of two grids."""
    by_u = [_blend(basis_u, grid_u, r) for r in (0, 1)]
    by_v = [_blend(basis_v, grid_v, r) for r in (0, 1)]
    weights = planes.unit_weights[..., None]
    points = weights * planes.points
    along_u, along_v = weights * planes.directions(closed_u=basis_u.closed, closed_v=basis_v.closed)
    nothing = np.zeros_like(points)
    shares = [weights] if planes.weights is not None else []
    base = on_grid(np.concatenate([points, *shares, nothing, nothing], axis=2), by_u, by_v)
    plus = on_grid(np.concatenate([nothing, *shares, along_u, along_v], axis=2), by_u, by_v)
    pairs = zip(quotients(base), quotients(plus), strict=True)
    return TangentTerms(*(term for pair in pairs for term in pair))
