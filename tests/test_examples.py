"""The designs that ship with the program: each opens, and shows what its caption says."""

import json
import runpy
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.frames import curvature
from plusedit.io.files import load
from plusedit.resources import example_files
from plusedit.scene.options import options_of
from plusedit.scene.overlays import overlays

MAKER = runpy.run_path(str(Path(__file__).parents[1] / "assets/make_examples.py"))


def panels(name):
    """The curves of an example by the names of its shapes."""
    [path] = [path for path in example_files() if path.stem == name]
    return {shape.name: shape.curve for shape in load(path).design.shapes.values()}


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def inflections(curve):
    """How often the curvature changes its sign."""
    _, velocity, acceleration = curve.derivatives(np.linspace(0.0, 1.0, 2001))
    return int((np.diff(np.sign(curvature(velocity, acceleration))) != 0).sum())


def alike(old, new):
    """Whether two JSON trees agree but for the rounding of numbers."""
    if isinstance(old, dict):
        return old.keys() == new.keys() and all(alike(old[key], new[key]) for key in old)
    if isinstance(old, list):
        return len(old) == len(new) and all(map(alike, old, new))
    if isinstance(old, float):
        return new == pytest.approx(old, rel=1e-9, abs=1e-9)
    return old == new


@pytest.mark.parametrize("path", example_files(), ids=lambda path: path.stem)
def test_an_example_opens_without_a_remark(path):
    loaded = load(path)
    assert len(loaded.design) > 0
    assert not loaded.notes


@pytest.mark.parametrize("path", example_files(), ids=lambda path: path.stem)
def test_an_example_switches_on_overlays_that_there_are(path):
    assert options_of(load(path).design.view).overlays <= set(overlays)


def test_the_examples_are_those_that_are_made():
    made = dict(MAKER["files"]())
    assert sorted(made) == [path.name for path in example_files()]
    for path in example_files():
        assert alike(json.loads(path.read_bytes()), json.loads(made[path.name])), path.name


def test_figure_1_grows_s_from_zero_and_changes_nothing_else():
    curves = list(panels("figure_1").values())
    strengths = [curve.s for curve in curves]
    assert strengths[0] == 0.0
    assert strengths == sorted(set(strengths))
    for curve in curves:
        assert_allclose(curve.lines.points - curve.lines.points[0], MAKER["ARCH"], atol=1e-8)


def test_figure_2_differs_in_the_inner_directions_only():
    a, b, c = panels("figure_2").values()
    assert a.s == b.s == c.s
    for other in (b, c):
        ahead = other.lines.points - other.lines.points[0]
        assert_allclose(ahead, a.lines.points - a.lines.points[0], atol=1e-8)
        assert_allclose(other.directions[[0, -1]], a.directions[[0, -1]], atol=1e-8)
        assert (np.abs(other.directions[1:-1] - a.directions[1:-1]) > 0.1).any(axis=1).all()


def test_figure_3a_is_tangent_to_its_end_control_lines():
    curve = panels("figure_3")["(a)"]
    velocity = curve.derivatives([0.0, 1.0])[1]
    for at, direction in zip(velocity, curve.directions[[0, -1]], strict=True):
        assert at @ direction > 0.0
        assert cross(at, direction) == pytest.approx(0.0, abs=1e-9)


def test_figure_3b_closes_smoothly():
    curve = panels("figure_3")["(b)"]
    position, velocity, _ = curve.derivatives([0.0, 1.0])
    assert_allclose(position[0], position[1], atol=1e-12)
    assert_allclose(velocity[0], velocity[1], atol=1e-9)
    assert cross(velocity[0], curve.directions[0]) == pytest.approx(0.0, abs=1e-9)


def test_figure_3c_has_one_inflection_more_than_its_classical_curve():
    curve = panels("figure_3")["(c)"]
    assert len(curve.lines) == 3
    assert inflections(curve) == inflections(curve.classical) + 1


def test_figure_4_has_the_curves_of_figures_1_and_2():
    of_figures = [*list(panels("figure_1").values())[1:], *panels("figure_2").values()]
    for curve, same in zip(panels("figure_4").values(), of_figures, strict=True):
        assert curve.s == same.s
        assert_allclose(curve.directions, same.directions, atol=1e-8)


def test_figure_5_is_of_order_4_with_six_points():
    classical, plus = panels("figure_5").values()
    assert classical.s == 0.0 < plus.s
    assert classical.basis == plus.basis
    assert (plus.basis.order, plus.basis.size, plus.closed) == (4, 6, False)


def test_figure_6_lowers_s_and_then_reverses_the_upper_right_line():
    a, b, c = panels("figure_6").values()
    assert a.closed and b.closed and c.closed
    assert 0.0 < b.s < a.s == c.s
    upper_right = c.lines.points.sum(axis=1).argmax()
    signs = np.where(np.arange(len(c.lines)) == upper_right, -1.0, 1.0)
    assert_allclose(c.directions, signs[:, None] * a.directions, atol=1e-8)


def test_the_strands_of_the_braid_share_one_straight_line():
    for curve in panels("braid").values():
        assert_array_equal(curve.lines.points[:, 1], 0.0)
