"""The map that a file brings along: its texture coordinates."""

import numpy as np

from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.flattening.distortion import stretch
from plusedit.geometry.mesh.flattening.overlaps import border_overlaps
from plusedit.geometry.mesh.maps import Layout, Subject, register

SAME = 1e-7  # of the extent: texture coordinates of a vertex that differ by less are rounded
UNEVEN = 2.0  # of widths to heights in the middle face: angles are no longer kept


class FileUV:
    """The texture coordinates as they are."""

    title = "texture coordinates"

    def objection(self, subject: Subject) -> str:
        if subject.uv is None:
            return "the file has no texture coordinates"
        return "" if np.ptp(subject.uv, axis=0).all() else "they lie on one line"

    def drawback(self, subject: Subject) -> str:
        assert subject.uv is not None
        mesh, sheet = subject.mesh, subject.sheet
        corners = subject.uv[mesh.triangulation.corners]
        first, second, third = corners.transpose(1, 2, 0)
        (a, b), (c, d) = second - first, third - first
        if not (a * d - b * c > 0.0).all():
            return "some of their faces are turned over or collapsed"
        if seams(subject):
            return "they are torn along seams"
        if border_overlaps(corners, np.flatnonzero(sheet.opposite < 0)):
            return "they overlap"
        middle = float(np.median(stretch(mesh, subject.uv).angles))
        return "" if middle < UNEVEN else f"they stretch most faces {middle:.1f} times one way"

    def layout(self, subject: Subject) -> Layout:
        assert subject.uv is not None
        places = subject.uv[subject.mesh.triangulation.corners]
        return Layout(PlaneDomain(), places)


def seams(subject: Subject) -> int:
    """How many edges inside the part have other texture coordinates on their two sides."""
    assert subject.uv is not None
    sheet, corners = subject.sheet, subject.uv[subject.mesh.triangulation.corners]
    tails = corners.reshape(-1, 2)
    heads = np.roll(corners, -1, axis=1).reshape(-1, 2)
    inner = np.flatnonzero(sheet.opposite >= 0)
    across = sheet.opposite[inner]
    extent = float(np.ptp(tails, axis=0).max())
    apart = np.maximum(
        np.abs(tails[inner] - heads[across]).max(axis=1),
        np.abs(heads[inner] - tails[across]).max(axis=1),
    )
    return int(np.count_nonzero(apart > SAME * extent)) // 2


register("file_uv")(FileUV())
