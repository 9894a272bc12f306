"""What surfaces of meshes look like, and how long what was evaluated is kept."""

import gc
from dataclasses import replace
from weakref import ref

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import Style
from plusedit.geometry.mesh.evaluation import points_and_normals
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene import drawn_mesh
from plusedit.scene.camera import AXES, PlaneCamera
from plusedit.scene.drawn_mesh import (
    drawing_of,
    keep,
    known_before,
    known_drawing,
    looks_alike,
    previewed,
)
from plusedit.scene.framing import framed
from plusedit.scene.items import Mesh, Polyline, Segments
from plusedit.scene.mesh_drawing import vertex_normals
from plusedit.scene.mesh_nets import net_of, polygon_edges
from plusedit.scene.mesh_shapes import SHORTEST, mesh_silhouette
from plusedit.scene.options import ViewOptions
from plusedit.scene.scene import scene_items
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_framing import framed_in_space
from plusedit.scene.space_scene import space_items
from tests.geometry.mesh.mesh_surfaces import torus
from tests.scene.meshes import HILL, a_hill, a_landscape

CAMERA = SpaceCamera((800.0, 600.0), (0.5, 0.5, 0.2), 2.0)
BARE = ViewOptions(overlays=frozenset(), handles="none", isolines=False)
MIRRORED = np.array([[0.6, -0.8, 0.1], [0.8, 0.6, 0.0], [0.2, 0.0, -1.5]])
TURN = np.array([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]])


def the_mesh(layers):
    (item,) = [item for item in (*layers.solids, *layers.glass) if isinstance(item, Mesh)]
    return item


# Drawings


def test_a_drawing_is_the_surface_at_the_places_of_its_net():
    surface = a_hill()
    drawing = drawing_of(surface)
    assert drawing.is_exact
    assert_array_equal(drawing.points, surface.at(drawing.net.places))


def test_small_meshes_are_drawn_finer_than_they_are_and_keep_their_vertices():
    surface = a_hill()
    net = net_of(surface)
    count = surface.mesh.vertex_count
    assert len(net.triangles) > 20 * surface.mesh.face_count
    assert_allclose(net.places[:count], surface.vertex_places)


def test_the_edges_of_a_net_run_along_those_of_the_polygons():
    surface = a_hill(3)
    net = net_of(surface)
    # On a height field with parameters x and y, edges are lines of constant x or y.
    starts, ends = net.places[net.edges[:, 0]], net.places[net.edges[:, 1]]
    assert ((starts == ends).sum(axis=1) == 1).all()
    assert_allclose(3.0 * starts[starts == ends] % 1.0, 0.0, atol=1e-12)
    length = np.abs(ends - starts).sum()
    assert_allclose(length, 8.0)
    assert_allclose(np.abs(np.diff(net.places[net.boundary], axis=1)).sum(), 4.0)


def test_each_triangle_lies_in_the_face_that_it_says():
    surface = a_hill(3)
    net = net_of(surface)
    middle = net.places[net.triangles].mean(axis=1)
    cell = np.floor(3.0 * middle).astype(int) @ [3, 1]
    assert_array_equal(net.faces, cell)


