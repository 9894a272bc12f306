"""How far surfaces of meshes are from their meshes, by what is drawn of them."""

import numpy as np
import pytest

from plusedit.geometry.mesh.deviation import deviation
from plusedit.scene.drawn_deviation import drawn_deviation
from plusedit.scene.drawn_mesh import drawing_of
from tests.geometry.mesh.mesh_surfaces import torus
from tests.scene.meshes import a_hill

TURN = np.array([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]])


@pytest.mark.parametrize("made", [a_hill, torus])
def test_a_surface_is_as_far_from_its_mesh_after_both_were_moved(made):
    surface = made(s=0.8)
    before = drawn_deviation(surface, drawing_of(surface)).to_surface
    moved = surface.transformed(2.0 * TURN, [1.0, -2.0, 3.0])
    after = drawn_deviation(moved, drawing_of(moved)).to_surface
    assert (after.rms, after.largest) == pytest.approx((2.0 * before.rms, 2.0 * before.largest))


@pytest.mark.parametrize("made", [a_hill, torus])
def test_it_is_what_is_found_without_a_drawing(made):
    surface = made(s=0.8)
    found, wanted = drawn_deviation(surface, drawing_of(surface)), deviation(surface)
    assert found.to_surface.rms == pytest.approx(wanted.to_surface.rms, rel=1e-4)
