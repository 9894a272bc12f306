"""Better corners for pillows: what is told of them beforehand, and what comes of them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.mesh.flattening.cones import (
    best_corners,
    conformal,
    measured_cost,
    stretches,
)
from plusedit.geometry.mesh.flattening.distortion import stretch
from plusedit.geometry.mesh.flattening.paths import edge_graph, farthest_points
from plusedit.geometry.mesh.flattening.pillows import cone_chain, pillow_layout
from plusedit.geometry.mesh.flattening.sheet import Sheet
from plusedit.geometry.mesh.mapping import mapped
from plusedit.geometry.mesh.maps import silent
from plusedit.geometry.mesh.repair import repaired
from tests.geometry.mesh.bodies import cylinder, real_mesh
from tests.geometry.mesh.mapped_bodies import assert_seams_fit, ball, blocks, turned_in_space

SLANTED = {
    "egg": ball(3, (3.0, 1.0, 0.7)),
    "closed cylinder": cylinder(24, 3.0),
    "bar of blocks": blocks((x, 0, 0) for x in range(9)).subdivided(2).mesh,
    "cube": blocks([(0, 0, 0)]).subdivided(3).mesh,
}
"""Bodies of which four vertices far from each other make no good corners"""

every_body = pytest.mark.parametrize("body", SLANTED.values(), ids=SLANTED.keys())


def pairs(*points):
    """Points of the plane, None at infinity, as a row of pairs."""
    rows = [(1.0, 0.0) if x is None else (x, 1.0) for x in points]
    return np.array([rows], dtype=np.complex128)


def far_apart(mesh):
    """The corners that pillows had if they were never changed."""
    sheet = Sheet.of(mesh)
    return tuple(cone_chain(sheet, edge_graph(sheet), ())[0])


def cost_of(mesh, cone_points):
    sheet = Sheet.of(mesh)
    return measured_cost(sheet, pillow_layout(sheet, cone_points, silent).places)


@pytest.mark.parametrize(
    "corners",
    [(0, 1, 2, 3), (-7, 0.1, 4, 1e5), (1, 1j, -1, -1j), (0, 1, 3, None), (1e-9, 0, 1, None)],
)
def test_corners_on_a_circle_stretch_nothing(corners):
    assert_allclose(stretches(pairs(*corners)), 1.0, atol=1e-9)


def test_the_corners_of_a_tetrahedron_are_farthest_from_a_right_angle():
    corners = pairs(0, *np.sqrt(2.0) * np.exp(2j * np.pi * np.arange(3) / 3))
    assert_allclose(stretches(corners), np.sqrt(3.0))


def test_the_order_of_corners_and_where_the_sphere_is_seen_from_do_not_matter():
    random = np.random.default_rng(5)
    corners = random.normal(size=(40, 4, 2)) + 1j * random.normal(size=(40, 4, 2))
    expected = stretches(corners)
    assert ((expected >= 1.0) & (expected <= np.sqrt(3.0) + 1e-9)).all()
    moved = corners @ (random.normal(size=(2, 2)) + 1j * random.normal(size=(2, 2)))
    assert_allclose(stretches(moved), expected, rtol=1e-9)
    assert_allclose(stretches(corners[:, [2, 0, 3, 1]]), expected, rtol=1e-9)


def test_what_is_told_of_corners_comes_true():
    mesh = ball(4, (1.5, 1.0, 0.8))
    sheet = Sheet.of(mesh)
    random = np.random.default_rng(2)
    for _ in range(4):
        corners = random.choice(mesh.vertex_count, 4, replace=False)
        found = mapped(mesh, wish="pillow", cone_points=tuple(corners.tolist()))
        periods = found.parameters.reshape(-1, 3, 2) / (2.0 * found.domain.width, 1.0)
        tau = 0.5j / found.domain.width
        others = [v for v in corners.tolist() if v not in found.cone_points]
        known = conformal(sheet, periods, tau, [*found.cone_points, *others])
        best, cost, now = best_corners(known)
        assert cost <= now
        assert cost_of(mesh, tuple(best)) < 1.5 * cost + 0.3


@every_body
def test_slanted_pillows_get_better_corners(body):
    found = mapped(body, wish="pillow")
    far = mapped(body, wish="pillow", cone_points=far_apart(body))
    assert set(found.cone_points) != set(far.cone_points)
    assert_seams_fit(body, found)
    assert found.flips == 0
    assert cost_of(body, found.cone_points) < cost_of(body, far.cone_points) - 0.2
    medians = [np.median(stretch(body, each.parameters).angles) for each in (found, far)]
    assert medians[0] < 1.05 * medians[1]


def test_good_corners_are_kept():
    body = ball(4)
    assert set(mapped(body).cone_points) == set(far_apart(body))


def test_corners_do_not_depend_on_size_and_place():
    random = np.random.default_rng(8)
    body = ball(3, (3.0, 1.0, 0.7))
    body = body.with_vertices(body.vertices * random.uniform(0.9, 1.1, (body.vertex_count, 1)))
    moved = turned_in_space(body.with_vertices(100.0 * body.vertices))
    assert mapped(moved).cone_points == mapped(body).cone_points


def test_given_corners_are_never_changed():
    body = SLANTED["egg"]
    wished = far_apart(body)
    assert set(mapped(body, cone_points=wished).cone_points) == set(wished)


def test_layouts_that_turn_triangles_over_are_never_better():
    sheet = Sheet.of(ball(1))
    places = np.tile([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], (sheet.own, 1, 1))
    assert measured_cost(sheet, places) < np.inf
    places[3, 0] = (1.0, 1.0)
    assert measured_cost(sheet, places) == np.inf


@pytest.mark.parametrize(
    ("name", "least", "most"),
    [("goathead_closed.obj", 1.4, 1.1), ("teapot_3parts.obj", 1.3, 1.1), ("femur.stl", 1.1, 1.05)],
)
def test_real_bodies_keep_angles_better_with_better_corners(name, least, most):
    mesh = repaired(real_mesh(name)).parts[0].mesh
    found = mapped(mesh)
    sheet = Sheet.of(mesh)
    loops = mesh.topology.loops
    filled = sheet.filled([sheet.ring(loop) for loop in loops]) if loops else sheet
    far = mapped(
        mesh, wish=found.name, cone_points=tuple(cone_chain(filled, edge_graph(filled), ())[0])
    )
    medians = [np.median(stretch(mesh, each.parameters).angles) for each in (far, found)]
    assert medians[0] > least
    assert medians[1] < most
    assert found.flips == 0


def test_limbs_keep_corners_at_their_tips():
    """A body with four long limbs: without a corner at its tip each would come to nothing."""
    arms = [(x, 0, 0) for x in range(-6, 7)] + [(0, y, 0) for y in (*range(-6, 0), *range(1, 7))]
    body = blocks(arms).subdivided(1).mesh
    found = mapped(body)
    tips = body.vertices[list(found.cone_points)]
    sheet = Sheet.of(body)
    points, _ = farthest_points(sheet, edge_graph(sheet), 4)
    assert (
        len({tuple(np.round((body.vertices[p] - 0.5)[:2] / 6.5).astype(int)) for p in points}) == 4
    )
    assert len({tuple(np.round((tip - 0.5)[:2] / 6.5).astype(int)) for tip in tips}) == 4
