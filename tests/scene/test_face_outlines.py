"""What selected faces look like on the surface of a mesh."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.selection import NOTHING_SELECTED, LineId, Selection
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.face_outlines import face_fill, face_items, outline_of
from plusedit.scene.handles import ALL_UP_TO, SEVERAL, faces_handled, handle_shapes, handled
from plusedit.scene.items import Markers, Mesh, Segments
from plusedit.scene.options import ViewOptions
from plusedit.scene.plane_handles import plane_handles
from plusedit.scene.scene import scene_items
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import space_items
from tests.scene.meshes import HILL, a_hill, a_landscape

SPACE = SpaceCamera((800.0, 600.0), (0.5, 0.5, 0.2), 1.5)
TOP = PlaneCamera((800.0, 600.0), (0.5, 0.5), 400.0)
MANY = a_hill(15)
PLACE = 7 * 15 + 7


def length(drawing, pairs):
    starts, ends = drawing.lines(pairs)
    return np.linalg.norm((ends - starts)[:, :2], axis=1).sum()


def picked(*numbers):
    lines = [LineId(HILL, number) for number in numbers]
    return Selection.of_lines(lines, lines[-1])


@pytest.mark.parametrize("faces, around, between", [((0,), 4, 0), ((0, 1), 6, 1), ((0, 16), 8, 0)])
def test_an_outline_runs_around_faces_along_the_edges_of_the_mesh(faces, around, between):
    drawing = drawing_of(MANY)
    outline = outline_of(drawing.net, faces)
    assert_allclose(length(drawing, outline.around), around / 15.0)
    assert_allclose(length(drawing, outline.between), between / 15.0)


def test_the_outline_of_all_faces_is_the_boundary():
    drawing = drawing_of(MANY)
    outline = outline_of(drawing.net, tuple(range(225)))
    around, boundary = (
        set(map(frozenset, e.tolist())) for e in (outline.around, drawing.net.boundary)
    )
    assert around == boundary
    assert_allclose(length(drawing, outline.between), 2.0 * 14)


def test_no_faces_have_no_outline():
    assert not len(outline_of(drawing_of(MANY).net, ()).around)


def test_outlines_and_fills_are_kept_while_they_look_the_same():
    drawing = drawing_of(MANY)
    assert outline_of(drawing.net, (3, 4)) is outline_of(drawing.net, (3, 4))
    assert face_fill(drawing, (3, 4)) is face_fill(drawing, (3, 4))
    assert face_fill(drawing, (3, 4)) is not face_fill(drawing, (3, 5))


def test_a_fill_lies_on_the_surface_where_the_faces_are():
    drawing = drawing_of(MANY)
    fill = face_fill(drawing, (PLACE,))
    assert_allclose(fill.points[:, :2].min(axis=0), np.full(2, 7.0 / 15.0))
    assert_allclose(fill.points[:, :2].max(axis=0), np.full(2, 8.0 / 15.0))
    assert len(fill.triangles) == np.count_nonzero(drawing.net.faces == PLACE)


@pytest.mark.parametrize("items", [space_items, scene_items], ids=["space", "plane"])
def test_selected_faces_are_outlined_with_their_control_planes(items):
    camera = SPACE if items is space_items else TOP
    layers = items(a_landscape(MANY), camera, ViewOptions(), picked(PLACE))
    drawn = [item for item in layers if isinstance(item, Segments) and item.color == "selected"]
    assert any(
        len(item.starts) == len(outline_of(drawing_of(MANY).net, (PLACE,)).around) for item in drawn
    )
    dots = [item for item in layers.handles if isinstance(item, Markers)]
    assert sum(len(item.points) for item in dots) == 4
    plain = items(a_landscape(MANY), camera, ViewOptions(), Selection.of_shapes([HILL]))
    assert not plain.handles


def test_selected_faces_are_tinted_in_space():
    layers = space_items(a_landscape(MANY), SPACE, ViewOptions(), picked(PLACE))
    assert [item for item in layers.glass if isinstance(item, Mesh)]


def test_of_a_large_mesh_only_selected_planes_have_handles():
    design = a_landscape(MANY)
    assert handle_shapes(design, Selection.of_shapes([HILL]), ViewOptions()) == ()
    assert handle_shapes(design, Selection.of_shapes([HILL]), ViewOptions(handles="all")) == ()
    assert handled(design, picked(3, 7), ViewOptions()) == ((HILL, (3, 7)),)
    assert handled(design, picked(3, 7), ViewOptions(handles="none")) == ()


def test_of_many_selected_faces_the_leading_one_has_handles():
    several = range(SEVERAL)
    assert faces_handled(a_landscape(MANY), HILL, picked(*several)) == tuple(several)
    assert faces_handled(a_landscape(MANY), HILL, picked(*several, 90, 80)) == (80,)


def test_of_a_small_mesh_all_planes_have_handles():
    design = a_landscape()
    assert handled(design, NOTHING_SELECTED, ViewOptions()) == ((HILL, None),)
    assert len(plane_handles(a_hill(), SPACE).numbers) == 36 <= ALL_UP_TO


@pytest.mark.parametrize("camera", [SPACE, TOP])
def test_handles_of_some_faces_are_those_of_each_alone(camera):
    both, alone = (plane_handles(MANY, camera, faces) for faces in ((7, PLACE), (PLACE,)))
    row = both.rows_of((PLACE,))
    assert_array_equal(both.numbers, [7, PLACE])
    assert_allclose(both.corners[row], alone.corners)
    assert_allclose(both.tips_world[:, row], alone.tips_world)
    assert_array_equal(both.among((PLACE,)), [False, True])
    assert both.automatic.all()


def test_no_faces_have_no_handles():
    assert not len(plane_handles(MANY, SPACE, ()).points)


def test_lines_around_faces_are_drawn_in_the_color_asked_for():
    (line,) = face_items(drawing_of(MANY), (3,), "hover", 3.0)
    assert (line.color, line.width) == ("hover", 3.0)
