import pytest

from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.making.primitives import sheet
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.hand import Hand

SHEET = ShapeId("sheet")


def over_a_sheet():
    hand = Hand(Design({SHEET: Shape(sheet(), "Sheet")}), SpaceCamera((800.0, 600.0), height=4.0))
    hand.session.select(Selection.of_shapes([SHEET]))
    return hand


@pytest.mark.parametrize(("beside", "name"), [(4, "column"), (1, "row")])
def test_the_hint_of_an_edge_names_what_a_double_click_on_it_selects(beside, name):
    hand = over_a_sheet()
    points = hand.session.design.surface(SHEET).net.control_points
    # Off the middle of the edge, where the automatic grip stands.
    place = 0.75 * points[5] + 0.25 * points[5 + beside]
    hand.gestures.move(hand.at(place))
    assert f"the {name} of" in hand.said.hint
    hand.double_click(place)
    numbers = sorted(line.number for line in hand.session.selection.lines)
    assert numbers == ([1, 5, 9, 13] if name == "column" else [4, 5, 6, 7])


def test_the_ground_of_space_tells_how_to_get_about():
    hand = over_a_sheet()
    hand.gestures.move(hand.at((9.0, 9.0, 0.0)))
    assert "orbits" in hand.said.hint
