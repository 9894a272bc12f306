"""A point of a shape is pulled exactly to where it shall be, by the least change."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.influence import influence
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.pulling import Change, pulled
from plusedit.geometry.surface import PlusSurface
from tests.geometry.curves import KINDS, random_curve
from tests.geometry.mesh.mesh_surfaces import cylinder, height_field, pillow, torus
from tests.geometry.surfaces import PAIRS, random_surface

BODIES = {"plane": height_field, "cylinder": cylinder, "torus": torus, "pillow": pillow}
CHANGES: list[Change] = ["points", "gradients", "both"]


def point_at(shape, place) -> Floats:
    if isinstance(shape, PlusCurve):
        return shape.at([place[0]])[0]
    return shape.derivatives_at([place], highest=0)[0][0]


def data_of(shape) -> Floats:
    """Points and gradients over the spacing, as what the least change is measured in."""
    spacings = [shape.spacing] if isinstance(shape, PlusCurve) else shape.spacings
    gradients = [h * shape.s * d for h, d in zip(spacings, shape.vectors, strict=True)]
    return np.concatenate([shape.net.control_points, *gradients])


def with_given_directions(shape):
    net = shape.net
    return shape.with_net(net.with_vectors(shape.vectors, np.zeros_like(net.automatic_vectors)))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("change", CHANGES)
def test_the_point_of_a_curve_comes_to_the_target(kind, dimension, change):
    curve = random_curve(kind, dimension=dimension, seed=3)
    target = curve.at([0.37])[0] + np.array([0.4, -0.7, 0.2])[:dimension]
    assert_allclose(pulled(curve, (0.37,), target, change).at([0.37])[0], target, atol=1e-12)


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("kinds", PAIRS)
def test_the_point_of_a_surface_comes_to_the_target(kinds, change):
    surface = random_surface(*kinds, seed=5)
    place = (0.41, 0.63)
    target = point_at(surface, place) + np.array([0.3, -0.2, 0.5])
    moved = pulled(surface, place, target, change)
    assert_allclose(point_at(moved, place), target, atol=1e-12)


@pytest.mark.parametrize("kind", KINDS)
def test_shares_are_what_the_point_is_made_of(kind):
    curve = with_given_directions(random_curve(kind, seed=2))
    shares = influence(curve, (0.31,))
    summed = shares.values @ curve.lines.points + shares.reaches[0] @ curve.gradients
    assert_allclose(summed, curve.at([0.31])[0], atol=1e-13)
    assert shares.values.sum() == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("change", CHANGES)
@given(seed=st.integers(0, 500), u=st.floats(0.05, 0.95))
def test_no_other_change_is_smaller(change, seed, u):
    curve = with_given_directions(random_curve("bezier", size=5, seed=seed))
    target = curve.at([u])[0] + 0.5
    found = pulled(curve, (u,), target, change)
    rng = np.random.default_rng(seed)
    shares = influence(curve, (u,))
    row = np.concatenate([shares.values, shares.reaches[0] / curve.spacing])
    if change != "both":
        row[len(curve.lines) :] *= change == "gradients"
        row[: len(curve.lines)] *= change == "points"
    free = row != 0.0
    # Any change that leaves the point where it is may be added: that makes it larger.
    other = rng.normal(size=(len(row), 2)) * free[:, None]
    other -= np.outer(row, row @ other) / (row @ row)
    change_made = data_of(found) - data_of(curve)
    assert np.linalg.norm(change_made) <= np.linalg.norm(change_made + other) + 1e-12


def test_automatic_directions_follow_where_points_are_pulled():
    lines = ControlLines.of([[0, 0], [1, 2], [3, 2], [4, 0], [6, 1]])
    curve = PlusCurve(BSpline(5, 4), lines, 3.0)
    moved = pulled(curve, (0.5,), curve.at([0.5])[0] + 1.0, "points")
    assert moved.lines.automatic.all()


def test_far_lines_of_a_b_spline_stay_as_they_are():
    curve = random_curve("bspline", size=12, seed=4)
    for change in CHANGES:
        moved = pulled(curve, (0.05,), curve.at([0.05])[0] + 0.3, change)
        assert (moved.lines.points[8:] == curve.lines.points[8:]).all()
        assert (moved.lines.automatic[8:] == curve.lines.automatic[8:]).all()


def test_a_point_pulled_to_where_it_is_leaves_the_same_object():
    curve = random_curve("bezier")
    for change in CHANGES:
        assert pulled(curve, (0.3,), curve.at([0.3])[0], change) is curve


def test_gradients_have_no_hold_on_an_open_end():
    curve = random_curve("bspline")
    with pytest.raises(ValueError, match="pull points"):
        pulled(curve, (0.0,), curve.at([0.0])[0] + 1.0, "gradients")


def test_without_s_gradients_move_nothing():
    curve = random_curve("bezier", s=0.0)
    target = curve.at([0.4])[0] + 1.0
    with pytest.raises(ValueError, match="s = 0"):
        pulled(curve, (0.4,), target, "gradients")
    assert_allclose(pulled(curve, (0.4,), target, "both").at([0.4])[0], target, atol=1e-12)


def test_what_makes_no_sense_is_refused():
    curve, surface = random_curve("bezier"), random_surface("bezier", "bspline")
    with pytest.raises(ValueError, match="change"):
        pulled(curve, (0.5,), [0.0, 0.0], "weights")
    with pytest.raises(ValueError, match="to: expected shape"):
        pulled(curve, (0.5,), [0.0, 0.0, 0.0])
    with pytest.raises(ValueError, match="place"):
        pulled(surface, (0.5,), [0.0, 0.0, 0.0])
    assert isinstance(surface, PlusSurface)


@pytest.mark.parametrize("kind", sorted(BODIES))
@pytest.mark.parametrize("smoothness", [0.5, 3.0])
def test_shares_of_faces_are_what_a_mesh_surface_is_made_of(kind, smoothness):
    surface = BODIES[kind]().with_smoothness(smoothness).with_s(0.8)
    for place in surface.vertex_places[[0, 5, 11]]:
        shares = influence(surface, tuple(place))
        by_u, by_v = surface.s * surface.vectors
        summed = shares.values @ surface.net.control_points
        summed += shares.reaches[0] @ by_u + shares.reaches[1] @ by_v
        assert_allclose(summed, surface.at([place])[0], atol=1e-10)


@pytest.mark.parametrize("change", CHANGES)
def test_a_mesh_surface_comes_to_the_target_and_changes_nearby_alone(change):
    surface = BODIES["pillow"]()
    place = tuple(surface.vertex_places[7])
    target = surface.at([place])[0] + np.array([0.2, -0.1, 0.3])
    moved = pulled(surface, place, target, change)
    assert_allclose(moved.at([place])[0], target, atol=1e-9)
    assert 0 < len(moved.edited) <= surface.mesh.face_count
    assert (moved.net.automatic_vectors.all()) == (change == "points")
