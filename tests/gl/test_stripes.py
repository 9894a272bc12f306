"""Stripes of light on surfaces, by the pixels that are drawn."""

import numpy as np
import pytest

from plusedit.geometry.blend import Grid
from plusedit.geometry.making.primitives import sphere
from plusedit.scene.items import Mesh, Patch
from plusedit.scene.options import ViewOptions
from plusedit.scene.stripes import Stripes, stripes_of
from plusedit.views.gl.artist import Look
from tests.gl.easel import FRONT, ISO, at

BALL = sphere(radius=0.8)
FINE = Grid.uniform(81)
KINDS = ["zebra", "reflection", "isophotes"]
UPWARDS = (0.0, 0.0, 1.0)


def ball(easel, stripes, camera=FRONT, fine=FINE):
    return easel.draw(
        Patch(BALL, fine, fine),
        camera=camera.framing(BALL.planes.control_points),
        look=Look(stripes=stripes),
    )


def changes(column):
    """How often a row of pixels goes from dark to light or back."""
    is_light = column[:, :3].mean(axis=1) > 128
    return int((np.diff(is_light.astype(int)) != 0).sum())


@pytest.mark.parametrize("kind", KINDS)
def test_there_are_as_many_stripes_as_are_asked_for(easel, kind):
    few, many = (ball(easel, Stripes(kind, count, UPWARDS), ISO) for count in (4, 12))
    column = few.shape[1] // 2
    assert 2 <= changes(few[:, column]) < changes(many[:, column])


def test_isophotes_of_a_ball_are_circles_of_latitude_where_light_falls_from_above(easel):
    camera = FRONT.framing(BALL.planes.control_points)
    pixels = ball(easel, Stripes("isophotes", 6, UPWARDS))
    for degrees in np.arange(-80.0, 81.0, 10.0):
        angle = np.radians(degrees)
        # A pair of bands is 30 degrees wide; its dark one lies in the middle of it.
        share = (90.0 - degrees) / 30.0 % 1.0
        if abs(abs(share - 0.5) - 0.25) < 0.05:
            continue
        for turn in (-0.3, 0.0, 0.3):
            place = 0.8 * np.array(
                [np.cos(angle) * np.sin(turn), -np.cos(angle) * np.cos(turn), np.sin(angle)]
            )
            is_light = at(pixels, camera, place)[:3].mean() > 128
            assert is_light == (abs(share - 0.5) > 0.25)


def test_isophotes_stay_where_they_are_while_the_eye_moves(easel):
    light = (0.6, -0.64, 0.48)
    place = 0.8 * np.array([0.1, -0.9, np.sqrt(0.18)])
    seen = []
    for turn in (0.0, 0.2, 0.4):
        camera = FRONT.framing(BALL.planes.control_points).orbited(turn, 0.1)
        pixels = easel.draw(
            Patch(BALL, FINE, FINE),
            camera=camera,
            look=Look(stripes=Stripes("isophotes", 3, light)),
        )
        seen.append(at(pixels, camera, place)[:3].mean() > 128)
    assert len(set(seen)) == 1


@pytest.mark.parametrize("kind", ["zebra", "reflection"])
def test_what_a_mirror_shows_moves_with_the_eye(easel, kind):
    camera = ISO.framing(BALL.planes.control_points)
    pictures = [
        easel.draw(
            Patch(BALL, FINE, FINE), camera=each, look=Look(stripes=Stripes(kind, 10, UPWARDS))
        )
        for each in (camera, camera.orbited(0.0, 0.15))
    ]
    # A ball looks alike from everywhere, but for its stripes; and zebra turns with the eye.
    differ = (np.abs(pictures[0] - pictures[1]).max(axis=2) > 60).mean()
    assert (differ > 0.015) == (kind == "reflection")


def test_crowded_stripes_become_their_mean(easel):
    pixels = ball(easel, Stripes("zebra", 200), ISO)
    middle = pixels[60:100, 80:120, :3].mean(axis=(0, 1))
    assert 70 < middle.mean() < 190


@pytest.mark.parametrize("kind", KINDS)
def test_meshes_have_the_same_stripes(easel, kind):
    u = Grid.uniform(161)
    points = BALL.sample(u, u).reshape(-1, 3)
    rows = np.arange(160)
    first = (rows[:, None] * 161 + rows).ravel()
    quads = np.stack([first, first + 161, first + 162, first + 1], axis=1)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.int32)
    camera = ISO.framing(BALL.planes.control_points)
    look = Look(stripes=Stripes(kind, 5, UPWARDS))
    normals = points / np.linalg.norm(points, axis=1, keepdims=True)
    as_mesh = easel.draw(Mesh(points, triangles, normals), camera=camera, look=look)
    as_patch = easel.draw(Patch(BALL, u, u), camera=camera, look=look)
    is_far_off = np.abs(as_mesh - as_patch)[..., :3].max(axis=2) > 90
    assert is_far_off.mean() < 0.02


def test_a_view_says_what_its_overlay_asks_for():
    assert stripes_of(ViewOptions()) is None
    options = ViewOptions().with_overlay("zebra", True).with_setting("zebra.count", 30.0)
    assert stripes_of(options) == Stripes("zebra", 30, stripes_of(options).light)


def test_only_one_overlay_paints_surfaces():
    options = ViewOptions().with_overlay("gaussian", True).with_overlay("zebra", True)
    assert {"zebra"} == options.overlays & {"gaussian", "zebra"}
    assert {"mean"} == options.with_overlay("mean", True).overlays & {"mean", "zebra"}
