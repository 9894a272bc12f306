"""The map of parts that suit no domain: those with several handles."""

import numpy as np

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.flattening.cutting import border_ring, cut_open
from plusedit.geometry.mesh.flattening.disks import circle_places
from plusedit.geometry.mesh.maps import Layout, Subject, all_filled, register, share_of


class RoughCut:
    """The part cut open to a disk; its surface has cracks along the cut."""

    title = "rough cut"

    def objection(self, subject: Subject) -> str:
        return "" if subject.handles else "it has no handles to be cut open"

    def drawback(self, subject: Subject) -> str:
        return ""

    def layout(self, subject: Subject) -> Layout:
        sheet, notes = all_filled(subject)
        subject.progress(0.1, "cutting it open")
        owners = subject.mesh.triangulation.owners.astype(np.intp)
        fans = np.arange(len(sheet.triangles) - sheet.own) + subject.mesh.face_count
        disk = cut_open(sheet, np.concatenate([owners, fans]))
        subject.progress(0.3, "laying out the disk")
        told = share_of(subject.progress, 0.3, 0.9)
        places = circle_places(disk, border_ring(disk), told)[: sheet.own]
        handles = "1 handle" if subject.handles == 1 else f"{subject.handles} handles"
        note = f"the map is rough: with {handles} the part was cut open, and cracks show there"
        return Layout(PlaneDomain(), places, (*notes, note))


register("rough_cut")(RoughCut())
