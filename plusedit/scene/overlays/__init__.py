"""The shelf of overlays: what can be drawn about a shape besides the shape itself.

An overlay is a function from a curve and a camera to items, below the curves in drawing order:

    @overlay("nodes", title="Nodes", order=50, shortcut="Shift+N")
    def draw(shape: Shape, curve: PlusCurve, camera: PlaneCamera) -> Iterator[Item]: ...

It is asked for every visible curve of a design while it is switched on.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TypeAlias

from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.registry import Registry
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Item

Draw: TypeAlias = Callable[[Shape, PlusCurve, PlaneCamera], Iterable[Item]]


@dataclass(frozen=True)
class Overlay:
    """One entry of the shelf."""

    name: str
    title: str
    """what the View menu says"""
    order: int
    """its place in the menu, and in drawing: the lowest lies below all others"""
    shortcut: str
    """such as "Shift+H", or nothing"""
    draw: Draw


overlays: Registry[Overlay] = Registry("plusedit.scene.overlays")


def overlay(name: str, *, title: str, order: int, shortcut: str = "") -> Callable[[Draw], Draw]:
    """A decorator that puts a drawing function on the shelf."""

    def put(draw: Draw) -> Draw:
        overlays.register(name)(Overlay(name, title, order, shortcut, draw))
        return draw

    return put


def in_order() -> list[Overlay]:
    """All overlays, in the order of the menu and of drawing."""
    return sorted(overlays.values(), key=lambda entry: (entry.order, entry.name))
