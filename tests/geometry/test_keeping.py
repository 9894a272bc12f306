"""Shapes keep their constraints whatever else is edited, exactly and by the least change."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.constraints import Wish, constraints
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.keeping import holds, kept
from plusedit.geometry.lines import ControlLines
from tests.geometry.curves import random_curve
from tests.geometry.surfaces import a_surface, random_surface

START, END = Wish("tangent_start"), Wish("tangent_end")
CLOSING = Wish("smooth_closing")


def arch(s=3.0, order=4):
    points = [[0, 0], [1, 2], [2.5, 2.5], [4, 2], [5, 0], [7, 1]]
    return PlusCurve(BSpline(6, order), ControlLines.of(points), s)


def moved(curve, number, by):
    points = curve.lines.points.copy()
    points[number] += by
    return replace(curve, lines=curve.lines.with_points(points))


def velocities(curve):
    return curve.derivatives([0.0, 1.0], highest=1)[1]


@pytest.mark.parametrize("name", list(constraints))
def test_every_constraint_has_words(name):
    constraint = constraints[name]
    assert constraint.title and constraint.conflict.endswith(".")
    assert constraint.order > 0


def test_no_two_constraints_are_solved_at_the_same_place():
    assert len({entry.order for entry in constraints.values()}) == len(constraints)


@given(seed=st.integers(0, 300), kind=st.sampled_from(["bezier", "bspline", "kinks"]))
def test_tangent_ends_run_along_their_lines(seed, kind):
    curve = random_curve(kind, seed=seed, s=2.0)
    found = kept(curve, (START, END))
    assert not found.problems
    for velocity, gradient in zip(
        velocities(found.geometry), found.geometry.gradients[[0, -1]], strict=True
    ):
        assert velocity @ gradient == pytest.approx(
            np.linalg.norm(velocity) * np.linalg.norm(gradient)
        )


@given(seed=st.integers(0, 300), line=st.integers(0, 5))
def test_tangency_is_kept_while_points_are_moved(seed, line):
    by = np.random.default_rng(seed).normal(size=2)
    first = kept(arch(), (START, END)).geometry
    after = kept(moved(first, line, by), (START, END), first)
    assert not after.problems
    assert all(holds(after.geometry, wish) for wish in (START, END))


def test_what_holds_already_is_left_as_it_is():
    curve = kept(arch(), (START, END, Wish("passing", (2,)))).geometry
    assert kept(curve, (START, END, Wish("passing", (2,)))).geometry is curve


@pytest.mark.parametrize("numbers", [(2,), (1, 4), (0, 1, 2, 3, 4, 5)])
def test_chosen_points_are_passed_through(numbers):
    curve = kept(arch(), (Wish("passing", numbers),)).geometry
    at = curve.at(curve.basis.nodes[list(numbers)])
    assert_allclose(at, curve.lines.points[list(numbers)], atol=1e-12)


def test_passing_leaves_what_tangency_has_settled():
    wishes = (START, END, Wish("passing", (2, 3)))
    found = kept(arch(), wishes)
    assert not found.problems
    assert all(holds(found.geometry, wish) for wish in wishes)


def test_passing_changes_no_more_than_the_least():
    curve = arch()
    found = kept(curve, (Wish("passing", (2,)),)).geometry
    change = found.gradients - curve.gradients
    share = np.linalg.norm(change, axis=1)
    assert share[5] == 0.0  # the last line has no hold on the node of the third
    assert found.lines.automatic[5]


@pytest.mark.parametrize("basis", [Bernstein(6), BSpline(6, 4)])
def test_a_closed_curve_stays_smooth_whichever_end_is_dragged(basis):
    curve = kept(replace(arch(), basis=basis), (CLOSING,)).geometry
    for number in (0, 5, 2):
        dragged = moved(curve, number, np.array([0.5, -0.75]))
        after = kept(dragged, (CLOSING,), curve).geometry
        assert_allclose(after.lines.points[number], dragged.lines.points[number], atol=1e-14)
        assert_allclose(after.at([0.0]), after.at([1.0]), atol=1e-13)
        assert_allclose(*velocities(after), atol=1e-11)


@pytest.mark.parametrize("number", [0, 5])
def test_the_seam_turns_with_whichever_end_line_is_turned(number):
    curve = kept(arch(), (CLOSING,)).geometry
    lines = curve.lines.with_direction(number, np.array([0.0, 1.5]))
    after = kept(replace(curve, lines=lines), (CLOSING,), curve).geometry
    assert_allclose(after.directions[[0, -1]], [[0.0, 1.5]] * 2, atol=1e-12)


def test_a_surface_keeps_its_corners_and_passes_through_points():
    wishes = (Wish("corner_tangency", (0, 3)), Wish("passing", (7, 11)))
    found = kept(a_surface(5, 5), wishes)
    assert not found.problems
    assert all(holds(found.geometry, wish) for wish in wishes)


@given(seed=st.integers(0, 100))
def test_corners_stay_tangent_while_planes_are_moved(seed):
    wish = Wish("corner_tangency", (0, 1, 2, 3))
    surface = random_surface("bspline", "bezier", seed=seed, s=1.0)
    found = kept(surface, (wish,))
    assert not found.problems
    assert holds(found.geometry, wish)


@pytest.mark.parametrize(
    "curve, wish, words",
    [
        (replace(arch(), s=0.0), START, "set s"),
        (random_curve("closed"), END, "closed curve"),
        (random_curve("rag"), START, "rational Gaussian"),
        (PlusCurve(Bernstein(2), ControlLines.of([[0, 0], [1, 1]])), START, "at least 3"),
        (PlusCurve(Bernstein(3), ControlLines.of([[0, 0], [1, 1], [2, 0]])), CLOSING, "insert"),
        (arch(), Wish("passing", ()), "select"),
        (arch(), Wish("passing", (9,)), "no control point 10"),
    ],
)
def test_what_cannot_be_kept_is_said_with_what_would_help(curve, wish, words):
    found = kept(curve, (wish,))
    assert found.geometry is curve
    assert words in found.problems[wish]


def test_three_lines_can_be_tangent_at_one_end_only():
    points = [[0, 0], [1, 2], [3, 0]]
    directions = [[1, 0.2], [1, 0], [0.3, 1]]
    curve = PlusCurve(Bernstein(3), ControlLines.of(points, directions), 2.0)
    found = kept(curve, (START, END))
    assert set(found.problems) == {END}
    assert "one more control line" in found.problems[END]
    assert holds(found.geometry, START)


def test_points_that_cannot_all_be_passed_are_told_and_come_as_close_as_can_be():
    angles = 2.0 * np.pi * np.arange(6) / 6.0
    points = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    points[0] *= 2.0
    curve = PlusCurve(BSpline(6, 4, closed=True), ControlLines.of(points), 1.0)
    wish = Wish("passing", tuple(range(6)))
    found = kept(curve, (wish,))
    assert "Leave a point out" in found.problems[wish]
    away = constraints["passing"].miss(found.geometry, wish.numbers)
    assert away <= constraints["passing"].miss(curve, wish.numbers)
