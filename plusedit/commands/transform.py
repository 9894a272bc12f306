"""Affine maps of control lines and planes, exact for whole curves, surfaces and meshes."""

from dataclasses import dataclass

import numpy as np

from plusedit.commands.base import NetCommand, edit_geometries, fitted, fitted_matrix, rows_meant
from plusedit.commands.meshes import transformed_meshes
from plusedit.commands.rotation import keeps_the_plane
from plusedit.document.design import Design
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_transforms import transformed_surface
from plusedit.geometry.transforms import transformed


@dataclass(frozen=True, eq=False)
class Transform(NetCommand):
    """Map points by x -> matrix x + offset, and the directions given by the user as vectors.

    Where every line or plane of a shape is meant the shape becomes its exact image: under a
    similarity s takes the factor and automatic directions stay so, under any other map they
    become given. Where only some are meant, automatic directions go on following their neighbors;
    those of faces, which follow nothing, are mapped and become given.
    """

    matrix: Floats
    """(2, 2) or (3, 3); in a dimension that it has not, nothing changes"""
    offset: Floats
    """(2,) or (3,)"""
    name: str = "Transform"
    """the verb of the label"""

    @property
    def verb(self) -> str:
        return self.name

    def apply(self, design: Design) -> Design:
        def mapped(shape_id: ShapeId, geometry: Geometry) -> Geometry:
            rows = rows_meant(design, shape_id, self.targets[shape_id])
            if geometry.dimension == 2 and not keeps_the_plane(self.matrix):
                raise ValueError("a plane curve can be turned in the top view only")
            matrix = fitted_matrix(self.matrix, geometry.dimension)
            offset = fitted(self.offset, geometry.dimension)
            if (matrix == np.eye(len(matrix))).all() and not offset.any():
                return geometry
            return image(geometry, rows, matrix, offset)

        design, others = transformed_meshes(design, self.targets, self.matrix, self.offset)
        return edit_geometries(design, others, lambda i: design[i].geometry, mapped)


def image(geometry: Geometry, rows: list[int], matrix: Floats, offset: Floats) -> Geometry:
    """The geometry with some of its lines or planes mapped, as `Transform` says."""
    net = geometry.net
    if len(set(rows)) == len(net):
        if isinstance(geometry, PlusCurve):
            return transformed(geometry, matrix, offset)
        if isinstance(geometry, PlusSurface):
            return transformed_surface(geometry, matrix, offset)
    points, automatic = net.control_points.copy(), net.automatic_vectors
    points[rows] = points[rows] @ matrix.T + offset
    if isinstance(geometry, MeshSurface):
        # What is a face's own does not follow its neighbors: it would stay as it is.
        given, automatic = geometry.vectors.copy(), automatic.copy()
        automatic[:, rows] = False
    else:
        given = net.given_vectors.copy()
    given[:, rows] = given[:, rows] @ matrix.T
    return geometry.with_net(net.with_control_points(points).with_vectors(given, automatic))
