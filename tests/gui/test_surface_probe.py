"""What the status bar says of the point of a surface under the pointer."""

import numpy as np
import pytest

from plusedit.geometry.mesh.domains import TorusDomain
from plusedit.interaction.mesh_facets import mesh_crossings
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.coloring import mesh_values
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import overlays
from plusedit.scene.space_camera import SpaceCamera
from plusedit.views.arithmetic import calculated
from plusedit.views.probe import reading
from tests.geometry.mesh.mesh_surfaces import torus as torus_mesh
from tests.geometry.test_surface_frames import sphere

TOP = PlaneCamera((800.0, 600.0), scale=100.0)
MIDDLE = np.array([400.0, 300.0])
IN_SPACE = SpaceCamera((800.0, 600.0), height=8.0, pitch=0.9)


def numbers(text):
    """What stands behind each name."""
    words = text.split()
    return {name: calculated(value) for name, value in zip(words[::2], words[1::2], strict=False)}


def test_a_surface_tells_how_it_bends():
    found = numbers(reading(sphere(0.5), TOP, MIDDLE + np.array([20.0, 10.0])))
    assert found["K"] == pytest.approx(4.0)
    assert found["H"] == found["κ₁"] == found["κ₂"] == pytest.approx(-2.0)


def test_beside_a_surface_nothing_is_told():
    assert reading(sphere(0.5), TOP, MIDDLE + np.array([300.0, 0.0])) == ""


def test_the_value_of_the_map_that_is_on_is_told():
    options = ViewOptions().with_overlay("draft", True)
    text = reading(sphere(0.5), TOP, MIDDLE + np.array([30.0, 0.0]), options)
    assert f"Draft angle {np.degrees(np.arccos(0.6)):.4g} °" in text


def test_what_is_told_anyway_is_told_once():
    options = ViewOptions().with_overlay("gaussian", True)
    pixel = MIDDLE + np.array([30.0, 0.0])
    assert reading(sphere(0.5), TOP, pixel, options) == reading(sphere(0.5), TOP, pixel)


def test_a_mesh_tells_how_it_bends_as_seen_from_its_front():
    surface = torus_mesh(smoothness=1.0)
    drawing_of(surface)
    found = numbers(reading(surface, IN_SPACE, _on_the_ring()))
    assert found["K"] == pytest.approx(found["κ₁"] * found["κ₂"], rel=1e-2, abs=1e-3)
    assert found["κ₂"] < -0.5


def test_a_mesh_tells_its_value_of_the_map_once_that_is_known():
    surface, entry = torus_mesh(smoothness=1.0), overlays["draft"]
    options = ViewOptions().with_overlay("draft", True)
    drawing = drawing_of(surface)
    assert "Draft" not in reading(surface, IN_SPACE, _on_the_ring(), options)
    mesh_values(entry, surface, drawing, entry.numbers({}))
    text = reading(surface, IN_SPACE, _on_the_ring(), options)
    assert float(text.split("Draft angle ")[1].split()[0]) > 60.0


def test_across_a_seam_parameters_run_on():
    surface = torus_mesh(smoothness=0.7)
    drawing = drawing_of(surface)
    domain = surface.domain
    assert isinstance(domain, TorusDomain)
    for turn in np.linspace(-0.1, 0.1, 21):
        pixel = IN_SPACE.to_screen(surface.at([[turn % 1.0, 0.25 * domain.height]]))[0]
        first = mesh_crossings(pixel, surface, IN_SPACE)[0]
        away = abs(first.u - turn) % 1.0
        assert min(away, 1.0 - away) < 0.08
    assert drawing.is_exact


def _on_the_ring():
    """A pixel in the middle of the tube, where it is nearest to the eye."""
    return IN_SPACE.to_screen(np.array([[0.0, -2.0, 1.0]]))[0] + np.array([0.0, 4.0])
