"""What the surfaces of one mesh with parameters share, whatever S, s and the edits are."""

from functools import cached_property
from typing import NamedTuple

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Domain
from plusedit.geometry.mesh.face_net import FaceNet
from plusedit.geometry.mesh.plane_tree import PlaneTree
from plusedit.geometry.mesh.planes import FacePlanes, planes_of
from plusedit.geometry.mesh.polygons import PolygonMesh


class FoundationParts(NamedTuple):
    """What a foundation is made of."""

    mesh: PolygonMesh
    domain: Domain
    parameters: Floats
    area_weights: bool
    factors: Floats | None


class Foundation:
    """The faces' control planes and where they are, each computed when first asked for."""

    def __init__(self, parts: FoundationParts) -> None:
        self.parts = parts

    @classmethod
    def of(cls, parts: FoundationParts, before: "Foundation | None" = None) -> "Foundation":
        """The foundation of these parts; of another one what it has in common is kept."""
        found = cls(parts)
        if before is not None and before.serves(parts._replace(factors=before.parts.factors)):
            found.planes, found.net = before.planes, before.net
        return found

    def serves(self, parts: FoundationParts) -> bool:
        """Whether it is of the same mesh, parameters and factors: objects, not values."""
        mesh, domain, parameters, area_weights, factors = self.parts
        return (
            mesh is parts.mesh
            and domain == parts.domain
            and parameters is parts.parameters
            and area_weights == parts.area_weights
            and factors is parts.factors
        )

    @property
    def domain(self) -> Domain:
        return self.parts.domain

    @cached_property
    def planes(self) -> FacePlanes:
        """The control planes of the faces, without edits; ValueError where no face has one."""
        planes = planes_of(self.parts.mesh, self.parts.parameters, self.parts.area_weights)
        if not len(planes.used):
            raise ValueError("parameters: no face has any extent in them, so there is no surface")
        return planes

    @cached_property
    def net(self) -> FaceNet:
        """The same planes, as edits see them."""
        return FaceNet.of(self.planes)

    @cached_property
    def reaches(self) -> Floats:
        """(f,) sigma_i / S: the radii times the local factors."""
        factors, radii = self.parts.factors, self.planes.radii
        return radii if factors is None else radii * factors

    @cached_property
    def tree(self) -> PlaneTree:
        """Where the planes are; those of faces without parameter area are left out."""
        centers = self.domain.shifted(self.planes.centers)
        return PlaneTree.of(centers, self.reaches, self.planes.used)
