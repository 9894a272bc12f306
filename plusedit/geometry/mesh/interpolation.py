"""Weights that interpolate sums of Gaussians between the nodes of a grid.

Sums over many planes vary by u and v like noise that a Gaussian has smoothed, about a smooth mean.
The weights of eight nodes that are best for such noise on average, and exact for polynomials up to
the fifth degree for the sake of the mean, are those of universal kriging (Matheron, 1969) with the
covariance exp(-d^2 / (4 sigma^2)): the noise left over is half of what Lagrange's weights leave.
"""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

TAPS = 8
EXACT = 5  # degree
DEGREE = 9  # of the weights themselves, as polynomials of the place between two nodes
TRIED = 24  # places between two nodes at which the polynomials are fitted


def weights(share: float, spacing: float) -> Floats:
    """(8,) the weights of nodes -3 to 4 for the place `share` of the way from node 0 to node 1.

    `spacing` is that of the nodes in units of sigma.
    """
    nodes = np.arange(TAPS) - TAPS // 2 + 1.0
    away = nodes[:, None] - nodes
    covariance = np.exp(-0.25 * (spacing * away) ** 2)
    powers = np.vander(nodes - 0.5, EXACT + 1, increasing=True)
    none = np.zeros((EXACT + 1, EXACT + 1))
    matrix = np.block([[covariance, powers], [powers.T, none]])
    right = [
        np.exp(-0.25 * (spacing * (nodes - share)) ** 2),
        (share - 0.5) ** np.arange(EXACT + 1),
    ]
    found: Floats = np.linalg.solve(matrix, np.concatenate(right))[:TAPS]
    return found


@lru_cache(maxsize=4)
def weight_polynomials(spacing: float) -> NDArray[np.float32]:
    """(80,) ten rows of eight: the coefficients of the weights, from the highest power down."""
    shares = 0.5 - 0.5 * np.cos(np.pi * (np.arange(TRIED) + 0.5) / TRIED)
    rows = np.array([weights(float(share), spacing) for share in shares])
    return np.polyfit(shares, rows, DEGREE).astype(np.float32).ravel()
