"""Picking and moving surfaces of meshes."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.commands.lines import MovePoints
from plusedit.interaction.facets import hidden, point_of, surfaces_under
from plusedit.interaction.highlighting import highlight
from plusedit.interaction.mesh_facets import mesh_crossings
from plusedit.interaction.picking import inside, under
from plusedit.interaction.tool import Pointer, Stage
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.space_camera import SpaceCamera
from plusedit.tools.select import Select
from tests.scene.meshes import HILL, a_hill, a_landscape

ABOVE = SpaceCamera((800.0, 600.0), (0.5, 0.5, 0.2), 2.0, pitch=1.2)
HILLSIDE = a_hill(15)


def a_stage(camera=ABOVE, **shape):
    design = a_landscape(HILLSIDE, **shape)
    drawing_of(HILLSIDE)
    return Stage(design, camera)


@pytest.mark.parametrize("perspective", [True, False])
def test_what_lies_under_a_pixel_is_the_face_and_place_that_is_drawn_there(perspective):
    camera = SpaceCamera((800.0, 600.0), (0.5, 0.5, 0.2), 2.0, pitch=1.2, perspective=perspective)
    place = np.array([[0.31, 0.72]])
    at = camera.to_screen(HILLSIDE.at(place))[0]
    (hit,) = surfaces_under(at, a_stage(camera))
    first = mesh_crossings(at, HILLSIDE, camera)[0]
    assert_allclose((first.u, first.v), place[0], atol=5e-3)
    assert first.face == 15 * 4 + 10
    assert_allclose(point_of(hit, at, camera), HILLSIDE.at(place)[0], atol=5e-3)


def test_a_click_on_the_surface_takes_the_mesh():
    at = ABOVE.to_screen(HILLSIDE.at([[0.3, 0.7]]))[0]
    hit = under(at, a_stage())
    assert (hit.kind, hit.shape, hit.line) == ("mesh", HILL, None)
    assert list(highlight(hit, a_stage()))


@pytest.mark.parametrize("state", [{"locked": True}, {"visible": False}])
def test_locked_and_hidden_meshes_are_not_taken(state):
    at = ABOVE.to_screen(HILLSIDE.at([[0.3, 0.7]]))[0]
    assert under(at, a_stage(**state)) is None


def test_in_a_plane_view_a_mesh_is_taken_by_its_outline():
    camera = PlaneCamera((800.0, 600.0), scale=300.0, center=(0.5, 0.5))
    edge, middle = camera.to_screen(HILLSIDE.at([[0.0, 0.5], [0.2, 0.8]]))
    assert under(edge, a_stage(camera)).shape == HILL
    assert under(middle, a_stage(camera)) is None


@pytest.mark.parametrize("camera", [ABOVE, PlaneCamera((800.0, 600.0), center=(0.5, 0.5))])
def test_a_box_around_all_of_a_mesh_takes_it(camera):
    stage = a_stage(camera)
    assert inside(np.zeros(2), np.array(camera.size), stage).shapes == {HILL}
    assert not inside(np.zeros(2), np.array(camera.size) / 2.0, stage).shapes


def test_a_mesh_hides_what_lies_behind_it():
    points = HILLSIDE.at([[0.4, 0.4]]) + np.outer([-0.5, 0.5], [0.0, 0.0, 1.0])
    below, above = hidden(points, a_landscape(HILLSIDE), ABOVE)
    assert below and not above


def test_a_mesh_is_dragged_as_a_whole():
    at = ABOVE.to_screen(HILLSIDE.at([[0.3, 0.7]]))[0]
    drag = Select().drag(Pointer(*at), a_stage())
    next(drag)
    shown = drag.send(Pointer(at[0] + 40.0, at[1]))
    assert isinstance(shown.outcome, MovePoints)
    assert set(shown.outcome.targets) == {HILL}
