"""What is left of many parts, against measuring all of them."""

from dataclasses import dataclass

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from plusedit.geometry.candidates import TOGETHER, Candidates, candidates, firsts, levels


@dataclass(frozen=True, eq=False)
class Stretches:
    """Stretches of a line, each from its middle as far to both sides as it may stray."""

    middles: np.ndarray
    strays: np.ndarray

    def coarser(self):
        first = np.arange(0, len(self.strays), TOGETHER)
        low = np.minimum.reduceat(self.middles - self.strays, first)
        high = np.maximum.reduceat(self.middles + self.strays, first)
        return Stretches((low + high) / 2.0, (high - low) / 2.0)


def stretches(random, count):
    return Stretches(np.cumsum(random.uniform(-1.0, 2.0, count)), random.uniform(0.0, 1.0, count))


def left_of(parts, places):
    """The candidates for the places, and the distances of all parts from all of them."""
    found = candidates(
        levels(parts),
        len(places),
        lambda row, among, place: np.abs(among.middles[place] - places[row]),
    )
    return found, np.abs(parts.middles - places[:, None])


@given(st.integers(1, 400), st.integers(1, 60), st.integers(0, 10**6))
def test_parts_that_may_be_the_nearest_are_all_left(count, things, seed):
    random = np.random.default_rng(seed)
    parts = stretches(random, count)
    found, distances = left_of(parts, random.uniform(-5.0, 1.5 * count, things))
    least = (distances + parts.strays).min(axis=1, keepdims=True)
    expected = np.argwhere(distances - parts.strays <= least)
    pairs = np.stack([found.row, found.place], axis=1)
    assert {tuple(pair) for pair in expected} == {tuple(pair) for pair in pairs}
    np.testing.assert_array_equal(found.distances, distances[found.row, found.place])
    assert (np.diff(found.row) >= 0).all()


def test_few_of_many_parts_are_measured():
    parts = Stretches(np.arange(5000.0), np.full(5000, 0.5))
    measured = []

    def measure(row, among, place):
        measured.append(len(row))
        return np.abs(among.middles[place] - 10.0 * row)

    found = candidates(levels(parts), 300, measure)
    assert len(found.row) < 4 * 300
    assert sum(measured) < 0.05 * 300 * 5000


def test_what_is_not_a_number_leaves_every_thing_a_part():
    found, _ = left_of(Stretches(np.arange(50.0), np.ones(50)), np.array([3.0, np.nan, 7.0]))
    assert set(found.row) == {0, 1, 2}


def test_the_nearest_few_of_each_thing_are_kept():
    row = np.array([0, 0, 0, 1, 2, 2, 2, 2])
    distances = np.array([3.0, 1.0, 2.0, 9.0, 4.0, 4.0, 1.0, 7.0])
    found = Candidates(row, np.arange(8), distances).nearest(2)
    assert found.row.tolist() == [0, 0, 1, 2, 2]
    assert found.place.tolist() == [1, 2, 3, 6, 4]
    assert firsts(row).tolist() == [0, 3, 4]
