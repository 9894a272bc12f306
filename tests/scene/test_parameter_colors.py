"""The colors of faces in a view of parameters, and what they stand for."""

import numpy as np
import pytest

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.flattening.distortion import Stretch
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.parameter_colors import (
    LOUD,
    MEASURES,
    FaceColors,
    legend_of,
    painted,
    scale_of,
    shares,
)
from plusedit.scene.parameter_raster import face_raster
from plusedit.scene.parameter_sheet import ParameterSheet
from plusedit.scene.theme import DARK, LIGHT, contrast

NONE = np.zeros(0, dtype=np.intp)
PLACES = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


def two_triangles(**moved):
    """A square of two triangles, the second of which may be turned over in the parameters."""
    mesh = PolygonMesh.of(np.column_stack([PLACES, np.zeros(4)]), [(0, 1, 2), (0, 2, 3)])
    places = PLACES.copy()
    for vertex, place in moved.items():
        places[int(vertex[1:])] = place
    return MeshSurface(mesh, PlaneDomain(), places[mesh.corners])


def picture(surface, chosen=NONE, theme=LIGHT, measure="angles"):
    sheet = ParameterSheet.of(surface)
    camera = PlaneCamera((80.0, 80.0)).framing(np.stack(sheet.unfolding.bounds), 8.0)
    raster = face_raster(sheet.unfolding, camera, sheet.flipped)
    return painted(raster, sheet, FaceColors.of(sheet, measure, theme), chosen)


def test_what_keeps_angles_lies_at_the_low_end_and_more_than_fourfold_at_the_high_one():
    stretch = Stretch(np.array([1.0, 2.0, 4.0, 9.0, np.inf]), np.ones(5))
    np.testing.assert_allclose(shares("angles", stretch), [0.0, 0.5, 1.0, 1.0, 1.0])


def test_areas_lie_in_the_middle_where_they_have_their_share():
    stretch = Stretch(np.ones(5), np.array([1.0, 10.0, 0.1, 0.0, 1e9]))
    np.testing.assert_allclose(shares("areas", stretch), [0.5, 0.75, 0.25, 0.0, 1.0])


@pytest.mark.parametrize("measure", MEASURES)
def test_ticks_stand_where_their_values_lie(measure):
    legend = legend_of(measure, Stretch(np.ones(1), np.ones(1)), LIGHT)
    for share, text in legend.ticks:
        above, _, below = text.partition("/")
        value = np.array([float(above) / float(below or 1.0)])
        found = shares(measure, Stretch(np.maximum(value, 1.0), value))
        assert found[0] == pytest.approx(share)
    assert legend.is_open == (False, False)


def test_a_legend_is_open_where_values_lie_beyond():
    assert legend_of("angles", Stretch(np.array([5.0]), np.ones(1)), LIGHT).is_open == (False, True)
    assert legend_of("areas", Stretch(np.ones(1), np.array([1e-3])), DARK).is_open == (True, False)


@pytest.mark.parametrize("theme", [LIGHT, DARK])
def test_beside_the_faces_pixels_are_clear_and_on_them_opaque(theme):
    pixels = picture(two_triangles(), theme=theme)
    assert pixels[2, 2] == 0
    assert (pixels[20:60, 20:60] >> 24 == 255).all()


@pytest.mark.parametrize("theme", [LIGHT, DARK])
def test_what_the_map_leaves_as_it_is_stands_out_least_from_the_ground(theme):
    for measure, middle in (("angles", 0.0), ("areas", 0.5)):
        scale = scale_of(measure, theme)
        shares_of = np.linspace(0.0, 1.0, 9)
        colors = scale.hexadecimal(9)
        contrasts = [contrast(color, theme.color("canvas")) for color in colors]
        assert shares_of[int(np.argmin(contrasts))] == middle


def test_a_face_that_is_turned_over_is_loud_and_striped():
    sheet = ParameterSheet.of(two_triangles(v3=(1.2, 0.1)))
    assert sheet.flips == 1
    assert sheet.flipped.tolist() == [False, True]
    pixels = picture(two_triangles(v3=(1.2, 0.1)))
    found = set(np.unique(pixels).tolist())
    assert int("FF" + LOUD[1:], 16) in found
    assert 0xFFFFFFFF in found
    assert int("FF" + LOUD[1:], 16) not in set(np.unique(picture(two_triangles())).tolist())


def test_selected_faces_have_another_color_and_an_outline():
    plain, chosen = picture(two_triangles()), picture(two_triangles(), np.array([1]))
    lower, upper = (50, 60), (30, 20)
    assert plain[lower] == chosen[lower]
    assert plain[upper] != chosen[upper]
    accent = int("FF" + LIGHT.color("selected")[1:], 16)
    assert np.count_nonzero(chosen == accent) > 64
    assert not np.count_nonzero(plain == accent)


def test_faces_are_outlined_where_they_are_large_enough_to_be_seen():
    pixels = picture(two_triangles())
    assert len(np.unique(pixels)) == 3  # clear, faces, outline
