"""Gaussian curvature: positive on domes and bowls, negative on saddles, zero on what unrolls."""

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.scene import drawn_curvature
from plusedit.scene.drawn_curvature import curvatures_of_drawing, curvatures_on_grid
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.overlays import CONTRAST, Coloring, overlay

gaussian = overlay(
    "gaussian",
    title="Gaussian curvature",
    order=71,
    shortcut="F2",
    group="Surface analysis",
    coloring=Coloring("Gaussian curvature", "1 / unit²", "diverging", outliers=5.0, least=1e-15),
    settings=(CONTRAST,),
)


@gaussian.coloring_of_surfaces
def of_surface(surface: PlusSurface, u: Floats, v: Floats) -> Floats:
    """(m_u, m_v) the products of the principal curvatures."""
    return drawn_curvature.gaussian(curvatures_on_grid(surface, u, v))


@gaussian.coloring_of_meshes
def of_mesh(surface: MeshSurface, drawing: MeshDrawing) -> Floats:
    """(n,) the same of a mesh."""
    return drawn_curvature.gaussian(curvatures_of_drawing(surface, drawing))
