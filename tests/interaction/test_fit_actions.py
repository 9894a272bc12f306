"""Curves are fitted anew from the menu."""

from itertools import pairwise

import numpy as np
import pytest

from plusedit.commands.fitting import FitSource, fit_source, fitted_shape
from plusedit.document.design import Design, EditError
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.residual import residual
from plusedit.interaction.actions import edit_actions
from plusedit.scene.items import Caption, Segments
from plusedit.scene.overlays import Seen, overlays
from tests.interaction.hand import CAMERA, WAVE, Hand

ACTIONS = {action.name: action for action in edit_actions()}


def crowded():
    """A gentle wave of sixty lines, of which few would do."""
    x = np.linspace(0.0, 4.0, 60)
    lines = ControlLines.of(np.stack([x, np.sin(x)], axis=1))
    return PlusCurve(BSpline(60, 4), lines, 2.0)


def hand():
    found = Hand(Design({WAVE: Shape(crowded(), "Wave")}))
    found.session.select(Selection.of_shapes([WAVE]))
    return found


def perform(found, name):
    found.gestures.perform_by(lambda: ACTIONS[name].make(found.gestures.stage()))


def test_a_crowded_curve_gets_few_lines_and_keeps_its_shape():
    found = hand()
    before = found.curve()
    perform(found, "fit")
    after = found.curve()
    assert len(after.lines) < 12
    source = fit_source(found.session.design[WAVE])
    assert residual(after, before.at(np.linspace(0, 1, 200))).largest < 1.2 * source.tolerance
    assert found.session.undo_label == "Fit curve"


def test_closer_takes_more_lines_and_looser_fewer():
    found = hand()
    perform(found, "fit")
    first = len(found.curve().lines)
    for _ in range(6):
        perform(found, "fit_closer")
    closer = len(found.curve().lines)
    for _ in range(12):
        perform(found, "fit_looser")
    assert len(found.curve().lines) <= first < closer


def test_the_overlay_shows_the_points_and_tells_the_distances():
    found = hand()
    perform(found, "fit")
    shape = found.session.design[WAVE]
    items = list(overlays["fit_residual"].draw(shape, shape.curve, Seen(CAMERA)))
    (hairs,) = [item for item in items if isinstance(item, Segments)]
    (caption,) = [item for item in items if isinstance(item, Caption)]
    largest = np.linalg.norm(hairs.starts - hairs.ends, axis=1).max()
    assert caption.rows[1].value == f"{largest:.3g}"


def test_a_curve_that_was_not_fitted_has_no_points_to_show():
    assert not list(overlays["fit_residual"].draw(Shape(crowded(), "A"), crowded(), Seen(CAMERA)))


def square(turned=()):
    """The sides of a square as four curves, some of them the other way round."""
    corners = [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)]
    shapes = {}
    for number, ends in enumerate(pairwise(corners)):
        points = ends[::-1] if number in turned else ends
        curve = PlusCurve(Bernstein(2), ControlLines.of(points), 0.0)
        shapes[ShapeId(f"side-{number}")] = Shape(curve, f"Side {number}")
    return Design(shapes)


@pytest.mark.parametrize("turned", [(), (1,), (0, 2, 3)])
def test_curves_that_meet_become_one_with_the_same_corners(turned):
    found = Hand(square(turned))
    found.session.select(Selection.of_shapes(found.session.design))
    perform(found, "join_fitted")
    ((shape_id, shape),) = found.session.design.shapes.items()
    corners = np.array([(0, 0), (2, 0), (2, 2), (0, 2)], dtype=float)
    assert residual(shape.curve, corners).largest < 1e-9
    assert found.session.selection.shapes == {shape_id}
    found.session.undo()
    assert len(found.session.design) == 4


def test_curves_that_do_not_meet_stay_as_they_are():
    design = square()
    found = Hand(design.without("side-1"))
    before = found.session.design
    found.session.select(Selection.of_shapes(["side-0", "side-2"]))
    perform(found, "join_fitted")
    assert found.session.design is before
    assert "meet end to end" in found.errors[-1]


def two_strokes(gap, dimensions=(2, 2)):
    """Two strokes one after the other, so far apart."""
    flat = np.array([(0.0, 0.0), (1.0, 0.5), (2.0, 0.0)]), np.array([(0.0, 0.0), (1.0, -0.5)])
    shapes = {}
    for number, (points, dimension) in enumerate(zip(flat, dimensions, strict=True)):
        moved = points + ((2.0 + gap, 0.0) if number else 0.0)
        rows = np.pad(moved, ((0, 0), (0, dimension - 2)))
        curve = PlusCurve(Bernstein(len(rows)), ControlLines.of(rows), 0.0)
        shapes[ShapeId(f"stroke-{number}")] = Shape(curve, "stroke")
    return Design(shapes)


@pytest.mark.parametrize("dimensions", [(2, 2), (2, 3), (3, 2)])
def test_strokes_that_nearly_meet_are_joined(dimensions):
    found = Hand(two_strokes(4.0 * CAMERA.pixel, dimensions))
    found.session.select(Selection.of_shapes(found.session.design))
    perform(found, "join_fitted")
    ((_, shape),) = found.session.design.shapes.items()
    assert shape.curve.dimension == max(dimensions)
    meeting = np.pad([[2.0 + 2.0 * CAMERA.pixel, 0.0]], ((0, 0), (0, max(dimensions) - 2)))
    assert residual(shape.curve, meeting).largest < 0.02


def test_strokes_far_apart_are_not():
    found = Hand(two_strokes(40.0 * CAMERA.pixel))
    found.session.select(Selection.of_shapes(found.session.design))
    perform(found, "join_fitted")
    assert len(found.session.design) == 2
    assert "meet end to end" in found.errors[-1]


def test_points_on_pixels_are_not_followed_more_closely_than_they_are_smooth():
    t = np.linspace(0.0, 1.0, 180)
    points = np.round(np.stack([600.0 * t, 200.0 * np.sin(6.0 * t)], axis=1))
    shape = fitted_shape(FitSource(points, 3.0), "Stroke")
    found = Hand(Design({WAVE: shape}))
    found.session.select(Selection.of_shapes([WAVE]))
    for _ in range(3):
        perform(found, "fit_closer")
    kept = found.session.design
    with pytest.raises(EditError, match="Stroke: the 180 points that it is fitted to"):
        ACTIONS["fit_closer"].make(found.gestures.stage())
    assert found.session.design is kept
    assert np.abs(found.curve().lines.points[:, 1]).max() < 210.0
