"""The map of parts that are flat, or nearly so, wherever they lie in space."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.flattening.overlaps import overlaps
from plusedit.geometry.mesh.maps import Layout, Subject, register
from plusedit.geometry.mesh.polygons import PolygonMesh

TILT = np.cos(np.radians(30.0))  # of a normal to the mean one; angles grow by 1.15 at most


class Flat:
    """The part seen along its mean normal, which keeps a flat one as it is."""

    title = "flat sheet"

    def objection(self, subject: Subject) -> str:
        return "" if mean_normal(subject.mesh).any() else "its faces look all ways"

    def drawback(self, subject: Subject) -> str:
        mesh = subject.mesh
        normal = mean_normal(mesh)
        if (mesh.area_vectors @ normal < TILT * mesh.areas).any():
            return "some faces are tilted by more than 30 degrees"
        places = seen_along(mesh, normal)
        first, second, third = places.transpose(1, 2, 0)
        (a, b), (c, d) = second - first, third - first
        if (a * d - b * c < 0.0).any():
            return "some faces are folded over"
        return "parts lie above each other" if overlaps(subject.sheet, places) else ""

    def layout(self, subject: Subject) -> Layout:
        return Layout(PlaneDomain(), seen_along(subject.mesh, mean_normal(subject.mesh)))


def mean_normal(mesh: PolygonMesh) -> Floats:
    """(3,) of unit length, or zero where the faces' normals cancel."""
    total = mesh.area_vectors.sum(axis=0)
    length = float(np.linalg.norm(total))
    return total / length if length > 0.0 else np.zeros(3)


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


register("flat")(Flat())
