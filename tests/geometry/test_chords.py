"""Chains of chords against the curves that they stand for."""

from itertools import pairwise

import numpy as np
import pytest

from plusedit.geometry.chords import Chords, chains
from tests.geometry.curves import KINDS, random_curve

SLACK = 1.1  # a curve is sampled to find out how far it strays

smooth_kinds = pytest.mark.parametrize("kind", [kind for kind in KINDS if kind != "staircase"])


def from_segments(points, chords):
    """(m, k) distances, by looking at very many places of each chord."""
    shares = np.linspace(0.0, 1.0, 201)[:, None, None]
    places = (1.0 - shares) * chords.points[:-1] + shares * chords.points[1:]
    return np.array([np.linalg.norm(places - point, axis=2).min(axis=0) for point in points])


@smooth_kinds
@pytest.mark.parametrize("dimension", [2, 3])
def test_the_curve_over_a_chord_strays_no_farther_than_is_known(kind, dimension):
    curve = random_curve(kind, seed=3, dimension=dimension, contrast=10.0)
    u = np.linspace(0.0, 1.0, 3001)[:-1]
    points = curve.at(u)
    for chords in chains(curve, None):
        over = np.searchsorted(chords.u, u, side="right") - 1
        distances, shares = chords.from_points(points, over)
        assert (distances <= SLACK * chords.strays[over]).all()
        assert ((shares >= 0.0) & (shares <= 1.0)).all()


def test_coarser_chords_join_points_of_finer_ones_up_to_the_ends():
    chain = chains(random_curve("bspline"), None)
    for coarse, fine in pairwise(chain):
        assert np.isin(coarse.u, fine.u).all()
        assert len(coarse) < len(fine)
    assert {(chords.u[0], chords.u[-1]) for chords in chain} == {(0.0, 1.0)}


def test_distances_from_a_chord_are_those_of_its_nearest_place():
    random = np.random.default_rng(2)
    corners = random.normal(size=(9, 3))
    corners[4] = corners[3]
    chords = Chords(np.linspace(0.0, 1.0, 9), corners, np.zeros(8))
    points = 2.0 * random.normal(size=(20, 3))
    row, place = (each.ravel() for each in np.indices((20, 8)))
    distances, shares = chords.from_points(points[row], place)
    looked_at = from_segments(points, chords).ravel()
    assert (distances <= looked_at + 1e-14).all()
    assert (distances >= looked_at - 1e-2).all()
    there = chords.points[place] + shares[:, None] * chords.ways[place]
    np.testing.assert_allclose(np.linalg.norm(points[row] - there, axis=1), distances)
