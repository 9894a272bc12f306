"""How much the control plane of each face moves one point of a mesh surface."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.evaluation import Prepared
from plusedit.geometry.mesh.mesh_surface import MeshSurface


def shares(surface: MeshSurface, place: tuple[float, float]) -> tuple[Floats, Floats]:
    """(f,) the shares R of the points P and (2, f) E of s A and s B in the point at a place.

    S = sum R P + sum E_u s A + sum E_v s B, to the accuracy of the surface itself.
    """
    at = surface.domain.reduced(np.array([place], dtype=np.float64))
    known = Prepared.of(surface, at)
    shifts, signs = known.images
    away = (signs[:, None] * (at - shifts))[:, None] - known.tree.centers
    exponents = (away**2 * known.halves).sum(axis=2)
    weights = known.heights * np.exp(exponents.min() - exponents)
    weights /= weights.sum()
    count = surface.mesh.face_count
    values, reaches = np.zeros(count), np.zeros((2, count))
    values[known.tree.order] = weights.sum(axis=0)
    reaches[:, known.tree.order] = np.einsum("kn,knd->dn", weights, away)
    return values, reaches
