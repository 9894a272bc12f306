"""Surfaces of meshes at places that triangles join: what is drawn of them."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import PolygonMesh

Pairs: TypeAlias = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class DrawnNet:
    """Where surfaces of a mesh are evaluated, and how those places are joined."""

    mesh: PolygonMesh
    """the faces that are drawn: those of the mesh, or parts of them"""
    places: Floats
    """(n, 2) parameters of their vertices"""
    edges: Pairs
    """(k, 2) vertices joined by the edges of the faces before they were split"""
    boundary: Pairs
    """(b, 2) those of edges that have a face on one side only"""
    parents: NDArray[np.int32]
    """(f,) the face of the mesh in which each face lies"""
    sides: Floats | None = None
    """(n,) 1, or -1 where the fronts of the faces around look against S_u x S_v; None: 1"""
    latest: "list[MeshDrawing]" = field(default_factory=list, repr=False)
    """the last drawing that was made with it, if any"""

    @property
    def triangles(self) -> NDArray[np.int32]:
        """(t, 3) vertices."""
        return self.mesh.triangulation.triangles

    @cached_property
    def corners(self) -> NDArray[np.int32]:
        """(3, t) the same in three rows."""
        return np.ascontiguousarray(self.triangles.T)

    @cached_property
    def faces(self) -> NDArray[np.int32]:
        """(t,) the face of the mesh before in which each triangle lies."""
        return self.parents[self.mesh.triangulation.owners]


@dataclass(frozen=True, eq=False)
class MeshDrawing:
    """A surface at the vertices of a net."""

    net: DrawnNet
    points: Floats
    """(n, 3)"""
    given: Floats | None = None
    """(n, 3) normals as `normals` has them, where they are known"""
    is_exact: bool = True
    """whether all is to full accuracy; else it is near enough for a moment"""

    @classmethod
    def of(
        cls, net: DrawnNet, points: NDArray[np.floating], across: NDArray[np.floating], exact: bool
    ) -> "MeshDrawing":
        """A surface with its unit vectors along S_u x S_v (n, 3)."""
        normals = across if net.sides is None else net.sides[:, None] * across
        return cls(net, points.astype(np.float64), normals.astype(np.float64), exact)

    @cached_property
    def normals(self) -> Floats:
        """(n, 3) unit vectors to the front, or zero where there is none.

        Where not given, the means of the triangles around.
        """
        if self.given is not None:
            return self.given
        return vertex_normals(self.points, self.net.triangles)

    def lines(self, pairs: Pairs) -> tuple[Floats, Floats]:
        """(k, 3) starts and ends of the segments that join vertices."""
        return self.points[pairs[:, 0]], self.points[pairs[:, 1]]


def vertex_normals(points: Floats, triangles: NDArray[np.int32]) -> Floats:
    """(n, 3) unit normals of points by the triangles around them, large ones counting for more."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    flat, count = triangles.ravel(), len(points)
    sums = [np.bincount(flat, np.repeat(across[:, k], 3), count) for k in range(3)]
    normals = np.stack(sums, axis=1)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    unit: Floats = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0.0)
    return unit
