import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from plusedit.scene.camera import PlaneCamera
from plusedit.scene.options import (
    USUAL,
    ViewOptions,
    camera_of,
    options_of,
    panes_of,
    space_camera_of,
    view_tree,
)
from plusedit.scene.overlays import Overlay, overlays
from plusedit.scene.space_camera import SpaceCamera
from tests.designs import json_values, words

options = st.builds(
    ViewOptions,
    st.frozensets(words),
    st.sampled_from(["auto", "selected", "all", "none"]),
    *[st.booleans()] * 8,
    st.sampled_from(["studio", "matcap"]),
)
trees = st.dictionaries(
    words | st.sampled_from(["overlays", "handles", "camera", "camera_3d", "panes", "grid"]),
    json_values,
)
SIZE = (640.0, 480.0)


@given(options, trees)
def test_what_a_design_keeps_comes_back(chosen, old):
    assert options_of(view_tree(chosen, old=old)) == chosen


@given(trees)
def test_any_tree_gives_some_options(tree):
    assert isinstance(options_of(tree), ViewOptions)
    camera_of(tree, SIZE)
    space_camera_of(tree, SIZE)
    panes_of(tree)


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


@given(
    st.tuples(*[st.floats(-1e9, 1e9)] * 3),
    st.floats(1e-9, 1e12),
    st.floats(-4.0, 4.0),
    st.floats(-1.5, 1.5),
    st.booleans(),
)
def test_a_camera_of_the_3d_view_comes_back(target, height, yaw, pitch, perspective):
    camera = SpaceCamera(SIZE, target, height, yaw, pitch, perspective)
    assert space_camera_of(view_tree(USUAL, camera_3d=camera, old={}), SIZE) == camera


def test_a_camera_of_the_3d_view_that_makes_no_sense_is_none():
    whole = {"target": [0, 0, 0], "height": 1, "yaw": 0, "pitch": 0}
    assert space_camera_of({"camera_3d": whole}, SIZE) is not None
    for changed in (
        {"target": [0, 0]},
        {"target": [0, 0, "far"]},
        {"height": 0},
        {"height": None},
        {"pitch": 2},
        {"perspective": 1},
        {"yaw": 1e300},
    ):
        assert space_camera_of({"camera_3d": {**whole, **changed}}, SIZE) is None


def test_what_a_tree_says_of_the_3d_view_stays_unless_it_is_given():
    kept = view_tree(USUAL, camera_3d=SpaceCamera(SIZE), panes="3d", old={})
    assert view_tree(USUAL, old=kept) == kept
    assert panes_of(view_tree(USUAL, panes="both", old=kept)) == "both"


def test_an_overlay_is_switched_on_and_off():
    on = ViewOptions().with_overlay("hulls", True)
    assert "hulls" in on.overlays
    assert on.with_overlay("hulls", False) == ViewOptions()


def test_one_overlay_that_colors_surfaces_is_on_at_a_time(monkeypatch):
    other = Overlay("other", "Other", 99, "")
    other.coloring_of_surfaces(lambda surface, u, v: np.zeros((len(u), len(v))))
    monkeypatch.setitem(overlays._filled(), "other", other)
    one = ViewOptions().with_overlay("deviation", True)
    two = one.with_overlay("other", True)
    assert two.overlays == ViewOptions().overlays | {"other"}
    assert two.with_overlay("hulls", True).overlays >= {"other", "hulls"}
    assert two.with_overlay("deviation", True) == one
    assert two.with_overlay("other", False) == ViewOptions()


def test_an_overlay_that_nobody_knows_stays_switched_on():
    kept = ViewOptions(overlays=frozenset({"unheard of"})).with_overlay("deviation", True)
    assert kept.overlays == {"unheard of", "deviation"}
