"""The map of closed parts without handles."""

from plusedit.geometry.mesh.flattening.pillows import pillow_layout
from plusedit.geometry.mesh.maps import Layout, Subject, register


class Pillow:
    """A flat sphere with four cone points; without a seam."""

    title = "pillow"

    def objection(self, subject: Subject) -> str:
        if subject.handles:
            return "it has handles"
        return "it isn't closed" if subject.boundaries else ""

    def drawback(self, subject: Subject) -> str:
        return ""

    def layout(self, subject: Subject) -> Layout:
        return pillow_layout(subject.sheet, subject.cone_points, subject.progress)


register("pillow")(Pillow())
