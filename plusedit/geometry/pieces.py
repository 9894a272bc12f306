"""Where to look first: parameters between which a curve is smooth and plain.

Methods that sample (drawing, length, nearest point, inflections) start from them. A B-spline is
a polynomial between its knots. Rational Gaussians have no knots, but a narrow one hands over to
its neighbour suddenly, where the two are equal; about that place a few parameters lie as close
as the change is fast. Very unequal weights make the same sudden changes within one polynomial
piece, at a rate that is even in log(u / (1 - u)): the logarithms of the terms
W_i u^i (1 - u)^(k - i) are straight lines there, but for a common part.
"""

from functools import lru_cache
from math import ceil, log

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis, is_local
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface

EVEN = 8.0  # ratio of weights up to which nothing sudden happens
SAMPLES = 4  # to the piece: a piece is taken for a polynomial of that degree
SMOOTH = 16  # order of closed B-splines that look like Gaussians, far wider than a piece
HANDOVER = np.array([-40.0, -4.0, 0.0, 4.0, 40.0])  # in units of the width of the change


def breaks(basis: Basis) -> Floats:
    """Parameters from 0 to 1, both among them, between which the functions are smooth.

    All kinks a curve can have, but for cusps, are among them.
    """
    if isinstance(basis, RationalGaussian):
        return _handovers(basis)
    if is_local(basis):
        return basis.breaks
    return np.array([0.0, 1.0])


def pieces(curve: PlusCurve) -> Grid:
    """The breaks, and between them as many parameters as degree and weights ask for.

    The same object for the same basis, so that what is worked out there can be kept.
    """
    return _pieces(curve.basis, _contrast(curve.lines.unit_weights))


def surface_pieces(surface: PlusSurface) -> tuple[Grid, Grid]:
    """The same by u and by v."""
    weights = surface.planes.unit_weights
    by_u, by_v = _contrast(weights), _contrast(weights.T)
    return _pieces(surface.basis_u, by_u), _pieces(surface.basis_v, by_v)


def degree(basis: Basis) -> int:
    """Of polynomials that do for the pieces; four, for want of any, for other functions."""
    if isinstance(basis, RationalGaussian):
        return SAMPLES
    if not is_local(basis):
        return basis.size
    return min(basis.order, SMOOTH) if basis.closed else basis.order


def _contrast(weights: Floats) -> int:
    """The logarithm of the largest ratio of weights, rounded up; 0 where it does not matter.

    Of those (n,) or, if they are (n, m), of any of their columns.
    """
    ratio = float((weights.max(axis=0) / weights.min(axis=0)).max())
    return 0 if ratio <= EVEN else ceil(log(ratio))


@lru_cache(maxsize=128)
def _pieces(basis: Basis, contrast: int) -> Grid:
    inside = _fractions(degree(basis), contrast)
    ends = breaks(basis)
    steps = ends[:-1, None] + np.diff(ends)[:, None] * inside
    return Grid(np.unique(np.append(steps, 1.0)))


def _fractions(highest: int, contrast: int) -> Floats:
    """Fractions of one piece, from 0 on and without 1."""
    count = ceil(highest / SAMPLES)
    # Closer at the ends, as the nodes of Chebyshev are: polynomials change fastest there.
    even = (1.0 - np.cos(np.pi * np.arange(count) / count)) / 2.0
    if not contrast:
        return even
    reach = contrast + 2.0
    slow = np.linspace(-reach, reach, ceil(reach))
    return np.union1d(even, 1.0 / (1.0 + np.exp(-slow)))


def _handovers(basis: RationalGaussian) -> Floats:
    """Nodes, and where a change from one to the next is quick, parameters about it."""
    x = basis.nodes
    sigma = np.broadcast_to(np.array(basis.sigma, dtype=np.float64), x.shape)
    ahead, wide = np.append(x, x[0] + 1.0), np.append(sigma, sigma[0])
    if not basis.closed:
        ahead, wide = ahead[:-1], wide[:-1]
    gap = np.diff(ahead)
    change = gap * wide[:-1] / (wide[:-1] + wide[1:])
    width = wide[:-1] * wide[1:] / gap
    quick = width < gap / 8.0
    about = (ahead[:-1] + change)[quick, None] + width[quick, None] * HANDOVER
    middle = (ahead[:-1] + gap / 2.0)[quick, None]
    near = np.clip(about, middle - 0.499 * gap[quick, None], middle + 0.499 * gap[quick, None])
    inside = near.ravel()
    if basis.closed:
        inside = inside - np.floor(inside)
    return np.unique(np.concatenate([[0.0], x, inside, [1.0]]))
