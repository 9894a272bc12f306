"""Compiles all loops of mesh surfaces, so that the first mesh need not wait for them.

    python -m plusedit.geometry.mesh.preparation

Half a minute, the first time. What is compiled is kept (`geometry.compiling`).
"""

import numpy as np

from plusedit.geometry.mesh.deviation import deviation
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.evaluation import jets, points_and_normals
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.preview import preview
from plusedit.geometry.row_products import load_kernels

CELLS = 32  # each way: so many that the preview takes grids


def prepare() -> None:
    """Have every loop run once on a small surface; nothing where numba is missing."""
    if not load_kernels():
        return
    surface = _hill(CELLS)
    for smoothness in (0.5, 4.0):
        preview(surface.with_smoothness(smoothness), surface.vertex_places)
    points_and_normals(surface, surface.vertex_places)
    jets(surface, surface.vertex_places, highest=2)
    deviation(surface)


def _hill(count: int) -> MeshSurface:
    """Squares over a square, parameters x and y."""
    steps = np.linspace(0.0, 1.0, count + 1)
    places = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    heights = np.sin(3.0 * places).prod(axis=1)
    low = (np.arange(count)[:, None] * (count + 1) + np.arange(count)).ravel()
    faces = np.stack([low, low + 1, low + count + 2, low + count + 1], axis=1)
    mesh = PolygonMesh.of_rows(np.column_stack([places, heights]), faces)
    return MeshSurface(mesh, PlaneDomain(), places[faces].reshape(-1, 2))


if __name__ == "__main__":
    prepare()
