"""Surfaces: what the shader makes of the terms, what is sent, and what is not sent again."""

import ctypes
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.blend import Grid
from plusedit.scene.items import Patch, Polyline
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.theme import LIGHT
from plusedit.views.gl import functions, patches
from plusedit.views.gl.buffers import Buffer
from plusedit.views.gl.colors import Palette
from plusedit.views.gl.context import current_functions
from plusedit.views.gl.patches import PatchBuffers, frame_of, key_of
from plusedit.views.gl.programs import Program
from plusedit.views.gl.sight import Sight
from tests.geometry.surfaces import PAIRS, a_surface, random_surface
from tests.gl.easel import SIZE, Easel, at

pytestmark = pytest.mark.gl

GRID = Grid.uniform(25)
VIEW = SpaceCamera((float(SIZE[0]), float(SIZE[1]))).framing(a_surface().planes.control_points)


def patch_of(surface, grid_u=GRID, grid_v=GRID, **looks):
    return Patch(surface, grid_u, grid_v, **looks)


def moved(surface, by):
    """The same surface with its control point (1, 2) elsewhere."""
    points = surface.planes.points.copy()
    points[1, 2] += by
    return surface.with_net(surface.planes.with_points(points))


@pytest.fixture
def sent(monkeypatch):
    """The sizes of everything that was sent to the card, in bytes."""
    sizes = []
    for name in ("put", "put_part"):
        real = getattr(Buffer, name)

        def noted(self, array, *where, real=real):
            sizes.append(array.nbytes)
            real(self, array, *where)

        monkeypatch.setattr(Buffer, name, noted)
    return sizes


def test_another_s_draws_what_a_fresh_surface_of_that_s_does(easel, gl):
    surface = a_surface(s=0.5)
    easel.draw(patch_of(surface), camera=VIEW)
    slid = easel.draw(patch_of(replace(surface, s=2.0)), camera=VIEW)
    fresh = Easel(gl)
    assert_array_equal(slid, fresh.draw(patch_of(a_surface(s=2.0)), camera=VIEW))
    fresh.put_away()


def test_another_s_sends_nothing_to_the_card(easel, sent):
    surface = a_surface()
    easel.draw(patch_of(surface), camera=VIEW)
    sent.clear()
    easel.draw(patch_of(replace(surface, s=2.0)), camera=VIEW)
    easel.draw(patch_of(replace(surface, s=3.0)), camera=VIEW.orbited(0.1, 0.1))
    assert sent == []


def test_the_same_items_send_nothing_again(easel, sent):
    items = patch_of(a_surface()), Polyline(a_surface().planes.points[0], "plus")
    easel.draw(*items, camera=VIEW)
    sent.clear()
    easel.draw(*items, camera=VIEW.orbited(0.1, 0.0))
    assert sent == []


def test_a_drag_draws_what_a_fresh_surface_does(easel, gl):
    surface = a_surface()
    easel.draw(patch_of(surface), camera=VIEW)
    for lift in (0.2, 0.5, -0.4):
        dragged = moved(surface, [0.1, 0.0, lift])
        picture = easel.draw(patch_of(dragged), camera=VIEW)
        fresh = Easel(gl)
        assert np.abs(picture - fresh.draw(patch_of(dragged), camera=VIEW)).max() <= 2
        fresh.put_away()


def test_a_drag_sends_only_the_rows_that_it_reaches(easel, sent):
    surface = a_surface(rows=30)
    easel.draw(patch_of(surface, Grid.uniform(201)), camera=VIEW)
    whole = sum(sent)
    sent.clear()
    easel.draw(patch_of(moved(surface, [0.0, 0.0, 0.1]), Grid.uniform(201)), camera=VIEW)
    assert 0 < sum(sent) < whole / 3


def test_a_drag_makes_no_new_buffers(alive, easel):
    surface = a_surface()
    easel.draw(patch_of(surface), camera=VIEW)
    before = set(alive)
    for lift in np.linspace(0.0, 1.0, 20):
        easel.draw(patch_of(moved(surface, [0.0, 0.0, lift])), camera=VIEW)
        assert alive == before


