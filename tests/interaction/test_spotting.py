"""The point of a shape under the pointer, and what overlays draw there."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.interaction.spotting import (
    NEAR,
    is_followed,
    nearest_on_curve,
    place_under,
    spot_items,
    spot_under,
)
from plusedit.interaction.tool import Stage
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.options import ViewOptions
from plusedit.scene.space_camera import SpaceCamera
from tests.geometry.surfaces import a_surface
from tests.scene.meshes import a_hill

PLANE = PlaneCamera((800.0, 600.0), scale=100.0)
SPACE = SpaceCamera((800.0, 600.0), height=4.0)


def segment(y, dimension=2):
    """From -1 to 1 at a height."""
    points = np.array([[-1.0, y, 0.0], [1.0, y, 0.0]])[:, :dimension]
    return PlusCurve(Bernstein(2), ControlLines.of(points), 0.0)


def a_stage(*geometries, camera=PLANE, chosen=(), overlays=("circle",)):
    design = Design({str(place): Shape(g, "") for place, g in enumerate(geometries)})
    selection = Selection(frozenset(), frozenset(chosen))
    return Stage(design, camera, selection, ViewOptions(overlays=frozenset(overlays)))


def at(point, camera=PLANE, by=(0.0, 0.0)):
    return camera.to_screen(np.array([point]))[0] + by


@pytest.mark.parametrize("camera", [PLANE, SPACE], ids=["plane", "space"])
def test_the_curve_under_the_pointer_is_spotted_at_its_nearest_point(camera):
    stage = a_stage(segment(0.0), segment(1.0), camera=camera)
    spot = spot_under(at([0.5, 1.0], camera, (0.0, 3.0)), stage)
    assert spot.shape == "1"
    assert_allclose(spot.place, 0.75, atol=0.02)


def test_far_from_all_nothing_is_spotted_unless_a_curve_is_selected():
    pixel = at([0.0, 0.0], by=(0.0, 3.0 * NEAR))
    assert spot_under(pixel, a_stage(segment(0.0))) is None
    assert spot_under(pixel, a_stage(segment(0.0), segment(2.0), chosen=["1"])).shape == "1"


def test_what_is_held_stays_spotted_beside_others():
    stage = a_stage(segment(0.0), segment(1.0))
    spot = spot_under(at([0.0, 1.0]), stage, "0")
    assert spot.shape == "0"
    assert_allclose(spot.place, 0.5)
    assert spot_under(at([0.0, 1.0]), stage, "gone") is None


@pytest.mark.parametrize("camera", [PLANE, SPACE], ids=["plane", "space"])
def test_a_surface_is_spotted_where_it_lies_under_the_pointer(camera):
    surface = a_surface()
    point = surface.derivatives_at([[0.4, 0.6]], highest=0)[0][0]
    pixel = at(point, camera)
    spot = spot_under(pixel, a_stage(surface, camera=camera))
    found = surface.derivatives_at([spot.place], highest=0)[0][0]
    assert_allclose(at(found, camera), pixel, atol=0.5)
    assert place_under(surface, np.array([1.0, 1.0]), camera) is None


def test_the_surface_of_a_mesh_is_spotted_with_its_parameters():
    hill = a_hill()
    stage = a_stage(hill, camera=SpaceCamera.standard("top", (800.0, 600.0)))
    spot = spot_under(np.array([400.0, 300.0]), stage)
    assert spot is not None
    assert len(spot.place) == 2


def test_in_space_a_surface_hides_curves_behind_it_but_not_those_before():
    top = SpaceCamera.standard("top", (800.0, 600.0))
    surface = a_surface()
    middle = surface.derivatives_at([[0.5, 0.5]], highest=0)[0][0]

    def line(height):
        ends = middle + np.array([[-0.1, 0.0, height], [0.1, 0.0, height]])
        return PlusCurve(Bernstein(2), ControlLines.of(ends), 0.0)

    pixel = at(middle, top)
    assert spot_under(pixel, a_stage(surface, line(2.0), camera=top)).shape == "1"
    assert spot_under(pixel, a_stage(surface, line(-2.0), camera=top)).shape == "0"


def test_the_nearest_point_is_that_of_the_curve_as_it_is_drawn():
    points = np.array([[0.0, 0.0], [1.0, 2.0], [2.0, -2.0], [3.0, 0.0]])
    curve = PlusCurve(Bernstein(4), ControlLines.of(points), 1.0)
    for u in (0.0, 0.2, 0.55, 1.0):
        distance, found = nearest_on_curve(curve, at(curve.at([u])[0]), PLANE)
        assert distance < 0.3
        assert_allclose(found, u, atol=2e-3)


def test_only_overlays_that_follow_the_pointer_and_are_on_draw_there():
    stage = a_stage(segment(0.0))
    spot = spot_under(at([0.0, 0.0]), stage)
    assert is_followed(stage) and list(spot_items(spot, stage))
    other = replace(stage, options=ViewOptions(overlays=frozenset({"comb", "polygon"})))
    assert not is_followed(other) and not list(spot_items(spot, other))
