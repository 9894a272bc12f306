"""What a design looks like in space, and where it is framed and composed."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.testing import assert_array_equal

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId, Style
from plusedit.scene.camera import AXES, PlaneCamera
from plusedit.scene.framing import framed
from plusedit.scene.items import Label, Markers, Mesh, Patch, Polygon, Polyline, Segments
from plusedit.scene.options import USUAL, ViewOptions, view_tree
from plusedit.scene.scene import scene_items
from plusedit.scene.space_camera import STANDARD, SpaceCamera
from plusedit.scene.space_composition import composed_in_space
from plusedit.scene.space_framing import framed_in_space
from plusedit.scene.space_scene import space_items
from tests.designs import BOW, a_design, designs
from tests.geometry.surfaces import PAIRS, a_surface, random_surface

SAIL = ShapeId("sail")
SIZE = (800.0, 600.0)
CAMERA = SpaceCamera(SIZE, (1.5, 2.0, 0.0), 6.0)
BARE = ViewOptions(overlays=frozenset(), handles="none", isolines=False)


def a_scene(**changes):
    """The known curves and a surface."""
    sail = replace(Shape(a_surface(), "Sail"), **changes)
    return Design({**a_design().shapes, SAIL: sail})


def points_on(surface):
    """(400, 3)"""
    return surface.at(*[np.linspace(0.0, 1.0, 20)] * 2).reshape(-1, 3)


def patches(layers):
    return [item for item in (*layers.solids, *layers.glass) if isinstance(item, Patch)]


def test_a_surface_is_a_patch_with_edges_and_a_curve_is_a_line():
    design = a_scene()
    layers = space_items(design, CAMERA, BARE)
    (patch,) = layers.solids
    assert patch.surface is design.surface(SAIL)
    assert len([line for line in layers.lines if line.color == "line"]) >= 4
    assert len([line for line in layers.lines if line.color == "plus"]) == 2
    assert not layers.handles


def test_isolines_are_yellow_where_u_runs_and_magenta_where_v_runs():
    layers = space_items(a_scene(), CAMERA, replace(BARE, isolines=True))
    surface = a_scene().surface(SAIL)
    for line in layers.lines:
        if line.color.startswith(("u", "v")):
            ends = surface.at([0.0, 1.0], [0.0, 1.0])[..., 0 if line.color[0] == "v" else 1]
            along = line.points[:, 0 if line.color[0] == "v" else 1]
            assert ends.min() - 1e-9 <= along.min() <= along.max() <= ends.max() + 1e-9
    assert {line.color[0] for line in layers.lines} >= {"u", "v"}


def test_the_same_design_gives_the_same_patch_and_lines_from_elsewhere():
    design = a_scene()
    first = space_items(design, CAMERA, ViewOptions())
    second = space_items(design, CAMERA.orbited(0.3, 0.1), ViewOptions())
    assert first.solids[0] is second.solids[0]
    inner = [[i for i in layers.lines if i.color.startswith("u@")] for layers in (first, second)]
    assert inner[0]
    assert all(a is b for a, b in zip(*inner, strict=True))


def test_a_change_of_s_keeps_the_control_planes_and_grids_of_the_patch():
    design = a_scene()
    shape = design[SAIL]
    other = design.with_shape(SAIL, shape.with_plus(replace(shape.surface, s=0.7)))
    (old,), (new,) = (space_items(d, CAMERA, BARE).solids for d in (design, other))
    assert new.surface.planes is old.surface.planes
    assert new.grid_u is old.grid_u


def test_locked_shapes_are_seen_through_and_hidden_ones_left_out():
    locked = space_items(a_scene(locked=True), CAMERA, BARE)
    assert not locked.solids
    assert patches(locked)[0].front == "front@45"
    assert not patches(space_items(a_scene(visible=False), CAMERA, BARE))


def test_a_surface_has_its_own_color_with_a_darker_back():
    (patch,) = space_items(a_scene(style=Style("#8090a0")), CAMERA, BARE).solids
    assert (patch.front, patch.back) == ("#8090a0", "#5C6873")


def test_a_selected_surface_glows_along_its_edges():
    layers = space_items(a_scene(), CAMERA, BARE, Selection.of_shapes([SAIL]))
    assert len([line for line in layers.lines if line.color == "selected@28"]) >= 4


def test_the_gizmo_of_the_selection_is_in_front_of_everything():
    selection = Selection.of_lines([LineId(SAIL, 6)])
    usual = ViewOptions()
    assert space_items(a_scene(), CAMERA, usual, selection).labels
    assert not space_items(a_scene(), CAMERA, BARE, selection).labels
    assert not space_items(a_scene(), CAMERA, usual).labels


def test_a_draft_has_coarser_patches():
    near = replace(CAMERA, height=2.0)
    fine, draft = (space_items(a_scene(), near, BARE, draft=d).solids[0] for d in (False, True))
    assert len(draft.grid_u) < len(fine.grid_u)


def test_only_the_shapes_that_are_asked_for_are_drawn():
    layers = space_items(a_scene(), CAMERA, ViewOptions(), only={BOW})
    assert not layers.solids
    assert layers.lines


def test_hulls_are_seen_through():
    layers = space_items(a_scene(), CAMERA, ViewOptions(frozenset({"hulls"}), "none"))
    bodies = [item for item in layers.glass if isinstance(item, Mesh)]
    assert len(bodies) == 5
    assert [item for item in layers.glass if isinstance(item, Polygon)]


@pytest.mark.parametrize("perspective", [True, False])
def test_everything_ends_up_in_one_layer(perspective):
    options = ViewOptions(frozenset({"classical", "polygon", "hulls", "nodes", "names"}), "all")
    layers = space_items(a_scene(), replace(CAMERA, perspective=perspective), options)
    kinds = [set(map(type, getattr(layers, name))) for name in ("solids", "glass", "lines")]
    assert kinds[0] == {Patch}
    assert kinds[1] == {Mesh, Polygon}
    assert kinds[2] <= {Polyline, Segments, Markers}
    assert {type(item) for item in layers.labels} == {Label}


@settings(max_examples=20)
@given(designs)
def test_whatever_a_file_can_hold_can_be_drawn_in_space(design):
    for item in space_items(design, CAMERA, ViewOptions(handles="all")):
        for value in vars(item).values():
            if isinstance(value, np.ndarray):
                assert np.isfinite(value).all()


# In the plane


@pytest.mark.parametrize("kinds", PAIRS)
def test_the_plane_view_shows_surfaces_as_lines_along_every_axis(kinds):
    design = Design({SAIL: Shape(random_surface(*kinds), "Sail")})
    for projection in AXES:
        camera = PlaneCamera(SIZE, projection=projection)
        items = list(scene_items(design, camera, ViewOptions()))
        assert [item for item in items if isinstance(item, Polyline)]
        assert not [item for item in items if isinstance(item, Patch | Mesh)]


def test_framing_the_plane_sees_all_of_a_surface():
    design = Design({SAIL: Shape(a_surface(), "Sail")})
    for projection in AXES:
        camera = framed(design, PlaneCamera(SIZE, projection=projection), ViewOptions())
        screen = camera.to_screen(
            design.surface(SAIL).at(*[np.linspace(0, 1, 20)] * 2).reshape(-1, 3)
        )
        assert (screen >= 0.0).all()
        assert (screen <= SIZE).all()


# Framing and composing


@pytest.mark.parametrize("view", list(STANDARD))
def test_framing_sees_everything_and_keeps_the_direction(view):
    design = a_scene()
    before = SpaceCamera.standard(view, SIZE)
    camera = framed_in_space(design, before, ViewOptions(), margin=20.0)
    assert (camera.yaw, camera.pitch) == (before.yaw, before.pitch)
    points = [points_on(design.surface(SAIL)), *(g.net.control_points for _, g in design.drawn())]
    screen = np.concatenate([camera.to_screen(rows) for rows in points])
    assert (screen >= 18.0).all()
    assert (screen <= np.array(SIZE) - 18.0).all()


def test_framing_nothing_changes_nothing():
    assert framed_in_space(Design(), CAMERA, ViewOptions()) is CAMERA


def test_framing_some_shapes_looks_at_them_alone():
    options = ViewOptions(handles="none")
    near = framed_in_space(a_scene(), CAMERA, options, only=[BOW])
    assert near == framed_in_space(a_scene().without(SAIL, ShapeId("wing")), CAMERA, options)


def test_a_composition_looks_as_the_design_says_from_where_it_fits():
    kept = replace(CAMERA, yaw=1.0, pitch=0.2, perspective=False)
    design = replace(a_scene(), view=view_tree(USUAL, camera_3d=kept, old={}))
    camera = composed_in_space(design, SIZE).camera
    assert (camera.yaw, camera.pitch, camera.perspective) == (1.0, 0.2, False)
    assert composed_in_space(design, SIZE, "top").camera.pitch == np.pi / 2.0
    assert composed_in_space(a_scene(), SIZE).camera.perspective


def test_a_composition_shows_the_ground_only_where_it_is_asked_for():
    assert not composed_in_space(a_scene(), SIZE).options.ground
    asked = replace(a_scene(), view={"ground": True})
    assert composed_in_space(asked, SIZE).options.ground


def test_an_unknown_view_is_told_with_those_there_are():
    with pytest.raises(KeyError, match="top"):
        composed_in_space(a_scene(), SIZE, "sideways")


def test_composing_leaves_the_design_as_it_is():
    design = a_scene()
    before = dict(design.shapes)
    composed_in_space(design, (300.0, 200.0))
    assert_array_equal([design.shapes[i] is s for i, s in before.items()], True)
