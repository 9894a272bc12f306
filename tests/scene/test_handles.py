from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.selection import NOTHING_SELECTED, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.handles import LONGEST, SHORTEST, handle_shapes, handles
from plusedit.scene.options import ViewOptions
from tests.designs import BOW, WING, a_curve, a_design
from tests.geometry.curves import KINDS, random_curve

CAMERA = PlaneCamera((800.0, 600.0), scale=100.0)


def lengths(at):
    """From grip to grip, in pixels."""
    return np.linalg.norm(at.tips[0] - at.tips[1], axis=1)


@given(
    st.sampled_from(KINDS),
    st.floats(-1e3, 1e3),
    st.floats(-5.0, 5.0).map(lambda power: 10.0**power),
)
def test_grips_stand_from_24_to_160_pixels_apart_about_their_dot(kind, s, scale):
    curve = replace(random_curve(kind), s=s)
    at = handles(curve, PlaneCamera((800.0, 600.0), scale=scale))
    assert (lengths(at)[at.drawn] >= SHORTEST - 1e-6).all()
    assert (lengths(at)[at.drawn] <= LONGEST + 1e-6).all()
    assert_allclose(at.tips.mean(axis=0), at.points, atol=1e-6)


def test_between_the_limits_the_segment_reaches_h_times_the_gradient_to_both_sides():
    curve = a_curve(s=1.5)
    at = handles(curve, CAMERA)
    ends = curve.lines.points + curve.spacing * curve.gradients
    assert not at.limited.any()
    assert_allclose(at.tips[0], CAMERA.to_screen(ends))


def test_the_first_grip_is_on_the_side_of_d_whatever_the_sign_of_s():
    for s in (1.5, -1.5):
        curve = a_curve(s=s)
        at = handles(curve, CAMERA)
        toward = (at.tips[0] - at.points) * (1.0, -1.0)
        assert ((toward * curve.directions).sum(axis=1) > 0.0).all()


def test_without_a_magnitude_directions_are_still_shown_and_can_be_gripped():
    at = handles(a_curve(s=0.0), CAMERA)
    assert at.drawn.all()
    assert at.limited.all()
    assert_allclose(lengths(at), SHORTEST)


def test_a_control_line_without_direction_has_no_grips():
    lines = ControlLines.of([[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]], [None, [0.0, 0.0], None])
    at = handles(PlusCurve(BSpline(3, 3), lines, 1.0), CAMERA)
    assert at.drawn.tolist() == [True, False, True]
    assert_allclose(at.tips[:, 1], [at.points[1]] * 2)


def test_a_direction_seen_end_on_has_no_grips():
    lines = ControlLines.of([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]], [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0]])
    at = handles(PlusCurve(BSpline(2, 2), lines, 1.0), CAMERA)
    assert at.drawn.tolist() == [False, True]


def test_arms_lead_to_the_first_grips_in_the_world():
    curve = random_curve("closed", dimension=3)
    at = handles(curve, CAMERA)
    assert_allclose(CAMERA.to_screen(curve.lines.points + at.arms)[at.drawn], at.tips[0][at.drawn])


def many(count):
    """A design with that many control lines in two shapes."""
    halves = [count // 2, count - count // 2]
    curves = [random_curve("bspline", size=size) for size in halves]
    return Design({ShapeId(str(i)): Shape(curve, str(i)) for i, curve in enumerate(curves)})


@pytest.mark.parametrize(("count", "shown"), [(200, ("0", "1")), (201, ("1",))])
def test_up_to_200_control_lines_all_are_shown_beyond_those_of_the_selection(count, shown):
    selection = Selection.of_shapes([ShapeId("1")])
    assert handle_shapes(many(count), selection, ViewOptions()) == shown


@pytest.mark.parametrize(
    ("handles", "shown"), [("all", (WING, BOW)), ("none", ()), ("selected", (BOW,))]
)
def test_options_say_whose_control_lines_are_shown(handles, shown):
    selection = Selection.of_shapes([BOW])
    assert handle_shapes(a_design(), selection, ViewOptions(handles=handles)) == shown


@pytest.mark.parametrize("state", [{"visible": False}, {"locked": True}])
def test_control_lines_that_can_not_be_edited_are_not_shown(state):
    design = a_design()
    design = design.with_shape(WING, replace(design[WING], **state))
    assert handle_shapes(design, NOTHING_SELECTED, ViewOptions()) == (BOW,)
