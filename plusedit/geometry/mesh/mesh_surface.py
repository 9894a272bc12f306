"""RaG+ surfaces: the control planes of a polygon mesh, blended by rational Gaussians.

    S(x) = sum_i W_i L_i(x) G_i(x) / sum_i W_i G_i(x),   G_i(x) = exp(-|x - c_i|^2 / (2 sigma_i^2))
    L_i(x) = P_i + s ((x - c_i)_u A_i + (x - c_i)_v B_i),   sigma_i = S r_i

over the planes of all faces and their images in the domain. The smoothness S tells how much detail
is left, the magnitude s how much of the planes is used: 1 the planes of the faces, 0 the points
alone.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import isfinite

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.mesh.domains import Domain
from plusedit.geometry.mesh.face_net import EditedPlane, EditedPlanes, FaceNet
from plusedit.geometry.mesh.foundation import Foundation, FoundationParts
from plusedit.geometry.mesh.planes import FacePlanes
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.net import ControlNet

__all__ = ["USUAL_SMOOTHNESS", "EditedPlane", "MeshSurface"]

USUAL_SMOOTHNESS = 0.7


@dataclass(frozen=True, eq=False)
class MeshSurface:
    """A RaG+ surface; never changed in place and compared by identity.

    ValueError where parts do not fit together or no face has a control plane.
    """

    mesh: PolygonMesh
    domain: Domain
    parameters: Floats
    """(c, 2) one (u, v) per corner, unwrapped within every face"""
    smoothness: float = USUAL_SMOOTHNESS
    """S > 0"""
    s: float = 1.0
    area_weights: bool = False
    """whether faces count by their area over their squared radius"""
    edited: Mapping[int, EditedPlane] = field(default_factory=dict)
    """by face"""
    factors: Floats | None = None
    """(f,) positive local factors of the smoothness, or None where all are one"""
    shared: Foundation | None = field(default=None, repr=False)
    """the foundation of another surface; made anew unless it is of the same faces"""

    def __post_init__(self) -> None:
        count = self.mesh.face_count
        if not (isfinite(self.smoothness) and self.smoothness > 0.0):
            raise ValueError(f"smoothness: must be positive and finite, got {self.smoothness}")
        if not isfinite(self.s):
            raise ValueError(f"s: must be finite, got {self.s}")
        edited = EditedPlanes.of(self.edited)
        for face in (*edited.faces[:1].tolist(), *edited.faces[-1:].tolist()):
            if not 0 <= face < count:
                raise ValueError(f"planes: there is no face {face}, only 0 to {count - 1}")
        object.__setattr__(self, "edited", edited)
        if self.shared is not None and self.shared.serves(self.foundation_parts):
            return
        if self.shared is None or self.parameters is not self.shared.parts.parameters:
            shape = (len(self.mesh.corners), 2)
            parameters = frozen(self.parameters, shape=shape, name="parameters")
            object.__setattr__(self, "parameters", parameters)
        if self.factors is not None:
            factors = frozen(self.factors, shape=(count,), name="factors")
            if count and factors.min() <= 0.0:
                raise ValueError(f"factors: must be positive, got {factors.min()}")
            object.__setattr__(self, "factors", factors)
        object.__setattr__(self, "shared", Foundation.of(self.foundation_parts, self.shared))

    @property
    def foundation_parts(self) -> FoundationParts:
        """What the foundation depends on."""
        return FoundationParts(
            self.mesh, self.domain, self.parameters, self.area_weights, self.factors
        )

    @property
    def foundation(self) -> Foundation:
        """What does not depend on S, s and the edits; the same object as long as that is so."""
        assert self.shared is not None
        return self.shared

    @property
    def planes(self) -> FacePlanes:
        """The control planes with the edits made; centers, radii and weights stay the faces'.

        The same object as long as the edits are, whatever S and s.
        """
        return self.net.planes if self.edited else self.foundation.planes

    @property
    def dimension(self) -> int:
        """3, as of every mesh."""
        return 3

    @property
    def net(self) -> FaceNet:
        """The control planes, as edits see them."""
        return EditedPlanes.of(self.edited).on(self.foundation.net)

    @property
    def vectors(self) -> Floats:
        """(2, f, 3) the gradients A and B of all faces."""
        return self.net.vectors

    def with_net(self, net: ControlNet) -> "MeshSurface":
        """The same faces with other control planes; only what is not the faces' own is kept."""
        if not isinstance(net, FaceNet):
            raise TypeError("a mesh has the control planes of its faces")
        return self.with_edited(net.edited)

    @property
    def sigmas(self) -> Floats:
        """(f,) the widths of the Gaussians; zero for faces without a plane."""
        widths: Floats = self.smoothness * self.foundation.reaches
        return widths

    @cached_property
    def vertex_places(self) -> Floats:
        """(n, 2) parameters of the vertices, each as in its first corner.

        A vertex of no face has those of the first corner of all.
        """
        places = np.zeros((self.mesh.vertex_count, 2))
        if len(self.mesh.corners):
            places[:] = self.parameters[0]
            # Written backwards, so that the first corner of each vertex is the one that stays.
            places[self.mesh.corners[::-1]] = self.parameters[::-1]
        places.flags.writeable = False
        return places

    def at(self, places: ArrayLike) -> Floats:
        """(m, 3) points at places (m, 2), to full accuracy.

        A plane is left out only where its exponent is more than 36 below the largest there.
        """
        from plusedit.geometry.mesh.evaluation import evaluated

        return evaluated(self, np.asarray(places, dtype=np.float64), derivatives=False)[0]

    def derivatives(self, places: ArrayLike, *, highest: int = 1) -> tuple[Floats, ...]:
        """(S, S_u, S_v, S_uu, S_uv, S_vv) up to order `highest` at places (m, 2), (m, 3) each.

        To full accuracy.
        """
        from plusedit.geometry.mesh.evaluation import jets

        return jets(self, np.asarray(places, dtype=np.float64), highest=highest)

    def with_smoothness(self, smoothness: float) -> "MeshSurface":
        """The same planes with another S."""
        return replace(self, smoothness=smoothness)

    def with_s(self, s: float) -> "MeshSurface":
        """The same planes with another magnitude."""
        return replace(self, s=s)

    def with_edited(self, edited: Mapping[int, EditedPlane]) -> "MeshSurface":
        """The surface with these edits in place of all others."""
        return replace(self, edited=edited)

    def with_plane(
        self,
        face: int,
        point: ArrayLike | None = None,
        gradient_u: ArrayLike | None = None,
        gradient_v: ArrayLike | None = None,
    ) -> "MeshSurface":
        """The surface with other parts of one control plane; those not given stay as they are."""
        before = self.edited.get(face, EditedPlane())
        parts = {"point": point, "gradient_u": gradient_u, "gradient_v": gradient_v}
        given = {name: np.asarray(part) for name, part in parts.items() if part is not None}
        return self.with_edited({**self.edited, face: replace(before, **given)})

    def with_factors(self, factors: ArrayLike | None) -> "MeshSurface":
        """The surface with other local factors (f,) of the smoothness."""
        return replace(self, factors=None if factors is None else np.asarray(factors))

    def transformed(self, matrix: ArrayLike, offset: ArrayLike) -> "MeshSurface":
        """The surface of the mesh and the edited planes after x -> matrix x + offset."""
        turn, shift = np.asarray(matrix, dtype=np.float64), np.asarray(offset, dtype=np.float64)
        edited = EditedPlanes.of(self.edited).transformed(turn, shift)
        mesh = self.mesh.with_vertices(self.mesh.vertices @ turn.T + shift)
        return replace(self, mesh=mesh, edited=edited)
