"""The map of terrains: u, v = x, y."""

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.flattening.overlaps import overlaps
from plusedit.geometry.mesh.maps import Layout, Subject, register

STEEPEST = 0.02  # of the normal's z: a face closer to upright nearly vanishes from above


class HeightField:
    """x and y, both divided by the larger extent of the two."""

    title = "height field"

    def objection(self, subject: Subject) -> str:
        low, high = subject.mesh.bounds
        return "" if (high - low)[:2].any() else "it has no extent in x and y"

    def drawback(self, subject: Subject) -> str:
        mesh = subject.mesh
        if subject.is_height_field:
            return ""
        places = mesh.vertices[mesh.triangulation.triangles, :2]
        first, second, third = places.transpose(1, 2, 0)
        (a, b), (c, d) = second - first, third - first
        if (a * d - b * c < STEEPEST * subject.sheet.doubled_areas).any():
            return "some faces are upright or turned away from above"
        return "parts lie above each other" if overlaps(subject.sheet, places) else ""

    def layout(self, subject: Subject) -> Layout:
        mesh = subject.mesh
        low, high = mesh.bounds
        extent = float((high - low)[:2].max())
        flat = (mesh.vertices[:, :2] - low[:2]) / extent
        return Layout(PlaneDomain(), flat[mesh.triangulation.triangles])


register("height_field")(HeightField())
