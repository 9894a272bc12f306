import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.selection import LineId
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.blend import Grid
from plusedit.geometry.making.primitives import sheet
from plusedit.interaction.tool import Held
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.hand import EMPTY, WAVE, Hand

PARAMETERS = np.linspace(0.0, 1.0, 33)


def test_a_click_inserts_a_line_that_is_selected_and_keeps_the_shape():
    hand = Hand(tool="insert")
    before = hand.curve()
    hand.click(before.at([0.3])[0])
    assert len(hand.points()) == 6
    assert_allclose(hand.curve().at(PARAMETERS), before.at(PARAMETERS), atol=1e-9)
    assert len(hand.numbers) == 1
    assert hand.session.undo_label == "Insert control line"


def test_hovering_shows_where_on_the_nearest_curve():
    hand = Hand(tool="insert")
    place = hand.curve().at([0.3])[0]
    hand.gestures.move(hand.at(place + 0.05))
    (ring,) = hand.said.items
    assert np.linalg.norm(ring.points[0] - place) < 0.1
    hand.gestures.move(hand.at(EMPTY))
    assert hand.said.items == ()


def test_the_selected_numbers_of_other_lines_are_not_kept():
    hand = Hand(tool="insert")
    hand.select(4)
    hand.click(hand.curve().at([0.3])[0])
    (number,) = hand.numbers
    assert hand.session.selection.active == LineId(WAVE, number)


def test_a_drag_inserts_and_moves_in_one_step():
    hand = Hand(tool="insert")
    before = hand.session.design
    place = hand.curve().at([0.3])[0]
    hand.drag(place, np.add(place, 0.5), moves=10)
    assert len(hand.points()) == 6
    hand.session.undo()
    assert hand.session.design is before


def test_a_click_far_from_curves_does_nothing():
    hand = Hand(tool="insert")
    before = hand.session.design
    hand.click(EMPTY)
    hand.drag(EMPTY, (0.0, 3.9))
    assert hand.session.design is before


SHEET = ShapeId("sheet")


def over_a_sheet():
    """A hand over a sheet of 4 x 4 planes, seen from the front and above."""
    camera = SpaceCamera((800.0, 600.0), height=4.0)
    return Hand(Design({SHEET: Shape(sheet(), "Sheet")}), camera, "insert")


@pytest.mark.parametrize(
    ("held", "shape", "label"),
    [(Held.NONE, (5, 4), "Insert row"), (Held.SHIFT, (4, 5), "Insert column")],
)
def test_a_click_on_a_surface_inserts_a_row_of_planes_or_with_shift_a_column(held, shape, label):
    hand = over_a_sheet()
    before = hand.session.design.surface(SHEET)
    hand.click(before.at(0.3, 0.6)[0, 0], held)
    after = hand.session.design.surface(SHEET)
    assert after.planes.shape == shape
    assert hand.session.undo_label == label
    assert len(hand.session.selection.lines) == 4
    grid = Grid(PARAMETERS)
    assert_allclose(after.sample(grid, grid), before.sample(grid, grid), atol=1e-9)


def test_hovering_shows_the_line_of_a_surface_where_the_row_would_come():
    hand = over_a_sheet()
    surface = hand.session.design.surface(SHEET)
    hand.gestures.move(hand.at(surface.at(0.3, 0.6)[0, 0]))
    (line,) = hand.said.items
    expected = surface.sample(Grid(np.array([0.3])), Grid.uniform(len(line.points)))[0]
    assert_allclose(line.points, expected, atol=0.02)
    assert "row" in hand.said.hint and hand.said.readout == "u 0.300"


def test_a_drag_on_a_surface_inserts_a_row_and_moves_it_in_one_step():
    hand = over_a_sheet()
    before = hand.session.design
    place = before.surface(SHEET).at(0.3, 0.6)[0, 0]
    hand.drag(place, np.add(place, [0.0, 0.0, 0.5]), moves=5)
    planes = hand.session.design.surface(SHEET).planes
    assert planes.shape == (5, 4)
    heights = planes.points[..., 2]
    assert (heights != 0.0).any(axis=1).sum() == 1
    hand.session.undo()
    assert hand.session.design is before
