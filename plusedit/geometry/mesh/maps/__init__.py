"""The shelf of maps: each module here is one way to give a part of a mesh parameters.

A map takes the vertices of a connected part to a domain, one to one and without turning a face
over, and keeps angles as well as it can: the Gaussians of a RaG+ surface are round in the domain.
How large a face becomes matters little.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Domain
from plusedit.geometry.mesh.flattening.sheet import Indices, Sheet
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.topology import Topology
from plusedit.registry import Registry

Progress = Callable[[float, str], None]
"""Takes what share of the work is done, and what comes next; may raise to cancel it."""


def silent(share: float, words: str) -> None:
    """Progress that is not told to anyone."""


def share_of(progress: Progress, low: float, high: float) -> Progress:
    """Progress of a piece of the work that takes its share from `low` to `high`."""

    def told(share: float, words: str) -> None:
        progress(low + (high - low) * min(share, 1.0), words)

    return told


@dataclass(frozen=True, eq=False)
class Subject:
    """A connected part that is to get parameters, with what is known and wished."""

    mesh: PolygonMesh
    topology: Topology
    uv: Floats | None = None
    """(c, 2) texture coordinates, if the file has them"""
    is_height_field: bool = False
    """whether it is known to be a terrain"""
    cone_points: tuple[int, ...] = ()
    """four vertices for the corners of a pillow, or none to have them chosen"""
    progress: Progress = field(default=silent)

    @cached_property
    def sheet(self) -> Sheet:
        """The triangles of the part."""
        return Sheet.of(self.mesh)

    @property
    def handles(self) -> int:
        """g"""
        return self.topology.components[0].handles

    @property
    def boundaries(self) -> int:
        """b"""
        return self.topology.components[0].boundaries


@dataclass(frozen=True, eq=False)
class Layout:
    """Where a map puts the corners."""

    domain: Domain
    places: Floats
    """(t, 3, 2) parameters of the corners of the mesh's triangles"""
    notes: tuple[str, ...] = ()
    """what to tell"""
    cone_points: tuple[int, ...] = ()
    """vertices at the cone points of the domain"""


class Map(Protocol):
    """One way to give a part parameters."""

    @property
    def title(self) -> str:
        """Such as "pillow"."""
        ...

    def objection(self, subject: Subject) -> str:
        """Why it can't be used for the part, as a phrase; empty where it can."""
        ...

    def drawback(self, subject: Subject) -> str:
        """Why it doesn't suit the part, as a phrase; empty where it does. Asked only where there
        is no objection."""
        ...

    def layout(self, subject: Subject) -> Layout:
        """The parameters. ValueError, with a sentence, where they can't be found after all."""
        ...


maps: Registry[Map] = Registry("plusedit.geometry.mesh.maps")
register = maps.register


def holes(count: int) -> str:
    """ "1 hole was" or "5 holes were"."""
    return "1 hole was" if count == 1 else f"{count} holes were"


def filled_but_one(subject: Subject) -> tuple[Sheet, Indices, tuple[str, ...]]:
    """The sheet with all its holes filled but the longest, the ring of that, and what to tell."""
    sheet, (rim, *others) = subject.sheet, subject.topology.loops
    if not others:
        return sheet, sheet.ring(rim), ()
    filled = sheet.filled([sheet.ring(loop) for loop in others])
    return filled, sheet.ring(rim), (f"{holes(len(others))} filled for the map",)


def all_filled(subject: Subject) -> tuple[Sheet, tuple[str, ...]]:
    """The sheet with all its holes filled, and what to tell."""
    sheet, loops = subject.sheet, subject.topology.loops
    if not loops:
        return sheet, ()
    filled = sheet.filled([sheet.ring(loop) for loop in loops])
    return filled, (f"{holes(len(loops))} filled for the map",)
