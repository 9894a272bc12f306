from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from numpy.testing import assert_array_equal

from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Style
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Label, Markers, Polygon, Polyline, Segments
from plusedit.scene.options import ViewOptions
from plusedit.scene.scene import scene_items
from tests.designs import BOW, WING, a_design, designs

CAMERA = PlaneCamera((800.0, 600.0), (2.0, 1.0), 100.0)
BARE = ViewOptions(overlays=frozenset(), handles="none")


def recorded(design, options=BARE, selection=None, **more):
    """The items of each kind, in the order of drawing."""
    chosen = Selection() if selection is None else selection
    items = list(scene_items(design, CAMERA, options, chosen, **more))
    return {
        kind: [i for i in items if isinstance(i, kind)]
        for kind in (Polyline, Markers, Segments, Polygon, Label)
    }


def styled(**changes):
    """The known design with another wing."""
    design = a_design()
    return design.with_shape(WING, replace(design[WING], **changes))


def test_every_curve_is_a_line_back_to_front():
    first, second = recorded(a_design())[Polyline]
    assert (first.color, first.width) == ("plus", 2.0)
    assert_array_equal(first.points[0], a_design().curve(WING).at([0.0])[0])
    assert_array_equal(second.points[0], a_design().curve(BOW).at([0.0])[0])


def test_a_curve_has_the_color_and_width_of_its_style():
    line = recorded(styled(style=Style("#aabbcc", 5.0)))[Polyline][0]
    assert (line.color, line.width) == ("#aabbcc", 5.0)


def test_hidden_shapes_are_not_drawn():
    options = ViewOptions(overlays=frozenset({"classical", "polygon", "names"}))
    design = styled(visible=False)
    shown = recorded(design, options, Selection.of_shapes([WING]))
    alone = recorded(design.without(WING), options, Selection.of_shapes([WING]))
    assert {kind: len(items) for kind, items in shown.items()} == {
        kind: len(items) for kind, items in alone.items()
    }


def test_locked_shapes_are_dim_and_show_no_control_lines():
    locked = recorded(styled(locked=True), ViewOptions(overlays=frozenset()))
    assert locked[Polyline][0].color == "plus@45"
    dots = np.concatenate([item.points for item in locked[Markers]])
    assert set(map(tuple, a_design().curve(WING).lines.points[1:3])).isdisjoint(map(tuple, dots))


def test_a_selected_curve_glows_and_shows_which_way_it_runs():
    shown = recorded(a_design(), selection=Selection.of_shapes([BOW]))
    colors = [line.color for line in shown[Polyline]]
    assert colors == ["plus", "selected@28", "plus"]
    (arrow,) = shown[Polygon]
    assert arrow.fill == "selected"


def test_selected_control_lines_come_last_in_their_own_color():
    line = LineId(WING, 1)
    shown = recorded(a_design(), ViewOptions(overlays=frozenset()), Selection.of_lines([line]))
    dot = shown[Markers][-1]
    assert dot.outline == "selected"
    assert_array_equal(dot.points, a_design().curve(WING).lines.points[[1]])


def test_the_users_directions_are_solid_and_automatic_ones_hollow():
    grips = [
        item
        for item in recorded(a_design(), ViewOptions(overlays=frozenset()), only={WING})[Markers]
        if item.outline == "line" and item.size in (10.0, 7.5)
    ]
    assert {len(grip.points) for grip in grips if grip.fill is None} == {3}
    assert {len(grip.points) for grip in grips if grip.fill is not None} == {1}


def test_the_grip_on_the_side_of_the_direction_is_the_larger_one():
    curve = a_design().curve(WING)
    shown = recorded(a_design(), ViewOptions(overlays=frozenset()), only={WING})[Markers]
    (large,) = (item for item in shown if item.size == 10.0 and item.fill == "line")
    assert (large.points[0] - curve.lines.points[1]) @ curve.directions[1] > 0.0


def test_control_lines_of_other_shapes_are_quieter_while_something_is_selected():
    options = ViewOptions(overlays=frozenset())
    colors = {item.color for item in recorded(a_design(), options)[Segments]}
    assert colors == {"line"}
    some = recorded(a_design(), options, Selection.of_shapes([BOW]))
    assert {item.color for item in some[Segments]} == {"line", "line@60"}


def test_only_the_shapes_that_are_asked_for_are_drawn():
    assert len(recorded(a_design(), only={WING})[Polyline]) == 1


def test_drawing_leaves_the_design_as_it_is():
    design = a_design()
    before = dict(design.shapes)
    scene_items(design, CAMERA, ViewOptions())
    assert all(design.shapes[i] is shape for i, shape in before.items())


@settings(max_examples=30)
@given(designs)
def test_whatever_a_file_can_hold_can_be_drawn(design):
    for item in scene_items(design, CAMERA, ViewOptions(handles="all")):
        for value in vars(item).values():
            if isinstance(value, np.ndarray):
                assert np.isfinite(value).all()
