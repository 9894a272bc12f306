"""The map of sheets with four corners."""

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.flattening.disks import rectangle_places, sheet_corners
from plusedit.geometry.mesh.maps import Layout, Subject, filled_but_one, register, share_of


class Square:
    """A rectangle on whose sides the rim slides; other holes are filled before."""

    title = "rectangle"

    def objection(self, subject: Subject) -> str:
        if subject.handles:
            return "it has handles"
        if not subject.boundaries:
            return "it is closed"
        sheet = subject.sheet
        corners = len(sheet_corners(sheet, sheet.ring(subject.topology.loops[0])))
        return "" if corners == 4 else f"its rim has {corners or 'no'} corners, not four"

    def drawback(self, subject: Subject) -> str:
        return ""

    def layout(self, subject: Subject) -> Layout:
        subject.progress(0.2, "laying out the rectangle")
        corners = sheet_corners(subject.sheet, subject.sheet.ring(subject.topology.loops[0]))
        sheet, ring, notes = filled_but_one(subject)
        places = rectangle_places(sheet, ring, corners, share_of(subject.progress, 0.2, 0.9))
        return Layout(PlaneDomain(), places[: sheet.own], notes)


register("square")(Square())
