"""Which map suits a part.

A closed part has the pillow or, with a handle, the torus, neither of which has a seam. So has a
part whose holes are small, once they are filled: its roundness number, the squared length of the
longest loop of its border to 4 pi times the area, is 1 for a flat disk and small for a bag.
"""

from typing import NamedTuple

import numpy as np

from plusedit.geometry.mesh.flattening.normals import mean_normal
from plusedit.geometry.mesh.maps import Subject, maps

OPEN = 0.25  # of L^2 / (4 pi A): less is a bag rather than a sheet

LEVEL = np.cos(np.radians(45.0))  # of the mean normal's z


class Choice(NamedTuple):
    """A map and the reason for it."""

    name: str
    why: str


def openness(subject: Subject) -> float:
    """L^2 / (4 pi A) of the longest loop of the border; 0 for a closed part."""
    loops, area = subject.topology.loops, float(subject.mesh.areas.sum())
    return loops[0].length ** 2 / (4.0 * np.pi * area) if loops and area > 0.0 else 0.0


def suits(subject: Subject, name: str) -> bool:
    """Whether nothing speaks against a map."""
    return not (maps[name].objection(subject) or maps[name].drawback(subject))


def choice(subject: Subject) -> Choice:
    """The map that suits the part best."""
    if subject.is_height_field:
        return Choice("height_field", "it is a terrain")
    if subject.boundaries and suits(subject, "height_field") and not _leans(subject):
        return Choice("height_field", "all faces look up")
    if suits(subject, "file_uv"):
        return Choice("file_uv", "they have neither seams nor overlaps")
    if subject.handles:
        return _with_handles(subject)
    if not subject.boundaries:
        return Choice("pillow", "it is closed and has no handles")
    return _with_rims(subject)


def _leans(subject: Subject) -> bool:
    """Whether the part is flat, but closer to upright than to level: seen from above it is thin."""
    return mean_normal(subject.mesh)[2] < LEVEL and suits(subject, "flat")


def _with_handles(subject: Subject) -> Choice:
    handles = "a handle" if subject.handles == 1 else f"{subject.handles} handles"
    if subject.handles == 1 and openness(subject) < OPEN:
        return Choice("torus", "it has one handle")
    return Choice("rough_cut", f"it has {handles}, and no domain suits that")


def _with_rims(subject: Subject) -> Choice:
    if suits(subject, "flat"):
        return Choice("flat", "no face is tilted by more than 30 degrees")
    if suits(subject, "cylinder"):
        return Choice("cylinder", "it is a tube with two long rims")
    if openness(subject) < OPEN:
        few = len(subject.topology.loops)
        return Choice("filled_pillow", f"its {'hole is' if few == 1 else 'holes are'} small")
    if suits(subject, "square"):
        return Choice("square", "its rim has four corners")
    return Choice("circle", "it has one long rim")
