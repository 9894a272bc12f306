"""Affine maps of control lines and planes, exact for whole curves and surfaces."""

from dataclasses import dataclass

import numpy as np

from plusedit.commands.base import NetCommand, edit_shapes, fitted, fitted_matrix
from plusedit.commands.meshes import transformed_meshes
from plusedit.commands.rotation import keeps_the_plane
from plusedit.document.design import Design
from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface_transforms import transformed_surface
from plusedit.geometry.transforms import transformed


@dataclass(frozen=True, eq=False)
class Transform(NetCommand):
    """Map points by x -> matrix x + offset, and the directions given by the user as vectors.

    Where every line or plane of a shape is meant the shape becomes its exact image: under a
    similarity s takes the factor and automatic directions stay so, under any other map they
    become given. Where only some are meant, automatic directions go on following their neighbors.
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
        def mapped(shape_id: ShapeId, geometry: PlusGeometry) -> PlusGeometry:
            rows = list(self.targets[shape_id])
            if geometry.dimension == 2 and not keeps_the_plane(self.matrix):
                raise ValueError("a plane curve can be turned in the top view only")
            matrix = fitted_matrix(self.matrix, geometry.dimension)
            offset = fitted(self.offset, geometry.dimension)
            if (matrix == np.eye(len(matrix))).all() and not offset.any():
                return geometry
            return image(geometry, rows, matrix, offset)

        design, others = transformed_meshes(design, self.targets, self.matrix, self.offset)
        return edit_shapes(design, others, mapped)


def image(geometry: PlusGeometry, rows: list[int], matrix: Floats, offset: Floats) -> PlusGeometry:
    """The curve or surface with some of its lines or planes mapped, as `Transform` says."""
    net = geometry.net
    if len(set(rows)) == len(net):
        if isinstance(geometry, PlusCurve):
            return transformed(geometry, matrix, offset)
        return transformed_surface(geometry, matrix, offset)
    points, given = net.control_points.copy(), net.given_vectors.copy()
    points[rows] = points[rows] @ matrix.T + offset
    given[:, rows] = given[:, rows] @ matrix.T
    return geometry.with_net(
        net.with_control_points(points).with_vectors(given, net.automatic_vectors)
    )
