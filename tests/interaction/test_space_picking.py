from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.making.primitives import torus
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_nearest import hit_by_ray
from plusedit.interaction.facets import hidden, surfaces_under
from plusedit.interaction.gizmo_picking import gizmo_under
from plusedit.interaction.net_picking import edge_under, planes_along
from plusedit.interaction.picking import all_under, handles_under, under
from plusedit.interaction.tool import REACH, Held, Stage
from plusedit.scene.options import ViewOptions
from plusedit.scene.plane_handles import plane_handles
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.space_hand import (
    HELIX,
    PARALLEL,
    SAIL,
    SIZE,
    SPACE,
    VIEWS,
    SpaceHand,
    sail,
    scene,
)

every_view = pytest.mark.parametrize("camera", VIEWS, ids=str)
in_space = pytest.mark.parametrize("camera", [SPACE, PARALLEL], ids=str)
pixels = st.tuples(st.floats(150.0, 850.0), st.floats(150.0, 700.0)).map(np.array)

RING = ShapeId("ring")


def stage(camera=SPACE, start=None, **changes):
    return Stage(scene() if start is None else start, camera, **changes)


def a_torus():
    return Design({RING: Shape(torus(), "Torus")})


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(VIEWS), pixels)
def test_dots_and_grips_of_planes_are_found_as_by_looking_at_each(camera, at):
    here = stage(camera)
    planes = plane_handles(here.design.surface(SAIL), camera)
    expected = set()
    for number in range(16):
        places = [(0, planes.points), (1, planes.tips[0]), (2, planes.tips[1])]
        for side, where in places:
            shown = side == 0 or planes.drawn[side - 1, number]
            if shown and np.hypot(*(where[number] - at)) <= REACH:
                expected.add((number, side))
    hits = [hit for hit in handles_under(at, here) if hit.shape == SAIL]
    assert {(hit.number, hit.side) for hit in hits} == expected and len(hits) == len(expected)


@settings(max_examples=60, deadline=None)
@given(st.sampled_from([SPACE, PARALLEL]), pixels)
def test_a_surface_is_found_where_the_ray_through_the_pixel_meets_it(camera, at):
    here = stage(camera)
    surface = here.design.surface(SAIL)
    found = surfaces_under(at, here)
    exact = hit_by_ray(surface, *camera.ray(at))
    if exact is None or not found:
        return  # along the outline either may miss what the other meets
    point = surface.derivatives_at([[found[0].u, found[0].v]], highest=0)[0]
    assert np.hypot(*(camera.to_screen(point)[0] - at)) < 3.0
    assert_allclose(point[0], exact.point, atol=8.0 * camera.pixel)


@in_space
def test_most_of_a_surface_is_found_inside_its_outline(camera):
    here = stage(camera)
    places = here.design.surface(SAIL).at(np.linspace(0.1, 0.9, 9), np.linspace(0.1, 0.9, 9))
    for at in camera.to_screen(places.reshape(-1, 3)):
        assert surfaces_under(at, here)


def test_layers_of_a_surface_come_from_the_nearest_to_the_farthest():
    camera = SpaceCamera(SIZE, height=8.0, yaw=0.3, pitch=0.5)
    here = stage(camera, a_torus())
    middle = camera.to_screen(here.design.surface(RING).at([0.0], [0.0]).reshape(1, 3))[0]
    layers = [hit.depth for hit in surfaces_under(middle, here)]
    assert len(layers) >= 2 and layers == sorted(layers)


@in_space
def test_a_click_on_a_surface_selects_it_and_a_double_click_all_its_planes(camera):
    hand = SpaceHand(camera=camera)
    place = hand.on_surface(0.83, 0.83)
    hand.click(place)
    assert hand.session.selection == Selection.of_shapes([SAIL])
    hand.double_click(place)
    assert hand.session.selection.by_shape() == {SAIL: tuple(range(16))}


