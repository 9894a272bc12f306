"""Directions that lead a surface through its own control points.

At the nodes the surface is linear in the gradients: what the changes X of A and Y of B add there is

    (D (W X) C' + B (W Y) E') / w,    w = B W C',

with the square matrices B, D by u and C, E by v. Of all changes that put the surface onto its
control points the least is wanted. Without weights the singular value decomposition of D' and B'
as a pair (Golub & Van Loan, Matrix Computations, 6.1.6), with orthogonal U and V,

    D = F c U',  B = F s V',   and likewise   E = G c~ U~',  C = G s~ V~',

splits the problem into one for each pair (i, j), c_i s~_j X_ij + s_i c~_j Y_ij = (F^-1 R G^-T)_ij,
whose least solution is known. That is exact, and takes no more than n_u^3 + n_v^3. Weights that
are products of one by u and one by v go into the matrices. Any other weights make the same split
the preconditioner of conjugate gradients; what these leave is brought to zero by the split.
"""

from dataclasses import dataclass, replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid, blend
from plusedit.geometry.matrices import dense
from plusedit.geometry.passing import RANK, UNCHANGED
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_jets import sandwich

STEPS = 60  # of conjugate gradients at most: more only where weights are wildly unequal
DONE = 1e-4  # of what was missing: what is put right after that is as good as least
NOTHING = 1e-8  # of c or s, which are of the size of 1 / n^2 or zero
ROUNDS = 3  # of putting right what rounding left
PRODUCT = 1e-12  # relative: weights that near to products are products


@dataclass(frozen=True, eq=False)
class PassedSurface:
    """A surface with new directions, and how far it still misses its control points."""

    surface: PlusSurface
    largest_miss: float
    """in the unit of the points; rounding where the surface passes through all of them"""


def passing_through_surface(surface: PlusSurface) -> PlusSurface:
    """The surface through its control points with the least change of its gradients.

    Where that can't be done, as on most surfaces that close with even numbers of planes, the one
    that comes closest; `passed_surface` says how close. Points, weights and s stay, and so do
    automatic directions that need no change. Raises ValueError if s is zero, so that directions
    have no effect.
    """
    return passed_surface(surface).surface


def passed_surface(surface: PlusSurface) -> PassedSurface:
    """`passing_through_surface`, and how far the surface still is from its control points."""
    if surface.s == 0.0:
        raise ValueError("With s = 0 control planes have no effect; set s first.")
    problem = _problem(surface)
    missing = _missing(surface.planes.points, surface)
    change = problem.least_change(missing)
    best = _changed(surface, change)
    for _ in range(ROUNDS):
        change = change + problem.any_change(_missing(surface.planes.points, best))
        again = _changed(surface, change)
        if np.linalg.norm(misses(again)) >= np.linalg.norm(misses(best)):
            break
        best = again
    return PassedSurface(best, float(misses(best).max()))


def misses(surface: PlusSurface) -> Floats:
    """(n_u, n_v) how far the surface is from each control point at the nodes of its plane."""
    return np.asarray(np.linalg.norm(_missing(surface.planes.points, surface), axis=2))


def _missing(points: Floats, surface: PlusSurface) -> Floats:
    """(n_u, n_v, 3) from the surface at the nodes to the points."""
    at_nodes = (Grid(basis.nodes) for basis in surface.bases)
    return points - surface.sample(*at_nodes)


def _changed(surface: PlusSurface, change: Floats) -> PlusSurface:
    """The surface with other gradients; directions that stay as they are stay automatic."""
    size = np.linalg.norm(change, axis=-1)
    planes = surface.planes
    is_new = size > UNCHANGED * max(float(size.max()), float(np.abs(surface.gradients).max()))
    directions = surface.directions + change / surface.s
    given = np.where(is_new[..., None], directions, planes.given)
    return replace(
        surface, planes=replace(planes, given=given, automatic=planes.automatic & ~is_new)
    )


def _problem(surface: PlusSurface) -> "_Problem":
    matrices = [_matrices(basis) for basis in surface.bases]
    weights = surface.planes.unit_weights
    heights = np.log(weights)
    factors = np.exp(heights.mean(axis=1) - heights.mean()), np.exp(heights.mean(axis=0))
    others = weights / np.outer(*factors)
    by_u, by_v = (_rational(*pair, row) for pair, row in zip(matrices, factors, strict=True))
    splits = _split(*by_u), _split(*by_v)
    if np.abs(others - 1.0).max() <= PRODUCT:
        return _Problem(*splits, None, np.ones(weights.shape))
    return _Problem(*splits, others[..., None], by_u[0] @ others @ by_v[0].T)


def _matrices(basis: Basis) -> tuple[Floats, Floats]:
    """B and D at the nodes."""
    matrices = blend(basis, Grid(basis.nodes))
    return dense(matrices.values), dense(matrices.reaches)


def _rational(values: Floats, reaches: Floats, weights: Floats) -> tuple[Floats, Floats]:
    """B and D of the rational functions with the weights (n,)."""
    share = weights / (values @ weights)[:, None]
    return values * share, reaches * share


