import pytest

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.making.primitives import sheet
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.hand import CAMERA, Hand

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
