"""The map of parts that are flat, or nearly so, wherever they lie in space."""

import numpy as np

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.flattening.normals import mean_normal, seen_along
from plusedit.geometry.mesh.flattening.overlaps import overlaps
from plusedit.geometry.mesh.maps import Layout, Subject, register

TILT = np.cos(np.radians(30.0))  # of a normal to the mean one; angles grow by 1.15 at most


class Flat:
    """The part seen along its mean normal, which keeps a flat one as it is."""

    title = "flat sheet"

    def objection(self, subject: Subject) -> str:
        return "" if mean_normal(subject.mesh).any() else "its faces look all ways"

    def drawback(self, subject: Subject) -> str:
        mesh = subject.mesh
        first, second, third = mesh.vertices[mesh.triangulation.triangles].transpose(1, 0, 2)
        normals = np.cross(second - first, third - first)
        normal = mean_normal(mesh)
        if (normals @ normal < TILT * subject.sheet.doubled_areas).any():
            return "some faces are tilted by more than 30 degrees"
        places = seen_along(mesh, normal)
        return "parts lie above each other" if overlaps(subject.sheet, places) else ""

    def layout(self, subject: Subject) -> Layout:
        return Layout(PlaneDomain(), seen_along(subject.mesh, mean_normal(subject.mesh)))


register("flat")(Flat())
