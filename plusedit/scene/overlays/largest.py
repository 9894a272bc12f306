"""The largest of the curvatures that a surface has in all directions at a point."""

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.drawn_curvature import curvatures_of_drawing, curvatures_on_grid
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.overlays import CONTRAST, Coloring, overlay

largest = overlay(
    "largest",
    title="Largest curvature",
    order=73,
    shortcut="F4",
    group="Surface analysis",
    coloring=Coloring("Largest curvature", "1 / unit", "diverging", outliers=5.0, least=1e-9),
    settings=(CONTRAST,),
)


@largest.coloring_of_surfaces
def of_surface(surface: PlusSurface, u: Floats, v: Floats) -> Floats:
    """(m_u, m_v) the largest principal curvatures."""
    return curvatures_on_grid(surface, u, v).largest


@largest.coloring_of_meshes
def of_mesh(surface: MeshSurface, drawing: MeshDrawing) -> Floats:
    """(n,) the same of a mesh."""
    return curvatures_of_drawing(surface, drawing).largest
