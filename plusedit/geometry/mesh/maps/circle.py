"""The map of sheets of any outline."""

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.flattening.disks import circle_places
from plusedit.geometry.mesh.maps import Layout, Subject, filled_but_one, register, share_of


class Circle:
    """A disk with its rim on a circle; other holes are filled before."""

    title = "disk"

    def objection(self, subject: Subject) -> str:
        if subject.handles:
            return "it has handles"
        return "" if subject.boundaries else "it is closed"

    def drawback(self, subject: Subject) -> str:
        return ""

    def layout(self, subject: Subject) -> Layout:
        subject.progress(0.2, "laying out the disk")
        sheet, ring, notes = filled_but_one(subject)
        told = share_of(subject.progress, 0.2, 0.9)
        return Layout(PlaneDomain(), circle_places(sheet, ring, told)[: sheet.own], notes)


register("circle")(Circle())
