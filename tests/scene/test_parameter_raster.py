"""Faces as pixels of a view of the parameters."""

import numpy as np
import pytest

from plusedit.geometry.mesh.unfolding import NONE, Unfolding
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.parameter_raster import face_raster, fill, rims_of
from tests.geometry.mesh.mesh_surfaces import cylinder, height_field, pillow, torus

SURFACES = pytest.mark.parametrize("make", [height_field, cylinder, torus, pillow])


def filled(triangles, shape=(24, 32)):
    pixels = np.full(shape, NONE, dtype=np.int32)
    fill(pixels, np.array(triangles, dtype=float), np.arange(len(triangles), dtype=np.int32))
    return pixels


def definition(triangles, shape=(24, 32)):
    """Every pixel whose middle a triangle holds, one by one."""
    pixels = np.full(shape, NONE, dtype=np.int32)
    for number, triangle in enumerate(np.array(triangles, dtype=float)):
        for row in range(shape[0]):
            for column in range(shape[1]):
                away = triangle - (column + 0.5, row + 0.5)
                after = np.roll(away, -1, axis=0)
                sides = away[:, 0] * after[:, 1] - away[:, 1] * after[:, 0]
                if (sides > 0).all() or (sides < 0).all():
                    pixels[row, column] = number
    return pixels


@pytest.mark.parametrize("seed", range(6))
def test_a_triangle_fills_the_pixels_whose_middles_it_holds(seed):
    triangles = np.random.default_rng(seed).uniform((-9, -9), (41, 33), (3, 3, 2))
    np.testing.assert_array_equal(filled(triangles), definition(triangles))


@pytest.mark.parametrize("seed", range(6))
def test_triangles_around_a_point_leave_nothing_open_and_share_nothing(seed):
    # Whole and half numbers: many middles of pixels lie on edges.
    middle = np.random.default_rng(seed).integers(4, 40, 2) / 2.0
    rim = np.array([[0, 0], [32, 0], [32, 24], [0, 24]], dtype=float)
    triangles = np.array([[middle, a, b] for a, b in zip(rim, np.roll(rim, -1, 0), strict=True)])
    counts = sum((filled([t]) >= 0).astype(int) for t in triangles)
    assert (counts == 1).all()


def test_triangles_beside_the_view_and_without_area_fill_nothing():
    beside = [[[-5, 1], [-1, 1], [-3, 9]], [[40, 1], [60, 1], [50, 9]], [[1, 99], [9, 99], [5, 90]]]
    flat = [[[3, 3], [3, 3], [3, 3]], [[1, 5], [9, 5], [20, 5]]]
    assert (filled(beside + flat) == NONE).all()


def test_huge_triangles_are_cut_to_the_view():
    assert (filled([[[-1e15, -1e15], [1e15, -1e15], [0, 1e15]]]) == 0).all()


@SURFACES
def test_every_pixel_shows_the_face_that_is_there(make):
    unfolding = Unfolding.of(make())
    low, high = unfolding.bounds
    camera = PlaneCamera((90.0, 70.0)).framing(np.stack([low, high]), 20.0)
    count = unfolding.mesh.face_count
    numbers = face_raster(unfolding, camera, np.zeros(count, bool)).numbers
    for row, column in np.random.default_rng(2).integers(0, (70, 90), (60, 2)).tolist():
        place = camera.in_plane(np.array([[column + 0.5, row + 0.5]]))[0]
        seen, there = numbers[row, column], unfolding.face_at(place)
        is_in_cell = ((place >= low) & (place <= high)).all()
        if seen >= 0:
            assert seen % count == there
        else:
            # The images farther away than half a cell are not drawn.
            assert there == NONE or not is_in_cell


def test_images_beyond_the_cell_are_told_from_the_faces_in_it():
    unfolding = Unfolding.of(torus())
    camera = PlaneCamera((120.0, 90.0)).framing(np.stack(unfolding.bounds), 25.0)
    count = unfolding.mesh.face_count
    numbers = face_raster(unfolding, camera, np.zeros(count, bool)).numbers
    assert 0 <= numbers[45, 60] < count
    assert numbers[0, 0] >= count
    assert set(range(count)) >= set(np.unique(numbers[numbers < count]).tolist())


def test_what_is_to_lie_on_top_is_seen():
    surface = height_field()
    # All faces at one place.
    folded = np.tile(surface.parameters[:3], (surface.mesh.face_count, 1))
    unfolding = Unfolding.of(type(surface)(surface.mesh, surface.domain, folded))
    on_top = np.arange(surface.mesh.face_count) == 17
    camera = PlaneCamera((60.0, 60.0)).framing(folded, 5.0)
    numbers = face_raster(unfolding, camera, on_top).numbers
    assert set(np.unique(numbers).tolist()) == {NONE, 17}


def test_rims_are_where_numbers_change():
    values = np.array([[1, 1, 2], [1, 1, 2], [3, 3, 3]])
    expected = [[False, True, False], [True, True, True], [False, False, False]]
    assert rims_of(values).tolist() == expected
