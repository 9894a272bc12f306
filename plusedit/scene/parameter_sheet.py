"""What a view of the parameters of a mesh shows, whatever is selected and wherever it looks.

Worked out off the window's thread: of a large mesh it takes a part of a second.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Domain, PillowDomain
from plusedit.geometry.mesh.flattening.distortion import Stretch, flipped, flips, stretch
from plusedit.geometry.mesh.mapping import MapOffer, map_offers
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.unfolding import Unfolding


class Mapping(NamedTuple):
    """What a sheet depends on: objects, not values."""

    mesh: PolygonMesh
    parameters: Floats
    domain: Domain

    def lays_out(self, surface: MeshSurface) -> bool:
        """Whether the faces of a surface lie as they do here; it may be moved or bent in space."""
        return self.parameters is surface.parameters and self.domain == surface.domain

    def serves(self, surface: MeshSurface) -> bool:
        """Whether all that a sheet says is so of a surface."""
        return self.mesh is surface.mesh and self.lays_out(surface)


@dataclass(frozen=True, eq=False)
class ParameterSheet:
    """The faces of a mesh in the cell of their domain, and what the map did to them."""

    mapping: Mapping
    unfolding: Unfolding
    stretch: Stretch
    flipped: NDArray[np.bool_]
    """(f,) faces of which some triangle is turned over"""
    flips: int
    """how many triangles are turned over"""
    rims: tuple[Floats, Floats]
    """starts and ends (k, 2) of edges at the border of the mesh and at tears of the map"""
    sizes: Floats
    """(f,) the square root of the area of each face in the parameters"""
    cone_points: tuple[int, ...]
    """the vertices nearest to the cone points of a pillow, in their order; else none"""
    offers: tuple[MapOffer, ...]
    """the maps that there are"""

    @classmethod
    def of(cls, surface: MeshSurface) -> "ParameterSheet":
        """The sheet of a surface; takes its time, in whatever thread."""
        mesh, unfolding = surface.mesh, Unfolding.of(surface)
        return cls(
            Mapping(mesh, surface.parameters, surface.domain),
            unfolding,
            stretch(mesh, surface.parameters),
            flipped(mesh, surface.parameters),
            flips(mesh, surface.parameters),
            unfolding.rims,
            _sizes(unfolding),
            _cone_points(unfolding),
            map_offers(mesh),
        )

    @property
    def face_count(self) -> int:
        """f"""
        return self.unfolding.mesh.face_count


def _sizes(unfolding: Unfolding) -> Floats:
    mesh, corners = unfolding.mesh, unfolding.corners
    firsts = np.repeat(corners[mesh.starts[:-1]], mesh.sizes, axis=0)
    near, after = corners - firsts, (corners - firsts)[mesh.following]
    doubled = mesh.sums(near[:, 0] * after[:, 1] - near[:, 1] * after[:, 0])
    sizes: Floats = np.sqrt(0.5 * np.abs(doubled))
    return sizes


def _cone_points(unfolding: Unfolding) -> tuple[int, ...]:
    domain = unfolding.domain
    if not isinstance(domain, PillowDomain):
        return ()
    return tuple(unfolding.vertex_near(place) for place in domain.cone_points)
