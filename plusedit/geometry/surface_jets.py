"""Sums over control planes, and the derivatives of quotients of them.

A net here holds all that is summed up, side by side: (n_u, n_v, c + 6) with the columns

    W P and, if there are weights, W (c = 3 or 4),    s W d^u (3),    s W d^v (3).

With the functions b, c and reaches b* = (u - x) b, c* = (v - y) c of both bases, or derivatives,

    A = sum_ij (W P)_ij b_i c_j + (s W d^u)_ij b*_i c_j + (s W d^v)_ij b_i c*_j

is a numerator or, in the column of the weights, a denominator.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Blend
from plusedit.geometry.matrices import Banded, Matrix

ORDERS = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))
"""Of the derivatives by u and v, in the order in which they are given back."""

COUNTS = (1, 3, 6)  # how many of them there are up to order 0, 1, 2
BLOCK = 1 << 19  # numbers that are laid out at once for scattered places


def sandwich(left: Matrix, net: Floats, right: Matrix) -> Floats:
    """(a, b, dim) sum_ij left[a, i] net[i, j] right[b, j], as two products.

    Two products cost O(a n m + a m b) for each coordinate; the sum as written, O(a n m b).
    """
    return _from_left(left, _from_right(net, right))


def _from_right(net: Floats, right: Matrix) -> Floats:
    """(n, b, dim) sum_j net[i, j] right[b, j]."""
    n, m, dim = net.shape
    by_columns = np.ascontiguousarray(net.transpose(1, 0, 2)).reshape(m, n * dim)
    rows = (right @ by_columns).reshape(-1, n, dim)
    # Turned round here, where there are few rows, and not afterwards, where there are many.
    return np.ascontiguousarray(rows.transpose(1, 0, 2))


def _from_left(left: Matrix, lines: Floats) -> Floats:
    """(a, b, dim) sum_i left[a, i] lines[i, b]."""
    n, count, dim = lines.shape
    return np.asarray(left @ lines.reshape(n, count * dim)).reshape(-1, count, dim)


def on_grid(net: Floats, by_u: Sequence[Blend], by_v: Sequence[Blend]) -> list[Floats]:
    """(a, b, c) A and its derivatives at every pair of parameters, in the order of ORDERS.

    As many as the derivatives of the bases that are given, 1 to 3 of each, suffice for.
    """
    c = net.shape[2] - 6
    lines, turns = [], []
    for blend in by_v:
        points_and_turns = _from_right(net[..., : c + 3], blend.values)
        line = np.ascontiguousarray(points_and_turns[..., :c])
        line[..., :3] += _from_right(net[..., c + 3 :], blend.reaches)
        lines.append(line)
        turns.append(np.ascontiguousarray(points_and_turns[..., c:]))
    found = []
    for r, q in ORDERS[: COUNTS[len(by_u) - 1]]:
        total = _from_left(by_u[r].values, lines[q])
        total[..., :3] += _from_left(by_u[r].reaches, turns[q])
        found.append(total)
    return found


def at_places(net: Floats, by_u: Sequence[Blend], by_v: Sequence[Blend]) -> list[Floats]:
    """(k, c) the same at scattered places: row by row of the matrices of both bases."""
    (rows, left), (columns, right) = _factors(by_u), _factors(by_v)
    across = net.shape[1] if rows is None else right.shape[2]
    step = max(1, BLOCK // (max(left.shape[1:]) * across * net.shape[2]))
    parts = []
    for start in range(0, max(len(left), 1), step):
        part = slice(start, start + step)
        near_u, near_v = (None if each is None else each[part] for each in (rows, columns))
        sums = _sums(net, (near_u, left[part]), (near_v, right[part]))
        parts.append(_collected(sums, len(by_u), net.shape[2] - 6))
    return parts[0] if len(parts) == 1 else [np.concatenate(e) for e in zip(*parts, strict=True)]


Factors = tuple[NDArray[np.intp] | None, Floats]
"""(k, t) the control planes that count, None for all; and (k, f, t) what each is multiplied by,
f being values, reaches, values', reaches', ..."""


def _factors(blends: Sequence[Blend]) -> Factors:
    matrices = [matrix for blend in blends for matrix in (blend.values, blend.reaches)]
    columns = [each.columns for each in matrices if isinstance(each, Banded)]
    entries = [each.entries if isinstance(each, Banded) else each for each in matrices]
    return (columns[0] if columns else None), np.stack(entries, axis=1)


def _sums(net: Floats, by_u: Factors, by_v: Factors) -> Floats:
    """(k, f, g, columns of the net) the sums for all factors f by u and g by v."""
    (rows, left), (columns, right) = by_u, by_v
    k, f, _ = left.shape
    n, m, width = net.shape
    if rows is None:
        lines = (left.reshape(-1, n) @ net.reshape(n, -1)).reshape(k, f, m, width)
        if columns is not None:
            lines = np.take_along_axis(lines, columns[:, None, :, None], axis=2)
    else:
        near = net[rows] if columns is None else net[rows[:, :, None], columns[:, None]]
        across = near.shape[2]
        lines = left @ near.reshape(k, rows.shape[1], across * width)
        lines = lines.reshape(k, f, across, width)
    return np.asarray(right[:, None] @ lines)


def _collected(sums: Floats, count: int, c: int) -> list[Floats]:
    """(k, c) A and its derivatives from the sums for all factors."""
    found = []
    for r, q in ORDERS[: COUNTS[count - 1]]:
        total = sums[:, 2 * r, 2 * q, :c].copy()
        total[:, :3] += sums[:, 2 * r + 1, 2 * q, c : c + 3]
        total[:, :3] += sums[:, 2 * r, 2 * q + 1, c + 3 :]
        found.append(total)
    return found


def quotients(sums: Sequence[Floats]) -> tuple[Floats, ...]:
    """A / w and its derivatives, in the order of ORDERS, from those of A and w.

    `sums` hold A and w side by side, (..., 4), or A alone, (..., 3), where w is one.
    S_u = (A_u - w_u S) / w, S_uu = (A_uu - 2 w_u S_u - w_uu S) / w,
    S_uv = (A_uv - w_u S_v - w_v S_u - w_uv S) / w.
    """
    if sums[0].shape[-1] == 3:
        return tuple(sums)
    tops, below = [each[..., :3] for each in sums], [each[..., 3:] for each in sums]
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
