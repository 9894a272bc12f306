"""How far surfaces of meshes are from their meshes, by the points that are drawn of them."""

from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.mesh.deviation import Deviation, deviation_of
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.moved_meshes import affine_way

_KNOWN: "WeakKeyDictionary[MeshDrawing, Deviation]" = WeakKeyDictionary()


def drawn_deviation(surface: MeshSurface, drawing: MeshDrawing) -> Deviation:
    """The distances between a mesh and the points that are drawn of its surface.

    Found if need be, in whatever thread, and kept with the drawing. ValueError where a point is
    not finite.
    """
    found = _KNOWN.get(drawing)
    if found is None:
        found = deviation_of(_drawn_mesh(surface, drawing), drawing.points, surface.mesh)
        _KNOWN[drawing] = found
    return found


def known_deviation(drawing: MeshDrawing) -> Deviation | None:
    """The same without waiting: None while it is not known."""
    return _KNOWN.get(drawing)


def _drawn_mesh(surface: MeshSurface, drawing: MeshDrawing) -> PolygonMesh:
    """The faces that are drawn where the mesh is now: it may have been moved since."""
    drawn = drawing.net.mesh
    before = drawn.vertices[: surface.mesh.vertex_count]
    if np.array_equal(before, surface.mesh.vertices):
        return drawn
    way = affine_way(before, surface.mesh)
    return drawn if way is None else drawn.with_vertices(way.moved(drawn.vertices))
