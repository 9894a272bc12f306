"""How planes are spread on the nodes of a grid and then blurred, all of a size at once.

A Gaussian of sigma is nearly a sum, with weights, of fourteen Gaussians of a lesser sigma at the
nodes around its center. So planes are spread on fourteen nodes each way, and what they have in
common, the lesser Gaussian, is applied to the whole grid afterwards: anterpolation, the transpose
of interpolation, as in nonuniform fast Fourier transforms (Dutt and Rokhlin, 1993). The weights are
those of least squares.

That many nodes reach for a variance of 3.6 squared nodes more. Planes of a *group* share a grid and
are sorted into trees by variance, 3.6 apart: those of the widest tree are spread and blurred by
what they have more than the next, that tree's planes are spread on the same grid, and so on.
"""

from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

SPACING = 0.36  # of the nodes, in units of the least sigma of a group
TREES = 3  # in a group
STEP = 3.6  # squared nodes, between the least variances of its trees
TAPS = 14  # nodes in a row that a plane is spread on
BEFORE = 6  # of these, before the plane
ROW = 16  # numbers, with the zeros after these
DEGREE = 7  # of the weights, as polynomials of the place between two nodes
BINS = 64  # sigmas from the least to the largest of a tree, between which weights are linear
BLUR = 5.0  # sigma: the nodes that a blur takes in

WIDTH = 188  # nodes in a row of a grid
MARGIN = 42  # of these around the places, to either side
GUARD = 12  # of the margin the outermost, on which no plane is spread
AFTER = 4  # nodes after a place that it is interpolated from, and one more than before it

TRIED = 24  # places between two nodes at which the polynomials are fitted
INDEPENDENT = 1e-11  # the least eigenvalue that counts, over the largest

Singles = NDArray[np.float32]


class Spreading(NamedTuple):
    """What it takes to spread the planes of each tree of a group, from the narrowest on."""

    least: Singles
    """(trees,) the least sigma, in nodes"""
    bins: Singles
    """(trees,) how many of the sigmas that weights are known for lie in a node"""
    weights: Singles
    """(trees, (BINS + 1) * (DEGREE + 1) * ROW) of each sigma the coefficients of the weights, from
    the highest power down"""
    radii: NDArray[np.int64]
    """(trees, 2) of the blur that follows, and of all that are left after it, in nodes"""
    blurs: Singles
    """(trees, k) the weights of that blur, from the middle on, and zeros"""


def least_sigmas() -> Floats:
    """(TREES + 1,) in nodes, where the trees of a group begin, and where the last one ends."""
    found: Floats = np.sqrt(SPACING**-2 + STEP * np.arange(TREES + 1))
    return found


@lru_cache(maxsize=1)
def spreading() -> Spreading:
    """The same for all surfaces and all S."""
    ends = least_sigmas()
    steps = np.sqrt(np.diff(ends[:-1] ** 2, prepend=0.0))
    radii = np.ceil(BLUR * steps).astype(np.int64)
    away = np.arange(radii.max() + 1)
    blurs = np.where(away > radii[:, None], 0.0, np.exp(-0.5 * (away / steps[:, None]) ** 2))
    blurs /= (2.0 * blurs.sum(axis=1) - blurs[:, 0])[:, None]
    return Spreading(
        ends[:-1].astype(np.float32),
        (BINS / np.diff(ends)).astype(np.float32),
        np.stack([_weights(*each) for each in pairwise(ends)]),
        np.stack([radii, np.cumsum(radii) - radii], axis=1),
        blurs.astype(np.float32),
    )


def _weights(least: float, most: float) -> Singles:
    """The coefficients for sigmas from the least, that of the blur, to the most."""
    nodes = np.arange(TAPS) - float(BEFORE)
    shares = 0.5 - 0.5 * np.cos(np.pi * (np.arange(TRIED) + 0.5) / TRIED)
    sigmas = np.linspace(least, most, BINS + 1)[:, None, None]
    inverse = np.linalg.pinv(
        _inner(least, least, nodes[:, None] - nodes), rcond=INDEPENDENT, hermitian=True
    )
    # A blur adds up to one, the Gaussian itself to this.
    height = np.sqrt(2.0 * np.pi) * least
    rows = height * inverse @ _inner(least, sigmas, nodes[:, None] - shares)
    found = np.zeros((BINS + 1, DEGREE + 1, ROW), dtype=np.float32)
    for into, values in zip(found, rows, strict=True):
        into[:, :TAPS] = np.polyfit(shares, values.T, DEGREE)
    return found.ravel()


def _inner(first: float | Floats, second: float | Floats, away: Floats) -> Floats:
    """Inner products of Gaussians of two sigmas, their centers that far from each other, for
    least squares over the whole line, but for a constant factor."""
    squares = np.square(first) + np.square(second)
    found: Floats = first * second / np.sqrt(squares) * np.exp(-0.5 * away**2 / squares)
    return found