def test_in_a_view_of_a_plane_a_surface_is_seen_through_but_for_its_lines():
    hand = SpaceHand(camera=VIEWS[0])
    hand.gestures.options = ViewOptions(handles="none")
    # Halfway between the lines at nodes and between them.
    hand.click(hand.on_surface(0.42, 0.42))
    assert not hand.session.selection
    hand.click(hand.on_surface(0.0, 0.42))
    assert hand.session.selection == Selection.of_shapes([SAIL])


def test_a_curve_in_front_of_a_surface_is_taken_before_it_and_one_behind_after_it():
    for height, first in ((3.0, HELIX), (-3.0, SAIL)):
        points = [[0.0, 1.5, height], [1.5, 1.5, height], [3.0, 1.5, height]]
        curve = PlusCurve(BSpline(3, 3), ControlLines.of(points), 0.5)
        start = Design({SAIL: Shape(sail(), "Sail"), HELIX: Shape(curve, "Line")})
        camera = replace(SPACE, pitch=np.pi / 2, target=(1.5, 1.5, 0.0))
        here = stage(camera, start, options=ViewOptions(handles="none"))
        at = camera.to_screen(curve.at([0.41]))[0]
        hits = all_under(at, here)
        assert hits[0].shape == first and {hit.shape for hit in hits} == {SAIL, HELIX}


@in_space
def test_of_handles_in_one_place_the_nearest_to_the_eye_is_taken(camera):
    origin, way = camera.ray(np.array([700.0, 300.0]))
    near, far = origin + way * 6.0, origin + way * 9.0
    points = [far, near, [0.0, 0.0, 0.0]]
    curve = PlusCurve(BSpline(3, 3), ControlLines.of(points), 0.5)
    here = stage(camera, Design({HELIX: Shape(curve, "Line")}))
    assert under(np.array([700.0, 300.0]), here).number == 1
    chosen = Selection.of_lines([LineId(HELIX, 0)])
    assert under(np.array([700.0, 300.0]), replace(here, selection=chosen)).number == 0


@in_space
def test_hidden_planes_can_be_picked_unless_only_the_front_is_asked_for(camera):
    start = a_torus()
    surface = start.surface(RING)
    points = surface.planes.control_points
    behind = [number for number, is_hidden in enumerate(hidden(points, start, camera)) if is_hidden]
    assert 0 < len(behind) < len(points)
    for number in behind:
        at = camera.to_screen(points[[number]])[0]
        anything = stage(camera, start, options=ViewOptions(handles="all"))
        front = stage(camera, start, options=ViewOptions(handles="all", front_only=True))
        assert (number, 0) in {(hit.number, hit.side) for hit in handles_under(at, anything)}
        assert (number, 0) not in {(hit.number, hit.side) for hit in handles_under(at, front)}


def test_alt_click_goes_through_all_that_lies_below():
    hand = SpaceHand()
    seen = []
    for _ in range(4):
        hand.click(hand.planes[6], Held.ALT)
        seen.append(hand.session.selection)
    assert Selection.of_lines([LineId(SAIL, 6)]) in seen
    assert Selection.of_shapes([SAIL]) in seen


def test_grips_that_are_not_shown_are_not_taken():
    x, y = np.meshgrid(np.linspace(0.0, 3.0, 30), np.linspace(0.0, 3.0, 30), indexing="ij")
    planes = ControlPlanes.of(np.stack([x, y, 0.0 * x], axis=-1))
    dense = PlusSurface(BSpline(30, 4), BSpline(30, 4), planes, 1.0)
    start = Design({SAIL: Shape(dense, "Dense")})
    here = stage(start=start, options=ViewOptions(handles="all"))
    tip = plane_handles(dense, SPACE).tips[0, 435]
    assert not any(hit.number == 435 and hit.side for hit in handles_under(tip, here))
    chosen = replace(here, selection=Selection.of_lines([LineId(SAIL, 435)]))
    assert any(hit.number == 435 and hit.side for hit in handles_under(tip, chosen))


# The gizmo


