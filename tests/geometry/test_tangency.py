"""End velocities of the changed curves, asked from the curves themselves."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.arrays import unit
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.tangency import closed_smoothly, tangent_at_ends

BASES = {
    "bezier of 4": Bernstein(4),
    "bezier": Bernstein(7),
    "cubic": BSpline(7, 4),
    "polygon": BSpline(7, 2),
    "uneven": BSpline(7, 4, knots=(0, 0, 0, 0, 0.1, 0.1, 0.1, 1, 1, 1, 1)),
}
every_basis = pytest.mark.parametrize("basis", BASES.values(), ids=BASES.keys())
some_weights = pytest.mark.parametrize("weighted", [False, True], ids=["even", "weighted"])


def a_curve(basis, *, weighted=False, seed=0, dimension=2, s=1.5, directions="random"):
    """An open curve with directions of any length."""
    random = np.random.default_rng(seed)
    points = random.uniform(-1.0, 1.0, (basis.size, dimension))
    rows = random.normal(size=points.shape) if directions == "random" else None
    weights = random.uniform(0.2, 5.0, basis.size) if weighted else None
    return PlusCurve(basis, ControlLines.of(points, rows, weights), s)


def end_velocities(curve):
    return curve.derivatives([0.0, 1.0], highest=1)[1]


def headings(curve):
    return unit(curve.gradients[[0, -1]])


@every_basis
@some_weights
@pytest.mark.parametrize("dimension", [2, 3])
def test_an_exact_speed_is_had_at_both_ends(basis, weighted, dimension):
    curve = a_curve(basis, weighted=weighted, dimension=dimension)
    made = tangent_at_ends(curve, how="exact", speed=2.5)
    assert_allclose(end_velocities(made), 2.5 * headings(curve), atol=1e-12)


@every_basis
@some_weights
@pytest.mark.parametrize("s", [-2.0, 0.3, 40.0])
@pytest.mark.parametrize("seed", range(3))
def test_the_least_change_is_tangent_forwards(basis, weighted, s, seed):
    curve = a_curve(basis, weighted=weighted, s=s, seed=seed)
    velocities = end_velocities(tangent_at_ends(curve))
    speed = np.linalg.norm(velocities, axis=1)
    assert (speed > 0.0).all()
    assert_allclose(velocities, speed[:, None] * headings(curve), atol=1e-12 * speed.max())


@every_basis
def test_no_other_speed_that_is_enough_needs_less_change(basis):
    for seed in range(10):
        curve = a_curve(basis, seed=seed)
        made = tangent_at_ends(curve, end=False)
        speed = np.linalg.norm(end_velocities(made)[0])
        chord = (curve.lines.points[1] - curve.lines.points[0]) / basis.nodes[1]
        slowest = 0.1 * np.linalg.norm(chord)
        assert speed >= slowest * (1.0 - 1e-12)
        for other in (0.5 * speed, 0.99 * speed, 1.01 * speed, 2.0 * speed):
            if other >= slowest:
                exact = tangent_at_ends(curve, end=False, how="exact", speed=other)
                assert change_of(exact, curve) > change_of(made, curve)


def change_of(made, curve):
    return np.linalg.norm(made.gradients - curve.gradients)


def test_a_least_speed_can_be_asked_for():
    curve = a_curve(Bernstein(5), seed=2)
    made = tangent_at_ends(curve, speed=30.0)
    assert (np.linalg.norm(end_velocities(made), axis=1) >= 30.0 - 1e-9).all()


@every_basis
@some_weights
def test_unit_directions_stay_unit_directions(basis, weighted):
    curve = a_curve(basis, weighted=weighted, directions=None, s=60.0)
    made = tangent_at_ends(curve, how="unit")
    assert_allclose(np.linalg.norm(made.directions, axis=1), 1.0, rtol=1e-12)
    velocities = end_velocities(made)
    assert ((velocities * headings(curve)).sum(axis=1) > 0.0).all()
    across = velocities - (velocities * headings(curve)).sum(axis=1)[:, None] * headings(curve)
    assert_allclose(across, 0.0, atol=1e-10)


def test_unit_directions_need_an_s_that_reaches_across():
    lines = ControlLines.of([(0, 0), (1, 2), (2, 2), (3, 0)], [(1, 0), (0, 1), (0, 1), (1, 0)])
    with pytest.raises(ValueError, match=r"only for s of at least 6; s is 5\.9"):
        tangent_at_ends(PlusCurve(Bernstein(4), lines, 5.9), how="unit")
    made = tangent_at_ends(PlusCurve(Bernstein(4), lines, 6.0), how="unit")
    assert_allclose(end_velocities(made)[0], [9.0, 0.0], atol=1e-12)


def test_unit_directions_that_only_run_backwards_are_refused():
    lines = ControlLines.of([(0, 0), (-9, 0.1), (2, 2), (3, 0)], [(1, 0), (0, 1), (0, 1), (1, 0)])
    with pytest.raises(ValueError, match="backwards"):
        tangent_at_ends(PlusCurve(Bernstein(4), lines, 1.0), how="unit", end=False)


@every_basis
def test_only_the_lines_beside_the_ends_change(basis):
    curve = a_curve(basis, directions=None)
    made = tangent_at_ends(curve)
    assert made.s == curve.s
    assert_array_equal(made.lines.points, curve.lines.points)
    changed = np.zeros(basis.size, dtype=bool)
    changed[[1, -2]] = True
    assert_array_equal(made.lines.automatic, ~changed)


@pytest.mark.parametrize(("start", "end", "changed"), [(True, False, 1), (False, True, 5)])
def test_one_end_alone_changes_one_line(start, end, changed):
    curve = a_curve(Bernstein(7))
    made = tangent_at_ends(curve, start=start, end=end)
    differs = (made.directions != curve.directions).any(axis=1)
    assert np.flatnonzero(differs).tolist() == [changed]


def test_one_end_of_three_lines_can_be_made_tangent_and_both_can_not():
    curve = a_curve(Bernstein(3))
    velocity = end_velocities(tangent_at_ends(curve, end=False, how="exact", speed=1.0))[0]
    assert_allclose(velocity, headings(curve)[0], atol=1e-12)
    with pytest.raises(ValueError, match="both ends needs at least 4 control lines"):
        tangent_at_ends(curve)


def test_making_tangent_twice_is_making_tangent_once():
    once = tangent_at_ends(a_curve(BSpline(6, 4), seed=3))
    assert_allclose(tangent_at_ends(once).directions, once.directions, atol=1e-12)


@every_basis
@some_weights
@pytest.mark.parametrize("seed", range(3))
def test_a_smoothly_closed_curve_ends_as_it_begins(basis, weighted, seed):
    curve = a_curve(basis, weighted=weighted, seed=seed)
    made = closed_smoothly(curve)
    start, end = made.at([0.0, 1.0])
    assert_array_equal(made.lines.points[-1], curve.lines.points[0])
    assert_allclose(start, end, atol=1e-14)
    first, last = end_velocities(made)
    speed = np.linalg.norm(first)
    assert_allclose(first, last, atol=1e-12 * speed)
    assert_allclose(first, speed * headings(made)[0], atol=1e-12 * speed)
    assert_allclose(made.gradients[0], made.gradients[-1], atol=1e-14)
    assert speed > 0.0


def test_closing_a_square_of_automatic_lines_keeps_its_symmetry():
    points = [(0, 0), (1, 1), (0, 2), (-1, 1), (0, 0)]
    made = closed_smoothly(PlusCurve(Bernstein(5), ControlLines.of(points), 2.0))
    assert_allclose(made.directions[0], (1.0, 0.0), atol=1e-12)
    u = np.linspace(0.0, 1.0, 21)
    assert_allclose(made.at(u), made.at(1.0 - u) * (-1.0, 1.0), atol=1e-12)


def test_opposite_end_lines_are_closed_across_the_points_beside_them():
    rows = [(0, 1), None, None, (0, -1)]
    lines = ControlLines.of([(0, 0), (1, 1), (-1, 1), (0, 0)], rows)
    made = closed_smoothly(PlusCurve(Bernstein(4), lines, 2.0))
    assert_allclose(made.directions[0], (1.0, 0.0), atol=1e-12)
    assert_allclose(*end_velocities(made), atol=1e-12)


@pytest.mark.parametrize("change", [tangent_at_ends, closed_smoothly])
def test_where_it_can_not_be_a_sentence_says_why(change):
    curve = a_curve(BSpline(5, 4))
    for basis, words in (
        (BSpline(5, 4, closed=True), "closed curve has no ends"),
        (RationalGaussian.of_size(5), "closed basis"),
    ):
        with pytest.raises(ValueError, match=words):
            change(replace(curve, basis=basis))
    with pytest.raises(ValueError, match="set s first"):
        change(replace(curve, s=0.0))
    with pytest.raises(ValueError, match="at least 4 control lines"):
        change(a_curve(Bernstein(3)))
    still = replace(curve, lines=curve.lines.with_directions(np.zeros((5, 2))))
    with pytest.raises(ValueError, match="no direction"):
        change(still)
    with pytest.raises(ValueError, match="speed: must be positive"):
        tangent_at_ends(curve, how="exact", speed=-1.0)
