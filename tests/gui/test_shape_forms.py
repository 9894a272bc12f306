"""Constraints and fits in the Inspector."""

import numpy as np
import pytest

from plusedit.commands.fitting import DrawFitted, FitSource, fit_source
from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.geometry.constraints import Wish
from tests.designs import WING, a_design
from tests.gui.finding import named, type_into

pytestmark = pytest.mark.gui


@pytest.fixture
def inspector(window):
    window.files.show(a_design(), None)
    return window.docks.widget("inspector")


def box(inspector, kind):
    return inspector._constraints.boxes[kind]


def test_a_box_sets_a_constraint_and_releases_it(window, inspector):
    window.session.select(Selection.of_shapes([WING]))
    inspector.refresh()
    box(inspector, "tangent_start").click()
    assert Wish("tangent_start") in window.session.design[WING].constraints
    inspector.refresh()
    assert box(inspector, "tangent_start").isChecked()
    box(inspector, "tangent_start").click()
    assert window.session.design[WING].constraints == ()


def test_a_box_of_what_cannot_be_kept_stays_empty(window, inspector, qtbot):
    said = []
    window.desk.said.listen(said.append)
    curve = window.session.design.curve(WING)
    window.session.select(Selection.of_shapes([WING]))
    inspector.refresh()
    kind = "smooth_closing"
    before = window.session.design
    box(inspector, kind).click()
    if len(curve.lines) < 4:
        assert window.session.design is before
        assert not box(inspector, kind).isChecked()
        assert said


def test_a_fitted_curve_is_fitted_again_by_its_tolerance(window, qtbot):
    x = np.linspace(0.0, 6.0, 80)
    source = FitSource(np.stack([x, np.sin(x)], axis=1), 1e-3)
    window.files.show(Design(), None)
    window.session.commit(DrawFitted(source))
    (shape_id,) = window.session.design
    before = len(window.session.design.curve(shape_id).lines)
    inspector = window.docks.widget("inspector")
    inspector.refresh()
    assert "80 points" in inspector._fit.told.text()
    type_into(qtbot, named(inspector, "tolerance"), "0.2")
    qtbot.waitUntil(lambda: window.session.undo_label == "Fit curve", timeout=20_000)
    assert len(window.session.design.curve(shape_id).lines) < before
    assert fit_source(window.session.design[shape_id]).tolerance == 0.2


def test_other_curves_have_no_fit_to_show(window, inspector):
    window.session.select(Selection.of_shapes([WING]))
    inspector.refresh()
    assert not inspector._fit.isVisibleTo(inspector)
