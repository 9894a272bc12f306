"""What the file of a mesh or a terrain says."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import PolygonMesh

Numbers = NDArray[np.int32]
Up: TypeAlias = Literal["y", "z"]
"""The axis that points up."""


@dataclass(frozen=True, eq=False)
class MeshFile:
    """A mesh as it stands in a file, but without faces that no polygon can be made of.

    Nothing is welded or turned around, but for formats in which every face repeats its points.
    """

    mesh: PolygonMesh
    uv: Floats | None = None
    """(c, 2) texture coordinates of every corner, v upwards; None if any corner has none"""
    groups: Mapping[str, Numbers] = field(default_factory=dict)
    """by name, the numbers of the faces that the file puts together, ascending"""
    is_height_field: bool = False
    """whether it is a terrain: z over a grid in x and y"""
    notes: tuple[str, ...] = ()
    """what was left out, ignored or assumed in reading: one sentence a kind"""
    up: Up = "z"
    """as the kind of file has it"""

    def upright(self, up: Up | None = None) -> "MeshFile":
        """The same with z up, where `up` is up in the file; None for what its kind has up."""
        if (up or self.up) == "z":
            return self
        x, y, z = self.mesh.vertices.T
        turned = np.stack([x, 0.0 - z, y], axis=1)
        return replace(self, mesh=self.mesh.with_vertices(turned), up="z")
