"""Disks laid out with their border on a circle, or on a rectangle along which it slides.

On the circle the border is spread by its length. On the rectangle the border between two corners
lies on a side, where every vertex slides to the mean of its neighbors, as if the part were
mirrored at the side; with the ratio of the sides for which the energies of u and v agree this
keeps angles, and a flat rectangle is mapped to itself. Weights must be symmetric for that: others
drift along a bent strip, farther and farther with its length.
"""

from itertools import pairwise

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.equations import Pins, solution
from plusedit.geometry.mesh.flattening.sheet import Indices, Sheet
from plusedit.geometry.mesh.flattening.weights import (
    conformal_weights,
    energies,
    mean_value_weights,
)
from plusedit.geometry.mesh.maps import Progress, share_of, silent

CORNER = 0.75 * np.pi  # angles of a sheet at its border: less is a corner of it
THINNEST = 1e-4  # of the ratios of a rectangle's sides


def circle_places(sheet: Sheet, ring: Indices, progress: Progress = silent) -> Floats:
    """(t, 3, 2) parameters with a ring of border on the circle of diameter one."""
    vertices = sheet.tails[ring]
    lengths = sheet.lengths.reshape(-1)[ring]
    total = float(lengths.sum())
    steps = lengths / total if total > 0.0 else np.full(len(ring), 1.0 / len(ring))
    # Edges of no length would bring two vertices to one place.
    steps = np.maximum(steps, 1e-9)
    angles = 2.0 * np.pi * (np.cumsum(steps) - steps) / steps.sum()
    rim = 0.5 + 0.5 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    weights = mean_value_weights(sheet)
    parameters = solution(sheet, weights, Pins(vertices, rim), progress=progress)
    return parameters[sheet.triangles]


def rectangle_places(
    sheet: Sheet, ring: Indices, corners: list[int], progress: Progress = silent
) -> Floats:
    """(t, 3, 2) parameters on a rectangle of width one.

    `corners` are the four places in the ring that go to its corners, ascending.
    """
    vertices = sheet.tails[np.roll(ring, -corners[0])]
    if _has_chords(sheet, _sides(vertices, corners)):
        sheet, ring = sheet.collared(ring)
        vertices = sheet.tails[np.roll(ring, -corners[0])]
    low, right, high, left = _sides(vertices, corners)
    weights = conformal_weights(sheet)
    columns = []
    for zero, one, begin in ((left, right, 0.0), (low, high, 0.5)):
        values = np.concatenate([np.zeros(len(zero)), np.ones(len(one))])
        pins = Pins(np.concatenate([zero, one]), values[:, None])
        told = share_of(progress, begin, begin + 0.5)
        columns.append(solution(sheet, weights, pins, progress=told))
    places = np.concatenate(columns, axis=1)[sheet.triangles]
    energy = energies(sheet, places)
    places[..., 1] *= np.clip(np.sqrt(energy[0, 0] / energy[1, 1]), THINNEST, 1.0 / THINNEST)
    return places


def _sides(vertices: Indices, corners: list[int]) -> list[Indices]:
    """The vertices of the four sides, corners included, of a ring that begins at a corner."""
    ends = [corner - corners[0] for corner in corners] + [len(vertices)]
    around = np.append(vertices, vertices[0])
    return [around[start : end + 1] for start, end in pairwise(ends)]


def _has_chords(sheet: Sheet, sides: list[Indices]) -> bool:
    """Whether an edge inside joins two vertices of a side: what it cuts off would collapse."""
    for side in sides:
        on_side = np.zeros(len(sheet.points), dtype=np.bool_)
        on_side[side] = True
        if (on_side[sheet.tails[sheet.chords]] & on_side[sheet.heads[sheet.chords]]).any():
            return True
    return False


def sheet_corners(sheet: Sheet, ring: Indices) -> list[int]:
    """The places in a ring of border where the sheet has a corner, less than 135 degrees inside."""
    around = sheet.points[sheet.triangles]
    after = np.roll(around, -1, axis=1) - around
    before = np.roll(around, 1, axis=1) - around
    along = np.einsum("tcd,tcd->tc", after, before)
    across = np.broadcast_to(sheet.doubled_areas[:, None], along.shape)
    angles = np.arctan2(across, along).ravel()
    sums = np.bincount(sheet.tails, angles, minlength=len(sheet.points))
    return np.flatnonzero(sums[sheet.tails[ring]] < CORNER).tolist()
