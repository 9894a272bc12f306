"""Numbers of overlays are kept with the view, and what an overlay gets makes sense."""

import pytest

from plusedit.scene.options import USUAL, options_of, view_tree
from plusedit.scene.overlays import Overlay, Setting, overlays

COMB = Overlay("comb", "Comb", 90, "", settings=(Setting("scale", "Scale", 1.0, 0.01, 100.0),))


def test_an_overlay_gets_the_usual_numbers_unless_others_are_set():
    assert COMB.numbers({}) == {"scale": 1.0}
    assert COMB.numbers({"comb.scale": 2.5, "other.scale": 7.0}) == {"scale": 2.5}


@pytest.mark.parametrize(("said", "taken"), [(1e9, 100.0), (1e-9, 0.01)])
def test_numbers_beyond_the_limits_are_taken_for_the_limits(said, taken):
    assert COMB.numbers({"comb.scale": said}) == {"scale": taken}


def test_a_design_keeps_the_numbers_of_its_view():
    options = USUAL.with_setting("comb.scale", 2.5).with_setting("comb.density", 40.0)
    assert options_of(view_tree(options, old={})) == options
    assert "overlay_settings" not in view_tree(USUAL, old={})


@pytest.mark.parametrize("kept", ["large", 3, [1.0], {"comb.scale": "x"}, {"comb.scale": -1.0}])
def test_numbers_that_make_no_sense_are_as_usual(kept):
    assert options_of({"overlay_settings": kept}) == USUAL


@pytest.mark.parametrize("name", list(overlays))
def test_the_settings_on_the_shelf_have_words_and_limits(name):
    for setting in overlays[name].settings:
        assert setting.title
        assert 0.0 < setting.least <= setting.usual <= setting.most
