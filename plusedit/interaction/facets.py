"""Surfaces as they cover the view: which lie under a pixel, at what parameters and how deep.

A surface is looked at as the coarse grid of triangles that it is drawn with during drags, in
pixels: so one look takes no more than a few array operations, whatever the families.
"""

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.document.design import Design
from plusedit.geometry.arrays import Floats
from plusedit.geometry.surface import PlusSurface
from plusedit.interaction.face_picking import meshes_under
from plusedit.interaction.hits import Hit
from plusedit.interaction.mesh_depths import MARGIN
from plusedit.interaction.mesh_facets import facets_of_mesh, mesh_crossings
from plusedit.interaction.tool import Stage
from plusedit.scene.camera import Camera
from plusedit.scene.drawn_surface import surface_grids

BEHIND = 2e-3  # of the usual length of a pixel: smaller ones are behind the eye, or all but
FEW = 12  # points that are looked for one by one among the triangles of a mesh


@dataclass(frozen=True, eq=False)
class Facets:
    """The quadrangles of one surface; row by row, in all arrays but the parameters."""

    corners: Floats
    """(k, 4, 2) pixels, round each of them"""
    depths: Floats
    """(k, 4)"""
    low: Floats
    """(k, 2) of the box around each"""
    high: Floats
    u: Floats
    """(k, 4) the parameters of the corners"""
    v: Floats


_KEPT: "WeakKeyDictionary[PlusSurface, tuple[Camera, Facets]]" = WeakKeyDictionary()


def facets_of(surface: PlusSurface, camera: Camera) -> Facets:
    """The quadrangles of a surface in that view; those of the last view are kept."""
    kept = _KEPT.get(surface)
    if kept is None or kept[0] != camera:
        kept = _KEPT[surface] = camera, _facets(surface, camera)
    return kept[1]


def _facets(surface: PlusSurface, camera: Camera) -> Facets:
    grid_u, grid_v = surface_grids(surface, camera, draft=True)
    points = surface.sample(grid_u, grid_v)
    shape, flat = points.shape[:2], points.reshape(-1, 3)
    screen, depths = camera.to_screen(flat), camera.depths(flat)
    before = np.where(camera.pixel_at(flat) > BEHIND * camera.pixel, 1.0, 0.0)
    u, v = np.meshgrid(grid_u.parameters, grid_v.parameters, indexing="ij")
    corners = _quads(screen.reshape(*shape, 2))
    usable = _quads(before.reshape(shape)).all(axis=1) & np.isfinite(corners).all(axis=(1, 2))
    corners = corners[usable]
    return Facets(
        corners,
        _quads(depths.reshape(shape))[usable],
        np.ascontiguousarray(corners.min(axis=1)),
        np.ascontiguousarray(corners.max(axis=1)),
        _quads(u)[usable],
        _quads(v)[usable],
    )


def _quads(grid: Floats) -> Floats:
    """(k, 4, ...) the values at the corners of each cell of a grid (m_u, m_v, ...)."""
    around = [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]]
    return np.stack(around, axis=2).reshape(-1, 4, *grid.shape[2:])


def crossings(at: Floats, facets: Facets) -> list[tuple[float, float, float]]:
    """(depth, u, v) wherever the surface lies under a pixel (2,), the nearest to the eye first."""
    inside = (facets.low[:, 0] <= at[0]) & (facets.high[:, 0] >= at[0])
    inside &= (facets.low[:, 1] <= at[1]) & (facets.high[:, 1] >= at[1])
    found = []
    for row in np.flatnonzero(inside):
        for corners in ([0, 1, 2], [0, 2, 3]):
            shares = _shares(at, facets.corners[row, corners])
            if shares is not None:
                parts = (facets.depths, facets.u, facets.v)
                depth, u, v = (float(shares @ part[row, corners]) for part in parts)
                found.append((depth, u, v))
    return sorted(found)


def _shares(at: Floats, triangle: Floats) -> Floats | None:
    """(3,) what each corner of a triangle (3, 2) has in a point; None if it lies outside."""
    (ax, ay), (bx, by) = triangle[1] - triangle[0], triangle[2] - triangle[0]
    twice = float(ax * by - ay * bx)
    if twice == 0.0:
        return None
    x, y = at - triangle[0]
    second, third = (x * by - y * bx) / twice, (ax * y - ay * x) / twice
    shares = np.array([1.0 - second - third, second, third])
    return shares if shares.min() >= 0.0 else None


def surfaces_under(at: Floats, stage: Stage) -> list[Hit]:
    """Every layer of every surface that lies under the pixel, the nearest to the eye first."""
    found = [
        Hit("surface", shape_id, u=u, v=v, depth=depth)
        for shape_id, surface in stage.design.surfaces()
        if stage.design[shape_id].editable
        for depth, u, v in crossings(at, facets_of(surface, stage.camera))
    ]
    found += meshes_under(at, stage)
    return sorted(found, key=lambda hit: hit.depth)


def point_of(hit: Hit, at: Floats, camera: Camera) -> Floats:
    """(3,) the point of the world that was hit under a pixel, as deep as it lies."""
    origin, way = camera.ray(at)
    first, second = camera.depths(np.stack([origin, origin + way]))
    point: Floats = origin + (hit.depth - first) / (second - first) * way
    return point


def hidden(points: Floats, design: Design, camera: Camera) -> list[bool]:
    """Which of the points (m, 3) of the world a surface hides from the eye."""
    surfaces = [
        facets_of(surface, camera)
        for shape_id, surface in design.surfaces()
        if design[shape_id].visible
    ]
    limits = camera.depths(points) - MARGIN * camera.pixel_at(points)
    by_meshes = _hidden_by_meshes(points, limits, design, camera)
    return [
        behind
        or any((first := crossings(at, facets)) and first[0][0] < limit for facets in surfaces)
        for behind, at, limit in zip(by_meshes, camera.to_screen(points), limits, strict=True)
    ]


def _hidden_by_meshes(points: Floats, limits: Floats, design: Design, camera: Camera) -> list[bool]:
    meshes = [mesh for shape_id, mesh in design.meshes() if design[shape_id].visible]
    screen = camera.to_screen(points)
    if len(points) <= FEW:
        return [
            any(
                (layers := mesh_crossings(at, mesh, camera)) and layers[0].depth < limit
                for mesh in meshes
            )
            for at, limit in zip(screen, limits, strict=True)
        ]
    seen = screen, camera.depths(points), camera.pixel_at(points)
    behind = [facets_of_mesh(mesh, camera).map.hides(*seen) for mesh in meshes]
    found: list[bool] = np.any([np.zeros(len(points), np.bool_), *behind], axis=0).tolist()
    return found
