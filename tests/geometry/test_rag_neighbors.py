"""Rational Gaussians of many lines, of which only neighbors are worked out, against all of them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.rag import RationalGaussian

COUNT = 60


def a_basis(closed, width, uneven):
    random = np.random.default_rng(3)
    nodes = tuple(np.sort(random.uniform(0.0, 0.99, COUNT)).tolist()) if uneven else None
    sigma = width / COUNT
    return RationalGaussian(
        COUNT, tuple(sigma * random.uniform(0.7, 1.4, COUNT)) if uneven else sigma, closed, nodes
    )


def of_all(basis, u):
    """Values and reaches by the sum over all nodes and a dozen images of each on both sides."""
    images = np.arange(-12.0, 13.0) if basis.closed else np.zeros(1)
    distance = u[:, None, None] - basis.nodes[:, None] - images
    sigma = np.broadcast_to(np.array(basis.sigma), COUNT)[:, None]
    exponent = -0.5 * (distance / sigma) ** 2
    g = np.exp(exponent - exponent.max(axis=(1, 2), keepdims=True))
    g /= g.sum(axis=(1, 2), keepdims=True)
    return g.sum(axis=2), (distance * g).sum(axis=2)


@pytest.mark.parametrize("closed", [False, True], ids=["open", "closed"])
@pytest.mark.parametrize("uneven", [False, True], ids=["even", "uneven"])
@pytest.mark.parametrize("width", [1e-3, 0.1, 0.6, 1.5, 6.0, 40.0])
def test_the_far_ones_are_not_missed(closed, width, uneven):
    basis = a_basis(closed, width, uneven)
    u = np.random.default_rng(4).uniform(0.0, 1.0, 80)
    values, reaches = of_all(basis, u)
    assert_allclose(basis.values(u), values, atol=1e-13)
    assert_allclose(basis.reaches(u), reaches, atol=1e-13)
    step = 1e-6 * min(1.0, width)
    for derivative in (1, 2):
        before, after = (basis.values(u + by, derivative=derivative - 1) for by in (-step, step))
        size = np.abs(basis.values(u, derivative=derivative)).max()
        slope = (after - before) / (2.0 * step)
        assert_allclose(basis.values(u, derivative=derivative), slope, atol=1e-3 * (size + 1.0))
