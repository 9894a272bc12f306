import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from plusedit.document.selection import Selection
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.interaction.picking import (
    curves_under,
    handles_under,
    inside,
    nearest_on_segments,
    under,
)
from plusedit.interaction.places import in_world
from plusedit.interaction.tool import REACH, Stage
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.handles import handles
from plusedit.scene.options import ViewOptions
from tests.interaction.hand import BOW, CAMERA, WAVE, design


def stage(start=None, **changes):
    return Stage(design() if start is None else start, CAMERA, **changes)


pixels = st.tuples(st.floats(150.0, 650.0), st.floats(150.0, 600.0)).map(np.array)


@settings(max_examples=50)
@given(pixels)
def test_handles_are_found_as_by_looking_at_each(at):
    here = stage()
    expected = set()
    for shape_id, curve in here.design.curves():
        stand = handles(curve, CAMERA)
        for number in range(len(curve.lines)):
            for side, place in (0, stand.points), (1, stand.tips[0]), (-1, stand.tips[1]):
                if (side == 0 or stand.drawn[number]) and np.hypot(*(place[number] - at)) <= REACH:
                    expected.add((shape_id, number, side))
    found = [(hit.shape, hit.number, hit.side) for hit in handles_under(at, here)]
    assert set(found) == expected and len(found) == len(expected)


@settings(max_examples=50)
@given(pixels)
def test_a_curve_is_found_where_its_nearest_point_is_near(at):
    here = stage()
    for shape_id, curve in here.design.curves():
        screen = CAMERA.to_screen(curve.at(np.linspace(0.0, 1.0, 4001)))
        nearest = np.hypot(*(screen - at).T).min()
        hits = {hit.shape: hit for hit in curves_under(at, here)}
        if nearest < REACH - 0.5:
            assert_allclose(hits[shape_id].distance, nearest, atol=0.5)
            there = CAMERA.to_screen(curve.at([hits[shape_id].u]))[0]
            assert_allclose(np.hypot(*(there - at)), nearest, atol=0.5)
        elif nearest > REACH + 0.5:
            assert shape_id not in hits


def test_handles_come_before_curves():
    start = CAMERA.to_screen(np.array([[0.0, 0.0]]))[0]
    assert under(np.add(start, (0.0, 6.0)), stage()).kind in ("dot", "grip")


def test_a_grip_wins_over_a_dot_only_when_it_is_nearer():
    lines = ControlLines.of([[0, 0], [0.4, 0.0], [4, 0]], [[1.0, 0.0], [1.0, 0.0], [1.0, 0.0]])
    curve = PlusCurve(BSpline(3, 3), lines, 0.8)
    assert_allclose(handles(curve, CAMERA).tips[0][0], CAMERA.to_screen(lines.points)[1])
    here = stage(design(wave=curve))
    dot = CAMERA.to_screen(lines.points)[1]
    assert (under(dot, here).kind, under(dot, here).number) == ("dot", 1)


def test_of_handles_in_one_place_that_of_the_front_shape_is_taken():
    start = design(wave=PlusCurve(BSpline(2, 2), ControlLines.of([[0, 0], [1, 0]]), 0.5))
    both = start.with_shape(BOW, start[WAVE])
    assert under(CAMERA.to_screen(np.zeros((1, 2)))[0], stage(both)).shape == BOW


def test_a_box_takes_the_shapes_that_it_holds():
    everything = inside(np.zeros(2), np.array(CAMERA.size), stage())
    assert everything.shapes == {WAVE, BOW} and len(everything.lines) == 8
    hidden = inside(np.zeros(2), np.array(CAMERA.size), stage(options=ViewOptions(handles="none")))
    assert hidden == Selection.of_shapes([WAVE, BOW])


def test_ten_thousand_handles_are_looked_at_together():
    count = 10_000
    points = np.column_stack([np.arange(count) / 10.0, np.zeros(count)])
    curve = PlusCurve(BSpline(count, 4), ControlLines.of(points), 1.0)
    here = stage(design(wave=curve), options=ViewOptions(handles="all"))
    hits = handles_under(CAMERA.to_screen(points[[37]])[0], here)
    assert (hits[0].kind, hits[0].number) == ("dot", 37)


def test_the_nearest_point_of_a_segment_may_be_inside_or_at_an_end():
    starts, ends = np.array([[0.0, 0.0]] * 3), np.array([[4.0, 0.0], [4.0, 0.0], [0.0, 0.0]])
    for at, shares in (((1.0, 2.0), (0.25, 0.25, 0.0)), ((9.0, 0.0), (1.0, 1.0, 0.0))):
        along, distances = nearest_on_segments(np.array(at), starts, ends)
        assert_allclose(along, shares)
        places = starts + along[:, None] * (ends - starts)
        assert_allclose(distances, np.hypot(*(places - at).T))


@pytest.mark.parametrize("projection", ["top", "front", "right"])
def test_pixels_are_seen_where_they_were_put_into_the_world(projection):
    camera = PlaneCamera((800.0, 600.0), (1.0, 2.0), 50.0, projection)
    pixels = np.array([[10.0, 20.0], [700.0, 300.0]])
    assert_allclose(camera.to_screen(in_world(pixels, camera)), pixels)
