"""The polygon mesh that a surface smooths, as it was read."""

from collections.abc import Iterator
from weakref import WeakKeyDictionary

from plusedit.document.shape import Shape
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.scene.items import Item, Segments
from plusedit.scene.mesh_nets import polygon_edges
from plusedit.scene.overlays import Seen, overlay

COLOR = "classical@60"

_EDGES: "WeakKeyDictionary[PolygonMesh, Segments]" = WeakKeyDictionary()

original_mesh = overlay("mesh", title="Original mesh", order=45, shortcut="Shift+M")


@original_mesh.of_meshes
def mesh_edges(shape: Shape, surface: MeshSurface, seen: Seen) -> Iterator[Item]:
    """Hairlines along the edges of all faces."""
    mesh = surface.mesh
    kept = _EDGES.get(mesh)
    if kept is None:
        edges = polygon_edges(mesh)[0]
        ends = mesh.vertices[edges[:, 0]], mesh.vertices[edges[:, 1]]
        kept = _EDGES[mesh] = Segments(*ends, COLOR, 1.0)
    yield kept
