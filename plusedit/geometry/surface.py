"""Plus surfaces.

    S(u, v) = sum_ij W_ij L_ij(u, v) b_i(u) c_j(v) / sum_ij W_ij b_i(u) c_j(v),
    L_ij(u, v) = P_ij + s ((u - x_i) d^u_ij + (v - y_j) d^v_ij).

With B, D the matrices of the basis by u and C, E those of the one by v (`blend`), numerator and
denominator are products from both sides,

    A = B (W P) C' + s (D (W d^u) C' + B (W d^v) E'),    w = B W C',

so the surface is linear in the points and the directions, and affine in s: S = base + s plus.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import LARGEST, Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Blend, Grid, blend_at, parameters_of
from plusedit.geometry.matrices import Matrix, dense
from plusedit.geometry.net import ControlNet
from plusedit.geometry.planes import ControlPlanes

Way: TypeAlias = Literal["u", "v"]
"""One of the two directions of a surface."""

WAYS: tuple[Way, Way] = ("u", "v")

ORDERS = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
"""Of the derivatives by u and v, in the order in which they are given back."""

COUNTS = (1, 3, 6)  # how many of them there are up to order 0, 1, 2


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
        by_u = [blend_at(self.basis_u, parameters_of(u), r) for r in range(highest + 1)]
        by_v = [blend_at(self.basis_v, parameters_of(v), r) for r in range(highest + 1)]
        return self._quotients(by_u, by_v, highest, sandwich)

    def derivatives_at(self, places: ArrayLike, *, highest: int = 2) -> tuple[Floats, ...]:
        """The same at scattered parameters (k, 2), rows of u and v; each is (k, 3)."""
        rows = np.asarray(places, dtype=np.float64).reshape(-1, 2)
        by_u = [blend_at(self.basis_u, parameters_of(rows[:, 0]), r) for r in range(highest + 1)]
        by_v = [blend_at(self.basis_v, parameters_of(rows[:, 1]), r) for r in range(highest + 1)]
        return self._quotients(by_u, by_v, highest, paired)

    def _quotients(
        self, by_u: list[Blend], by_v: list[Blend], highest: int, product: "Product"
    ) -> tuple[Floats, ...]:
        weights = self.planes.unit_weights[..., None]
        points = weights * self.planes.points
        along_u, along_v = weights * self.gradients
        tops, below = [], []
        for r, q in ORDERS[: COUNTS[highest]]:
            bu, bv = by_u[r], by_v[q]
            top = product(bu.values, points, bv.values)
            top += product(bu.reaches, along_u, bv.values)
            top += product(bu.values, along_v, bv.reaches)
            tops.append(top)
            if self.planes.weights is not None:
                below.append(product(bu.values, weights, bv.values))
        return _divided(tops, below) if below else tuple(tops)


def sandwich(left: Matrix, net: Floats, right: Matrix) -> Floats:
    """(a, b, dim) sum_ij left[a, i] net[i, j] right[b, j], as two products.

    Two products cost O(a n m + a m b) for each coordinate; the sum as written, O(a n m b).
    """
    n, m, dim = net.shape
    by_columns = np.ascontiguousarray(net.transpose(1, 0, 2)).reshape(m, n * dim)
    rows = (right @ by_columns).reshape(-1, n, dim)
    # Turned round here, where there are few rows, and not afterwards, where there are many.
    lines = np.ascontiguousarray(rows.transpose(1, 0, 2)).reshape(n, -1)
    return np.asarray(left @ lines).reshape(-1, len(rows), dim)


def paired(left: Matrix, net: Floats, right: Matrix) -> Floats:
    """(k, dim) sum_ij left[k, i] net[i, j] right[k, j]: one point for each pair of rows."""
    n, m, dim = net.shape
    rows = (left @ net.reshape(n, m * dim)).reshape(-1, m, dim)
    found: Floats = np.einsum("km,kmd->kd", dense(right), rows)
    return found


Product: TypeAlias = Callable[[Matrix, Floats, Matrix], Floats]


def _divided(tops: list[Floats], below: list[Floats]) -> tuple[Floats, ...]:
    """The quotient of numerators and denominators and its derivatives, in the order of ORDERS.

    S_u = (A_u - w_u S) / w, S_uu = (A_uu - 2 w_u S_u - w_uu S) / w,
    S_uv = (A_uv - w_u S_v - w_v S_u - w_uv S) / w.
    """
    w = below[0]
    at = tops[0] / w
    if len(tops) == 1:
        return (at,)
    by_u, by_v = (tops[1] - below[1] * at) / w, (tops[2] - below[2] * at) / w
    if len(tops) == 3:
        return at, by_u, by_v
    by_uu = (tops[3] - 2.0 * below[1] * by_u - below[3] * at) / w
    by_uv = (tops[4] - below[1] * by_v - below[2] * by_u - below[4] * at) / w
    by_vv = (tops[5] - 2.0 * below[2] * by_v - below[5] * at) / w
    return at, by_u, by_v, by_uu, by_uv, by_vv


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
    found: list[tuple[Floats, Floats]] = []
    below: list[Floats] = []
    for r, q in ORDERS[:3]:
        bu, bv = by_u[r], by_v[q]
        plus = sandwich(bu.reaches, along_u, bv.values)
        plus += sandwich(bu.values, along_v, bv.reaches)
        found.append((sandwich(bu.values, points, bv.values), plus))
        if planes.weights is not None:
            below.append(sandwich(bu.values, weights, bv.values))
    if below:
        divided = [_divided([pair[way] for pair in found], below) for way in (0, 1)]
        found = list(zip(*divided, strict=True))
    return TangentTerms(*found[0], *found[1], *found[2])
