"""What is drawn over the faces in a view of parameters."""

import numpy as np
import pytest

from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Label, Markers, Polygon, Polyline, Segments
from plusedit.scene.parameter_items import (
    FEW,
    cell_items,
    circle_items,
    cone_items,
    cone_spots,
    hover_items,
    rim_items,
)
from plusedit.scene.parameter_sheet import ParameterSheet
from tests.geometry.mesh.mesh_surfaces import cylinder, height_field, pillow, torus

SURFACES = pytest.mark.parametrize("make", [height_field, cylinder, torus, pillow])
NONE = np.zeros(0, dtype=np.intp)


def seen(surface):
    """The sheet, a camera, and the images of the cell that it sees."""
    sheet = ParameterSheet.of(surface)
    camera = PlaneCamera((400.0, 300.0)).framing(np.stack(sheet.unfolding.bounds), 60.0)
    return sheet, camera, sheet.unfolding.images_within(*camera.window)


@SURFACES
def test_the_rim_of_the_cell_is_around_all_centers(make):
    sheet, _, images = seen(make())
    lines = [i for i in cell_items(sheet, images) if isinstance(i, Polyline) and len(i.points) == 2]
    rim = np.concatenate([line.points for line in lines])
    assert len(lines) == 4
    assert (rim.min(axis=0) <= sheet.unfolding.centers.min(axis=0)).all()
    assert (rim.max(axis=0) >= sheet.unfolding.centers.max(axis=0)).all()


def test_sides_that_are_sewn_together_are_dashed():
    sheet, _, images = seen(cylinder())
    lines = [i for i in cell_items(sheet, images) if isinstance(i, Polyline) and len(i.points) == 2]
    upright = [line for line in lines if line.points[0, 0] == line.points[1, 0]]
    assert {line.color for line in upright} == {"u"}
    assert {line.dash for line in upright} == {"dash"}


def test_there_are_images_around_a_torus_and_none_around_a_sheet():
    assert len(seen(torus())[2].shifts) > 4
    assert len(seen(height_field())[2].shifts) == 1


@SURFACES
def test_circles_have_the_width_of_the_gaussians(make):
    surface = make()
    sheet, camera, _ = seen(surface)
    rings, dots = circle_items(sheet, surface.sigmas, np.array([4]), camera)
    away = np.linalg.norm(rings.starts - sheet.unfolding.centers[4], axis=1)
    np.testing.assert_allclose(away, surface.sigmas[4])
    np.testing.assert_allclose(dots.points, sheet.unfolding.centers[[4]])


def test_without_a_selection_there_are_circles_of_all_faces_if_they_are_few():
    surface = height_field(9)
    sheet, camera, _ = seen(surface)
    (rings,) = circle_items(sheet, surface.sigmas, NONE, camera)
    assert len(rings.starts) % sheet.face_count == 0
    many = height_field(15)
    assert many.mesh.face_count > FEW
    sheet, camera, _ = seen(many)
    assert not list(circle_items(sheet, many.sigmas, NONE, camera))
    nearer = camera.zoomed(4.0, (200.0, 150.0))
    assert list(circle_items(sheet, many.sigmas, NONE, nearer))


def test_the_outline_of_a_face_lies_at_the_image_that_is_pointed_at():
    sheet, _, _ = seen(torus())
    center = sheet.unfolding.centers[3]
    for shift in ((0.0, 0.0), (1.0, 0.0), (0.0, -0.7)):
        (outline,) = hover_items(sheet, 3, center + shift)
        assert isinstance(outline, Polygon)
        np.testing.assert_allclose(outline.points.mean(axis=0), center + shift, atol=1e-12)


def test_a_pillow_has_four_handles_and_smaller_ones_at_their_images():
    sheet, _, images = seen(pillow())
    spots = cone_spots(sheet, images)
    own = [spot for spot in spots if spot.is_own]
    np.testing.assert_allclose([s.place for s in own], sheet.unfolding.domain.cone_points)
    assert len(spots) > 4
    marks = [item for item in cone_items(spots, None) if isinstance(item, Markers)]
    assert len({mark.size for mark in marks}) == 2
    assert {i.text for i in cone_items(spots, None) if isinstance(i, Label)} == set("ABCD")


@pytest.mark.parametrize("make", [height_field, cylinder, torus])
def test_what_is_no_pillow_has_no_handles(make):
    sheet, _, images = seen(make())
    assert cone_spots(sheet, images) == ()
    assert sheet.cone_points == ()


def test_the_cone_points_of_a_pillow_are_the_vertices_nearest_to_them():
    unfolding = seen(pillow())[0].unfolding
    for spot, vertex in zip(
        unfolding.domain.cone_points, seen(pillow())[0].cone_points, strict=True
    ):
        near = unfolding.domain.nearest(
            unfolding.vertex_places, np.broadcast_to(spot, unfolding.vertex_places.shape)
        )
        away = np.linalg.norm(near - spot, axis=1)
        assert away[vertex] == pytest.approx(away.min(), abs=1e-12)


def test_rims_are_drawn_at_every_image():
    sheet, _, images = seen(cylinder())
    items = list(rim_items(sheet, images))
    assert all(isinstance(item, Segments) for item in items)
    assert len(items) == len(images.shifts)
    assert {item.color for item in items} == {"text", "text@35"}