def test_far_from_the_origin_a_surface_looks_the_same(easel):
    surface = a_surface()
    away = np.array([4e7, -1e7, 3e6])
    there = surface.with_net(surface.planes.with_points(surface.planes.points + away))
    near = easel.draw(patch_of(surface), camera=VIEW)
    far = easel.draw(patch_of(there), camera=VIEW._aimed(np.array(VIEW.target) + away))
    assert np.abs(near - far).max() <= 6


@pytest.mark.parametrize("shading", ["studio", "matcap"])
def test_light_shows_form_and_is_never_black_or_white(easel, shading):
    from plusedit.views.gl.artist import Look

    pixels = easel.draw(
        patch_of(a_surface(s=1.0)), camera=VIEW, look=Look(shading=shading, transparent=True)
    )
    on_it = pixels[pixels[..., 3] == 255][:, :3]
    assert len(on_it) > 2000
    assert len(np.unique(on_it, axis=0)) > 60
    assert on_it.min() > 20
    assert on_it.max() < 250


def test_both_sides_have_their_color(easel):
    flat = a_surface().planes.points * [1.0, 1.0, 0.0]
    surface = replace(a_surface(), planes=a_surface().planes.with_points(flat), s=0.0)
    above = SpaceCamera.standard("top", VIEW.size).framing(flat.reshape(-1, 3))
    middle = SIZE[1] // 2, SIZE[0] // 2
    front, back = (
        easel.draw(patch_of(surface, front="x", back="z"), camera=above.looking(name))[middle]
        for name in ("top", "bottom")
    )
    assert front[0] > front[2]
    assert back[2] > back[0]


def test_wire_shows_the_samples(easel):
    plain, wired = (
        easel.draw(patch_of(a_surface(), Grid.uniform(9), Grid.uniform(9), wire=wire), camera=VIEW)
        for wire in (None, "line")
    )
    changed = (np.abs(plain - wired) > 30).any(axis=2)
    assert 200 < changed.sum() < 0.5 * (plain != LIGHT).size


def test_a_ghost_lets_through(easel):
    line = Polyline(a_surface().planes.points[1] - [0.0, 0.0, 1.0], "x", 4.0)
    ghost = patch_of(a_surface(), front="front@30", back="back@30")
    with_line, without = easel.draw(ghost, line, camera=VIEW), easel.draw(ghost, camera=VIEW)
    solid = [easel.draw(patch_of(a_surface()), *more, camera=VIEW) for more in ((line,), ())]
    covered = (np.abs(solid[1] - easel.draw(camera=VIEW)) > 8).any(axis=2)
    through = (np.abs(with_line - without) > 20).any(axis=2) & covered
    assert through.sum() > 100
    assert not ((np.abs(solid[0] - solid[1]) > 20).any(axis=2) & covered).all()


# What the vertex shader works out, against the geometry

FEEDBACK = {
    "TransformFeedbackVaryings": "eipe",
    "BeginTransformFeedback": "e",
    "EndTransformFeedback": "",
    "BindBufferBase": "eee",
    "GetBufferSubData": "ennp",
}
POINTS, RASTERIZER_DISCARD, FEEDBACK_BUFFER, INTERLEAVED = 0, 0x8C89, 0x8C8E, 0x8C8C


@pytest.fixture
def shaded(qapp, gl, monkeypatch):
    """Points and normals as the vertex shader of surfaces gives them."""
    monkeypatch.setattr(functions, "_SIGNATURES", {**functions._SIGNATURES, **FEEDBACK})
    gl = current_functions()
    real = gl.LinkProgram

    def linked(name):
        varyings = (ctypes.c_char_p * 2)(b"sight", b"normal")
        gl.TransformFeedbackVaryings(name, 2, varyings, INTERLEAVED)
        real(name)

    monkeypatch.setattr(gl, "LinkProgram", linked)
    program = Program(gl, "patch", "shade")

    def points_and_normals(patch, camera):
        count = len(patch.grid_u) * len(patch.grid_v)
        buffers = PatchBuffers(gl)
        lattice = patches.Lattice(gl, len(patch.grid_u), len(patch.grid_v))
        buffers.fill(key_of(patch), lattice, frame_of(patch.surface))
        program.use()
        box = frame_of(patch.surface).box(patch.surface.s)
        sight = Sight.of(camera, [box], Palette(LIGHT))
        sight.show(program, buffers.origin)
        sight.show_light(program, buffers.origin, (1.0,) * 4, (1.0,) * 4)
        program.set("s", patch.surface.s)
        program.set("least", patches.POINTLIKE * frame_of(patch.surface).size)
        found = np.zeros((count, 6), np.float32)
        caught = Buffer(gl)
        caught.put(found)
        gl.BindBufferBase(FEEDBACK_BUFFER, 0, caught.name)
        gl.Enable(RASTERIZER_DISCARD)
        buffers._vertices.bind()
        gl.BeginTransformFeedback(POINTS)
        gl.DrawArrays(POINTS, 0, count)
        gl.EndTransformFeedback()
        gl.Disable(RASTERIZER_DISCARD)
        gl.GetBufferSubData(FEEDBACK_BUFFER, 0, found.nbytes, functions.address(found))
        for held in (caught, buffers, lattice):
            held.release()
        assert gl.errors() == []
        # Back from the axes of the view, whose origin is the eye, into the world.
        axes = camera.axes_of_view
        return camera.eye + found[:, :3] @ axes, found[:, 3:] @ axes

    yield points_and_normals
    program.release()


