"""Few points that reach as far as very many."""

import numpy as np
from numpy.testing import assert_array_equal

from plusedit.scene.extremes import FEW, telling


def test_few_points_stay_as_they_are():
    points = np.eye(3)
    assert telling(points) is points


def test_many_points_reach_as_far_along_the_axes_and_hardly_less_aslant():
    rng = np.random.default_rng(7)
    points = rng.normal(size=(20 * FEW, 3))
    few = telling(points)
    assert len(few) < FEW + 50
    assert_array_equal(few.min(axis=0), points.min(axis=0))
    assert_array_equal(few.max(axis=0), points.max(axis=0))
    aslant = rng.normal(size=(3, 40))
    assert ((few @ aslant).max(axis=0) > 0.85 * (points @ aslant).max(axis=0)).all()


def test_a_single_spike_among_many_is_not_lost():
    points = np.zeros((5 * FEW, 2))
    points[4321] = (3.0, 1.0)
    assert (telling(points) == (3.0, 1.0)).all(axis=1).any()


def test_points_that_are_not_finite_never_tell():
    points = np.zeros((3 * FEW, 2))
    points[5] = np.nan
    points[6] = np.inf
    assert np.isfinite(telling(points)).all()
