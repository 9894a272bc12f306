import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.making.primitives import sheet
from plusedit.interaction.tool import Pointer
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.hand import CAMERA, Hand
from tests.interaction.space_hand import HELIX, SPACE, SpaceHand

SHEET = ShapeId("sheet")


@pytest.mark.parametrize("camera", [CAMERA, SpaceCamera((800.0, 600.0), height=4.0)])
@pytest.mark.parametrize("number", [0, 5, 15])
def test_a_selected_control_plane_is_no_end_that_the_pen_goes_on_from(camera, number):
    hand = Hand(Design({SHEET: Shape(sheet(), "Sheet")}), camera, "pen")
    hand.session.select(Selection.of_lines([LineId(SHEET, number)]))
    hand.gestures.move(hand.at((0.5, 0.5, 0.0)))
    hand.click((0.5, 0.5, 0.0))
    hand.click((0.9, 0.2, 0.0))
    assert len(hand.session.design) == 2
    (curve,) = (shape.curve for shape in hand.session.design.shapes.values() if shape.curve)
    assert len(curve.lines) == 2


@pytest.mark.parametrize("perspective", [True, False])
def test_the_pen_draws_on_the_ground(perspective):
    hand = Hand(Design(), SpaceCamera((800.0, 600.0), perspective=perspective), "pen")
    for place in ((0.0, 0.0, 0.0), (1.0, 0.5, 0.0), (2.0, 2.0, 0.0)):
        hand.click(place)
    assert_allclose(hand.points("curve"), [(0.0, 0.0), (1.0, 0.5), (2.0, 2.0)], atol=1e-9)


def test_where_the_ground_is_seen_from_its_edge_the_pen_draws_across_the_view():
    hand = Hand(Design(), SpaceCamera.standard("front", (800.0, 600.0)), "pen")
    for place in ((0.0, 0.0, 0.0), (1.0, 0.0, 0.5), (2.0, 0.0, 2.0)):
        hand.click(place)
    found = hand.points("curve")
    assert_allclose(found, [(0.0, 0.0, 0.0), (1.0, 0.0, 0.5), (2.0, 0.0, 2.0)], atol=1e-9)


def test_above_the_horizon_the_pen_draws_where_the_ground_ends():
    camera = SpaceCamera((800.0, 600.0), pitch=0.25)
    hand = Hand(Design(), camera, "pen")
    hand.click((0.0, 0.0, 0.0))
    hand.gestures.press(Pointer(400.0, -300.0))
    hand.gestures.release(Pointer(400.0, -300.0))
    x, y = hand.points("curve")[1]
    assert 9.0 * camera.height < (x * x + y * y) ** 0.5 <= 10.0 * camera.height
    across, _ = camera.to_screen(hand.points("curve")[1:])[0]
    assert_allclose(across, 400.0, atol=1e-3)


def test_the_pen_goes_on_with_a_space_curve_as_deep_as_its_end():
    hand = SpaceHand(tool="pen")
    end = hand.points(HELIX)[3]
    hand.session.select(Selection.of_lines([LineId(HELIX, 3)]))
    at = hand.at(end)
    hand.gestures.press(Pointer(at.x + 40.0, at.y - 30.0))
    hand.gestures.release(Pointer(at.x + 40.0, at.y - 30.0))
    added = hand.points(HELIX)[4]
    seen = SPACE.to_screen(added[None])[0]
    assert_allclose(seen, (at.x + 40.0, at.y - 30.0), atol=1e-6)
    assert_allclose(*SPACE.depths(hand.points(HELIX)[3:]), atol=1e-9)