@pytest.mark.parametrize(("kind_u", "kind_v"), PAIRS)
@pytest.mark.parametrize("contrast", [None, 5.0])
def test_the_shader_gives_the_points_and_normals_of_the_surface(shaded, kind_u, kind_v, contrast):
    surface = random_surface(kind_u, kind_v, contrast=contrast, s=1.3)
    camera = SpaceCamera((200.0, 160.0)).framing(surface.planes.control_points)
    inside = Grid(np.linspace(0.05, 0.95, 14))
    points, normals = shaded(patch_of(surface, inside, inside), camera)
    at, by_u, by_v = (
        each.reshape(-1, 3)
        for each in surface.derivatives(inside.parameters, inside.parameters, highest=1)
    )
    across = np.cross(by_u, by_v)
    slant = np.linalg.norm(across, axis=1)
    steep = slant / (np.linalg.norm(by_u, axis=1) * np.linalg.norm(by_v, axis=1))
    size = np.abs(at).max()
    assert_allclose(points, at, atol=1e-5 * size)
    clear = steep > 0.02
    assert clear.sum() > 100
    assert_allclose(normals[clear], (across / slant[:, None])[clear], atol=2e-3)


RED_TO_BLUE = np.linspace([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], len(GRID))
ALONG_U = np.repeat(RED_TO_BLUE[:, None], len(GRID), axis=1).astype(np.float32)


def ends_of(pixels, surface):
    """The colors on the screen near both ends of u."""
    return [at(pixels, VIEW, surface.at([u], [0.5])[0, 0])[:3] for u in (0.1, 0.9)]


def test_colors_at_samples_are_seen_where_these_are(easel):
    surface = a_surface()
    red, blue = ends_of(easel.draw(patch_of(surface, colors=ALONG_U), camera=VIEW), surface)
    assert red[0] > red[2] + 60
    assert blue[2] > blue[0] + 60


def test_colors_that_are_taken_away_are_seen_no_more(easel, gl):
    surface = a_surface()
    easel.draw(patch_of(surface, colors=ALONG_U), camera=VIEW)
    bare = easel.draw(patch_of(surface), camera=VIEW)
    fresh = Easel(gl)
    assert_array_equal(bare, fresh.draw(patch_of(surface), camera=VIEW))
    fresh.put_away()


def test_only_colors_that_changed_are_sent(easel, sent):
    surface = a_surface()
    easel.draw(patch_of(surface, colors=ALONG_U), camera=VIEW)
    sent.clear()
    easel.draw(patch_of(surface, colors=ALONG_U), camera=VIEW.orbited(0.1, 0.0))
    assert sent == []
    easel.draw(patch_of(surface, colors=ALONG_U[::-1].copy()), camera=VIEW)
    assert sent == [ALONG_U.nbytes]


def test_two_surfaces_of_the_same_planes_have_each_their_own_colors(easel):
    near, far = a_surface(s=0.0), a_surface(s=1.0)
    pixels = easel.draw(
        patch_of(near, colors=np.zeros_like(ALONG_U)),
        patch_of(far, colors=np.ones_like(ALONG_U)),
        camera=VIEW,
    )
    brightness = pixels[..., :3].max(axis=-1)
    assert (brightness < 100).any()
    assert (brightness > 200).any()
