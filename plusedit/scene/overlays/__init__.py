"""The shelf of overlays: what can be drawn about a shape besides the shape itself.

An overlay is an entry and a function for each kind of shape that it can be drawn of, from the
shape's geometry and a camera of the plane or of space to items:

    nodes = overlay("nodes", title="Nodes", order=50, shortcut="Shift+N")

    @nodes.of_curves
    def curve_nodes(shape: Shape, curve: PlusCurve, camera: Camera) -> Iterator[Item]: ...

    @nodes.of_surfaces
    def surface_nodes(shape: Shape, surface: PlusSurface, camera: Camera) -> Iterator[Item]: ...

They are asked for every visible shape of a design while the overlay is switched on. What they
draw lies below the curves in the plane; in space depth decides.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from plusedit.document.shape import Geometry, Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.registry import Registry
from plusedit.scene.camera import Camera
from plusedit.scene.items import Item

Taken: TypeAlias = Literal["curve", "surface", "mesh"]
DrawCurve: TypeAlias = Callable[[Shape, PlusCurve, Camera], Iterable[Item]]
DrawSurface: TypeAlias = Callable[[Shape, PlusSurface, Camera], Iterable[Item]]
DrawMesh: TypeAlias = Callable[[Shape, MeshSurface, Camera], Iterable[Item]]


@dataclass
class Overlay:
    """One entry of the shelf."""

    name: str
    title: str
    """what the View menu says"""
    order: int
    """its place in the menu, and in drawing: the lowest lies below all others"""
    shortcut: str
    """such as "Shift+H", or nothing"""
    _of_curves: DrawCurve | None = field(default=None, init=False, repr=False)
    _of_surfaces: DrawSurface | None = field(default=None, init=False, repr=False)
    _of_meshes: DrawMesh | None = field(default=None, init=False, repr=False)

    @property
    def takes(self) -> frozenset[Taken]:
        """What it can be drawn of."""
        draws: dict[Taken, object] = {
            "curve": self._of_curves,
            "surface": self._of_surfaces,
            "mesh": self._of_meshes,
        }
        return frozenset(kind for kind, draw in draws.items() if draw is not None)

    def draw(self, shape: Shape, geometry: Geometry, camera: Camera) -> Iterable[Item]:
        """What is drawn of a shape; nothing of a kind that it does not take."""
        if isinstance(geometry, PlusCurve):
            return self._of_curves(shape, geometry, camera) if self._of_curves else ()
        if isinstance(geometry, MeshSurface):
            return self._of_meshes(shape, geometry, camera) if self._of_meshes else ()
        return self._of_surfaces(shape, geometry, camera) if self._of_surfaces else ()

    def of_curves(self, draw: DrawCurve) -> DrawCurve:
        """A decorator: draw curves like that."""
        self._of_curves = draw
        return draw

    def of_surfaces(self, draw: DrawSurface) -> DrawSurface:
        """A decorator: draw surfaces like that."""
        self._of_surfaces = draw
        return draw

    def of_meshes(self, draw: DrawMesh) -> DrawMesh:
        """A decorator: draw surfaces of meshes like that."""
        self._of_meshes = draw
        return draw


overlays: Registry[Overlay] = Registry("plusedit.scene.overlays")


def overlay(name: str, *, title: str, order: int, shortcut: str = "") -> Overlay:
    """A new entry on the shelf, which draws nothing yet."""
    return overlays.register(name)(Overlay(name, title, order, shortcut))


def in_order() -> list[Overlay]:
    """All overlays, in the order of the menu and of drawing."""
    return sorted(overlays.values(), key=lambda entry: (entry.order, entry.name))
