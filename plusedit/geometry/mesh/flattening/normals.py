"""A part seen along its mean normal."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import PolygonMesh

CANCELED = 1e-9  # of the area: less is rounding


def mean_normal(mesh: PolygonMesh) -> Floats:
    """(3,) of unit length, or zero where the faces' normals cancel."""
    total = mesh.area_vectors.sum(axis=0)
    length = float(np.linalg.norm(total))
    return total / length if length > CANCELED * mesh.areas.sum() else np.zeros(3)


def seen_along(mesh: PolygonMesh, normal: Floats) -> Floats:
    """(t, 3, 2) the triangles seen against the normal, the larger extent being one.

    The first axis is the one of space most across the normal: a sheet that faces up keeps x and y.
    """
    axis = np.eye(3)[1 if abs(normal[0]) > 0.9 else 0]
    # Along the axis as far as the normal leaves it; then a right angle from both.
    first = axis - (axis @ normal) * normal
    first /= np.linalg.norm(first)
    flat = (mesh.vertices - mesh.bounds[0]) @ np.stack([first, np.cross(normal, first)], axis=1)
    flat -= flat[mesh.used].min(axis=0)
    extent = float(flat[mesh.used].max())
    seen: Floats = flat[mesh.triangulation.triangles] / extent
    return seen
