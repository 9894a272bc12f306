"""What the overlays of the paper's constructions show is what they say."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.corner_nets import corner_nets
from plusedit.geometry.hulls import line_ends
from plusedit.geometry.natural import natural_length_of
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Caption, Label, Markers, Patch, Polyline, Segments
from plusedit.scene.overlays import Seen, overlays
from plusedit.scene.space_camera import SpaceCamera
from tests.geometry.curves import KINDS, random_curve
from tests.geometry.surfaces import a_surface, random_surface

CAMERA = PlaneCamera((800.0, 600.0), scale=200.0)
IN_SPACE = SpaceCamera((800.0, 600.0), height=3.0)
OPEN = ["bezier", "bspline", "rag", "high order"]


def items(name, geometry, kind, camera=CAMERA, lines=(), **numbers):
    entry = overlays[name]
    seen = Seen(camera, lines, {**entry.numbers({}), **numbers})
    drawn = entry.draw(Shape(geometry, "Arc"), geometry, seen)
    return [item for item in drawn if isinstance(item, kind)]


def caption(name, *geometries):
    entry = overlays[name]
    shapes = {ShapeId(str(i)): Shape(g, "Arc") for i, g in enumerate(geometries)}
    found = entry.draw_design(Design(shapes), frozenset(), Seen(CAMERA, (), entry.numbers({})))
    return [item for item in found if isinstance(item, Caption)]


@pytest.mark.parametrize("kind", OPEN)
def test_control_points_of_the_parents_lie_at_both_ends_of_the_lines(kind):
    curve = random_curve(kind)
    starts, ends = line_ends(curve)
    first, second = items("parents", curve, Markers)
    assert_allclose(first.points, starts)
    assert_allclose(second.points, ends)
    (tied,) = items("parents", curve, Segments)
    assert_allclose(tied.starts, starts)
    assert_allclose(tied.ends, ends)


@pytest.mark.parametrize("kind", OPEN)
def test_the_curve_is_the_mean_of_the_points_of_its_parents_under_the_pointer(kind):
    curve = random_curve(kind, contrast=3.0)
    found = list(overlays["parents"].draw_place(Shape(curve, "Arc"), curve, (0.3,), Seen(CAMERA)))
    first, second, at = (item.points[0] for item in found if isinstance(item, Markers))
    assert_allclose(0.7 * first + 0.3 * second, at)
    assert_allclose(at, curve.at([0.3])[0])


def test_closed_curves_have_no_parents():
    assert not items("parents", random_curve("closed"), Polyline)
    assert not caption("parents", random_curve("closed"))
    assert caption("parents", random_curve("closed"), random_curve("bezier"))


def test_the_four_nets_are_all_planes_at_the_four_corners():
    surface = random_surface("bezier", "bspline")
    found = items("corner_nets", surface, Markers)
    for net, marks in zip(corner_nets(surface), found, strict=True):
        assert_allclose(marks.points, net.reshape(-1, 3))
    assert len({(m.outline, m.mark) for m in found}) == 4
    labels = [label.text for label in items("corner_nets", surface, Label)]
    assert labels == ["(0, 0)", "(1, 0)", "(0, 1)", "(1, 1)"]


@pytest.mark.parametrize("kind", KINDS)
def test_hairs_run_from_the_classical_curve_to_the_curve(kind):
    curve = random_curve(kind, contrast=3.0, s=0.8)
    hairs, again = items("decomposition", curve, Segments)
    u = np.linspace(0.0, 1.0, len(hairs.starts))
    assert_allclose(hairs.starts, curve.classical.at(u), atol=1e-12)
    assert_allclose(hairs.ends, curve.at(u), atol=1e-12)
    assert_allclose(again.ends - again.starts, hairs.ends - hairs.starts, atol=1e-12)


@pytest.mark.parametrize("kind", ["bezier", "closed", "rag"])
def test_the_plus_term_lies_below_the_curve_about_one_place(kind):
    curve = random_curve(kind, s=0.8)
    (anchor,) = items("decomposition", curve, Markers)
    *_, term = items("decomposition", curve, Polyline)
    assert term.points[:, 1].max() < min(curve.lines.points[:, 1].min(), curve.at(0.5)[0, 1])
    grid = np.linspace(0.0, 1.0, 7)
    pull = curve.at(grid) - curve.classical.at(grid)
    near = [np.linalg.norm(term.points - anchor.points[0] - p, axis=1).min() for p in pull]
    assert_allclose(near, 0.0, atol=2.0 / CAMERA.scale + 0.05)


def test_without_s_there_is_only_one_part():
    for geometry in (random_curve("bezier", s=0.0), a_surface(s=0.0)):
        assert not items("decomposition", geometry, (Segments, Polyline))


def test_the_classical_surface_is_seen_through_and_the_same_while_nothing_changes():
    surface = a_surface()
    (glass,) = items("decomposition", surface, Patch, IN_SPACE)
    assert glass.surface is surface.classical
    assert items("decomposition", surface, Patch, IN_SPACE)[0] is glass


@pytest.mark.parametrize("kind", KINDS)
def test_a_family_runs_evenly_from_the_classical_curve_to_its_end(kind):
    curve = random_curve(kind)
    found = items("s_family", curve, Polyline, count=5.0, reach=2.0)
    length = natural_length_of(curve)
    assert len(found) == len({line.color for line in found}) == 5
    for line, ratio in zip(found, (0.0, 0.5, 1.0, 1.5, 2.0), strict=True):
        member = replace(curve, s=ratio * length)
        assert_allclose(line.points[0], member.at([0.0])[0], atol=1e-9)
        middle = len(line.points) // 2
        apart = np.linalg.norm(member.at(np.linspace(0.0, 1.0, 4001)) - line.points[middle], axis=1)
        assert apart.min() < 0.01 * length


def test_the_colors_of_a_family_are_told():
    (told,) = caption("s_family", random_curve("bezier"), a_surface())
    assert told.rows[0].text == "0"
    assert told.rows[-1].text == "1"
    colors = [line.color for line in items("s_family", random_curve("bezier"), Polyline)]
    assert [row.color for row in told.rows] == colors


def test_nothing_is_marked_while_no_line_is_selected():
    for geometry in (random_curve("bspline"), a_surface()):
        assert not items("support", geometry, object)


def test_the_band_of_a_b_spline_line_ends_with_its_support():
    curve = random_curve("bspline", size=12)
    knots = curve.basis.knot_vector
    band = items("support", curve, Polyline, lines=(5,))
    reach = np.concatenate([piece.points for piece in band])
    inside = curve.at(np.linspace(knots[5], knots[9], 2001))
    away = [np.linalg.norm(inside - point, axis=1).min() for point in reach]
    assert max(away) < 0.01
    ends = items("support", curve, Markers, lines=(5,))[0].points
    assert_allclose(ends, curve.at([knots[5], knots[9]]))


@pytest.mark.parametrize("kind", ["bezier", "rag", "closed", "closed rag"])
def test_the_band_is_widest_where_the_share_is_largest(kind):
    curve = random_curve(kind, size=6, contrast=3.0)
    band = items("support", curve, Polyline, lines=(3,))
    widest = max(band, key=lambda piece: piece.width).points
    u = np.linspace(0.0, 1.0, 2001)
    weights = curve.lines.weights
    shares = curve.basis.values(u) * weights
    best = curve.at([u[(shares[:, 3] / shares.sum(axis=1)).argmax()]])[0]
    assert np.linalg.norm(widest - best, axis=1).min() < 0.05


def test_the_outline_of_a_plane_s_support_lies_on_the_surface():
    surface = random_surface("bspline", "bspline")
    found = items("support", surface, Polyline, lines=(0,))
    assert len(found) == 4
    ends = [surface.basis_u.knot_vector[surface.basis_u.order], 0.0]
    corner = surface.at([ends[0]], [0.0])[0, 0]
    points = np.concatenate([line.points for line in found])
    assert np.linalg.norm(points - corner, axis=1).min() < 1e-9
