"""How far the surface of a mesh is from the mesh, in percent of the mesh's size.

The size is the diagonal of the box around the mesh: so large and small ones can be compared.
"""

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.drawn_deviation import drawn_deviation
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.overlays import Coloring, overlay

NO_MORE_THAN_ROUNDING = 1e-6  # percent

deviation = overlay(
    "deviation",
    title="Deviation from the mesh",
    order=70,
    shortcut="Shift+D",
    coloring=Coloring("Deviation", "% of the size", least=NO_MORE_THAN_ROUNDING),
    group="Surface analysis",
)


@deviation.coloring_of_meshes
def distances(surface: MeshSurface, drawing: MeshDrawing) -> Floats:
    """(n,) of the points of the mesh that are drawn moved to the surface, from that surface."""
    found = drawn_deviation(surface, drawing)
    shares: Floats = 100.0 * found.from_mesh / (found.diagonal or 1.0)
    return shares
