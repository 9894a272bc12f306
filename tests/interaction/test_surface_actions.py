"""What keys and menus do to surfaces, and to what they find in the view of space."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_magnitude import best_surface_s, natural_length
from plusedit.interaction import curve_actions, surface_actions
from plusedit.interaction.actions import edit_actions
from plusedit.interaction.surface_actions import widest_gap
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.hand import WAVE, Hand, wave

ACTIONS = {action.name: action for action in edit_actions()}
SAIL = ShapeId("sail")
SIZE = (800.0, 600.0)
SPACE = SpaceCamera(SIZE)  # the isometric view: x to the right, z upwards


def sail(**changes):
    """Three rows of four planes over [0, 2] x [0, 3]."""
    x, y = np.meshgrid(np.arange(3.0), np.arange(4.0), indexing="ij")
    planes = ControlPlanes.of(np.stack([x, y, np.sin(1.5 * x) * np.cos(1.2 * y)], axis=-1))
    values = {"basis_u": BSpline(3, 3), "basis_v": BSpline(4, 4), "planes": planes, "s": 1.0}
    return PlusSurface(**{**values, **changes})


def the_design(surface=None):
    """The sail, and the wave, which is a plane curve, in front of it."""
    first = sail() if surface is None else surface
    return Design({SAIL: Shape(first, "Sail"), WAVE: Shape(wave(), "Wave")})


def a_hand(*planes, camera=SPACE, surface=None, active=None):
    """With those planes of the sail selected, or the sail as a whole."""
    hand = Hand(the_design(surface), camera)
    lines = [LineId(SAIL, number) for number in planes]
    at = None if active is None else LineId(SAIL, active)
    chosen = Selection.of_lines(lines, at) if lines else Selection.of_shapes([SAIL])
    hand.session.select(chosen)
    return hand


def does(hand, *names):
    for name in names:
        hand.gestures.perform_by(lambda name=name: ACTIONS[name].make(hand.gestures.stage()))
    return hand


def surface_of(hand):
    return hand.session.design.surface(SAIL)


def numbers(hand):
    return hand.session.selection.by_shape().get(SAIL, ())


# Every action


@pytest.mark.parametrize("name", list(ACTIONS))
@pytest.mark.parametrize("camera", [SPACE, PlaneCamera(SIZE)], ids=["space", "plane"])
def test_an_action_on_a_surface_is_at_most_one_step_and_says_what_it_can_not_do(name, camera):
    for planes in ((), (5,), (4, 5, 6, 7)):
        hand = a_hand(*planes, camera=camera)
        before = hand.session.design
        does(hand, name)
        for error in hand.errors:
            assert error[0].isupper()
        hand.session.undo()
        assert hand.session.design is before


@pytest.mark.parametrize("name", list(ACTIONS))
def test_no_action_touches_a_locked_surface(name):
    start = the_design()
    start = start.with_shape(SAIL, replace(start[SAIL], locked=True))
    hand = Hand(start, SPACE)
    hand.session.select(Selection.of_shapes([SAIL]))
    does(hand, name)
    if name != "unlock_all":
        assert hand.session.design[SAIL] is start[SAIL]


@pytest.mark.parametrize("name", [action.name for action in curve_actions.ACTIONS])
def test_what_is_for_curves_says_so_of_a_surface_and_leaves_it_out_of_a_mixture(name):
    hand = does(a_hand(), name)
    assert hand.errors == ["This works on curves, and only surfaces are selected."]
    hand.errors.clear()
    before = hand.session.design
    hand.session.select(Selection.of_shapes([SAIL, WAVE]))
    does(hand, name)
    assert hand.session.design[SAIL] is before[SAIL]
    assert not any("surface" in error for error in hand.errors)


@pytest.mark.parametrize("name", [action.name for action in surface_actions.ACTIONS])
def test_what_is_for_surfaces_says_so_of_a_curve(name):
    hand = a_hand()
    hand.session.select(Selection.of_shapes([WAVE]))
    (error,) = does(hand, name).errors
    assert "surface" in error and error.endswith(".")


# Nudges, turns and mirrors in space


@pytest.mark.parametrize(
    "name, by",
    [
        ("nudge_right", (0.5, 0, 0)),
        ("nudge_left", (-0.5, 0, 0)),
        ("nudge_up", (0, 0, 0.5)),
        ("nudge_down_far", (0, 0, -5.0)),
        ("nudge_nearer", (0, 0, 0.5)),
        ("nudge_farther_a_little", (0, 0, -0.05)),
    ],
)
def test_nudges_go_along_the_axes_nearest_to_the_screen(name, by):
    hand = a_hand(5)
    hand.gestures.grid_step = 0.5
    does(hand, name)
    moved = surface_of(hand).planes.control_points - sail().planes.control_points
    assert_allclose(moved[5], by, atol=1e-15)


@pytest.mark.parametrize(
    "view, right, up",
    [
        ("top", (1, 0, 0), (0, 1, 0)),
        ("bottom", (1, 0, 0), (0, -1, 0)),
        ("front", (1, 0, 0), (0, 0, 1)),
        ("back", (-1, 0, 0), (0, 0, 1)),
        ("right", (0, 1, 0), (0, 0, 1)),
        ("left", (0, -1, 0), (0, 0, 1)),
    ],
)
def test_nudges_follow_the_view(view, right, up):
    hand = does(a_hand(5, camera=SpaceCamera.standard(view, SIZE)), "nudge_right", "nudge_up")
    moved = surface_of(hand).planes.control_points[5] - sail().planes.control_points[5]
    assert_allclose(moved, np.add(right, up), atol=1e-15)


def test_turn_keys_turn_planes_rigidly_about_the_way_of_looking():
    hand = does(a_hand(5), "turn_left_far")
    old, new = sail().vectors[:, 5], surface_of(hand).vectors[:, 5]
    toward = SPACE.toward
    assert_allclose(new @ new.T, old @ old.T, atol=1e-14)
    assert_allclose(new @ toward, old @ toward, atol=1e-14)
    flat_old, flat_new = (way @ SPACE.axes_of_view[:2].T for way in (old[0], new[0]))
    angle = np.angle(complex(*flat_new) / complex(*flat_old))
    assert_allclose(np.degrees(angle), 15.0)
    assert_allclose(surface_of(does(hand, "turn_right_far")).vectors[:, 5], old, atol=1e-14)


def test_plane_curves_turn_in_their_plane_beside_a_surface():
    hand = a_hand(5)
    hand.session.select(hand.session.selection | Selection.of_lines([LineId(WAVE, 2)]))
    does(hand, "turn_left")
    x, y = hand.directions()[2]
    assert_allclose(np.degrees(np.arctan2(y, x)), 5.0)
    assert hand.session.undo_label == "Rotate control line and control plane"


def test_a_surface_seen_from_above_turns_in_the_plane_of_the_view():
    hand = does(a_hand(5, camera=PlaneCamera(SIZE)), "turn_left")
    old, new = sail().vectors[0, 5], surface_of(hand).vectors[0, 5]
    assert new[2] == old[2]
    angle = np.angle(complex(*new[:2]) / complex(*old[:2]))
    assert_allclose(np.degrees(angle), 5.0)


@pytest.mark.parametrize("name, axis", [("mirror_horizontally", 0), ("mirror_vertically", 2)])
def test_mirroring_stays_in_place(name, axis):
    hand = does(a_hand(), name)
    u = np.linspace(0.0, 1.0, 9)
    image = sail().at(u, u)
    points = sail().planes.control_points[:, axis]
    image[..., axis] = points.min() + points.max() - image[..., axis]
    assert_allclose(surface_of(hand).at(u, u), image, atol=1e-12)


def test_a_plane_curve_can_not_be_nudged_or_mirrored_out_of_its_plane_in_space():
    hand = a_hand()
    hand.session.select(Selection.of_shapes([WAVE]))
    assert does(hand, "nudge_nearer", "mirror_vertically").errors == [
        "A plane curve can't leave its plane.",
        "A plane curve can't be mirrored out of its plane.",
    ]


def test_duplicates_lie_to_the_right_and_below_as_seen():
    hand = does(a_hand(), "duplicate")
    copied = hand.session.design.surface("sail-2").planes.points
    assert_allclose(copied, sail().planes.points + np.array([1.0, 0.0, -1.0]))


# Selecting


def test_all_are_selected_and_inverted():
    hand = does(a_hand(5), "select_all")
    assert len(hand.session.selection.lines) == 12 + 5
    assert len(numbers(does(a_hand(5), "invert"))) == 11


def test_tab_goes_from_plane_to_plane_and_on_to_the_next_shape():
    hand = does(a_hand(11), "next_line")
    assert hand.session.selection.active == LineId(WAVE, 0)
    does(hand, "previous_line", "previous_line")
    assert hand.session.selection.active == LineId(SAIL, 10)


def test_the_row_and_the_column_of_the_active_plane():
    hand = does(a_hand(5), "select_row")
    assert numbers(hand) == (4, 5, 6, 7)
    assert hand.session.selection.active == LineId(SAIL, 5)
    assert numbers(does(hand, "select_column")) == (1, 5, 9)


def test_rows_of_all_selected_planes_where_none_is_active():
    assert numbers(does(a_hand(1, 9), "select_row")) == (0, 1, 2, 3, 8, 9, 10, 11)
    hand = does(a_hand(), "select_row")
    assert hand.errors == ["Select a control plane of a surface first."]


def test_a_selection_grows_to_its_neighbors_and_shrinks_back():
    hand = does(a_hand(5), "grow_selection")
    assert numbers(hand) == (1, 4, 5, 6, 9)
    assert numbers(does(hand, "shrink_selection")) == (5,)
    assert does(hand, "shrink_selection").errors == ["The selection can't get any smaller."]


def test_a_selection_grows_round_the_seam():
    tube = sail(basis_v=BSpline(4, 3, closed=True))
    assert numbers(does(a_hand(0, surface=tube), "grow_selection")) == (0, 1, 3, 4)


def test_of_curves_too_a_selection_grows_to_its_neighbors():
    hand = Hand(the_design())
    hand.select(0, 3)
    assert does(hand, "grow_selection").numbers == (0, 1, 2, 3, 4)


# s


def test_s_goes_by_the_natural_length_and_to_the_best():
    hand = does(a_hand(), "s_up")
    assert surface_of(hand).s == pytest.approx(1.0 + natural_length(sail()) / 100.0)
    assert surface_of(does(hand, "s_zero")).s == 0.0
    assert surface_of(does(hand, "s_half")).s == pytest.approx(natural_length(sail()) / 2.0)
    assert surface_of(does(hand, "s_best")).s == pytest.approx(best_surface_s(sail()))


def test_without_a_selection_s_is_that_of_all_curves_and_surfaces():
    hand = does(Hand(the_design()), "s_zero")
    assert [geometry.s for _, geometry in hand.session.design.drawn()] == [0.0, 0.0]


# The menu of surfaces


def test_u_and_v_are_swapped_and_reversed():
    assert surface_of(does(a_hand(), "transpose")).planes.shape == (4, 3)
    points = surface_of(does(a_hand(), "reverse_v")).planes.points
    assert_array_equal(points, sail().planes.points[:, ::-1])


def test_a_surface_closes_along_u_and_opens_again():
    hand = does(a_hand(), "close_u")
    assert surface_of(hand).closed == (True, False)
    assert does(hand, "close_u").errors == ["What is selected is closed along u already."]
    assert surface_of(does(hand, "open_u")).closed == (False, False)


def test_the_order_goes_up_and_down_one_way():
    hand = does(a_hand(), "order_down_v")
    assert surface_of(hand).basis_v == BSpline(4, 3)
    does(hand, "order_up_v", "order_up_v")
    assert hand.errors == ["The order along v is the highest that this surface can have."]
    assert surface_of(hand).basis_u == sail().basis_u


@pytest.mark.parametrize("way, place", [("u", 0), ("v", 1)])
def test_the_family_changes_one_way(way, place):
    surface = surface_of(does(a_hand(), f"family_{way}_rag"))
    kinds = [type(basis).__name__ for basis in surface.bases]
    assert kinds[place] == "RationalGaussian" and kinds[1 - place] == "BSpline"


def test_a_new_row_comes_into_the_wider_gap_beside_the_active_plane():
    hand = does(a_hand(9), "insert_row")
    surface = surface_of(hand)
    assert surface.planes.shape == (4, 4)
    assert numbers(hand) == (8, 9, 10, 11)
    u = np.linspace(0.0, 1.0, 9)
    assert_allclose(surface.at(u, u), sail().at(u, u), atol=1e-9)


def test_without_an_active_plane_the_widest_gap_of_all_is_taken():
    basis = BSpline(5, 3, knots=(0.0,) * 3 + (0.1, 0.2) + (1.0,) * 3)
    nodes = basis.nodes
    widest = int(np.diff(nodes).argmax())
    assert widest_gap(basis, None) == pytest.approx(nodes[widest : widest + 2].mean())
    assert widest_gap(basis, 0) == pytest.approx(nodes[:2].mean())
    assert widest_gap(basis, 4) == pytest.approx(nodes[3:].mean())


def test_the_gap_across_the_seam_is_one_too():
    assert widest_gap(BSpline(4, 3, closed=True), 0) == pytest.approx(0.875)


@pytest.mark.parametrize("way", ["u", "v"])
def test_a_curve_is_taken_through_the_node_of_the_active_plane(way):
    hand = does(a_hand(5), f"extract_{way}")
    (added,) = hand.session.selection.shapes
    t = np.linspace(0.0, 1.0, 9)
    basis = sail().basis_u if way == "u" else sail().basis_v
    node = [basis.nodes[1]]
    on = sail().at(node, t)[0] if way == "u" else sail().at(t, node)[:, 0]
    assert_allclose(hand.session.design.curve(added).at(t), on, atol=1e-12)


def test_one_direction_is_reversed_and_reset():
    hand = does(a_hand(5), "reverse_directions_v")
    surface = surface_of(hand)
    assert_array_equal(surface.vectors[1, 5], -sail().vectors[1, 5])
    assert_array_equal(surface.vectors[0, 5], sail().vectors[0, 5])
    assert surface_of(does(hand, "reset_directions_v")).planes.automatic.all()
