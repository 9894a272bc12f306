from hypothesis import given
from hypothesis import strategies as st

from plusedit.scene.camera import PlaneCamera
from plusedit.scene.options import USUAL, ViewOptions, camera_of, options_of, view_tree
from tests.designs import json_values, words

options = st.builds(
    ViewOptions,
    st.frozensets(words),
    st.sampled_from(["auto", "selected", "all", "none"]),
    st.booleans(),
    st.booleans(),
    st.booleans(),
)
trees = st.dictionaries(
    words | st.sampled_from(["overlays", "handles", "camera", "grid"]), json_values
)
SIZE = (640.0, 480.0)


@given(options, trees)
def test_what_a_design_keeps_comes_back(chosen, old):
    assert options_of(view_tree(chosen, old=old)) == chosen


@given(trees)
def test_any_tree_gives_some_options(tree):
    assert isinstance(options_of(tree), ViewOptions)
    camera_of(tree, SIZE)


def test_a_usual_view_says_nothing():
    assert view_tree(USUAL, old={}) == {}


def test_keys_that_nobody_knows_stay():
    assert view_tree(USUAL, old={"author": "Ada", "handles": "all"}) == {"author": "Ada"}


@given(
    st.tuples(st.floats(-1e9, 1e9), st.floats(-1e9, 1e9)),
    st.floats(1e-6, 1e9),
    st.sampled_from(["top", "front", "right"]),
)
def test_a_camera_comes_back(center, scale, projection):
    camera = PlaneCamera(SIZE, center, scale, projection)
    assert camera_of(view_tree(USUAL, camera, old={}), SIZE) == camera


def test_a_camera_that_makes_no_sense_is_none():
    for kept in (
        3,
        {"center": [0, 0]},
        {"center": [0], "scale": 1},
        {"center": [0, True], "scale": 1},
        {"center": [0, 0], "scale": 0},
        {"center": [0, 1e300], "scale": 1},
        {"center": [0, 0], "scale": 1, "projection": "sideways"},
    ):
        assert camera_of({"camera": kept}, SIZE) is None


def test_an_overlay_is_switched_on_and_off():
    on = ViewOptions().with_overlay("hulls", True)
    assert "hulls" in on.overlays
    assert on.with_overlay("hulls", False) == ViewOptions()
