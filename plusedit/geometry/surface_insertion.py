"""One row or column of control planes more, or fewer, with the shape kept as far as may be.

What adds a line to a curve (see `insertion`) adds a row to a surface, in every column of planes
alike. Where the functions of the old basis are sums of those of the larger one, the new planes are
the same means of old ones,

    W'_jc = sum_i a_ji W_ic,   L'_jc(u, v) = sum_i a_ji W_ic L_ic(u, v) / W'_jc,

and the surface stays exactly what it was. Else three things are fitted for every column c, from a
guess that they leave unwillingly: w_c = sum_i b_i W_ic, the plus curve of its points and d^u,
and the curve sum_i b_i W_ic d^v_ic / w_c. Of these the surface is made by v in the same way as
before.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import blend_at
from plusedit.geometry.insertion import (
    exact_shares,
    involved,
    larger_basis,
    neighbors,
    reluctantly_solved,
    samples_about,
    shift_of,
)
from plusedit.geometry.matrices import Banded, dense
from plusedit.geometry.net import Flags
from plusedit.geometry.planes import ControlPlanes, automatic_planes
from plusedit.geometry.sizes import kept_basis
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_transforms import transposed

ALIKE = 13  # digits: weights of two columns of which as many agree are proportional
LEAST = 0.1  # of the guess: a fitted weight is no less


def insert_row(surface: PlusSurface, u: float) -> tuple[PlusSurface, int]:
    """The surface with one more row of planes about the parameter u, and the number i of the row.

    Bezier+ and open B-spline+ surfaces, with and without weights, stay exactly as they are. Others
    change as little as they can; where B-splines close, u may begin at another place.
    Raises ValueError if u is not finite; outside [0, 1] it is clamped, or wrapped.
    """
    if not np.isfinite(u):
        raise ValueError(f"insert_row: expected a finite parameter, got {u}")
    old = surface.basis_u
    basis, index = larger_basis(old, float(u))
    shares = exact_shares(old, basis)
    if shares is not None:
        return _surface(surface, basis, *_refined(surface, basis, shares)), index
    shift = shift_of(old, basis, index, u)
    return _surface(surface, basis, *_fitted(surface, basis, index, shift)), index


def insert_column(surface: PlusSurface, v: float) -> tuple[PlusSurface, int]:
    """The surface with one more column of planes about v, and its number j; as `insert_row`."""
    larger, index = insert_row(transposed(surface), v)
    return transposed(larger), index


def without_rows(surface: PlusSurface, rows: "list[int] | tuple[int, ...]") -> PlusSurface:
    """The surface of the other rows, the planes (i, j) of other i; at least 2 must be left."""
    count = surface.planes.shape[0]
    kept = np.setdiff1d(np.arange(count), rows)
    if len(kept) < 2:
        raise ValueError(f"points: a surface needs at least 2 x 2, {len(kept)} rows would stay")
    planes = surface.planes.taken(kept, np.arange(surface.planes.shape[1]))
    return replace(surface, basis_u=kept_basis(surface.basis_u, kept), planes=planes)


def without_columns(surface: PlusSurface, columns: "list[int] | tuple[int, ...]") -> PlusSurface:
    """The surface of the other columns, the planes (i, j) of other j; at least 2 must be left."""
    return transposed(without_rows(transposed(surface), columns))


@dataclass(frozen=True, eq=False)
class _Rows:
    """Planes with all directions worked out."""

    points: Floats
    """(n, c, 3)"""
    along_u: Floats
    along_v: Floats
    weights: Floats | None
    """(n, c), the largest 1"""


def _rows_of(surface: PlusSurface) -> _Rows:
    planes, (along_u, along_v) = surface.planes, surface.directions
    weights = None if planes.weights is None else planes.unit_weights
    return _Rows(planes.points, along_u, along_v, weights)


def _refined(surface: PlusSurface, basis: Basis, shares: Banded) -> tuple[_Rows, Flags]:
    """The planes of the same surface in a larger basis, and which directions were automatic."""
    old, columns = _rows_of(surface), shares.columns
    entries = shares.entries[..., None] * np.ones(old.points.shape[1])
    weights = None
    if old.weights is not None:
        entries = entries * old.weights[columns]
        weights = entries.sum(axis=1)
        entries /= weights[:, None]
    distances = basis.nodes[:, None] - surface.basis_u.nodes[columns]
    points, along_u, along_v = (
        np.einsum("jkc,jkcd->jcd", entries, rows[columns])
        for rows in (old.points, old.along_u, old.along_v)
    )
    pulls = entries * distances[..., None]
    points += surface.s * np.einsum("jkc,jkcd->jcd", pulls, old.along_u[columns])
    # Rows that are only renumbered stay to the last bit.
    new, entry = np.nonzero(shares.entries == 1.0)
    same = columns[new, entry]
    points[new], along_u[new] = old.points[same], old.along_u[same]
    along_v[new] = old.along_v[same]
    was_automatic = np.zeros((2, *points.shape[:2]), dtype=np.bool_)
    was_automatic[:, new] = surface.planes.automatic[:, same]
    if weights is not None and old.weights is not None:
        weights[new] = old.weights[same]
    return _Rows(points, along_u, along_v, weights), was_automatic


def _fitted(surface: PlusSurface, basis: Basis, index: int, shift: float) -> tuple[_Rows, Flags]:
    """The planes for the basis whose columns come closest to those at u + shift.

    Least squares for what is added to a guess. Rows without part in what it lacks stay.
    """
    old, (near, automatic) = _rows_of(surface), _guessed(surface, basis, shift)
    u, s, extent = samples_about(basis, index), surface.s, float(np.ptp(old.points))
    wanted, matrices = _matrices(surface.basis_u, u + shift), _matrices(basis, u)
    near = _with_fitted_weights(near, old, matrices[0], wanted[0])
    missing, turned = (
        before - after
        for before, after in zip(_curves(old, *wanted, s), _curves(near, *matrices, s), strict=True)
    )
    # A direction counts as what it moves the surface by; without s it moves nothing and stays.
    pull = s / (max(abs(s), extent) or 1.0) * (basis.size if basis.closed else basis.size - 1)
    points, along_u, along_v = near.points.copy(), near.along_u.copy(), near.along_v.copy()
    for columns, factor in _groups(near.weights, matrices[0], points.shape[1]):
        values, reaches = (factor * matrix for matrix in matrices)
        lacking = missing[:, columns].reshape(len(u), -1)
        free = involved(values, lacking, extent)
        parts = np.concatenate([values[:, free], pull * reaches[:, free]], axis=1)
        change = reluctantly_solved(parts, lacking, basis.size)
        change = change.reshape(2, len(free), len(columns), 3)
        points[np.ix_(free, columns)] += change[0]
        along_u[np.ix_(free, columns)] += pull / s * change[1] if s else 0.0
        lacking = turned[:, columns].reshape(len(u), -1)
        free = involved(values, s * surface.spacings[1] * lacking, extent)
        change = reluctantly_solved(values[:, free], lacking, basis.size)
        along_v[np.ix_(free, columns)] += change.reshape(len(free), len(columns), 3)
    return _Rows(points, along_u, along_v, near.weights), automatic


def _guessed(surface: PlusSurface, basis: Basis, shift: float) -> tuple[_Rows, Flags]:
    """Means of the two rows on both sides of each new one, and which directions are automatic."""
    rows, shares, distances = neighbors(surface.basis_u, basis.nodes + shift)
    old, flags = _rows_of(surface), surface.planes.automatic

    def mean(of: Floats) -> Floats:
        found: Floats = np.einsum("jk,jk...->j...", shares, of[rows])
        return found

    points = mean(old.points)
    points += surface.s * np.einsum("jk,jkcd->jcd", shares * distances, old.along_u[rows])
    weights = None if old.weights is None else mean(old.weights)
    automatic = (flags[:, rows] | (shares == 0.0)[..., None]).all(axis=2)
    closed_u, closed_v = surface.closed
    free = automatic_planes(points, closed_u=closed_u, closed_v=closed_v)
    along_u, along_v = (
        np.where(flag[..., None], way, mean(given))
        for flag, way, given in zip(automatic, free, (old.along_u, old.along_v), strict=True)
    )
    return _Rows(points, along_u, along_v, weights), automatic


def _with_fitted_weights(near: _Rows, old: _Rows, values: Floats, wanted: Floats) -> _Rows:
    """The guess with weights whose sums w_c come closest to the old ones, as far as positive."""
    if near.weights is None or old.weights is None:
        return near
    missing = wanted @ old.weights - values @ near.weights
    free = involved(values, missing, float(old.weights.max()))
    weights = near.weights.copy()
    weights[free] += reluctantly_solved(values[:, free], missing, len(weights))
    is_fit = (weights >= LEAST * near.weights).all(axis=0)
    return replace(near, weights=np.where(is_fit, weights, near.weights))


def _matrices(basis: Basis, u: Floats) -> tuple[Floats, Floats]:
    matrices = blend_at(basis, u)
    return dense(matrices.values), dense(matrices.reaches)


def _curves(rows: _Rows, values: Floats, reaches: Floats, s: float) -> tuple[Floats, Floats]:
    """(m, c, 3) each: for every column the curve of its points and d^u, and that of its d^v."""
    weights = np.ones(rows.points.shape[:2]) if rows.weights is None else rows.weights
    below = (values @ weights)[..., None]
    points, along_u, along_v = (
        weights[..., None] * part for part in (rows.points, rows.along_u, rows.along_v)
    )
    first = np.tensordot(values, points, 1) + s * np.tensordot(reaches, along_u, 1)
    return first / below, np.tensordot(values, along_v, 1) / below


def _groups(
    weights: Floats | None, values: Floats, count: int
) -> Iterator[tuple[NDArray[np.intp], Floats]]:
    """Which of `count` columns have the same rational functions, and what makes them of others.

    All of them without weights, and where every weight is a product of one by u and one by v.
    """
    if weights is None:
        yield np.arange(count), np.ones((1, 1))
        return
    alike = np.round(weights / weights.max(axis=0), ALIKE)
    _, first, group = np.unique(alike, axis=1, return_index=True, return_inverse=True)
    for number, column in enumerate(first):
        row = weights[:, column]
        yield np.flatnonzero(group.ravel() == number), row / (values @ row)[:, None]


def _surface(surface: PlusSurface, basis: Basis, rows: _Rows, was_automatic: Flags) -> PlusSurface:
    """Of those rows; directions are automatic where they were and would be the same."""
    closed_u, closed_v = surface.closed
    directions = np.stack([rows.along_u, rows.along_v])
    free = automatic_planes(rows.points, closed_u=closed_u, closed_v=closed_v)
    kept = was_automatic & (free == directions).all(axis=-1)
    largest = surface.planes.weights
    weights = None
    if rows.weights is not None and largest is not None:
        weights = rows.weights * largest.max()
    planes = ControlPlanes(rows.points, directions, kept, weights)
    return PlusSurface(basis, surface.basis_v, planes, surface.s)