@dataclass(frozen=True, eq=False)
class _Split:
    """Of one way: B and D, and the parts of their common decomposition."""

    values: Floats
    """B (n, n)"""
    reaches: Floats
    """D (n, n)"""
    inverse: Floats
    """the pseudo-inverse of F, (r, n)"""
    c: Floats
    """(r,) D = F c U'"""
    s: Floats
    """(r,) B = F s V'; c^2 + s^2 = 1"""


def _split(values: Floats, reaches: Floats) -> _Split:
    # [D'; B'] = Q S T', then U c W' is the upper half of Q: D' = U c (W' S T') = U c F'.
    Q, S, T = np.linalg.svd(np.concatenate([reaches.T, values.T]), full_matrices=False)
    rank = int((RANK * S[0] < S).sum())
    n, Q, S, T = len(values), Q[:, :rank], S[:rank], T[:rank]
    _, c, W = np.linalg.svd(Q[:n], full_matrices=False)
    s = np.linalg.norm(Q[n:] @ W.T, axis=0)
    return _Split(values, reaches, W @ (T / S[:, None]), c, np.asarray(s))


@dataclass(frozen=True, eq=False)
class _Problem:
    """The changes of gradients, (2, n_u, n_v, 3), that put right what is missing."""

    by_u: _Split
    by_v: _Split
    weights: Floats | None
    """(n_u, n_v, 1) what is left of them beside those in the matrices; None if nothing is"""
    sums: Floats
    """(n_u, n_v) w, divided by that of the weights in the matrices"""

    def any_change(self, missing: Floats) -> Floats:
        """One that does for what is missing (n_u, n_v, 3): the least, or with weights W X, W Y."""
        wanted = self.sums[..., None] * self._within_reach(missing)
        change = self._pulled(self._solved(wanted))
        return change if self.weights is None else change / self.weights

    def least_change(self, missing: Floats) -> Floats:
        """The least, to next to nothing of what is missing."""
        if self.weights is None:
            return self.any_change(missing)
        rest = self.sums[..., None] * self._within_reach(missing)
        allowed, found = DONE * np.linalg.norm(rest), np.zeros_like(rest)
        step = solved = self._solved(rest)
        progress = float((rest * solved).sum())
        for _ in range(STEPS):
            if np.linalg.norm(rest) <= allowed or progress <= 0.0:
                break
            effect = self._pushed(self.weights**2 * self._pulled(step))
            share = progress / float((step * effect).sum())
            found, rest = found + share * step, rest - share * effect
            solved = self._solved(rest)
            before, progress = progress, float((rest * solved).sum())
            step = solved + progress / before * step
        return self.weights * self._pulled(found)

    def _pulled(self, Y: Floats) -> Floats:
        """D' Y C and B' Y E."""
        u, v = self.by_u, self.by_v
        return np.stack(
            [
                sandwich(u.reaches.T, Y, v.values.T),
                sandwich(u.values.T, Y, v.reaches.T),
            ]
        )

    def _pushed(self, change: Floats) -> Floats:
        """D X C' + B Y E'."""
        u, v = self.by_u, self.by_v
        pushed: Floats = sandwich(u.reaches, change[0], v.values)
        pushed += sandwich(u.values, change[1], v.reaches)
        return pushed

    def _solved(self, wanted: Floats) -> Floats:
        """Y for which D D' Y C C' + B B' Y E E' is what is wanted."""
        u, v = self.by_u, self.by_v
        # By v the values are C and the reaches E: their s and c have changed places.
        square = np.outer(u.c, v.s) ** 2 + np.outer(u.s, v.c) ** 2
        good = square > NOTHING**2 * square.max()
        inner = sandwich(u.inverse, wanted, v.inverse)
        inner *= np.divide(1.0, square, out=np.zeros_like(square), where=good)[..., None]
        return sandwich(u.inverse.T, inner, v.inverse.T)

    def _within_reach(self, missing: Floats) -> Floats:
        """The nearest to what is missing that changes of gradients can do."""
        u, v = self.by_u, self.by_v
        for out_u, out_v in ((u.c, v.c), (u.s, v.s)):
            rows_u, rows_v = u.inverse[out_u <= NOTHING], v.inverse[out_v <= NOTHING]
            if len(rows_u) and len(rows_v):
                missing = missing - self._out_of_reach(missing, rows_u, rows_v)
        return missing

    def _out_of_reach(self, missing: Floats, rows_u: Floats, rows_v: Floats) -> Floats:
        """The part of what is missing that only products of the rows by u and by v would do."""
        (along_u, _), (along_v, _) = np.linalg.qr(rows_u.T), np.linalg.qr(rows_v.T)
        if self.weights is None:
            return sandwich(along_u, sandwich(along_u.T, missing, along_v.T), along_v)
        products = np.einsum("ia,jb->ijab", along_u, along_v) * self.sums[..., None, None]
        along, _ = np.linalg.qr(products.reshape(self.sums.size, -1))
        out: Floats = (along @ (along.T @ missing.reshape(-1, 3))).reshape(missing.shape)
        return out
