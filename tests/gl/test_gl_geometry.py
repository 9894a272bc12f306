"""What is worked out before anything is drawn; it needs no display."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.blend import Grid
from plusedit.scene.items import Polyline, Segments
from plusedit.scene.space_camera import STANDARD, SpaceCamera
from plusedit.scene.theme import LIGHT
from plusedit.views.gl.colors import Palette
from plusedit.views.gl.egl import context_without_display
from plusedit.views.gl.ground import ground_of
from plusedit.views.gl.patches import frame_of
from plusedit.views.gl.sight import Sight
from plusedit.views.gl.strokes import GAP, GOES_ON, KIND, records_of
from plusedit.views.gl.triangles import grid_triangles, triangulated
from plusedit.views.gl.tripod import ARM, axis_under, tripod_camera, tripod_items
from tests.geometry.surfaces import PAIRS, random_surface
from tests.gl.easel import ISO, Easel

VIEWS = [SpaceCamera((640.0, 480.0), (3.0, -2.0, 1.0), 7.0, 0.4, pitch) for pitch in (-0.7, 0.5)]
PALETTE = Palette(LIGHT)


def area(points, triangles):
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2.0


# The axes in the corner


@pytest.mark.parametrize("camera", VIEWS)
def test_a_click_on_the_end_of_an_axis_asks_for_the_view_from_there(camera):
    small = tripod_camera(camera)
    for name, (yaw, pitch) in STANDARD.items():
        if name != "iso":
            end = ARM * SpaceCamera((1.0, 1.0), yaw=yaw, pitch=pitch).toward
            pixel = small.to_screen(end[None])[0]
            assert axis_under(pixel, camera) == name
            assert pixel[0] > 540.0
            assert pixel[1] < 100.0


@pytest.mark.parametrize("camera", VIEWS)
def test_a_click_elsewhere_asks_for_nothing(camera):
    for pixel in ([320.0, 240.0], [5.0, 5.0], [638.0, 2.0]):
        assert axis_under(np.array(pixel), camera) is None


def test_of_two_ends_behind_each_other_the_nearer_is_taken():
    front = SpaceCamera.standard("front", (640.0, 480.0))
    middle = tripod_camera(front).to_screen(np.zeros((1, 3)))[0]
    assert axis_under(middle, front) == "front"


def test_the_axes_are_the_same_items_while_the_view_is():
    assert tripod_items(VIEWS[0]) is tripod_items(VIEWS[0])
    assert tripod_items(VIEWS[0]) is not tripod_items(VIEWS[0], "top")


# The ground


def test_the_ground_lies_in_z_zero_about_what_is_looked_at():
    ground = ground_of(ISO)
    for item in ground.items:
        ends = np.concatenate([item.starts, item.ends])
        assert not ends[:, 2].any()
        assert (np.linalg.norm(ends - ground.middle, axis=1) <= ground.reach * (1.0 + 1e-9)).all()


@pytest.mark.parametrize(("view", "axis"), [("front", 1), ("back", 1), ("left", 0), ("top", 2)])
def test_along_an_axis_the_ground_is_the_plane_that_is_seen(view, axis):
    for item in ground_of(ISO.looking(view)).items:
        assert not item.starts[:, axis].any()


# Lines


def test_a_closed_line_goes_on_at_its_ends():
    turns = np.linspace(0.0, 2.0 * np.pi, 9)
    ring = np.stack([np.cos(turns), np.sin(turns), np.zeros(9)], axis=1)
    closed = records_of(Polyline(ring, "plus"), PALETTE, np.zeros(3), ISO)
    opened = records_of(Polyline(ring[:-1], "plus"), PALETTE, np.zeros(3), ISO)
    assert closed[[0, -1], KIND].tolist() == [GOES_ON, GOES_ON]
    assert_allclose(closed[[0, -1], :3], ring[[-2, 1]], atol=1e-6)
    assert opened[[0, -1], KIND].tolist() == [GAP, GAP]


def test_segments_are_apart_from_each_other():
    starts, ends = np.zeros((3, 3)), np.ones((3, 3))
    records = records_of(Segments(starts, ends, "plus"), PALETTE, np.zeros(3), ISO)
    assert records[:, KIND].tolist() == [0.0, 0.0, GAP] * 3


def test_dashes_are_measured_on_the_screen():
    line = Polyline(np.array([[0.0, 0, 0], [1.0, 0, 0], [1.0, 0, 1.0]]), "plus", 1.0, "dash")
    for camera in VIEWS:
        records = records_of(line, PALETTE, np.zeros(3), camera)
        steps = np.linalg.norm(np.diff(camera.to_screen(line.points), axis=0), axis=1)
        assert_allclose(records[1:-1, -1], [0.0, steps[0], steps.sum()], rtol=1e-5)


# Triangles


@pytest.mark.parametrize("turn", [1, -1])
def test_triangles_fill_a_polygon_with_notches(turn):
    angles = np.linspace(0.0, 2.0 * np.pi, 10, endpoint=False)[::turn]
    reach = np.where(np.arange(10) % 2, 1.0, 0.35)
    star = np.stack([reach * np.cos(angles), reach * np.sin(angles), 0.0 * angles], axis=1)
    x, y = star[:, 0], star[:, 1]
    enclosed = abs((x * np.roll(y, -1) - y * np.roll(x, -1)).sum()) / 2.0
    triangles = triangulated(star @ np.linalg.qr(np.arange(9.0).reshape(3, 3) ** 1.5)[0])
    assert len(triangles) == 8
    assert area(star, triangles) == pytest.approx(enclosed)


def test_a_convex_polygon_is_a_fan():
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    assert triangulated(square).tolist() == [[0, 1, 2], [0, 2, 3]]


def test_a_grid_is_covered_once_facing_the_normal():
    u, v = np.meshgrid(np.linspace(0.0, 2.0, 4), np.linspace(0.0, 3.0, 5), indexing="ij")
    points = np.stack([u, v, 0.0 * u], axis=-1).reshape(-1, 3)
    triangles = grid_triangles(4, 5).astype(int)
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    assert (np.cross(b - a, c - a)[:, 2] > 0.0).all()
    assert area(points, triangles) == pytest.approx(6.0)


# What is seen


@pytest.mark.parametrize(("kind_u", "kind_v"), PAIRS)
def test_a_surface_stays_inside_of_its_frame(kind_u, kind_v):
    surface = random_surface(kind_u, kind_v, contrast=4.0)
    low, high = frame_of(surface).box(surface.s)
    points = surface.sample(Grid.uniform(30), Grid.uniform(30))
    assert (points >= low - 1e-9).all()
    assert (points <= high + 1e-9).all()


@pytest.mark.parametrize("perspective", [True, False])
def test_a_pull_brings_points_nearer_by_a_pixel(perspective):
    camera = SpaceCamera((640.0, 480.0), height=4.0, perspective=perspective)
    sight = Sight.of(camera, [(np.full(3, -2.0), np.full(3, 2.0))], PALETTE)
    point = np.array([0.5, -0.3, 0.4])
    toward = camera.eye - point if perspective else camera.toward
    pixel = camera.pixel_at(point[None])[0]
    nearer = point + pixel * toward / np.linalg.norm(toward)

    def depth(at):
        clip = sight.matrix @ np.append(at, 1.0)
        return clip[2] / clip[3], clip[3]

    (here, w), (there, _) = depth(point), depth(nearer)
    across, always = sight.pull
    assert across / w + always == pytest.approx(there - here, rel=0.02)


def test_there_is_opengl_without_a_display(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    with context_without_display() as gl:
        easel = Easel(gl)
        pixels = easel.draw(Polyline(np.array([[-1.0, 0, 0], [1.0, 0, 0]]), "plus", 5.0))
        assert len(np.unique(pixels.reshape(-1, 4), axis=0)) > 1
        easel.put_away()
