"""The map of parts without handles that are nearly closed."""

from plusedit.geometry.mesh.flattening.pillows import pillow_layout
from plusedit.geometry.mesh.maps import Layout, Subject, holes, register


class FilledPillow:
    """A pillow of the part with its holes filled; the filling has no control planes."""

    title = "pillow with filled holes"

    def objection(self, subject: Subject) -> str:
        if subject.handles:
            return "it has handles"
        return "" if subject.boundaries else "it has no holes to fill"

    def drawback(self, subject: Subject) -> str:
        return ""

    def layout(self, subject: Subject) -> Layout:
        sheet, loops = subject.sheet, subject.topology.loops
        filled = sheet.filled([sheet.ring(loop) for loop in loops])
        found = pillow_layout(filled, subject.cone_points, subject.progress)
        told = f"{holes(len(loops))} filled for the map"
        return Layout(found.domain, found.places, (told,), found.cone_points)


register("filled_pillow")(FilledPillow())
