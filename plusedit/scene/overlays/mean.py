"""Mean curvature: negative on domes, positive in bowls, as seen from the front."""

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.scene import drawn_curvature
from plusedit.scene.drawn_curvature import curvatures_of_drawing, curvatures_on_grid
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.overlays import CONTRAST, Coloring, overlay

mean = overlay(
    "mean",
    title="Mean curvature",
    order=72,
    shortcut="F3",
    group="Surface analysis",
    coloring=Coloring("Mean curvature", "1 / unit", "diverging", outliers=5.0, least=1e-9),
    settings=(CONTRAST,),
)


@mean.coloring_of_surfaces
def of_surface(surface: PlusSurface, u: Floats, v: Floats) -> Floats:
    """(m_u, m_v) the means of the principal curvatures."""
    return drawn_curvature.mean(curvatures_on_grid(surface, u, v))


@mean.coloring_of_meshes
def of_mesh(surface: MeshSurface, drawing: MeshDrawing) -> Floats:
    """(n,) the same of a mesh."""
    return drawn_curvature.mean(curvatures_of_drawing(surface, drawing))