@in_space
def test_every_part_of_the_gizmo_that_is_shown_can_be_taken(camera):
    hand = SpaceHand(camera=camera)
    hand.pick(6)
    here, gizmo = hand.gestures.stage(), hand.gizmo
    for axis in range(3):
        if gizmo.shown(axis):
            hit = gizmo_under(camera.to_screen(gizmo.arrow(axis)[1:])[0], here)
            assert (hit.kind, hit.axis) == ("arrow", axis)
        found = {
            (hit.kind, hit.axis)
            for at in camera.to_screen(gizmo.ring(axis))
            if (hit := gizmo_under(at, here)) is not None
        }
        assert ("ring", axis) in found


def test_what_is_taken_of_the_gizmo_lights_up_and_a_click_there_keeps_the_selection():
    hand = SpaceHand()
    hand.pick(6)
    before = hand.session.selection
    hand.gestures.move(hand.at(hand.on_arrow(2)))
    assert hand.said.items and hand.said.cursor == "move"
    hand.click(hand.on_arrow(2))
    assert hand.session.selection == before


def test_there_is_no_gizmo_where_nothing_in_space_is_selected():
    hand = SpaceHand()
    for selection in (
        Selection(),
        Selection.of_shapes([SAIL]),
        Selection.of_lines([LineId(ShapeId("bow"), 1)]),
    ):
        hand.session.select(selection)
        assert hand.gizmo is None
    hand.pick(6)
    hand.gestures.options = ViewOptions(handles="none")
    assert gizmo_under(hand.at(hand.on_arrow(2)).at, hand.gestures.stage()) is None


def test_the_gizmo_has_the_same_size_at_any_zoom():
    for height in (0.5, 6.0, 300.0):
        hand = SpaceHand(camera=replace(PARALLEL, height=height))
        hand.pick(6)
        ring = hand.gestures.camera.to_screen(hand.gizmo.ring(2))
        assert_allclose(np.ptp(ring, axis=0).max(), 128.0, atol=4.0)


# Edges of nets


@every_view
def test_an_edge_of_the_net_stands_for_its_row_of_planes(camera):
    here = stage(camera, Design({SAIL: Shape(sail(), "Sail")}))
    points = here.design.surface(SAIL).planes.control_points
    for first, second, row in ((1, 5, {1, 5, 9, 13}), (8, 9, {8, 9, 10, 11})):
        middle = points[[first, second]].mean(axis=0)
        edge = edge_under(camera.to_screen(middle[None])[0], here, 1.0)
        if isinstance(camera, SpaceCamera):
            assert {line.number for line in planes_along(edge, here).lines} == row
        else:
            assert edge is not None


def test_edges_that_are_not_drawn_are_not_taken():
    points = sail().planes.control_points
    at = SPACE.to_screen(points[[1, 5]].mean(axis=0)[None])[0]
    here = stage(options=ViewOptions(frozenset()))
    assert edge_under(at, here) is None and edge_under(at, stage()) is not None


def test_a_double_click_with_shift_adds_a_row():
    hand = SpaceHand(Design({SAIL: Shape(sail(), "Sail")}))
    hand.pick(0)
    at = hand.at(0.3 * hand.planes[8] + 0.7 * hand.planes[9], Held.SHIFT)
    hand.gestures.double_click(at)
    assert hand.session.selection.by_shape() == {SAIL: (0, 8, 9, 10, 11)}


@in_space
def test_a_box_selects_the_dots_in_it_and_surfaces_wholly_inside(camera):
    hand = SpaceHand(camera=camera)
    low = camera.to_screen(hand.planes).min(axis=0) - 100.0
    high = camera.to_screen(hand.planes).max(axis=0) + 40.0
    hand.gestures.press(replace(hand.at(hand.planes[0]), x=low[0], y=low[1]))
    hand.gestures.move(replace(hand.at(hand.planes[0]), x=high[0], y=high[1]))
    assert hand.session.selection.by_shape()[SAIL] == tuple(range(16))
