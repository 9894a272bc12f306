"""Pointing, selecting and dragging in a view of parameters."""

import numpy as np
import pytest

from plusedit.document.selection import NOTHING_SELECTED, LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.mesh.unfolding import NONE
from plusedit.interaction.parameter_hand import BOX, CONE, CONE_DRAG, ParameterHand, ParameterStage
from plusedit.interaction.tool import Held, Pointer
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Markers, Polygon
from plusedit.scene.parameter_sheet import ParameterSheet
from tests.geometry.mesh.mesh_surfaces import height_field, pillow

MESH = ShapeId("mesh")


class Hand:
    """A hand, what it works on, and what it has told."""

    def __init__(self, surface, selection=NOTHING_SELECTED):
        self.sheet = ParameterSheet.of(surface)
        unfolding = self.sheet.unfolding
        self.camera = PlaneCamera((400.0, 300.0)).framing(np.stack(unfolding.bounds), 40.0)
        self.stage = ParameterStage(MESH, self.sheet, self.camera, selection, unfolding.face_at)
        self.hand = ParameterHand()
        self.selections, self.cones = [], []
        self.hand.selected.listen(self.selections.append)
        self.hand.cones_chosen.listen(self.cones.append)

    def at(self, place, held=Held.NONE):
        x, y = self.camera.to_screen(np.array(place, dtype=float)[None])[0]
        return Pointer(float(x), float(y), held)

    def center(self, face, held=Held.NONE):
        return self.at(self.sheet.unfolding.centers[face], held)

    def click(self, at):
        self.hand.press(at, self.stage)
        self.hand.release(at, self.stage)

    def drag(self, start, end):
        self.hand.press(start, self.stage)
        self.hand.move(end)
        self.hand.release(end, self.stage)


def faces(selection):
    return {line.number for line in selection.lines}


def test_a_click_selects_the_face_that_is_there():
    hand = Hand(height_field())
    hand.click(hand.center(17))
    assert hand.selections == [Selection.of_lines([LineId(MESH, 17)])]


def test_shift_adds_a_face_and_takes_it_out_again():
    before = Selection.of_lines([LineId(MESH, 3)])
    hand = Hand(height_field(), before)
    hand.click(hand.center(5, Held.SHIFT))
    hand.click(hand.center(3, Held.SHIFT))
    assert [faces(s) for s in hand.selections] == [{3, 5}, set()]
    assert all(MESH in s.shapes for s in hand.selections)


def test_a_click_beside_the_faces_leaves_the_mesh_selected_as_a_whole():
    hand = Hand(height_field(), Selection.of_lines([LineId(MESH, 3)]))
    hand.click(Pointer(2.0, 2.0))
    assert hand.selections == [Selection.of_shapes([MESH])]
    hand.click(Pointer(2.0, 2.0, Held.SHIFT))
    assert hand.selections[-1] == hand.stage.selection


def test_a_box_selects_the_faces_whose_centers_it_holds():
    hand = Hand(height_field())
    hand.drag(hand.at((0.1, 0.6)), hand.at((0.5, 0.2)))
    inside = hand.sheet.unfolding.faces_within(np.array([0.1, 0.2]), np.array([0.5, 0.6]))
    assert len(inside)
    assert faces(hand.selections[0]) == set(inside.tolist())


@pytest.mark.parametrize(
    ("held", "expected"), [(Held.SHIFT, lambda a, b: a | b), (Held.CTRL, lambda a, b: a - b)]
)
def test_a_box_adds_with_shift_and_takes_out_with_ctrl(held, expected):
    before = Selection.of_lines(LineId(MESH, face) for face in range(0, 160, 3))
    hand = Hand(height_field(), before)
    hand.drag(hand.at((0.1, 0.6)), hand.at((0.5, 0.2), held))
    inside = hand.sheet.unfolding.faces_within(np.array([0.1, 0.2]), np.array([0.5, 0.6]))
    assert faces(hand.selections[0]) == expected(faces(before), set(inside.tolist()))


def test_an_empty_box_leaves_the_mesh_selected_as_a_whole():
    hand = Hand(height_field())
    hand.drag(Pointer(1.0, 1.0), Pointer(9.0, 9.0))
    assert hand.selections == [Selection.of_shapes([MESH])]


def test_the_face_under_the_pointer_is_shown_unless_a_drag_is_under_way():
    hand = Hand(height_field())
    hand.hand.move(hand.center(8))
    assert hand.hand.face(hand.stage) == 8
    assert any(isinstance(item, Polygon) for item in hand.hand.items(hand.stage))
    hand.hand.press(hand.center(8), hand.stage)
    hand.hand.move(hand.center(30))
    assert hand.hand.face(hand.stage) == NONE
    assert hand.hand.hint(hand.stage) == BOX


def test_escape_ends_a_box_without_selecting():
    hand = Hand(height_field())
    hand.hand.press(hand.at((0.1, 0.6)), hand.stage)
    hand.hand.move(hand.at((0.5, 0.2)))
    assert hand.hand.cancel()
    hand.hand.release(hand.at((0.5, 0.2)), hand.stage)
    assert not hand.selections
    assert not hand.hand.cancel()


def test_a_cone_point_is_dragged_to_the_vertex_nearest_to_where_it_is_let_go():
    hand = Hand(pillow())
    cones = hand.sheet.unfolding.domain.cone_points
    target = hand.sheet.unfolding.corners[200]
    hand.drag(hand.at(cones[2]), hand.at(target + 1e-3))
    expected = list(hand.sheet.cone_points)
    expected[2] = int(hand.sheet.unfolding.mesh.corners[200])
    where = hand.sheet.unfolding.vertex_places
    (found,) = hand.cones
    assert [found[k] for k in (0, 1, 3)] == [expected[k] for k in (0, 1, 3)]
    np.testing.assert_allclose(where[found[2]], target)
    assert not hand.selections


def test_while_a_cone_point_is_dragged_its_landing_is_shown():
    hand = Hand(pillow())
    cones = hand.sheet.unfolding.domain.cone_points
    hand.hand.press(hand.at(cones[0]), hand.stage)
    assert hand.hand.hint(hand.stage) == CONE
    hand.hand.move(hand.at((0.7, 0.3)))
    assert hand.hand.hint(hand.stage) == CONE_DRAG
    rings = [i for i in hand.hand.items(hand.stage) if isinstance(i, Markers) and i.mark == "ring"]
    assert len(rings) == 1


def test_a_click_on_a_cone_point_changes_nothing():
    hand = Hand(pillow())
    hand.click(hand.at(hand.sheet.unfolding.domain.cone_points[1]))
    assert not hand.selections
    assert not hand.cones


def test_a_cone_point_put_back_where_it_was_asks_for_nothing():
    hand = Hand(pillow())
    place = hand.sheet.unfolding.domain.cone_points[0]
    hand.hand.press(hand.at(place), hand.stage)
    hand.hand.move(hand.at((0.7, 0.3)))
    hand.hand.release(hand.at(place), hand.stage)
    # Vertices that lie there: every triangle of this pillow has its own.
    places = hand.sheet.unfolding.vertex_places
    for points in hand.cones:
        np.testing.assert_allclose(places[points[0]], place, atol=1e-9)
