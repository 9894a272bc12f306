"""What is said once a curve was led through its points."""

import numpy as np
import pytest

from plusedit.app.passing_notices import FAR, swing
from plusedit.commands.curves import PassThrough, SetMagnitude
from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.passing import passing_through

pytestmark = pytest.mark.gui

WALK = ShapeId("walk")


def a_walk(count, s=1.0):
    """A curve that turns this way and that, at random."""
    steps = np.random.default_rng(1).normal(size=(count, 2))
    return PlusCurve(BSpline(count, 4), ControlLines.of(steps.cumsum(axis=0)), s)


def a_wave(count):
    """A curve whose points lie near each other."""
    u = np.linspace(0.0, 6.0, count)
    return PlusCurve(BSpline(count, 4), ControlLines.of(np.column_stack([u, np.sin(u)])), 1.0)


@pytest.fixture
def walking(window):
    window.files.show(Design({WALK: Shape(a_walk(30), "Walk")}), None)
    return window


def test_a_curve_that_swings_far_out_is_told_of(walking):
    before = walking.session.design.curve(WALK)
    walking.desk.commit(PassThrough((WALK,)))
    after = walking.session.design.curve(WALK)
    u = np.linspace(0.0, 1.0, 5001)
    size = np.linalg.norm(np.ptp(before.lines.points, axis=0))
    moved = np.linalg.norm(after.at(u) - before.at(u), axis=1).max() / size
    assert moved > FAR
    assert walking.status.text.text().startswith("Walk: it passes through its points")
    assert f"{moved:.0%} of its size" in walking.status.text.text()


def test_other_edits_are_not_told_of(walking):
    walking.desk.commit(SetMagnitude({WALK: 40.0}))
    assert "passes through" not in walking.status.text.text()


def test_a_curve_that_stays_where_it_is_is_not_told_of():
    wave = a_wave(40)
    assert swing(wave, passing_through(wave)) == ""
