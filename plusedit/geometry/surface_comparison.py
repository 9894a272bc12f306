"""Families of surfaces compared by how well they come near the same grid of points.

With B, D the matrices by u and C, E those by v, the surface is linear in its control points P and
gradients U and V,

    S = B P C' + D U C' + B V E'.

Classical surfaces separate into curves by u and curves by v. For plus surfaces all is solved at
once, in the coordinates of an orthonormal basis of the columns of [B D] by u and of [C E] by v:
what of the points lies outside of these, no surface reaches. The points keep their parameters.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import blends_at
from plusedit.geometry.comparison import (
    KINDS,
    RANK,
    SPREAD,
    Check,
    Fit,
    Kind,
    basis_of,
    is_plus,
    least_moves,
    reaches_of,
    row_matrix,
)
from plusedit.geometry.matrices import dense
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_magnitude import natural_length


@dataclass(frozen=True, eq=False)
class SampledSurface:
    """Points of a surface to come near to."""

    points: Floats
    """(m_u, m_v, 3)"""
    u: Floats
    """(m_u,) parameters from 0 to 1, rising"""
    v: Floats
    """(m_v,)"""

    @classmethod
    def even(cls, points: Floats) -> "SampledSurface":
        """Points at even parameters."""
        rows, columns = points.shape[:2]
        return cls(points, np.linspace(0.0, 1.0, rows), np.linspace(0.0, 1.0, columns))


def surface_fits(
    sampled: SampledSurface,
    sizes: Sequence[int],
    *,
    kinds: Sequence[Kind] = KINDS,
    order: int = 4,
    check: Check = lambda: None,
) -> Iterator[Fit]:
    """Surfaces of those families with so many control elements each way, one after the other."""
    for size in sizes:
        for kind in kinds:
            check()
            yield fit_surface(sampled, kind, size, order=order)


def fit_surface(sampled: SampledSurface, kind: Kind, size: int, *, order: int = 4) -> Fit:
    """The surface of that family with `size` x `size` control elements nearest to the points.

    Distances are those from each point to the point of the surface of the same parameters.
    """
    basis = basis_of(kind, size, order)
    ways = _Way.of(basis, sampled.u), _Way.of(basis, sampled.v)
    made = (_plus if is_plus(kind) else _classical)(sampled.points, *ways)
    surface = _surface(basis, *made) if is_plus(kind) else _still(basis, made[0])
    apart = np.linalg.norm(surface.at(sampled.u, sampled.v) - sampled.points, axis=2)
    return Fit(kind, surface, float(apart.max()), float(np.sqrt(np.mean(apart**2))))


@dataclass(frozen=True, eq=False)
class _Way:
    """What is known of one of the ways of a surface."""

    values: Floats
    """B (m, n)"""
    reaches: Floats
    """D (m, n)"""
    scale: Floats
    """(n,) how far gradients move it"""
    to_nodes: Floats
    """(n, m) from the points to what they are at the nodes, about"""
    to_slopes: Floats
    """(n, m) and to half their slopes there"""

    @classmethod
    def of(cls, basis: Basis, u: Floats) -> "_Way":
        both = blends_at(basis, u, 0)[0]
        values, reaches = dense(both.values), dense(both.reaches)
        x, width = basis.nodes, SPREAD / basis.size
        low, high = np.clip(x - width, 0.0, 1.0), np.clip(x + width, 0.0, 1.0)
        slopes = (row_matrix(u, high) - row_matrix(u, low)) / (2.0 * (high - low)[:, None])
        return cls(values, reaches, reaches_of(values, reaches), row_matrix(u, x), slopes)

    @property
    def frame(self) -> Floats:
        """(m, r) orthonormal columns that span those of B and D."""
        left, sizes, _ = np.linalg.svd(
            np.hstack([self.values, self.reaches / self.scale]), full_matrices=False
        )
        kept: Floats = left[:, sizes > RANK * sizes[0]]
        return kept


def _classical(points: Floats, by_u: _Way, by_v: _Way) -> tuple[Floats]:
    """(n, n, 3) the control points of least squares."""
    from_u, from_v = (np.linalg.pinv(way.values, rcond=RANK) for way in (by_u, by_v))
    return (np.einsum("iu,uvd,jv->ijd", from_u, points, from_v, optimize=True),)


def _plus(points: Floats, by_u: _Way, by_v: _Way) -> tuple[Floats, Floats, Floats]:
    """(n, n, 3) control points and gradients by u and by v of least squares.

    Of several the nearest to the points at the nodes, with half their slopes.
    """
    at = _both(by_u.to_nodes, points, by_v.to_nodes)
    along_u = _both(by_u.to_slopes, points, by_v.to_nodes)
    along_v = _both(by_u.to_nodes, points, by_v.to_slopes)
    left = points - _both(by_u.values, at, by_v.values)
    left -= _both(by_u.reaches, along_u, by_v.values)
    left -= _both(by_u.values, along_v, by_v.reaches)
    frame_u, frame_v = by_u.frame.T, by_v.frame.T
    b, d = frame_u @ by_u.values, frame_u @ by_u.reaches / by_u.scale
    c, e = frame_v @ by_v.values, frame_v @ by_v.reaches / by_v.scale
    matrix = np.hstack([np.kron(b, c), np.kron(d, c), np.kron(b, e)])
    goal = _both(frame_u, left, frame_v).reshape(-1, 3)
    moves = least_moves(matrix, goal).reshape(3, *at.shape)
    moved_u = moves[1] / by_u.scale[:, None, None]
    moved_v = moves[2] / by_v.scale[:, None]
    return at + moves[0], along_u + moved_u, along_v + moved_v


def _both(left: Floats, points: Floats, right: Floats) -> Floats:
    product: Floats = np.einsum("iu,uvd,jv->ijd", left, points, right, optimize=True)
    return product


def _still(basis: Basis, points: Floats) -> PlusSurface:
    return PlusSurface(basis, basis, ControlPlanes.of(points), s=0.0)


def _surface(basis: Basis, points: Floats, along_u: Floats, along_v: Floats) -> PlusSurface:
    """The surface with half its natural length for s, as the scale of directions."""
    planes = ControlPlanes.of(points)
    s = natural_length(PlusSurface(basis, basis, planes)) / 2.0 or 1.0
    return PlusSurface(basis, basis, planes.with_directions(np.stack([along_u, along_v]) / s), s)
