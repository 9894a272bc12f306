import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.geometry.mesh.spreading import (
    BEFORE,
    BINS,
    DEGREE,
    GUARD,
    MARGIN,
    ROW,
    TAPS,
    TREES,
    least_sigmas,
    spreading,
)

FINE = np.linspace(-25.0, 26.0, 1000)
NODES = np.arange(TAPS) - BEFORE
tree_numbers = st.integers(0, TREES - 1)
shares = st.floats(0.0, 1.0)


def gaussian(away, sigma):
    return np.exp(-0.5 * (away / sigma) ** 2)


def weights_of(tree, along, share):
    """The weights, and their slopes, of a plane that is that far along the tree's sigmas."""
    table = spreading().weights[tree].reshape(BINS + 1, DEGREE + 1, ROW).astype(float)
    place = along * BINS
    low = min(int(place), BINS - 1)
    rows = table[low] + (place - low) * (table[low + 1] - table[low])
    values = [np.polyval(column, share) for column in rows.T]
    slopes = [np.polyval(np.polyder(column), share) for column in rows.T]
    return np.array(values), np.array(slopes)


@given(tree_numbers, shares, shares)
def test_a_gaussian_is_a_sum_of_lesser_ones_at_the_nodes_around(tree, along, share):
    least, most = least_sigmas()[tree : tree + 2]
    sigma = least + along * (most - least)
    weights, slopes = weights_of(tree, along, share)
    # What a blur of sum one makes of a node.
    blurred = gaussian(FINE[:, None] - NODES, least) / (np.sqrt(2.0 * np.pi) * least)
    whole = gaussian(FINE - share, sigma)
    assert_allclose(blurred @ weights[:TAPS], whole, atol=4e-6)
    assert_allclose(blurred @ slopes[:TAPS] * sigma, (FINE - share) / sigma * whole, atol=2e-5)
    assert not weights[TAPS:].any()


def test_blurs_one_after_the_other_are_that_of_the_least_sigma_of_a_tree():
    known, middle = spreading(), 60
    found = np.zeros(2 * middle + 1)
    found[middle] = 1.0
    for tree, least in enumerate(known.least):
        half = known.blurs[tree].astype(float)
        found = np.convolve(found, np.concatenate([half[:0:-1], half]), mode="same")
        normal = gaussian(np.arange(-middle, middle + 1), least) / (np.sqrt(2.0 * np.pi) * least)
        assert_allclose(found, normal, atol=2e-6)


@pytest.mark.parametrize("tree", range(TREES))
def test_the_margin_of_a_grid_is_wide_enough_for_all_blurs(tree):
    radius, after = spreading().radii[tree]
    assert MARGIN - 4 - after - radius >= 0
    assert 5.5 * least_sigmas()[tree + 1] <= MARGIN - GUARD - BEFORE
