"""What overlays say of curves: the circle under the pointer, turning points, joints, numbers."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.arrays import unit
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.continuity import joints
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.curve_numbers import curve_numbers, known_numbers
from plusedit.geometry.lines import ControlLines
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Caption, Label, Markers, Polyline, Segments
from plusedit.scene.outward import SLOPE
from plusedit.scene.overlays import Seen, overlays
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.turning_points import turning_points
from tests.geometry.curves import random_curve
from tests.geometry.surfaces import a_surface

CAMERA = PlaneCamera((800.0, 600.0), scale=200.0)
IN_SPACE = SpaceCamera((800.0, 600.0), height=3.0)


def quarter(radius=2.0, dimension=2):
    """A quarter of a circle about the origin, run to the left."""
    points = radius * np.array([[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])
    weights = np.array([1.0, np.sqrt(0.5), 1.0])
    return PlusCurve(Bernstein(3), ControlLines.of(points[:, :dimension], weights=weights), 0.0)


def wave():
    """An S with one inflection, in the middle."""
    points = np.array([[0.0, 0.0], [1.0, 1.0], [2.0, -1.0], [3.0, 0.0]])
    return PlusCurve(Bernstein(4), ControlLines.of(points), 0.0)


def zigzag(order=4):
    points = np.column_stack([np.arange(9.0), np.tile([0.0, 1.0, 3.0], 3)])
    return PlusCurve(BSpline(9, order), ControlLines.of(points), 4.0)


def at_place(geometry, u, camera=CAMERA):
    seen = Seen(camera)
    return list(overlays["circle"].draw_place(Shape(geometry, ""), geometry, (u,), seen))


def of_curve(name, curve, camera=CAMERA):
    entry = overlays[name]
    return list(entry.draw(Shape(curve, ""), curve, Seen(camera, (), entry.numbers({}))))


def of_design(name, *curves, chosen=(), hurried=False):
    entry = overlays[name]
    design = Design({str(place): Shape(c, f"c{place}") for place, c in enumerate(curves)})
    seen = Seen(CAMERA, (), entry.numbers({}), design, is_hurried=hurried)
    return list(entry.draw_design(design, frozenset(chosen), seen))


def only(kind, items):
    return [item for item in items if isinstance(item, kind)]


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("camera", [CAMERA, IN_SPACE], ids=["plane", "space"])
@pytest.mark.parametrize("u", [0.0, 0.3, 1.0])
def test_the_osculating_circle_of_a_circle_is_that_circle(dimension, camera, u):
    items = at_place(quarter(dimension=dimension), u, camera)
    (ring,) = only(Polyline, items)
    assert_allclose(np.linalg.norm(ring.points, axis=1), 2.0)
    center = only(Markers, items)[0]
    assert_allclose(center.points, 0.0, atol=1e-14)
    (label,) = only(Label, items)
    assert label.text == "r 2   κ 0.5"


def test_the_circle_touches_the_curve_with_its_tangent_and_curvature():
    curve = random_curve("bspline")
    (ring,) = only(Polyline, at_place(curve, 0.37))
    point, velocity, _ = (rows[0] for rows in curve.derivatives([0.37]))
    assert_allclose(ring.points[0], point, atol=1e-12)
    way = ring.points[1] - ring.points[-2]
    assert abs(way[0] * velocity[1] - way[1] * velocity[0]) < 1e-9 * np.hypot(*way) * np.hypot(
        *velocity
    )


def test_a_curve_that_turns_right_has_negative_curvature():
    lines = quarter().lines
    other = PlusCurve(
        Bernstein(3), ControlLines.of(lines.points[::-1], weights=lines.weights[::-1]), 0.0
    )
    (label,) = only(Label, at_place(other, 0.5))
    assert label.text.endswith("κ \N{MINUS SIGN}0.5")


def test_where_the_curve_is_straight_it_is_the_tangent():
    line = ControlLines.of(np.array([[0.0, 0.0], [1.0, 1.0]]))
    items = at_place(PlusCurve(Bernstein(2), line, 0.0), 0.5)
    assert not only(Polyline, items)
    (tangent,) = only(Segments, items)
    assert_allclose(tangent.ends - tangent.starts, (tangent.ends - tangent.starts)[0, 0])


def test_surfaces_and_places_where_the_curve_stands_still_have_no_circle():
    surface = a_surface()
    assert not list(
        overlays["circle"].draw_place(Shape(surface, ""), surface, (0.5, 0.5), Seen(CAMERA))
    )
    still = PlusCurve(Bernstein(3), ControlLines.of(np.ones((3, 2))), 1.0)
    assert not at_place(still, 0.5)


def test_an_s_has_an_inflection_in_its_middle_and_extrema_on_both_sides():
    marks = {item.mark: item.points for item in only(Markers, of_curve("extrema", wave()))}
    assert_allclose(marks["diamond"], [[1.5, 0.0]], atol=1e-12)
    assert len(marks["square"]) == 2
    labels = [label.text for label in only(Label, of_curve("extrema", wave()))]
    assert sorted(text[:3] for text in labels) == ["κ 1", "κ \N{MINUS SIGN}"] or len(labels) == 2


def test_values_stand_on_the_outer_side_of_the_curve():
    curve = zigzag()
    found = turning_points(curve)
    labels = only(Label, of_curve("extrema", curve))
    ways = CAMERA.to_screen(found.extrema + found.outward) - CAMERA.to_screen(found.extrema)
    offsets = np.array([label.offset for label in labels])
    assert len(labels) > 1
    assert ((ways * offsets).sum(axis=1) > 0.0).all()
    for label, (right, _) in zip(labels, unit(ways), strict=True):
        wanted = "center" if abs(right) < SLOPE else "left" if right > 0.0 else "right"
        assert label.anchor == wanted


def test_values_beside_extrema_are_the_curvature_there():
    found = turning_points(zigzag())
    labels = only(Label, of_curve("extrema", zigzag()))
    texts = [label.text[2:].replace("\N{MINUS SIGN}", "-") for label in labels]
    assert [float(text) for text in texts] == pytest.approx(found.curvatures.tolist(), rel=1e-2)


def test_unchanged_curves_are_searched_once():
    curve = wave()
    assert turning_points(curve) is turning_points(curve)


def test_a_caption_counts_them():
    (caption,) = only(Caption, of_design("extrema", wave(), wave()))
    assert [row.value for row in caption.rows] == ["2", "4"]


@pytest.mark.parametrize(("order", "mark"), [(2, "square"), (3, "diamond"), (4, "ring")])
def test_each_order_of_continuity_has_a_mark_of_its_own(order, mark):
    curve = zigzag(order)
    (marks,) = only(Markers, of_curve("continuity", curve))
    assert marks.mark == mark
    assert_allclose(marks.points, [joint.point for joint in joints(curve)])


def test_corners_are_told_in_degrees():
    one = PlusCurve(Bernstein(2), ControlLines.of(np.array([[0.0, 0.0], [1.0, 0.0]])), 0.0)
    other = PlusCurve(Bernstein(2), ControlLines.of(np.array([[1.0, 0.0], [1.0, 2.0]])), 0.0)
    items = of_design("continuity", one, other)
    assert [label.text for label in only(Label, items)] == ["G0  90°"]
    (caption,) = only(Caption, items)
    assert [row.value for row in caption.rows] == ["0", "0", "1"]


def test_a_jump_of_curvature_is_told_by_its_size():
    arc, line = quarter(), ControlLines.of(np.array([[2.0, 0.0], [2.0, -1.0]]))
    items = of_design("continuity", arc, PlusCurve(Bernstein(2), line, 0.0))
    assert [label.text for label in only(Label, items)] == ["G1  Δκ 0.5"]


def test_numbers_of_the_selected_curves_are_told():
    (caption,) = of_design("numbers", wave(), quarter(), chosen=["1"])
    assert caption.title == "c1"
    rows = {row.text: row.value for row in caption.rows}
    assert rows["length"] == "3.14159 units"
    assert rows["bending energy"] == "0.785398 / unit"
    assert rows["inflections"] == "0 of at most 0"


def test_of_several_curves_the_sums_are_told_while_none_is_selected():
    (caption,) = of_design("numbers", quarter(), wave(), quarter())
    assert caption.title == "3 curves together"
    one, all_three = curve_numbers(quarter()), caption.rows
    assert float(all_three[0].value.split()[0]) > 2.0 * one.length
    assert all_three[2].value == "1 of at most 2"


@pytest.mark.parametrize("name", ["extrema", "numbers"])
def test_of_very_many_curves_only_the_selected_are_worked_on(name):
    many = [wave() for _ in range(250)]
    before = sum(known_numbers(curve) is not None for curve in many)
    (caption, *_) = of_design(name, *many, chosen=["3"]) or [None]
    assert caption is not None
    assert "1" in {row.value[:1] for row in caption.rows}
    assert sum(known_numbers(curve) is not None for curve in many) <= before + 1
    rest = of_design(name, *many)
    assert not rest or "select" in rest[0].rows[0].text


def test_while_an_edit_goes_on_what_is_not_known_is_told_later():
    curve = wave()
    (caption,) = of_design("numbers", curve, hurried=True)
    assert {row.value for row in caption.rows} == {"…"}
    of_design("numbers", curve)
    (caption,) = of_design("numbers", curve, hurried=True)
    assert "…" not in {row.value for row in caption.rows}
