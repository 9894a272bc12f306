"""Parts are split where that helps, and get parameters."""

import numpy as np
from numpy.testing import assert_array_equal

from plusedit.geometry.mesh.mapping import carried, mapped
from plusedit.geometry.mesh.refine import refined
from plusedit.geometry.mesh.splitting import Wishes, split_and_mapped
from tests.geometry.mesh.bodies import cube, cylinder, sheet
from tests.geometry.mesh.mapped_bodies import areas_of, assert_seams_fit, ball


def test_even_parts_are_mapped_as_they_are():
    mesh = ball(3)
    found = split_and_mapped(mesh)
    assert found.mesh is mesh
    assert found.notes == ()
    assert_array_equal(found.mapped.parameters, mapped(mesh).parameters)


def test_thin_faces_are_split_unless_it_is_not_wished():
    mesh = cylinder(12, 60.0)
    finer = split_and_mapped(mesh, Wishes(wanted=500))
    assert finer.notes == refined(mesh, wanted=500).notes
    assert finer.notes[0].endswith("because of 24 thin faces")
    assert split_and_mapped(mesh, Wishes(wanted=3000)).mesh.face_count > 3000
    as_it_is = split_and_mapped(mesh, Wishes(refine=False))
    assert as_it_is.mesh is mesh
    assert as_it_is.notes[0] == "24 thin faces would better be split"


def test_faces_that_reach_half_around_are_split():
    found = split_and_mapped(cube())
    assert found.mesh.face_count == 96
    assert found.notes == ("the faces were split into 96: some were half of the map",)


def test_endless_limbs_keep_their_faces_apart():
    mesh = ball(2, (1.0, 1.0, 300.0))
    fine = refined(mesh, wanted=4000)
    assert mapped(fine.mesh).notes
    found = split_and_mapped(mesh, Wishes(wanted=4000))
    assert found.mesh.face_count == fine.mesh.face_count
    assert_array_equal(found.mapped.parameters, carried(mapped(mesh), fine).parameters)
    assert found.notes == fine.notes
    assert areas_of(found.mesh, found.mapped.parameters).min() > 0.0
    assert_seams_fit(found.mesh, found.mapped)


def test_a_map_that_does_not_suit_is_told_and_another_one_taken():
    found = split_and_mapped(sheet(4, 4), Wishes(map_name="torus"))
    assert found.mapped.name == "height_field"
    assert found.notes == ("the map 'torus' does not suit this part: it has no handles, not one",)


def test_texture_coordinates_are_split_with_the_faces():
    mesh = sheet(1, 40)
    uv = mesh.vertices[mesh.corners, :2] * 0.01
    longer = mesh.with_vertices(mesh.vertices * (1.0, 30.0, 1.0))
    found = split_and_mapped(longer, Wishes(uv=uv, map_name="file_uv"))
    assert found.mesh.face_count > 40
    places = found.mesh.vertices[found.mesh.corners, :2] / (100.0, 3000.0)
    np.testing.assert_allclose(found.mapped.parameters, places, atol=1e-12)
