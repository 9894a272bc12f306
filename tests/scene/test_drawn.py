from dataclasses import replace

import numpy as np
import pytest

from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn import TOLERANCE, drawn
from tests.geometry.curves import KINDS, random_curve

DENSE = np.linspace(0.0, 1.0, 4001)
SIZE = (900.0, 600.0)


def farthest(points, line):
    """Of points (m, 2) from a polyline (k, 2), by trying every segment: the oracle."""
    starts, by = line[:-1], np.diff(line, axis=0)
    squares = np.maximum((by**2).sum(axis=1), 1e-300)
    to = points[:, None] - starts
    share = np.clip((to * by).sum(axis=2) / squares, 0.0, 1.0)
    distances = np.linalg.norm(to - share[..., None] * by, axis=2)
    return distances.min(axis=1).max()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("scale", [2.0, 77.0, 900.0])
def test_a_polyline_is_never_farther_than_a_quarter_pixel_from_the_curve(kind, scale):
    camera = PlaneCamera(SIZE, scale=scale)
    for seed in range(4):
        curve = random_curve(kind, seed=seed)
        screen = camera.to_screen(curve.at(DENSE))
        seen = ((screen > 0.0) & (screen < SIZE)).all(axis=1)
        if seen.any():
            assert farthest(screen[seen], drawn(curve, camera).screen) <= TOLERANCE


@pytest.mark.parametrize("projection", ["front", "right"])
def test_space_curves_are_smooth_along_every_axis(projection):
    camera = PlaneCamera(SIZE, scale=200.0, projection=projection)
    curve = random_curve("bspline", dimension=3)
    screen = camera.to_screen(curve.at(DENSE))
    assert farthest(screen, drawn(curve, camera).screen) <= TOLERANCE


def test_panning_takes_the_same_points_again():
    curve, camera = random_curve("bspline"), PlaneCamera(SIZE, scale=100.0)
    assert drawn(curve, camera).points is drawn(curve, camera.panned((31.0, 17.0))).points


def test_a_drag_keeps_the_grid_of_the_frame_before():
    curve, camera = random_curve("bspline"), PlaneCamera(SIZE, scale=100.0)
    first = drawn(curve, camera).grid
    points = curve.lines.points.copy()
    points[3] += 0.01
    moved = replace(curve, lines=curve.lines.with_points(points))
    assert drawn(moved, camera).grid is first


def test_deep_zoom_makes_fine_only_what_is_seen():
    curve = random_curve("bspline")
    center = curve.at([0.4])[0]
    camera = PlaneCamera(SIZE, (float(center[0]), float(center[1])), scale=1e7)
    assert len(drawn(curve, camera).grid) < 2000
    near = camera.to_screen(curve.at(0.4 + np.linspace(-1e-5, 1e-5, 2001)))
    seen = near[((near > 0.0) & (near < SIZE)).all(axis=1)]
    assert farthest(seen, drawn(curve, camera).screen) <= TOLERANCE


def test_a_curve_whose_points_coincide_is_drawn():
    curve = random_curve("bezier")
    lines = curve.lines.with_points(np.ones_like(curve.lines.points))
    assert np.isfinite(drawn(replace(curve, lines=lines, s=0.0), PlaneCamera(SIZE)).screen).all()
