"""The area of a surface, the integral of |S_u x S_v|."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.pieces import surface_pieces
from plusedit.geometry.surface import PlusSurface

# Of the whole area, what the rule of Gauss and Legendre in one cell may differ by from that for
# its quarters; their own error is a small part of that.
ACCURACY = 1e-10
LEAST = 1e-5  # of the square of the size: of smaller areas the accuracy is that of such a one
ROUNDS = 30
MOST = 1 << 20  # samples; a surface folded flat is not smooth along its folds
BLOCK = 1 << 16  # samples that are worked on at once

NODES, WEIGHTS = (row / 2.0 for row in np.polynomial.legendre.leggauss(10))
HALVES = np.array([[0.0, 0.0], [0.0, 0.5], [0.5, 0.0], [0.5, 0.5]])
"""Where the quarters of a cell begin, shares of its width by u and by v."""


def area(surface: PlusSurface) -> float:
    """The area of all of the surface, in the square of the unit of the points.

    To 1e-9 of it; to 1e-7 where S_u and S_v are parallel at some points, to 1e-5 of a surface that
    is folded flat, with edges inside a knot span. What lies in several layers counts as often.
    """
    u, v = (_with_middles(grid.parameters) for grid in surface_pieces(surface))
    quarters = _on_grid(surface, u, v)
    whole = _on_grid(surface, u[::2], v[::2])
    both = quarters.reshape(len(whole), 2, -1, 2).sum(axis=(1, 3))
    # What is drawn together to a line has an area of rounding; that is not worth dividing.
    size = float(np.abs(surface.planes.points).max() + np.abs(surface.gradients).max())
    allowed = ACCURACY * max(float(both.sum()), LEAST * size * size)
    is_rough = np.abs(both - whole) > allowed
    rows, columns = np.nonzero(is_rough.repeat(2, axis=0).repeat(2, axis=1))
    low = np.stack([u[rows], v[columns]], axis=1)
    width = np.stack([np.diff(u)[rows], np.diff(v)[columns]], axis=1)
    smooth = float(both[~is_rough].sum())
    return smooth + _divided(surface, low, width, quarters[rows, columns], allowed)


def _divided(
    surface: PlusSurface, low: Floats, width: Floats, rough: Floats, allowed: float
) -> float:
    """The area over cells (k, 2), halved both ways until it no longer matters.

    `rough` (k,) is what is known of it.
    """
    total, left = 0.0, MOST
    for _ in range(ROUNDS):
        left -= 4 * len(low) * NODES.size**2
        if not len(low) or left < 0:
            break
        low = (low[:, None] + HALVES * width[:, None]).reshape(-1, 2)
        width = np.repeat(width, 4, axis=0) / 2.0
        quarters = _by_rule(surface, low, width)
        both = quarters.reshape(-1, 4).sum(axis=1)
        is_rough = np.abs(both - rough) > allowed
        total += float(both[~is_rough].sum())
        again = np.repeat(is_rough, 4)
        low, width, rough = low[again], width[again], quarters[again]
    return total + float(rough.sum())


def _with_middles(u: Floats) -> Floats:
    return np.insert(u, np.arange(1, len(u)), (u[:-1] + u[1:]) / 2.0)


def _on_grid(surface: PlusSurface, u: Floats, v: Floats) -> Floats:
    """(a, b) areas over the cells between parameters (a + 1,) and (b + 1,), by one rule each."""
    across, widths = _nodes(v), np.diff(v)
    found = np.empty((len(u) - 1, len(widths)))
    step = max(1, BLOCK // (NODES.size * len(across)))
    for start in range(0, len(found), step):
        ends = u[start : start + step + 1]
        _, du, dv = surface.derivatives(_nodes(ends), across, highest=1)
        sizes = _sizes(du, dv).reshape(len(ends) - 1, NODES.size, -1, NODES.size)
        sums = np.einsum("aibj,i,j->ab", sizes, WEIGHTS, WEIGHTS)
        found[start : start + step] = np.diff(ends)[:, None] * sums * widths
    return found


def _by_rule(surface: PlusSurface, low: Floats, width: Floats) -> Floats:
    """(k,) areas over cells (k, 2), by one rule each."""
    count = NODES.size
    places = np.stack(np.meshgrid(0.5 + NODES, 0.5 + NODES, indexing="ij"), axis=-1)
    places = places.reshape(-1, 2)
    weights = np.outer(WEIGHTS, WEIGHTS).ravel()
    found = np.empty(len(low))
    step = max(1, BLOCK // count**2)
    for start in range(0, len(low), step):
        some = slice(start, start + step)
        at = low[some, None] + places * width[some, None]
        _, du, dv = surface.derivatives_at(at.reshape(-1, 2), highest=1)
        found[some] = _sizes(du, dv).reshape(-1, count**2) @ weights
    areas: Floats = found * width.prod(axis=1)
    return areas


def _nodes(u: Floats) -> Floats:
    """(10 m,) the nodes of the rule in each interval, one after another."""
    nodes: Floats = ((u[:-1] + u[1:])[:, None] / 2.0 + np.diff(u)[:, None] * NODES).ravel()
    return nodes


def _sizes(du: Floats, dv: Floats) -> Floats:
    """(...) |S_u x S_v|, of whatever size."""
    largest = max(float(np.abs(du).max()), float(np.abs(dv).max()))
    if largest == 0.0:
        return np.zeros(du.shape[:-1])
    normal = np.cross(du / largest, dv / largest)
    sizes: Floats = np.sqrt(np.einsum("...d,...d->...", normal, normal)) * largest * largest
    return sizes
