"""How far surfaces of meshes are from their meshes, by the points that are drawn of them."""

from weakref import WeakKeyDictionary

from plusedit.geometry.mesh.deviation import Deviation, deviation_of
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.mesh_drawing import MeshDrawing

_KNOWN: "WeakKeyDictionary[MeshDrawing, Deviation]" = WeakKeyDictionary()


def drawn_deviation(surface: MeshSurface, drawing: MeshDrawing) -> Deviation:
    """The distances between a mesh and the points that are drawn of its surface.

    Found if need be, in whatever thread, and kept with the drawing. ValueError where a point is
    not finite.
    """
    found = _KNOWN.get(drawing)
    if found is None:
        found = deviation_of(drawing.net.mesh, drawing.points, surface.mesh)
        _KNOWN[drawing] = found
    return found


def known_deviation(drawing: MeshDrawing) -> Deviation | None:
    """The same without waiting: None while it is not known."""
    return _KNOWN.get(drawing)
