"""What is said and shown once shapes keep something, and once they can't."""

from dataclasses import replace

import pytest

from plusedit.commands.constraints import Constrain
from plusedit.commands.curves import SetMagnitude
from plusedit.document.constraining import problems_of
from plusedit.geometry.constraints import Wish
from tests.designs import WING, a_design

pytestmark = pytest.mark.gui

TANGENT = Wish("tangent_start")


@pytest.fixture
def filled(window):
    window.files.show(a_design(), None)
    return window


def keep_tangent(window):
    window.desk.commit(Constrain({WING: TANGENT}))


def test_an_edit_that_breaks_a_constraint_says_so(filled):
    keep_tangent(filled)
    said = []
    filled.desk.said.listen(said.append)
    filled.desk.preview(SetMagnitude({WING: 0.0}))
    [words] = problems_of(filled.session.design[WING]).values()
    assert said == [f"wing: {words}"]
    filled.desk.preview(SetMagnitude({WING: -0.0}))
    assert len(said) == 1
    filled.desk.commit(SetMagnitude({WING: 0.0}))
    assert len(said) == 2
    assert filled.status.text.text() == f"wing: {words}"


def test_one_reason_is_told_once(filled):
    keep_tangent(filled)
    filled.desk.commit(Constrain({WING: Wish("passing", (0, 1))}))
    filled.desk.commit(SetMagnitude({WING: 0.0}))
    assert len(problems_of(filled.session.design[WING])) == 2
    assert filled.status.text.text().count("set s first") == 1


def test_an_edit_that_keeps_all_says_nothing(filled):
    keep_tangent(filled)
    said = []
    filled.desk.said.listen(said.append)
    filled.desk.commit(SetMagnitude({WING: 1.0}))
    assert said == []


def test_the_first_constraint_shows_the_badges(filled):
    filled.view.toggle_overlay("constraints")
    keep_tangent(filled)
    assert "constraints" in filled.view.options.overlays


def test_badges_that_were_switched_off_stay_off(filled):
    keep_tangent(filled)
    filled.view.toggle_overlay("constraints")
    filled.desk.commit(Constrain({WING: Wish("tangent_end")}))
    assert "constraints" not in filled.view.options.overlays


def test_a_design_is_opened_with_the_badges_as_it_says(filled):
    keep_tangent(filled)
    design = replace(filled.session.design, view={"overlays": []})
    filled.files.show(design, None)
    assert "constraints" not in filled.view.options.overlays
