"""Selecting and dragging faces of meshes, in both kinds of view."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.commands.lines import MovePoints
from plusedit.document.selection import NOTHING_SELECTED, LineId, Selection
from plusedit.interaction.highlighting import highlight
from plusedit.interaction.picking import under
from plusedit.interaction.selecting import delete, invert, neighbor, select_all
from plusedit.interaction.tool import Held, Pointer
from plusedit.scene.items import Segments
from plusedit.scene.options import ViewOptions
from plusedit.scene.plane_handles import handles_of_plane
from tests.interaction.face_hand import ABOVE, FEW, MANY, TOP, FaceHand
from tests.interaction.space_hand import angles_between
from tests.scene.meshes import HILL

every_view = pytest.mark.parametrize("camera", [ABOVE, TOP], ids=["space", "top"])
MIDDLE = 7 * 15 + 7


def turned_by(hand, number):
    """Degrees by which the gradients (2,) of a face have turned."""
    return angles_between(hand.surface.vectors[:, number], MANY.vectors[:, number])


@every_view
def test_a_click_on_a_selected_mesh_selects_the_face_there(camera):
    hand = FaceHand(camera)
    hand.click_face(40)
    assert hand.chosen == (40,)
    assert hand.session.selection.active == LineId(HILL, 40)
    hand.click_face(MIDDLE)
    assert hand.chosen == (MIDDLE,)


def test_a_click_on_a_mesh_that_is_not_selected_selects_it_as_a_whole():
    hand = FaceHand()
    hand.session.select(NOTHING_SELECTED)
    hand.click_face(40)
    assert hand.session.selection == Selection.of_shapes([HILL])


def test_a_double_click_selects_the_face_at_once():
    hand = FaceHand()
    hand.session.select(NOTHING_SELECTED)
    hand.click_face(40)
    hand.gestures.double_click(hand.on_face(40))
    hand.gestures.release(hand.on_face(40))
    assert hand.chosen == (40,)


@pytest.mark.parametrize("held", [Held.SHIFT, Held.CTRL])
@every_view
def test_shift_and_control_add_faces_and_take_them_out(camera, held):
    hand = FaceHand(camera)
    for number in (40, 43, 46):
        hand.click_face(number, held)
    assert hand.chosen == (40, 43, 46)
    assert hand.session.selection.active == LineId(HILL, 46)
    hand.click_face(43, held)
    assert hand.chosen == (40, 46)


@every_view
def test_escape_goes_back_to_the_mesh_as_a_whole(camera):
    hand = FaceHand(camera)
    hand.click_face(40)
    assert hand.type("Escape") == [True]
    assert hand.session.selection == Selection.of_shapes([HILL])
    assert hand.type("Escape") == [False]


@every_view
def test_a_click_beside_the_mesh_selects_nothing(camera):
    hand = FaceHand(camera)
    hand.click_face(40)
    hand.tap(Pointer(5.0, 5.0))
    assert not hand.session.selection


@every_view
def test_what_a_click_would_take_is_outlined(camera):
    hand = FaceHand(camera)
    stage = hand.gestures.stage()
    hit = under(hand.on_face(40).at, stage)
    assert (hit.kind, hit.line) == ("face", LineId(HILL, 40))
    (outline,) = [item for item in highlight(hit, stage) if isinstance(item, Segments)]
    low, high = np.array([2, 10]) / 15.0, np.array([3, 11]) / 15.0
    assert_allclose(outline.starts[:, :2].min(axis=0), low, atol=1e-12)
    assert_allclose(outline.ends[:, :2].max(axis=0), high, atol=1e-12)


@every_view
def test_a_selected_face_is_dragged_by_its_surface(camera):
    hand = FaceHand(camera)
    hand.pick(40, MIDDLE)
    hand.pull(hand.on_face(40), (20.0, 0.0), (30.0, 10.0))
    assert hand.session.is_previewing
    hand.let_go()
    assert hand.moved == [40, MIDDLE]
    assert hand.session.undo_label == "Move 2 control planes"
    shift = camera.to_screen(hand.planes[[40]]) - camera.to_screen(MANY.planes.points[[40]])
    assert_allclose(shift[0], [30.0, 10.0], atol=1e-6)
    assert_array_equal(hand.surface.mesh.vertices, MANY.mesh.vertices)


@every_view
def test_a_selected_face_is_dragged_by_its_dot(camera):
    hand = FaceHand(camera)
    hand.pick(40)
    hand.nudge(hand.planes[40], (10.0, 0.0), (25.0, -15.0))
    assert hand.moved == [40]


def test_control_snaps_the_point_of_a_face_to_the_grid():
    hand = FaceHand()
    hand.gestures.grid_step = 0.25
    hand.pick(40)
    hand.pull(hand.on_face(40), (30.0, 10.0))
    at = hand.on_face(40)
    hand.gestures.move(Pointer(at.x + 30.0, at.y + 10.0, Held.CTRL))
    hand.let_go()
    assert_array_equal(hand.planes[40] / 0.25, np.round(hand.planes[40] / 0.25))


@every_view
def test_a_drag_that_is_given_up_leaves_the_very_same_design(camera):
    hand = FaceHand(camera)
    before = hand.session.design
    hand.pick(40)
    hand.pull(hand.on_face(40), (30.0, 10.0))
    assert hand.session.design is not before
    hand.type("Escape")
    assert hand.session.design is before
    assert hand.session.undo_label is None


def test_a_drag_on_another_face_moves_the_mesh():
    hand = FaceHand()
    hand.pick(40)
    hand.pull(hand.on_face(MIDDLE), (30.0, 10.0))
    hand.let_go()
    assert hand.session.undo_label == "Move mesh"
    assert not hand.surface.edited


def test_a_drag_on_another_face_of_a_view_of_a_plane_is_a_box():
    hand = FaceHand(TOP)
    hand.pick(40)
    hand.pull(hand.on_face(MIDDLE), (100.0, 100.0))
    hand.let_go()
    assert hand.session.undo_label is None
    assert len(hand.chosen) == 4


@pytest.mark.parametrize("side", [1, 2])
@every_view
def test_a_grip_turns_one_gradient_of_a_face(camera, side):
    hand = FaceHand(camera)
    hand.pick(MIDDLE)
    at, row = handles_of_plane(hand.surface, MIDDLE, camera)
    hand.nudge(at.tips_world[side - 1, row], (8.0, 8.0), (16.0, 16.0))
    assert hand.session.undo_label == "Rotate control plane"
    turned = turned_by(hand, MIDDLE)
    assert turned[side - 1] > 5.0 and turned[2 - side] < 1e-6
    lengths = np.linalg.norm(hand.surface.vectors[:, MIDDLE], axis=1)
    assert_allclose(lengths, np.linalg.norm(MANY.vectors[:, MIDDLE], axis=1))


def test_a_double_click_on_a_grip_gives_the_face_its_own_gradient_back():
    hand = FaceHand()
    hand.pick(MIDDLE)
    at, row = handles_of_plane(hand.surface, MIDDLE, ABOVE)
    hand.nudge(at.tips_world[0, row], (16.0, 16.0))
    assert hand.surface.edited
    at, row = handles_of_plane(hand.surface, MIDDLE, ABOVE)
    hand.double_click(at.tips_world[0, row])
    assert not hand.surface.edited


def test_the_gizmo_moves_and_turns_a_face():
    hand = FaceHand()
    hand.pick(MIDDLE)
    assert hand.gizmo.line == LineId(HILL, MIDDLE) and hand.gizmo.turns
    hand.nudge(hand.on_arrow(0), (20.0, 5.0))
    assert hand.moved == [MIDDLE]
    hand.nudge(hand.on_ring(2, 40.0), (15.0, 15.0))
    assert hand.session.undo_label == "Rotate control plane"
    assert (turned_by(hand, MIDDLE) > 1.0).all()


@pytest.mark.parametrize("drag", ["move", "turn", "scale"])
@every_view
def test_keys_begin_drags_of_faces(camera, drag):
    hand = FaceHand(camera)
    hand.pick(40, MIDDLE)
    hand.gestures.begin(drag, Pointer(600.0, 300.0))
    hand.gestures.move(Pointer(640.0, 360.0))
    hand.gestures.key("Enter")
    assert set(hand.surface.edited) == {40, MIDDLE}
    assert hand.session.undo_label.endswith("2 control planes")


def test_a_typed_distance_is_exact():
    hand = FaceHand()
    hand.pick(40)
    hand.gestures.begin("move", Pointer(600.0, 300.0))
    hand.type("Z", "0", ".", "5", "Enter")
    assert_allclose(hand.planes[40] - MANY.planes.points[40], [0.0, 0.0, 0.5])


def test_a_soft_move_takes_faces_around_along():
    hand = FaceHand(TOP)
    hand.pick(MIDDLE)
    hand.pull(hand.on_face(MIDDLE), (10.0, 0.0))
    hand.type("O")
    hand.gestures.move(Pointer(hand.gestures._pointer.x, hand.gestures._pointer.y - 40.0))
    hand.let_go()
    assert 10 < len(hand.moved) < 225
    assert hand.session.undo_label == "Softly move control plane"


# Boxes


def box(hand, low, high, held=Held.NONE):
    hand.pull(Pointer(*low, held), np.subtract(high, low))
    hand.let_go()


@every_view
def test_a_box_over_a_selected_mesh_selects_the_faces_in_it(camera):
    hand = FaceHand(camera)
    middles = camera.to_screen(hand.surface.at(hand.surface.planes.centers))
    low, high = np.array([1.0, 1.0]), middles[MIDDLE] + 3.0
    box(hand, low, high)
    assert hand.chosen == tuple(np.flatnonzero((middles <= high).all(axis=1)).tolist())
    assert 20 < len(hand.chosen) < 100


@every_view
def test_a_box_around_a_mesh_takes_it_as_a_whole(camera):
    hand = FaceHand(camera)
    box(hand, (1.0, -300.0), (1200.0, 1100.0))
    assert hand.session.selection == Selection.of_shapes([HILL])


def test_a_box_over_a_mesh_that_is_not_selected_selects_no_faces():
    hand = FaceHand()
    hand.session.select(NOTHING_SELECTED)
    box(hand, (1.0, 1.0), (500.0, 400.0))
    assert not hand.session.selection


@every_view
def test_a_box_that_begins_on_the_surface_adds_with_shift_and_takes_out_with_control(camera):
    hand = FaceHand(camera)
    hand.pick(0)
    start = hand.on_face(MIDDLE, Held.SHIFT)
    hand.pull(start, (120.0, 120.0))
    hand.let_go()
    added = hand.chosen
    assert 0 in added and len(added) > 2
    start = hand.on_face(MIDDLE, Held.CTRL)
    hand.pull(start, (120.0, 120.0))
    hand.let_go()
    assert hand.chosen == (0,)


def test_a_box_takes_only_faces_that_are_seen_where_that_is_wished():
    hand = FaceHand(camera=ABOVE.__class__((1000.0, 800.0), (0.5, 0.5, 0.2), 1.3, pitch=0.1))
    low, high = (1.0, 1.0), (700.0, 799.0)
    box(hand, low, high)
    everything = set(hand.chosen)
    hand.session.select(Selection.of_shapes([HILL]))
    hand.gestures.options = ViewOptions(front_only=True)
    box(hand, low, high)
    seen = set(hand.chosen)
    assert seen < everything
    assert seen and len(everything) - len(seen) > 10


def test_of_few_faces_all_planes_are_shown_and_taken_by_their_dots():
    hand = FaceHand(surface=FEW)
    hand.session.select(NOTHING_SELECTED)
    hand.click(FEW.planes.points[8])
    assert hand.chosen == (8,)


# Keys and menus


def test_delete_says_that_faces_stay():
    hand = FaceHand()
    hand.pick(40)
    hand.gestures.perform_by(lambda: delete(hand.gestures.stage()))
    assert "can't be deleted" in hand.errors[0]
    assert HILL in hand.session.design


def test_invert_selects_the_other_faces():
    hand = FaceHand()
    hand.pick(*range(3, 225))
    assert invert(hand.gestures.stage()).by_shape() == {HILL: (0, 1, 2)}
    hand.session.select(NOTHING_SELECTED)
    assert invert(hand.gestures.stage()) == Selection.of_shapes([HILL])
    assert select_all(hand.gestures.stage()) == Selection.of_shapes([HILL])


def test_tab_goes_from_face_to_face_and_round_again():
    hand = FaceHand()
    assert neighbor(hand.gestures.stage(), 1).by_shape() == {HILL: (0,)}
    assert neighbor(hand.gestures.stage(), -1).by_shape() == {HILL: (224,)}
    hand.pick(224)
    assert neighbor(hand.gestures.stage(), 1).by_shape() == {HILL: (0,)}


def test_a_selection_of_faces_grows_and_shrinks(actions):
    hand = FaceHand()
    hand.pick(MIDDLE)
    hand.gestures.perform(actions["grow_selection"](hand.gestures.stage()))
    around = [MIDDLE + 15 * i + j for i in (-1, 0, 1) for j in (-1, 0, 1)]
    assert hand.chosen == tuple(around)
    hand.gestures.perform(actions["shrink_selection"](hand.gestures.stage()))
    assert hand.chosen == (MIDDLE,)


@pytest.fixture
def actions():
    """What every action makes, by name."""
    from plusedit.interaction.actions import edit_actions

    return {action.name: action.make for action in edit_actions()}


@pytest.mark.parametrize(
    "name",
    [
        "nudge_left",
        "nudge_up_far",
        "nudge_nearer",
        "turn_left",
        "reverse_directions",
        "unit_length",
        "mirror_horizontally",
    ],
)
@pytest.mark.parametrize("rows", [(40, MIDDLE), ()], ids=["faces", "mesh"])
@every_view
def test_every_action_on_lines_serves_faces_and_meshes(actions, camera, rows, name):
    hand = FaceHand(camera)
    if rows:
        hand.pick(*rows)
    before = hand.surface
    hand.gestures.perform_by(lambda: actions[name](hand.gestures.stage()))
    assert hand.errors == []
    assert hand.surface is not before
    if rows:
        assert set(hand.surface.edited) == set(rows)
        hand.gestures.perform_by(lambda: actions["reset_directions"](hand.gestures.stage()))
        assert hand.surface.net.automatic_vectors.all()


def test_what_is_of_nets_only_says_so(actions):
    hand = FaceHand()
    hand.pick(40)
    for name in ("select_row", "insert_row", "extract_u", "transpose", "reverse_curve"):
        hand.gestures.perform_by(lambda name=name: actions[name](hand.gestures.stage()))
    assert len(hand.errors) == 5


@pytest.mark.parametrize("tool", ["select", "insert", "pen", "pan", "pull"])
@every_view
def test_every_tool_bears_meshes(camera, tool):
    hand = FaceHand(camera)
    hand.pick(40)
    hand.gestures.choose(tool)
    for held in Held:
        hand.gestures.move(hand.on_face(MIDDLE, held))
        hand.click_face(MIDDLE, held)
        hand.pull(hand.on_face(40, held), (5.0, 5.0), (20.0, 10.0))
        hand.gestures.cancel()


@pytest.mark.parametrize("name", ["s_up", "s_down", "s_zero", "s_half"])
def test_s_of_meshes_is_changed_by_keys(actions, name):
    hand = FaceHand()
    hand.gestures.perform(MovePoints({HILL: (40,)}, np.ones(3)))
    hand.gestures.perform_by(lambda: actions[name](hand.gestures.stage()))
    assert hand.errors == []
