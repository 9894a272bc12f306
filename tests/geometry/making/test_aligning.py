"""Curves are put in order without any change of their shapes."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.making.aligning import aligned, loop
from plusedit.geometry.making.coons import coons
from plusedit.geometry.transforms import reversed_curve, transformed
from tests.geometry.curves import random_curve
from tests.geometry.making.test_from_curves import edges

T = np.linspace(0.0, 1.0, 33)
UP = np.array([0.0, 0.0, 4.0])


def begun(curve, line):
    """The closed curve begun at another of its lines."""
    rows = np.roll(np.arange(len(curve.lines)), -line)
    return replace(curve, lines=curve.lines.taken(rows))


def test_an_open_curve_that_runs_backwards_is_reversed():
    curve = random_curve("bspline", dimension=3)
    above = transformed(reversed_curve(curve), np.eye(3), UP)
    _, second = aligned([curve, above])
    assert_allclose(second.at(T), curve.at(T) + UP, atol=1e-12)


def test_curves_that_run_alike_stay_the_very_same():
    curves = [random_curve("closed", dimension=3)]
    curves.append(transformed(curves[0], np.eye(3), UP))
    for old, new in zip(curves, aligned(curves), strict=True):
        assert new is old


@pytest.mark.parametrize("kind", ["closed", "closed, odd order", "closed rag"])
@pytest.mark.parametrize("backwards", [False, True])
def test_a_closed_curve_begins_beside_the_one_before(kind, backwards):
    curve = random_curve(kind, dimension=3)
    other = transformed(begun(curve, 3), np.eye(3), UP)
    _, second = aligned([curve, reversed_curve(other) if backwards else other])
    assert_allclose(second.at(T), curve.at(T) + UP, atol=1e-9)


@pytest.mark.parametrize("order", [(0, 1, 2, 3), (2, 0, 3, 1), (3, 2, 1, 0)])
@pytest.mark.parametrize("backwards", [(), (1, 2), (0, 3)])
def test_four_edges_form_a_loop_in_any_order(order, backwards):
    found = [reversed_curve(c) if i in backwards else c for i, c in enumerate(edges())]
    surface = coons(*loop([found[i] for i in order]))
    rims = np.concatenate([surface.at(T, [0.0, 1.0])[:, i] for i in (0, 1)])
    sides = np.concatenate(list(surface.at([0.0, 1.0], T)))
    every = np.concatenate([rims, sides])
    for curve in edges():
        for point in curve.at(T):
            assert np.linalg.norm(every - point, axis=1).min() < 1e-12


def test_edges_that_leave_a_gap_are_no_loop():
    around = edges()
    around[3] = transformed(around[3], np.eye(3), [0.0, 0.0, 0.5])
    with pytest.raises(ValueError, match=r"gap of 0\.5"):
        loop(around)


def test_a_loop_takes_four_open_curves():
    with pytest.raises(ValueError, match="needs four, not 3"):
        loop(edges()[:3])
    with pytest.raises(ValueError, match="closed"):
        loop([*edges()[:3], random_curve("closed")])