def test_edges_of_a_closed_mesh_have_faces_on_both_sides():
    from plusedit.geometry.mesh.polygons import PolygonMesh

    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    tetrahedron = PolygonMesh.of(corners, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
    edges, counts = polygon_edges(tetrahedron)
    assert len(edges) == 6
    assert (counts == 2).all()


def test_normals_are_those_of_the_plane_where_the_mesh_is_one():
    points = np.array([[0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [0.0, 1.0, 2.0], [5.0, 5.0, 5.0]])
    normals = vertex_normals(points, np.array([[0, 1, 2]], np.int32))
    assert_array_equal(normals[:3], np.tile([0.0, 0.0, 1.0], (3, 1)))
    assert_array_equal(normals[3], np.zeros(3))


def test_without_waiting_the_mesh_itself_stands_for_its_surface():
    surface = a_hill()
    shown = drawing_of(surface, wait=False)
    assert shown.points is surface.mesh.vertices
    assert not shown.is_exact
    assert known_drawing(surface) is None


def test_without_waiting_the_surface_before_the_change_stands_for_the_one_after():
    surface = a_hill()
    before = drawing_of(surface)
    smoother = surface.with_smoothness(3.0)
    assert drawing_of(smoother, wait=False) is before
    assert known_drawing(smoother) is None


def test_a_quick_drawing_does_for_a_moment_and_gives_way_to_the_exact_one():
    surface = a_hill()
    quick = keep(surface, previewed(surface))
    exact = surface.at(quick.net.places)
    assert_allclose(quick.points, exact, atol=1e-5 * surface.mesh.diagonal)
    assert drawing_of(surface, wait=False) is quick
    assert drawing_of(surface).is_exact


def test_pictures_do_not_wait_for_digits_that_no_one_sees(monkeypatch):
    monkeypatch.setattr(drawn_mesh, "AWAITED", 1)
    surface = a_hill(s=0.9)
    drawing = drawing_of(surface)
    assert not drawing.is_exact
    exact = surface.at(drawing.net.places)
    assert_allclose(drawing.points, exact, atol=1e-5 * surface.mesh.diagonal)
    assert drawing_of(surface) is drawing


@pytest.mark.parametrize("made", [a_hill, torus])
def test_a_surface_moved_as_a_whole_is_drawn_at_once(made):
    surface = made(s=0.8)
    drawing_of(surface)
    moved = surface.transformed(2.0 * TURN, [1.0, -2.0, 3.0])
    shown = drawing_of(moved, wait=False)
    assert shown.is_exact
    assert_allclose(shown.points, moved.at(shown.net.places), atol=1e-11)


def test_a_surface_with_an_edited_plane_is_not_taken_for_the_one_before():
    surface = a_hill()
    drawing_of(surface)
    edited = surface.with_plane(3, point=[0.0, 0.0, 9.0])
    assert known_drawing(edited) is None
    assert drawing_of(edited).points[:, 2].max() > 1.0


@pytest.mark.parametrize("made", [a_hill, torus])
def test_a_surface_moved_with_its_edited_planes_is_drawn_at_once(made):
    surface = made(s=0.8).with_plane(5, point=[0.1, 0.2, 0.9], gradient_u=[1.0, 0.5, 0.0])
    drawing_of(surface)
    moved = surface.transformed(MIRRORED, [1.0, -2.0, 3.0])
    shown = known_drawing(moved)
    points, normals = points_and_normals(moved, shown.net.places)
    assert_allclose(shown.points, points, atol=1e-11)
    assert_allclose(shown.normals, normals, atol=1e-6)
    assert known_drawing(moved.with_plane(5, point=[0.0, 0.0, 9.0])) is None


def test_the_drawing_has_the_normals_of_the_surface():
    surface = a_hill(smoothness=1.5)
    drawing = drawing_of(surface)
    assert_array_equal(drawing.normals, points_and_normals(surface, drawing.net.places)[1])
    assert_allclose(previewed(surface).normals, drawing.normals, atol=1e-3)


def test_fronts_are_those_of_the_faces_whatever_the_sense_of_the_parameters():
    surface = a_hill(smoothness=1.5)
    swapped = MeshSurface(surface.mesh, surface.domain, surface.parameters[:, ::-1], smoothness=1.5)
    assert net_of(surface).sides is None
    for drawing in (drawing_of(swapped), previewed(swapped)):
        assert (drawing.normals[:, 2] > 0.0).all()


def test_after_an_edit_only_what_it_reaches_is_evaluated(monkeypatch):
    surface = a_hill(12, smoothness=0.3)
    before = drawing_of(surface)
    edited = surface.with_plane(3, point=[0.05, 0.3, 0.5])
    evaluated_at = []

    def noted(surface, places, *rest):
        evaluated_at.append(len(places))
        return points_and_normals(surface, places, *rest)

    monkeypatch.setattr(drawn_mesh, "points_and_normals", noted)
    for drawing in (previewed(edited, known_before(edited)), drawing_of(edited)):
        assert drawing.is_exact
        points, normals = points_and_normals(edited, drawing.net.places)
        assert_allclose(drawing.points, points, atol=1e-12)
        assert_allclose(drawing.normals, normals, atol=1e-9)
    assert max(evaluated_at) < 0.5 * len(before.points)


def test_local_factors_are_taken_from_the_drawing_before_as_well():
    surface = a_hill(12, smoothness=0.3)
    drawing_of(surface)
    factors = np.ones(surface.mesh.face_count)
    factors[:3] = 2.0
    sharper = surface.with_factors(factors)
    assert known_before(sharper).surface is surface
    assert_allclose(drawing_of(sharper).points, sharper.at(net_of(surface).places), atol=1e-12)
    assert net_of(sharper) is net_of(surface)


def test_designs_look_alike_while_what_differs_is_yet_to_be_evaluated():
    surface = a_hill()
    drawing_of(surface)
    smoother = surface.with_smoothness(3.0)
    before, after = a_landscape(surface), a_landscape(smoother)
    assert looks_alike(before, after)
    assert not looks_alike(before, a_landscape(smoother, visible=False))
    assert not looks_alike(before, a_landscape(surface.with_plane(3, point=[0.0, 0.0, 9.0])))
    assert not looks_alike(before, Design())
    drawing_of(smoother)
    assert not looks_alike(before, after)


def test_what_is_no_longer_there_leaves_nothing_behind():
    surface = a_hill()
    mesh = ref(surface.mesh)
    drawing_of(surface)
    del surface
    gc.collect()
    assert mesh() is None


# In space


def test_a_mesh_is_a_solid_with_its_boundary():
    layers = space_items(a_landscape(), CAMERA, BARE)
    solid = the_mesh(layers)
    assert solid in layers.solids
    assert_allclose(np.linalg.norm(solid.normals, axis=1), 1.0)
    assert (solid.normals[:, 2] > 0.0).all()
    (boundary,) = [item for item in layers.lines if isinstance(item, Segments)]
    assert boundary.color == "line"


def test_items_stay_the_same_while_they_look_the_same():
    design = a_landscape()
    first, second = (space_items(design, camera, BARE) for camera in (CAMERA, CAMERA.orbited(1, 0)))
    assert the_mesh(first) is the_mesh(second)


def test_a_mesh_shows_its_style_and_whether_it_is_locked_hidden_or_selected():
    colored = space_items(a_landscape(style=Style("#8090A0")), CAMERA, BARE)
    assert the_mesh(colored).front == "#8090A0"
    locked = space_items(a_landscape(locked=True), CAMERA, BARE)
    assert the_mesh(locked) in locked.glass
    assert not list(space_items(a_landscape(visible=False), CAMERA, BARE))
    chosen = space_items(a_landscape(), CAMERA, BARE, Selection.of_shapes([HILL]))
    assert {item.color for item in chosen.lines} == {"selected"}


def test_edges_of_polygons_are_drawn_where_they_are_few_or_asked_for():
    design = a_landscape()
    few = space_items(design, CAMERA, replace(BARE, isolines=True))
    asked = space_items(design, CAMERA, replace(BARE, wire=True))
    for layers in (few, asked):
        edges = [item for item in layers.lines if isinstance(item, Segments)]
        assert max(len(item.starts) for item in edges) == len(net_of(design.mesh(HILL)).edges)


def test_the_mesh_as_it_was_read_is_an_overlay():
    design = a_landscape()
    mesh = design.mesh(HILL).mesh
    layers = space_items(design, CAMERA, replace(BARE, overlays=frozenset({"mesh"})))
    (ghost,) = [i for i in layers.lines if isinstance(i, Segments) and "classical" in i.color]
    edges, _ = polygon_edges(mesh)
    assert_array_equal(ghost.starts, mesh.vertices[edges[:, 0]])


def test_of_small_bumps_no_silhouette_is_drawn():
    count = 40
    hill = a_hill(count)
    bumps = hill.mesh.vertices.copy()
    bumps[:, 2] += 0.02 * np.sin(np.arange(len(bumps)) % (count + 1) * 2.0)
    rough = replace(hill, mesh=hill.mesh.with_vertices(bumps), smoothness=0.3, shared=None)
    drawing = drawing_of(rough)
    near = mesh_silhouette(drawing, CAMERA)
    assert near
    far = mesh_silhouette(drawing, replace(CAMERA, height=50.0))
    assert len(far) < len(near)
    assert all(np.ptp(CAMERA.to_screen(line), axis=0).max() >= SHORTEST - 1.0 for line in near)


def test_the_mesh_itself_is_drawn_where_that_is_asked_for():
    design = a_landscape()
    mesh = design.mesh(HILL).mesh
    item = the_mesh(space_items(design, CAMERA, replace(BARE, facets=True)))
    assert_array_equal(item.points, mesh.vertices[mesh.corners])
    ways = mesh.area_vectors / mesh.areas[:, None]
    assert_allclose(item.normals, ways[mesh.owners], atol=1e-12)
    (rim,) = space_items(design, CAMERA, replace(BARE, facets=True)).lines
    assert len(rim.starts) == 4 * 6
    assert set(map(tuple, rim.starts)) <= set(map(tuple, mesh.vertices))


def test_one_mesh_alone_may_be_shown_itself():
    design = a_landscape(style=Style(facets=True))
    shown = the_mesh(space_items(design, CAMERA, BARE))
    asked = the_mesh(space_items(a_landscape(), CAMERA, replace(BARE, facets=True)))
    assert len(shown.points) == len(asked.points) == len(a_hill().mesh.corners)


def test_a_mesh_is_framed():
    camera = framed_in_space(a_landscape(), CAMERA, BARE)
    screen = camera.to_screen(a_hill().mesh.vertices)
    assert ((screen > 0.0) & (screen < camera.size)).all()


# In the plane


@pytest.mark.parametrize("projection", list(AXES))
def test_a_plane_view_shows_the_outline_and_frames_it(projection):
    camera = framed(a_landscape(), PlaneCamera((800.0, 600.0), projection=projection), BARE)
    layers = scene_items(a_landscape(), camera, BARE)
    assert not [item for item in layers if isinstance(item, Mesh)]
    drawn = [item.points for item in layers if isinstance(item, Polyline)]
    drawn += [item.starts for item in layers if isinstance(item, Segments)]
    screen = camera.to_screen(np.concatenate(drawn))
    assert ((screen > 0.0) & (screen < camera.size)).all()


def test_a_view_from_the_front_shows_the_ridge():
    camera = PlaneCamera((800.0, 600.0), scale=300.0, projection="front")
    lines = [i for i in scene_items(a_landscape(), camera, BARE) if isinstance(i, Polyline)]
    highest = drawing_of(a_hill()).points[:, 2].max()
    assert max(line.points[:, 2].max() for line in lines) > 0.9 * highest
