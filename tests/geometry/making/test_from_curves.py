"""Surfaces from curves meet those curves."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.iso_curves import iso_curve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.making.coons import coons
from plusedit.geometry.making.extrusion import extruded
from plusedit.geometry.making.lofting import lofted, section_parameters
from plusedit.geometry.making.revolution import revolved
from plusedit.geometry.making.ruled import ruled
from plusedit.geometry.standard import elliptic_arc
from plusedit.geometry.surface_transforms import transformed_surface
from plusedit.geometry.transforms import transformed
from tests.geometry.curves import KINDS, random_curve

T = np.linspace(0.0, 1.0, 41)
TURN = np.array([[0.0, -1.2, 0.1], [1.0, 0.3, 0.0], [0.2, 0.0, -0.7]])
SHIFT = np.array([3.0, -1.0, 0.5])

every_kind = pytest.mark.parametrize("kind", KINDS)
with_and_without_weights = pytest.mark.parametrize("contrast", [None, 4.0])


def same(found, wanted, accuracy=1e-12):
    assert_allclose(found, wanted, rtol=0.0, atol=accuracy)


def sections(kind, count, contrast=None):
    """Curves one above the other; with weights, those of all are alike but for some."""
    curves = []
    for number in range(count):
        curve = random_curve(kind, dimension=3, s=2.0, seed=number, contrast=contrast)
        points = curve.lines.points + np.array([0.0, 0.0, 2.0 * number])
        lines = replace(curve.lines, points=points)
        if contrast is not None:
            weights = 1.0 + 0.3 * np.sin(np.arange(len(points)) + 0.3 * number)
            lines = lines.with_weights(weights)
        curves.append(replace(curve, lines=lines))
    return curves


def edge(kind, start, end, seed, s=2.0):
    """A random curve between two points."""
    curve = random_curve(kind, dimension=3, seed=seed, s=s)
    points = curve.lines.points.copy()
    points[0], points[-1] = start, end
    return replace(curve, lines=curve.lines.with_points(points))


CORNERS = np.array([[0.0, 0.0, 0.0], [3.0, 0.0, 0.2], [0.0, 3.0, 0.0], [3.2, 3.0, 0.5]])


def edges(kind_u="bspline", kind_v="bezier", s=2.0):
    """u0, u1, v0, v1, meeting in the corners."""
    a, b, c, d = CORNERS
    ends = ((kind_u, a, b), (kind_u, c, d), (kind_v, a, c), (kind_v, b, d))
    return [edge(kind, *two, seed, s) for seed, (kind, *two) in enumerate(ends)]


# Extruded


@every_kind
@with_and_without_weights
def test_an_extruded_curve_is_moved_straight_on(kind, contrast):
    curve, by = random_curve(kind, dimension=3, contrast=contrast), np.array([0.1, -0.2, 3.0])
    for count in (2, 4):
        surface = extruded(curve, by, count=count)
        same(surface.at(T, T), curve.at(T)[:, None] + T[:, None] * by)


def test_an_extruded_curve_stays_straight_for_every_s():
    curve = random_curve("bspline", dimension=3)
    for s in (0.0, -1.0, 7.0):
        at_s = replace(extruded(curve, SHIFT), s=s)
        same(at_s.at(T, T), replace(curve, s=s).at(T)[:, None] + T[:, None] * SHIFT)


def test_an_extruded_curve_keeps_automatic_directions():
    curve = random_curve("closed")
    surface = extruded(curve, SHIFT)
    for column in (0, 1):
        assert_array_equal(surface.planes.automatic[0, :, column], curve.lines.automatic)
    assert surface.closed == (True, False)


def test_a_curve_that_is_not_moved_is_refused():
    with pytest.raises(ValueError, match="more than nothing"):
        extruded(random_curve("bspline"), np.zeros(3))


# Revolved


def cylinder_coordinates(points, center, axis):
    """Height along and distance from the axis."""
    axis = axis / np.linalg.norm(axis)
    seen = points - center
    height = seen @ axis
    return height, np.linalg.norm(seen - height[..., None] * axis, axis=-1)


@every_kind
@with_and_without_weights
@pytest.mark.parametrize("angle", [2.0 * np.pi, 1.0, -4.0])
def test_a_revolved_curve_runs_on_exact_circles(kind, contrast, angle):
    center, axis = np.array([0.1, 0.2, 0.3]), np.array([1.0, 2.0, -1.0])
    curve = random_curve(kind, dimension=3, contrast=contrast)
    surface = revolved(curve, center, axis, angle)
    height, distance = cylinder_coordinates(surface.at(T, T), center, axis)
    on_curve = cylinder_coordinates(curve.at(T), center, axis)
    same(height, np.broadcast_to(on_curve[0], height.shape))
    same(distance, np.broadcast_to(on_curve[1], distance.shape))
    same(surface.at([0.0], T)[0], curve.at(T))


def test_a_revolved_curve_stays_round_for_every_s():
    curve = random_curve("bspline")
    for s in (0.0, 5.0):
        surface = replace(revolved(curve, np.zeros(3), [0.0, 1.0, 0.0]), s=s)
        _, distance = cylinder_coordinates(surface.at(T, T), np.zeros(3), np.array([0.0, 1.0, 0.0]))
        wanted = np.abs(replace(curve, s=s).at(T)[:, 0])
        same(distance, np.broadcast_to(wanted, distance.shape))


def test_a_part_of_a_turn_ends_at_its_angle_counterclockwise():
    curve = PlusCurve(BSpline(2, 2), ControlLines.of([[1.0, 0.0, 0.0], [1.0, 0.0, 1.0]]))
    quarter = revolved(curve, np.zeros(3), [0.0, 0.0, 5.0], np.pi / 2)
    same(quarter.at([1.0], [0.0, 1.0])[0], [[0.0, 1.0, 0.0], [0.0, 1.0, 1.0]])


def test_a_whole_turn_ends_where_it_begins():
    surface = revolved(random_curve("bspline"), [0.0, 5.0, 0.0], [1.0, 0.0, 0.0])
    assert_array_equal(surface.planes.points[0], surface.planes.points[-1])


@pytest.mark.parametrize(
    ("axis", "angle", "sentence"),
    [
        ([0.0, 0.0, 0.0], 1.0, "needs a direction"),
        ([1.0, 0.0, 0.0], 1.0, "lies on the axis"),
        ([0.0, 1.0, 0.0], 0.0, "360"),
        ([0.0, 1.0, 0.0], 7.0, "360"),
    ],
)
def test_a_turn_that_makes_no_surface_is_refused(axis, angle, sentence):
    straight = PlusCurve(BSpline(2, 2), ControlLines.of([[1.0, 0.0], [2.0, 0.0]]))
    with pytest.raises(ValueError, match=sentence):
        revolved(straight, np.zeros(3), axis, angle)


# Ruled


@every_kind
@with_and_without_weights
def test_a_ruled_surface_joins_both_curves_by_straight_lines(kind, contrast):
    first, second = (
        random_curve(kind, dimension=3, contrast=contrast, seed=seed, s=2.0) for seed in (0, 1)
    )
    surface = ruled(first, second)
    for s in (2.0, -6.0):
        a, b = (replace(curve, s=s).at(T) for curve in (first, second))
        on = replace(surface, s=s).at(T, [0.0, 0.3, 1.0])
        same(on[:, 0], a)
        same(on[:, 2], b)
        same(np.cross(on[:, 1] - a, b - a), 0.0, 1e-11)


def test_a_ruled_surface_joins_curves_of_different_kinds():
    first = random_curve("bezier", size=4, s=1.0)
    second = random_curve("closed", size=5, dimension=3, s=-3.0)
    surface = ruled(first, second)
    same(iso_curve(surface, "v", 0.0).at(T)[:, :2], first.at(T))
    same(iso_curve(surface, "v", 1.0).at(T), second.at(T))


def test_automatic_directions_of_ruled_curves_stay_automatic():
    first, second = (random_curve("bspline", s=1.0, seed=seed) for seed in (0, 1))
    automatic = ruled(first, second).planes.automatic
    assert_array_equal(automatic[0, :, 0], first.lines.automatic)
    assert_array_equal(automatic[0, :, 1], second.lines.automatic)
    assert automatic[1].all()


def test_a_disk_is_ruled_between_a_circle_and_its_center():
    circle = elliptic_arc((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))
    dot = PlusCurve(BSpline(2, 2), ControlLines.of(np.zeros((2, 2))))
    distance = np.linalg.norm(ruled(circle, dot).at(T, [0.0, 1.0]), axis=-1)
    same(distance[:, 0], 1.0)
    same(distance[:, 1], 0.0)


# Lofted


@every_kind
@pytest.mark.parametrize("count", [2, 3, 4, 6])
@pytest.mark.parametrize("closed", [False, True])
def test_a_loft_meets_its_sections(kind, count, closed):
    if closed and count < 3:
        pytest.skip("two sections don't close")
    curves = sections(kind, count)
    surface, at = lofted(curves, closed=closed), section_parameters(curves, closed=closed)
    same(surface.at(T, at), np.stack([curve.at(T) for curve in curves], axis=1))
    assert surface.closed == (curves[0].closed, closed)
    for v, curve in zip(at, curves, strict=True):
        assert iso_curve(surface, "v", v).s == curve.s


@pytest.mark.parametrize("count", [2, 5])
def test_a_loft_meets_weighted_sections(count):
    curves = sections("kinks", count, contrast=2.0)
    surface, at = lofted(curves), section_parameters(curves)
    same(surface.at(T, at), np.stack([curve.at(T) for curve in curves], axis=1))
    assert surface.planes.weights is not None


def test_a_loft_through_weights_that_nothing_positive_joins_is_fitted():
    curves = sections("bspline", 4)
    contrasts = (1.0, 1e-4, 1e4, 1.0)
    curves = [
        replace(curve, lines=curve.lines.with_weights(contrast ** np.linspace(-1.0, 1.0, 8)))
        for curve, contrast in zip(curves, contrasts, strict=True)
    ]
    surface = lofted(curves, tolerance=1e-2)
    assert surface.planes.weights is None


def test_a_loft_of_classical_curves_is_classical():
    curves = [replace(curve, s=0.0) for curve in sections("bspline", 4)]
    surface = lofted(curves)
    assert surface.s == 0.0
    same(surface.at(T, section_parameters(curves)), np.stack([c.at(T) for c in curves], axis=1))


def test_a_loft_through_moved_copies_goes_straight():
    curve = sections("bspline", 1)[0]
    moved = [transformed(curve, np.eye(3), z * SHIFT) for z in (0.0, 1.0, 2.5, 3.0, 4.0)]
    same(lofted(moved).at(T, T), curve.at(T)[:, None] + 4.0 * T[:, None] * SHIFT, 1e-11)


def test_the_planes_of_a_loft_through_a_parabola_lie_on_it():
    line = ControlLines.of([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
    at = np.linspace(0.0, 1.0, 4)
    curves = [
        transformed(PlusCurve(BSpline(2, 2), line), np.eye(3), (0.0, y, 1e-9 * y**2)) for y in at
    ]
    points = lofted(curves).planes.points
    same(points[..., 2], 1e-9 * points[..., 1] ** 2)


@pytest.mark.parametrize(
    ("count", "closed", "sentence"),
    [(1, False, "two curves"), (2, True, "three curves"), (0, False, "two")],
)
def test_too_few_sections_are_refused(count, closed, sentence):
    with pytest.raises(ValueError, match=sentence):
        lofted(sections("bspline", count), closed=closed)


def test_sections_in_one_place_are_refused():
    curve = random_curve("bspline")
    with pytest.raises(ValueError, match="same place"):
        lofted([curve, curve])


# Coons


@pytest.mark.parametrize("kind_u", ["bezier", "bspline", "kinks"])
@pytest.mark.parametrize("kind_v", ["bezier", "polygon", "high order"])
def test_a_coons_patch_meets_its_edges_for_every_s(kind_u, kind_v):
    around = edges(kind_u, kind_v)
    surface = coons(*around)
    for s in (2.0, -1.0):
        at_s = replace(surface, s=s)
        u0, u1, v0, v1 = (replace(curve, s=s).at(T) for curve in around)
        same(at_s.at(T, [0.0, 1.0]), np.stack([u0, u1], axis=1))
        same(at_s.at([0.0, 1.0], T), np.stack([v0, v1]))


def test_a_coons_patch_is_the_tensor_sum():
    around = edges()
    u0, u1, v0, v1 = (curve.at(T) for curve in around)
    u, v = T[:, None, None], T[None, :, None]
    a, b, c, d = CORNERS
    lines = (1 - v) * u0[:, None] + v * u1[:, None] + (1 - u) * v0 + u * v1
    corners = (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d)
    same(coons(*around).at(T, T), lines - corners)


def test_opposite_edges_of_different_kinds_are_met_too():
    u0, _, v0, v1 = edges()
    u1 = edge("high order", CORNERS[2], CORNERS[3], 9, s=-1.0)
    surface = coons(u0, u1, v0, v1)
    same(iso_curve(surface, "v", 1.0).at(T), u1.at(T))
    same(iso_curve(surface, "u", 0.0).at(T), v0.at(T))


def test_a_coons_patch_between_arcs_has_their_weights():
    inner, outer = (
        elliptic_arc((0.0, 0.0), (r, 0.0), (0.0, r), sweep=np.pi / 2) for r in (1.0, 2.0)
    )
    sides = [
        PlusCurve(BSpline(2, 2), ControlLines.of(ends))
        for ends in ([[1.0, 0.0], [2.0, 0.0]], [[0.0, 1.0], [0.0, 2.0]])
    ]
    surface = coons(inner, outer, *sides)
    distance = np.linalg.norm(surface.at(T, [0.0, 1.0]), axis=-1)
    same(distance, np.broadcast_to([1.0, 2.0], distance.shape))


def test_edges_whose_weights_disagree_at_a_corner_are_fitted():
    around = edges()
    around[0] = replace(around[0], lines=around[0].lines.with_weights(np.linspace(1.0, 3.0, 8)))
    surface = coons(*around, tolerance=1e-3)
    assert surface.planes.weights is None
    same(surface.at(T, [0.0])[:, 0], around[0].at(T), 2e-3)


def test_edges_with_a_gap_are_refused_with_its_size():
    u0, u1, v0, v1 = edges()
    moved = transformed(v1, np.eye(3), [0.0, 0.0, 0.25])
    with pytest.raises(ValueError, match=r"don't meet at their ends: there is a gap of 0\.25"):
        coons(u0, u1, v0, moved)


def test_closed_edges_are_refused():
    u0, _, v0, v1 = edges()
    with pytest.raises(ValueError, match="closed curve"):
        coons(u0, random_curve("closed"), v0, v1)


# All of them


def surface_of(name, curves):
    made = {
        "extruded": lambda a, b, c, d: extruded(a, b.at([1.0])[0] - a.at([0.0])[0]),
        "ruled": lambda a, b, c, d: ruled(a, b),
        "lofted": lambda a, b, c, d: lofted([a, b, transformed(b, np.eye(3), SHIFT)]),
        "coons": coons,
    }
    return made[name](*curves)


@pytest.mark.parametrize("name", ["extruded", "ruled", "lofted", "coons"])
def test_the_surface_of_turned_curves_is_the_turned_surface(name):
    rotation = np.linalg.qr(TURN)[0]
    curves = edges()
    if name == "lofted":
        curves = [*sections("bspline", 2), *curves[2:]]
    turned = [transformed(curve, rotation) for curve in curves]
    surface = surface_of(name, curves)
    if name == "lofted":
        turned_sections = [*turned[:2], transformed(turned[1], np.eye(3), rotation @ SHIFT)]
        same(lofted(turned_sections).at(T, T), transformed_surface(surface, rotation).at(T, T))
    else:
        found = surface_of(name, turned)
        same(found.at(T, T), transformed_surface(surface, rotation).at(T, T))


def test_revolving_commutes_with_moving_all():
    curve, rotation = random_curve("bspline", dimension=3), np.linalg.qr(TURN)[0]
    rotation *= np.sign(np.linalg.det(rotation))
    point, axis = np.array([0.1, 2.0, 0.0]), np.array([1.0, 1.0, 0.0])
    there = revolved(transformed(curve, rotation, SHIFT), rotation @ point + SHIFT, rotation @ axis)
    here = transformed_surface(revolved(curve, point, axis), rotation, SHIFT)
    same(there.at(T, T), here.at(T, T))


@pytest.mark.parametrize("name", ["extruded", "ruled", "lofted", "coons"])
def test_the_directions_can_be_seen_and_turned(name):
    lengths = np.linalg.norm(surface_of(name, edges()).directions, axis=-1)
    assert (lengths > 1e-3).all()
