import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.coloring import mesh_values
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.items import Caption, Segments
from plusedit.scene.overlays import Seen, overlays
from tests.geometry.curves import random_curve
from tests.geometry.surfaces import a_surface
from tests.scene.meshes import a_hill

ENTRY = overlays["against_classical"]
CAMERA = PlaneCamera((800.0, 600.0), scale=200.0)


def seen(**settings):
    return Seen(CAMERA, settings={**ENTRY.numbers({}), **settings})


def hairs(curve, **settings):
    items = ENTRY.draw(Shape(curve, "bow"), curve, seen(**settings))
    return next(item for item in items if isinstance(item, Segments))


def caption(chosen=(), **geometries):
    shapes = {ShapeId(name): Shape(geometry, name) for name, geometry in geometries.items()}
    items = list(ENTRY.draw_design(Design(shapes), frozenset(chosen), seen()))
    assert all(isinstance(item, Caption) for item in items)
    return [(row.text, row.value) for item in items for row in item.rows]


def test_hairs_join_points_of_equal_parameters():
    curve = random_curve("bspline")
    drawn = hairs(curve)
    u = np.linspace(0.0, 1.0, len(drawn.starts))
    assert_allclose(drawn.starts, curve.classical.at(u))
    assert_allclose(drawn.ends, curve.at(u))


def test_density_makes_more_of_them():
    curve = random_curve("bspline")
    assert len(hairs(curve, density=40.0).starts) > 3 * len(hairs(curve, density=8.0).starts)


def test_a_classical_curve_has_none():
    curve = random_curve("bspline").classical
    assert not list(ENTRY.draw(Shape(curve, "bow"), curve, seen()))


def test_the_caption_tells_of_one_shape_in_full_and_of_several_the_farthest_first():
    curve = random_curve("bspline")
    assert [text for text, _ in caption(bow=curve)] == ["bow", "largest distance", "rms"]
    rows = caption(near=curve, still=curve.classical, surface=a_surface(s=100.0))
    assert [text for text, _ in rows] == ["largest distance, rms", "surface", "near"]


def test_it_tells_of_the_selected_shapes_alone():
    curve = random_curve("bspline")
    rows = caption(["one"], one=curve, two=a_surface())
    assert rows[0] == ("one", "")


@pytest.mark.parametrize("s", [0.0, 1.0, 2.0])
def test_meshes_depart_in_proportion_to_s(s):
    once, scaled = a_hill(s=1.0), a_hill(s=s)
    values = [
        mesh_values(ENTRY, hill, drawing_of(hill), seen().settings) for hill in (once, scaled)
    ]
    assert_allclose(values[1], s * values[0], atol=1e-9)
    rows = dict(caption(hill=scaled))
    assert rows["largest distance"] == f"{values[1].max():.4g} units"
