"""A surface of a mesh gets other parameters; control planes that were edited stay in space.

The gradients of a plane are derivatives by u and v. For parameters u', v' that depend on u and v
within a face, the same plane has

    A' = A du/du' + B dv/du',      B' = A du/dv' + B dv/dv',

where the derivatives are those of the linear map that fits the face's corners best; of a triangle
it meets them.
"""

from dataclasses import replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Domain
from plusedit.geometry.mesh.mesh_surface import EditedPlane, MeshSurface
from plusedit.geometry.mesh.planes import planes_of
from plusedit.geometry.mesh.polygons import PolygonMesh


def remapped(surface: MeshSurface, domain: Domain, parameters: Floats) -> MeshSurface:
    """The surface with other parameters (c, 2), unwrapped within every face.

    Edited planes keep their points, and lie in space as before. ValueError where the parameters do
    not fit the mesh or no face has any extent in them.
    """
    turned = [
        face
        for face, edit in surface.edited.items()
        if edit.gradient_u is not None or edit.gradient_v is not None
    ]
    edited = dict(surface.edited)
    if turned:
        by_u, by_v = _derivatives(surface, parameters, turned)
        planes = surface.planes
        rows = np.stack([planes.gradients_u[turned], planes.gradients_v[turned]], axis=1)
        new_u, new_v = (np.einsum("fk,fkd->fd", by, rows) for by in (by_u, by_v))
        for face, along_u, along_v in zip(turned, new_u, new_v, strict=True):
            edited[face] = EditedPlane(surface.edited[face].point, along_u, along_v)
    found = replace(surface, domain=domain, parameters=parameters, edited=edited, shared=None)
    _ = found.foundation.planes  # where there are none, that is told here
    return found


def _derivatives(
    surface: MeshSurface, parameters: Floats, faces: list[int]
) -> tuple[Floats, Floats]:
    """(k, 2) of each of the faces the derivatives of its old (u, v) by the new u, and by the
    new v."""
    taken = surface.mesh.taken(faces)
    old = surface.parameters[taken.corner_numbers]
    # What a control plane is to the corners in space, these are to those in the old parameters.
    numbers = np.arange(len(old), dtype=np.int32)
    flat = PolygonMesh(np.column_stack([old, np.zeros(len(old))]), numbers, taken.mesh.starts)
    planes = planes_of(flat, np.asarray(parameters)[taken.corner_numbers])
    return planes.gradients_u[:, :2], planes.gradients_v[:, :2]
