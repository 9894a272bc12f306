"""Surfaces of meshes on an even grid of their parameters, as files of triangles want them."""

from dataclasses import replace
from typing import Any

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.maps import Progress, silent
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.rectangle import Rectangle
from plusedit.io.fields import of_number
from plusedit.io.surface_mesh import SurfaceMesh, crossed

MOST = 16_000_000  # points: some gigabytes of memory
AT_ONCE = 65_536  # points that are evaluated before anybody may give up


def gridded(
    surface: MeshSurface,
    over: Rectangle,
    cells: tuple[int, int],
    *,
    name: str = "",
    color: str | None = None,
    numbers: Any = np.float64,
    tell: Progress = silent,
) -> SurfaceMesh:
    """The surface, to full accuracy, at the corners of so many cells along u and v.

    Parameters run from 0 to 1 along both sides of the rectangle. `numbers` is the kind of number
    that points are rounded to. ValueError where there would be too many points, or a point is
    beyond those numbers.
    """
    count = (cells[0] + 1) * (cells[1] + 1)
    if count > MOST:
        raise ValueError(f"a grid of {of_number(count, 'point')} is more than {MOST}")
    u, v = over.lines(cells)
    shape = (len(u), len(v), 3)
    places = np.stack(np.meshgrid(u, v, indexing="ij"), axis=-1).reshape(-1, 2)
    points, normals = np.empty((len(places), 3)), np.empty((len(places), 3))
    with np.errstate(all="ignore"):
        for first in range(0, len(places), AT_ONCE):
            tell(first / len(places), "evaluating the surface")
            rows = slice(first, first + AT_ONCE)
            points[rows], normals[rows] = _evaluated(surface, places[rows])
        rounded = points.astype(numbers).reshape(shape)
    if not np.isfinite(points).all():
        raise ValueError("a point is beyond a double")
    if not np.isfinite(rounded).all():
        raise ValueError("a point is beyond the numbers that the file has")
    directions = (-normals if over.is_mirrored else normals).astype(np.float32).reshape(shape)
    even_u, even_v = (np.linspace(0.0, 1.0, len(line)) for line in (u, v))
    poles = (False, False, False, False)
    mesh = SurfaceMesh(
        name, color, rounded, directions, even_u, even_v, over.closed, poles, over.is_mirrored
    )
    return _sewn(mesh)


def _evaluated(surface: MeshSurface, places: Floats) -> tuple[Floats, Floats]:
    """(m, 3) each: points and unit normals."""
    points, by_u, by_v = surface.derivatives(places)
    return points, crossed(by_u, by_v, surface.mesh.diagonal)[0]


def _sewn(mesh: SurfaceMesh) -> SurfaceMesh:
    """What is one place on both sides of a seam made the same to the last bit."""
    points, normals = mesh.points.copy(), mesh.normals.copy()
    for grid in (points, normals):
        if mesh.closed[0]:
            grid[-1] = grid[0]
        if mesh.closed[1]:
            grid[:, -1] = grid[:, 0]
    return replace(mesh, points=points, normals=normals)
