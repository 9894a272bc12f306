"""Surfaces as grids: fine enough, no finer than need be, and the same while they can be."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings

from plusedit.geometry.blend import Grid
from plusedit.geometry.pieces import breaks
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn_surface import MOST, TOLERANCE, surface_grids
from plusedit.scene.isolines import isolines
from plusedit.scene.space_camera import SpaceCamera
from tests.geometry.surfaces import PAIRS, a_surface, random_surface, surfaces

CAMERA = SpaceCamera((800.0, 600.0), (1.5, 2.0, 0.0), 6.0)
WIDE = SpaceCamera((800.0, 600.0), height=6.0)


def halved(grid):
    u = grid.parameters
    return Grid(np.sort(np.concatenate([u, (u[:-1] + u[1:]) / 2.0])))


def strays(surface, grids, camera):
    """Pixels from the middles of the sides of facets to the middles of their chords, at most."""
    by_u, by_v = grids
    found = []
    for points in (
        surface.sample(halved(by_u), by_v),
        surface.sample(by_u, halved(by_v)).swapaxes(0, 1),
    ):
        screen = camera.to_screen(points.reshape(-1, 3)).reshape(*points.shape[:2], 2)
        off = screen[1::2] - (screen[:-1:2] + screen[2::2]) / 2.0
        found.append(np.hypot(off[..., 0], off[..., 1]).max())
    return max(found)


def size(grids):
    return len(grids[0]) * len(grids[1])


@pytest.mark.parametrize("kinds", [pair for pair in PAIRS if "staircase" not in pair])
def test_facets_stray_no_farther_than_the_tolerance(kinds):
    surface = random_surface(*kinds, seed=3, s=0.7)
    grids = surface_grids(surface, WIDE)
    # Where there is perspective, half a chord in the world is not quite half a chord seen.
    assert strays(surface, grids, WIDE) <= 1.1 * TOLERANCE or size(grids) > MOST / 4


@pytest.mark.parametrize("kinds", PAIRS)
def test_every_knot_is_among_the_parameters(kinds):
    surface = random_surface(*kinds)
    for basis, grid in zip(surface.bases, surface_grids(surface, CAMERA), strict=True):
        assert np.isin(breaks(basis), grid.parameters).all()
        assert (np.diff(grid.parameters) > 0.0).all()
        assert grid.parameters[[0, -1]].tolist() == [0.0, 1.0]


def test_a_nearer_surface_is_finer_and_a_draft_is_coarser():
    surface = a_surface()
    far = size(surface_grids(surface, replace(CAMERA, height=100.0)))
    near = size(surface_grids(surface, replace(CAMERA, height=2.0)))
    assert far < near
    assert size(surface_grids(surface, replace(CAMERA, height=2.0), draft=True)) < near


def test_there_are_never_more_points_than_can_be_drawn():
    surface = random_surface("rag", "bspline", shape=(9, 9), s=5.0)
    for height in (1.0, 1e-2, 1e-5):
        assert size(surface_grids(surface, replace(WIDE, height=height))) <= MOST


def test_the_grids_stay_while_s_changes_and_the_view_turns():
    surface = a_surface()
    first = surface_grids(surface, CAMERA)
    for share in np.linspace(0.0, 1.0, 20):
        other = replace(surface, s=0.5 + 0.3 * share)
        turned = CAMERA.orbited(2.0 * share, 0.5 * share)
        for grid, old in zip(surface_grids(other, turned), first, strict=True):
            assert grid is old


def test_the_grids_stay_while_a_control_point_is_dragged():
    surface = a_surface()
    first = surface_grids(surface, CAMERA)
    for share in np.linspace(0.0, 1.0, 20):
        points = surface.planes.points.copy()
        points[1, 2, 2] += 0.5 * share
        moved = replace(surface, planes=surface.planes.with_points(points))
        for grid, old in zip(surface_grids(moved, CAMERA), first, strict=True):
            assert grid is old


def test_the_same_view_has_the_very_same_grids():
    surface = a_surface()
    assert surface_grids(surface, CAMERA) is surface_grids(surface, CAMERA)


def test_what_is_far_beside_the_view_is_coarser_than_what_is_seen():
    surface = a_surface(13, 12)
    near = CAMERA.looking("top").framing(surface.at([0.1, 0.2], [0.1, 0.2]).reshape(-1, 3))
    by_u, _ = surface_grids(surface, near)
    u = by_u.parameters
    assert np.diff(u)[u[:-1] < 0.25].mean() < 0.25 * np.diff(u)[u[:-1] > 0.75].mean()


def test_a_plane_view_has_grids_too():
    surface = a_surface()
    camera = PlaneCamera((800.0, 600.0), (1.5, 2.0), 100.0)
    assert strays(surface, surface_grids(surface, camera), camera) <= 1.1 * TOLERANCE


@settings(max_examples=25)
@given(surfaces())
def test_every_surface_has_grids(surface):
    for camera in (CAMERA, replace(CAMERA, perspective=False), PlaneCamera((800.0, 600.0))):
        assert 4 <= size(surface_grids(surface, camera)) <= MOST


# Lines


@pytest.mark.parametrize("kinds", PAIRS)
def test_lines_on_a_surface_lie_on_it_and_edges_are_where_it_is_open(kinds):
    surface = random_surface(*kinds)
    lines = isolines(surface, surface_grids(surface, CAMERA))
    assert len(lines.edges) == 2 * sum(not closed for closed in surface.closed)
    grid_u = surface_grids(surface, CAMERA)[0]
    nodes_v = np.unique(surface.basis_v.nodes)
    inner = nodes_v if surface.closed[1] else nodes_v[(nodes_v > 0.0) & (nodes_v < 1.0)]
    for points, v in zip(lines.along_u, inner, strict=True):
        np.testing.assert_allclose(points, surface.at(grid_u.parameters, [v])[:, 0], atol=1e-9)


def test_few_nodes_have_lines_between_them_and_many_have_fewer_lines():
    few = a_surface(3, 3)
    assert isolines(few, surface_grids(few, CAMERA)).between_u
    many = a_surface(100, 4)
    lines = isolines(many, surface_grids(many, CAMERA))
    assert not lines.between_v
    assert 12 <= len(lines.along_v) <= 24


def test_the_lines_of_a_view_are_kept_while_another_view_looks():
    surface = a_surface()
    first, second = (surface_grids(surface, replace(CAMERA, height=h)) for h in (1.0, 500.0))
    lines = isolines(surface, first)
    isolines(surface, second)
    assert isolines(surface, first) is lines
