"""Maps of curvature and draft, normals and principal directions, of shapes that are known."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.arrays import unit
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.making.primitives import exact_sphere
from plusedit.geometry.mesh.domains import TorusDomain
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.surface_frames import principal_curvatures
from plusedit.scene.beside import findings, has_findings
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.coloring import span_of
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.items import Segments
from plusedit.scene.level_lines import level_segments, triangles_of_grid
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import Coloring, Seen, overlays
from plusedit.scene.overlays.principal import LARGEST
from plusedit.scene.scene import scene_items
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import space_items
from tests.geometry.mesh.mesh_surfaces import pillow
from tests.geometry.mesh.mesh_surfaces import torus as torus_mesh
from tests.geometry.test_surface_frames import cylinder, sphere, surface_of, torus
from tests.scene.meshes import a_hill

U, V = np.linspace(0.02, 0.97, 11), np.linspace(0.03, 0.96, 9)
MAPS = ("gaussian", "mean", "largest", "smallest")
TOP = PlaneCamera((800.0, 600.0), scale=90.0)
CAMERA = SpaceCamera((800.0, 600.0), height=6.0)


def values(name, surface, numbers=None):
    return overlays[name].surface_values(surface, U, V, numbers)


def of_mesh(name, surface):
    return overlays[name].mesh_values(surface, drawing_of(surface))


def items(name, surface, camera=CAMERA, **settings):
    entry = overlays[name]
    numbers = {**entry.numbers({}), **settings}
    return list(entry.draw(Shape(surface, "Body"), surface, Seen(camera, settings=numbers)))


@pytest.mark.parametrize("radius", [0.01, 1.0, 250.0])
@pytest.mark.parametrize("ball", [sphere, exact_sphere])
def test_a_sphere_bends_alike_everywhere(ball, radius):
    surface = ball(radius)
    sign = np.sign(values("mean", surface)[0, 0])
    assert_allclose(values("gaussian", surface), 1.0 / radius**2, rtol=1e-7)
    for name in ("mean", "largest", "smallest"):
        assert_allclose(values(name, surface), sign / radius, rtol=1e-7)


@pytest.mark.parametrize("radius", [0.01, 1.0, 250.0])
def test_a_cylinder_bends_one_way_alone(radius):
    surface = cylinder(radius)
    assert (values("gaussian", surface) == 0.0).all()
    assert_allclose(values("mean", surface), -0.5 / radius, rtol=1e-9)
    assert (values("largest", surface) == 0.0).all()
    assert_allclose(values("smallest", surface), -1.0 / radius, rtol=1e-9)


def test_a_torus_bends_as_the_angle_around_its_tube_says():
    large, small = 2.0, 0.6
    surface = torus(large, small)
    points = surface.at(U, V)
    out = np.hypot(points[..., 0], points[..., 1])
    across = (out - large) / small
    assert_allclose(values("gaussian", surface), across / (small * out), rtol=1e-8, atol=1e-12)
    mean = -(large + 2.0 * small * across) / (2.0 * small * out)
    assert_allclose(values("mean", surface), mean, rtol=1e-8)
    assert_allclose(values("smallest", surface), -1.0 / small, rtol=1e-8)
    assert_allclose(values("largest", surface), -across / out, rtol=1e-6, atol=1e-9)


def test_a_saddle_bends_up_one_way_and_down_the_other():
    # z = x y over the unit square.
    corners = [[(u, v, u * v) for v in (0.0, 1.0)] for u in (0.0, 1.0)]
    surface = surface_of(Bernstein(2), Bernstein(2), corners)
    steep = 1.0 + U[:, None] ** 2 + V**2
    assert_allclose(values("gaussian", surface), -1.0 / steep**2, rtol=1e-10)
    assert_allclose(values("mean", surface), -(U[:, None] * V) / steep**1.5, rtol=1e-9)
    assert (values("largest", surface) > 0.0).all()
    assert (values("smallest", surface) < 0.0).all()


def test_maps_of_a_mesh_agree_with_each_other():
    surface = a_hill(smoothness=3.0)
    found = {name: of_mesh(name, surface) for name in MAPS}
    assert_allclose(found["gaussian"], found["largest"] * found["smallest"], atol=1e-12)
    assert_allclose(found["mean"], (found["largest"] + found["smallest"]) / 2.0, atol=1e-12)
    assert (found["largest"] >= found["smallest"]).all()


def test_a_smooth_mesh_bends_as_what_it_was_made_of():
    surface = replace(torus_mesh(), smoothness=0.7)
    exact = of_mesh("gaussian", surface)
    places = drawing_of(surface).net.places
    h = 1e-4
    tangents = [
        [surface.derivatives(places + step)[k] for k in (1, 2)]
        for step in ([h, 0.0], [-h, 0.0], [0.0, h], [0.0, -h])
    ]
    uu, uv = ((a - b) / (2.0 * h) for a, b in zip(tangents[0], tangents[1], strict=True))
    vv = (tangents[2][1] - tangents[3][1]) / (2.0 * h)
    by_differences = principal_curvatures((*surface.derivatives(places), uu, uv, vv))
    wanted = by_differences.largest * by_differences.smallest
    assert_allclose(exact, wanted, atol=1e-4 * np.abs(wanted).max())


def test_a_mesh_that_is_turned_inside_out_bends_the_other_way():
    surface = pillow()
    mesh = surface.mesh
    rows = mesh.corners.reshape(-1, 3)
    flipped = type(mesh).of_rows(mesh.vertices, rows[:, ::-1])
    parameters = surface.parameters.reshape(-1, 3, 2)[:, ::-1].reshape(-1, 2)
    inside_out = MeshSurface(flipped, surface.domain, parameters)
    for name, other, sign in (
        ("gaussian", "gaussian", 1.0),
        ("mean", "mean", -1.0),
        ("largest", "smallest", -1.0),
    ):
        here, there = of_mesh(name, surface), of_mesh(other, inside_out)
        assert_allclose(np.sort(here), np.sort(sign * there), rtol=1e-6, atol=1e-6)


def test_walls_along_the_pull_have_no_draft_and_roofs_a_right_angle():
    assert_allclose(values("draft", cylinder(1.0)), 0.0, atol=1e-9)
    ball = sphere(1.0)
    heights = ball.at(U, V)[..., 2]
    assert_allclose(values("draft", ball), np.degrees(np.arcsin(heights)), atol=1e-6)


def test_the_pull_can_lean():
    sideways = {"height": 1.0, "bearing": 90.0}
    ball = sphere(1.0)
    found = values("draft", ball, sideways)
    way = np.array([0.0, np.cos(np.radians(1.0)), np.sin(np.radians(1.0))])
    assert_allclose(found, np.degrees(np.arcsin(ball.at(U, V) @ way)), atol=1e-6)


def test_contrast_narrows_the_scale():
    data = np.linspace(-1.0, 1.0, 101)
    coloring = Coloring(kind="diverging")
    assert span_of(coloring, [data], 10.0).high == pytest.approx(0.1)


def test_hairs_point_away_from_the_middle_of_a_ball():
    hairs = next(item for item in items("normals", sphere(1.0)) if isinstance(item, Segments))
    assert len(hairs.starts) > 50
    assert_allclose(unit(hairs.ends - hairs.starts), unit(hairs.starts), atol=1e-9)


def test_hairs_are_as_long_as_is_asked_for_wherever_they_are():
    hairs = items("normals", sphere(1.0), PlaneCamera((800.0, 600.0), scale=50.0), length=30.0)[0]
    assert_allclose(np.linalg.norm(hairs.ends - hairs.starts, axis=1), 30.0 / 50.0)


def test_hairs_of_a_mesh_stand_on_its_surface():
    surface = torus_mesh()
    hairs = items("normals", surface)[0]
    out = hairs.starts * [1.0, 1.0, 0.0]
    ring = 2.0 * unit(out)
    assert (np.einsum("kd,kd->k", hairs.ends - hairs.starts, hairs.starts - ring) > 0.0).all()


def test_crosses_lie_along_and_across_a_cylinder():
    # The smallest curvature is that of the circles, for normals that point outward.
    around, upright = items("principal", cylinder(1.0), PlaneCamera((800.0, 600.0), scale=90.0))
    assert_allclose(np.abs(unit(upright.ends - upright.starts)[:, 2]), 1.0, atol=1e-9)
    assert_allclose(unit(around.ends - around.starts)[:, 2], 0.0, atol=1e-9)


def test_there_are_no_crosses_on_a_ball():
    assert items("principal", sphere(1.0)) == []


def test_spots_keep_their_distance_where_a_body_is_thin():
    starts = items("normals", sphere(1.0), density=12.0)[0].starts
    apart = np.linalg.norm(starts[:, None] - starts, axis=2)
    apart[np.arange(len(apart)), np.arange(len(apart))] = np.inf
    nearest = apart.min(axis=1)
    assert nearest.min() > 0.3 * np.median(nearest)


def scene_of(surface, wait):
    design = Design({"body": Shape(surface, "Body")})
    options = ViewOptions().with_overlay("principal", True)
    return [
        item
        for item in space_items(design, CAMERA, options, wait=wait)
        if isinstance(item, Segments) and item.color == LARGEST
    ]


def test_crosses_on_meshes_are_not_waited_for_and_stay_until_others_are_known():
    surface = torus_mesh()
    assert scene_of(surface, wait=False) == []
    assert len(scene_of(surface, wait=True)) == 1
    smoother = surface.with_smoothness(1.5)
    before, after = scene_of(surface, wait=False)[0], scene_of(smoother, wait=False)[0]
    assert_allclose(after.starts, before.starts)
    assert np.abs(scene_of(smoother, wait=True)[0].starts - before.starts).max() > 1e-3


def test_the_length_of_crosses_is_nothing_to_wait_for():
    surface, entry = torus_mesh(), overlays["principal"]
    numbers = entry.numbers({})
    findings(entry, surface, numbers)
    assert has_findings(entry, surface, {**numbers, "length": 50.0})
    assert not has_findings(entry, surface, {**numbers, "density": 30.0})


def plane_items(surface, name, camera=TOP, **settings):
    design = Design({"body": Shape(surface, "Body")})
    options = ViewOptions(overlays=frozenset({name}), isolines=False)
    for setting, value in settings.items():
        options = options.with_setting(f"{name}.{setting}", value)
    layers = scene_items(design, camera, options)
    return [item for item in layers.overlays if isinstance(item, Segments)], layers.legends


def test_in_the_plane_a_map_is_level_lines_in_the_colors_of_its_legend():
    lines, legends = plane_items(sphere(1.0), "draft")
    assert legends[0].unit == "° to the pull"
    assert len(lines) == len({line.color for line in lines}) > 4
    for line in lines:
        # On a ball the draft is the same along circles of latitude.
        assert np.ptp(np.linalg.norm(line.starts[:, :2], axis=1)) < 0.02
        assert_allclose(line.ends[:, 2], line.starts[:, 2], atol=0.02)


def test_in_the_plane_stripes_are_the_lines_where_they_meet():
    lines, legends = plane_items(sphere(1.0), "isophotes", height=90.0, count=3.0)
    assert not legends
    heights = np.degrees(np.arcsin(np.clip(lines[0].starts[:, 2], -1.0, 1.0)))
    for height in np.unique(np.round(heights)):
        assert abs((90.0 - height) / 30.0 % 1.0 - 0.5) == pytest.approx(0.0, abs=0.05)


def closed_ring(n=24, m=12):
    """A torus of quadrilaterals that share their vertices."""
    u, v = (each.ravel() for each in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    a, b = 2.0 * np.pi * u / n, 2.0 * np.pi * v / m
    out = 2.0 + 0.7 * np.cos(b)
    vertices = np.stack([out * np.cos(a), out * np.sin(a), 0.7 * np.sin(b)], axis=1)
    around = [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)]
    faces = np.stack([(i % n) * m + j % m for i, j in around], axis=1)
    places = np.stack([np.stack([i / n, 0.5 * j / m], axis=1) for i, j in around], axis=1)
    mesh = PolygonMesh.of_rows(vertices, faces)
    return MeshSurface(mesh, TorusDomain(0.5), places.reshape(-1, 2))


@pytest.mark.parametrize("name", ["zebra", "reflections", "isophotes"])
def test_of_closed_meshes_only_the_front_is_striped_in_the_plane(name):
    lines, _ = plane_items(closed_ring(), name)
    assert len(lines[0].starts) > 20
    assert lines[0].starts[:, 2].min() > -0.2


def test_level_lines_are_where_values_are_that():
    grid = np.linspace(-1.0, 1.0, 21)
    x, y = np.meshgrid(grid, grid, indexing="ij")
    points = np.stack([x, y, 0.0 * x], axis=-1).reshape(-1, 3)
    values = (2.0 * x + y).ravel()
    triangles = triangles_of_grid(21, 21)
    for level, (starts, ends) in zip(
        (-1.0, 0.05), level_segments(points, triangles, values, (-1.0, 0.05)), strict=True
    ):
        for places in (starts, ends):
            assert_allclose(2.0 * places[:, 0] + places[:, 1], level, atol=1e-12)
        length = np.linalg.norm(ends - starts, axis=1).sum()
        low, high = (level - 1.0) / 2.0, min((level + 1.0) / 2.0, 1.0)
        assert_allclose(length, (high - low) * np.sqrt(5.0))


def test_where_a_value_is_missing_there_is_no_line():
    points = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    values = np.array([0.0, 1.0, np.nan])
    starts, _ = next(level_segments(points, np.array([[0, 1, 2]]), values, [0.5]))
    assert len(starts) == 0
