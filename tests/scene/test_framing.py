import numpy as np
import pytest

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.scene.camera import AXES, PlaneCamera
from plusedit.scene.composition import composed
from plusedit.scene.framing import framed
from plusedit.scene.items import Label, Markers, Segments
from plusedit.scene.options import ViewOptions
from plusedit.scene.scene import scene_items
from tests.designs import BOW, WING, a_design
from tests.geometry.curves import random_curve

CAMERA = PlaneCamera((800.0, 500.0), (1000.0, 1000.0), 1e-3)
ALL = ViewOptions(frozenset({"classical", "polygon", "hulls", "names"}), "all")


def on_screen(items, camera):
    """All places of items, in pixels."""
    rows = []
    for item in items:
        match item:
            case Segments(starts, ends):
                rows += [starts, ends]
            case Label(at):
                rows.append(at[None])
            case _:
                rows.append(item.points)
    return np.concatenate([camera.to_screen(points) for points in rows])


@pytest.mark.parametrize("projection", AXES)
def test_all_that_is_drawn_is_seen_grips_and_all(projection):
    shape = Shape(random_curve("bspline", dimension=3), "Helix")
    design = Design({ShapeId("helix"): shape})
    camera = framed(design, PlaneCamera((800.0, 500.0), projection=projection), ALL, margin=20.0)
    screen = on_screen(scene_items(design, camera, ALL), camera)
    # Grips keep their size while the view is fitted: a few rounds leave a pixel or so.
    assert (screen > 10.0).all()
    assert (screen < np.array(camera.size) - 10.0).all()


def test_a_framed_design_fills_the_view():
    camera = framed(a_design(), CAMERA, ViewOptions(handles="none"), margin=20.0)
    screen = on_screen(scene_items(a_design(), camera, ViewOptions(handles="none")), camera)
    extent = screen.max(axis=0) - screen.min(axis=0)
    assert (extent > np.array(camera.size) - 60.0).any()


def test_framing_some_shapes_leaves_the_others_out():
    options = ViewOptions(handles="none")
    near = framed(a_design(), CAMERA, options, only=[BOW])
    assert near == framed(a_design().without(WING), CAMERA, options)


def test_an_empty_design_leaves_the_camera_where_it_is():
    assert framed(Design(), CAMERA, ALL) is CAMERA


def test_a_picture_shows_the_overlays_and_handles_that_the_design_asks_for():
    design = Design(a_design().shapes, view={"overlays": ["names"], "handles": "none"})
    layers = composed(design, (300.0, 200.0)).layers
    assert [item.text for item in layers.marks] == ["wing", "Bow"]
    assert not layers.handles


@pytest.mark.parametrize("asked", [True, False])
def test_a_picture_has_a_grid_only_if_the_design_asks_for_one(asked):
    design = Design(a_design().shapes, view={"grid": True} if asked else {})
    assert bool(composed(design, (300.0, 200.0)).grid) == asked


def test_a_tiny_picture_can_be_composed():
    assert list(composed(a_design(), (1.0, 1.0)))


def test_a_design_of_one_point_can_be_composed():
    curve = random_curve("bezier")
    lines = curve.lines.with_points(np.ones_like(curve.lines.points))
    picture = composed(Design({WING: Shape(type(curve)(curve.basis, lines, 0.0), "dot")}), (90, 60))
    marks = [item for item in picture if isinstance(item, Markers)]
    assert np.isfinite(on_screen(marks, picture.camera)).all()
