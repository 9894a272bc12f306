"""What the help says against the paper holds in the designs that are shipped to prove it."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.app.facts import FACTS, facts_page, follow
from plusedit.geometry.corner_nets import corner_hull, corner_nets
from plusedit.geometry.hulls import parent_hulls, union_hull
from plusedit.geometry.inflections import inflections
from plusedit.io.files import load
from plusedit.scene.options import options_of

U = np.linspace(0.0, 1.0, 201)


def geometries(name):
    """The geometries of a shipped design, in its order."""
    [fact] = [fact for fact in FACTS if fact.design == name]
    return [shape.geometry for shape in load(fact.path).design.shapes.values()]


def beyond(hull, points):
    """How far each point is outside of a convex polygon, counter-clockwise; negative inside."""
    along = np.roll(hull, -1, axis=0) - hull
    outwards = np.stack([along[:, 1], -along[:, 0]], axis=1)
    outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
    return np.einsum("mhd,hd->mh", points[:, None] - hull, outwards).max(axis=1)


def beyond_body(body, points):
    """How far each point is outside of a convex body; negative inside."""
    a, b, c = (body.points[body.triangles[:, corner]] for corner in range(3))
    outwards = np.cross(b - a, c - a)
    outwards /= np.linalg.norm(outwards, axis=1, keepdims=True)
    return np.einsum("mtd,td->mt", points[:, None] - a, outwards).max(axis=1)


def test_a_curve_is_outside_of_both_hulls_and_inside_the_hull_of_the_union():
    [curve] = geometries("fact_hull_of_the_union")
    points = curve.at(U)
    outside = np.min([beyond(hull, points) for hull in parent_hulls(curve)], axis=0)
    assert outside.max() > 0.2 * np.ptp(points)
    assert (outside > 0.0).mean() > 0.9
    assert beyond(union_hull(curve), points).max() <= 1e-9


def test_equal_directions_close_smoothly_and_opposite_ones_with_a_cusp():
    smooth, cusp = geometries("fact_equal_ends_close_smoothly")
    for curve, sign in ((smooth, 1.0), (cusp, -1.0)):
        assert_allclose(curve.directions[0], sign * curve.directions[-1], atol=1e-8)
        places, velocities, _ = curve.derivatives([0.0, 1.0])
        assert_allclose(places[0], places[1], atol=1e-9)
        headings = velocities / np.linalg.norm(velocities, axis=1, keepdims=True)
        own = curve.directions[[0, -1]]
        # Both are tangent to their end lines, and run along them.
        assert_allclose(headings, own / np.linalg.norm(own, axis=1, keepdims=True), atol=1e-6)
        assert_allclose(headings[0], sign * headings[1], atol=1e-6)


def test_a_surface_leaves_the_hull_of_two_nets_but_not_that_of_four():
    first, second = geometries("fact_four_nets_of_a_surface")
    for surface, pair in ((first, [0, 3]), (second, [1, 2])):
        points = surface.at(U[::10], U[::10]).reshape(-1, 3)
        nets = corner_nets(surface)[pair].reshape(-1, 3)
        assert_allclose(nets[:, 2], 0.0, atol=1e-9)
        assert np.abs(points[:, 2]).max() > 0.2
        assert beyond_body(corner_hull(surface), points).max() <= 1e-9


def test_convex_polygons_have_curves_with_two_inflections_more():
    curves = geometries("fact_two_inflections_more")
    assert [len(curve.lines) for curve in curves] == [4, 3]
    for curve in curves:
        legs = np.diff(curve.lines.points, axis=0)
        assert (legs[:-1, 0] * legs[1:, 1] - legs[:-1, 1] * legs[1:, 0] < 0.0).all()
        assert len(inflections(curve.classical)) == 0
        assert len(inflections(curve)) == 2


@pytest.mark.parametrize("fact", FACTS, ids=lambda fact: fact.design)
def test_the_design_of_a_fact_shows_it_and_says_so(fact):
    design = load(fact.path).design
    assert design.extra["about"]
    assert options_of(design.view).overlays & {"hulls", "classical"}


def test_links_on_the_page_open_the_designs_and_nothing_else():
    opened = []
    for fact in FACTS:
        assert f'href="{fact.design}"' in facts_page()
        follow(fact.design, opened.append)
    follow("https://example.org", opened.append)
    assert opened == [fact.path for fact in FACTS]
