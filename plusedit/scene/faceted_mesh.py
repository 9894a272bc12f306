"""Polygon meshes as they are: flat faces, each with corners of its own to be lit by itself."""

from dataclasses import dataclass
from functools import cached_property
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.scene.mesh_drawing import DrawnNet, MeshDrawing
from plusedit.scene.mesh_nets import polygon_edges


@dataclass(frozen=True, eq=False)
class FacetedDrawing(MeshDrawing):
    """Faces that share no vertices."""

    @cached_property
    def normals(self) -> Floats:
        """(n, 3) unit normals of the faces, at each of their corners."""
        return unit(self.net.mesh.area_vectors)[self.net.mesh.owners]


_FACETED: "WeakKeyDictionary[PolygonMesh, MeshDrawing]" = WeakKeyDictionary()


def faceted(mesh: PolygonMesh) -> MeshDrawing:
    """The faces of a mesh with one normal each, in place of the surface that they span.

    Its vertices are the corners of the mesh. The same drawing again for the same mesh.
    """
    kept = _FACETED.get(mesh)
    if kept is None:
        kept = _FACETED[mesh] = _drawing(mesh)
    return kept


def _drawing(mesh: PolygonMesh) -> MeshDrawing:
    count = len(mesh.corners)
    split = PolygonMesh(mesh.vertices[mesh.corners], np.arange(count, dtype=np.int32), mesh.starts)
    corner_of = np.zeros(mesh.vertex_count, dtype=np.intp)
    corner_of[mesh.corners] = np.arange(count)
    pairs, counts = polygon_edges(mesh)
    edges = corner_of[pairs]
    parents = np.arange(mesh.face_count, dtype=np.int32)
    net = DrawnNet(split, np.zeros((count, 2)), edges, edges[counts == 1], parents)
    return FacetedDrawing(net, split.vertices)
