"""Small surfaces of meshes to draw."""

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh

HILL = ShapeId("hill")


def a_hill(count=6, **options):
    """A height field of count x count quads over [0, 1]^2, parameters x and y."""
    side = np.linspace(0.0, 1.0, count + 1)
    x, y = (values.ravel() for values in np.meshgrid(side, side, indexing="ij"))
    vertices = np.stack([x, y, 0.5 * np.exp(-8.0 * ((x - 0.5) ** 2 + (y - 0.4) ** 2))], axis=1)
    number = np.arange(len(x)).reshape(count + 1, -1)
    around = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    faces = np.stack(around, axis=-1).reshape(-1, 4)
    mesh = PolygonMesh.of_rows(vertices, faces)
    return MeshSurface(mesh, PlaneDomain(), vertices[mesh.corners, :2], **options)


def a_landscape(surface=None, **shape):
    """A design with a hill."""
    return Design({HILL: Shape(surface or a_hill(), "Hill", **shape)})
