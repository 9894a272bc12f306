"""Weights of the edges of a sheet, for maps in which every vertex is a mean of its neighbors.

Floater's mean value weight of the edge from i to j, with the angles at i on both sides of it,

    w_ij = (tan(alpha / 2) + tan(beta / 2)) / |V_j - V_i|

is positive, whatever the triangles are like: so no triangle is turned over (Tutte), and a flat
sheet is mapped to itself (Floater, Mean value coordinates, 2003). It is not the same from both
ends; where a map can exist only if it is, the mean of both is taken.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.sheet import Sheet

STEEPEST = 1e4  # of the tangents of half the angles: those of slivers are kept within reason
SHORTEST = 1e-6  # of the mean edge


def half_tangents(sheet: Sheet) -> Floats:
    """(t, 3) tan(angle / 2) of every corner, between 1e-4 and 1e4."""
    around = sheet.points[sheet.triangles]
    after = np.roll(around, -1, axis=1) - around
    before = np.roll(around, 1, axis=1) - around
    along = np.einsum("tcd,tcd->tc", after, before)
    product = sheet.lengths * np.roll(sheet.lengths, 1, axis=1)
    across = np.broadcast_to(sheet.doubled_areas[:, None], along.shape)
    # Of the two forms of the tangent the one that doesn't cancel.
    acute = along >= 0.0
    above = np.where(acute, across, product - along)
    below = np.where(acute, product + along, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = above / below
    return np.clip(np.nan_to_num(ratio, nan=1.0, posinf=STEEPEST), 1.0 / STEEPEST, STEEPEST)


def mean_value_weights(sheet: Sheet) -> Floats:
    """(t, 3, 2) what every corner adds to the weights from it to the next and to the one before."""
    return _over_lengths(sheet, np.repeat(half_tangents(sheet)[:, :, None], 2, axis=2))


def symmetric_weights(sheet: Sheet) -> Floats:
    """(t, 3, 2) the same, but of every edge the mean from both ends."""
    tangents = half_tangents(sheet)
    along = 0.5 * (tangents + np.roll(tangents, -1, axis=1))
    return _over_lengths(sheet, np.stack([along, np.roll(along, 1, axis=1)], axis=2))


def _over_lengths(sheet: Sheet, values: Floats) -> Floats:
    mean = float(sheet.lengths.mean()) if sheet.lengths.size else 1.0
    floor = SHORTEST * mean if mean > 0.0 else 1.0
    lengths = np.maximum(sheet.lengths, floor)
    weights: Floats = values / np.stack([lengths, np.roll(lengths, 1, axis=1)], axis=2)
    return weights


def energies(sheet: Sheet, places: Floats) -> Floats:
    """(2, 2) integrals of grad u . grad u, grad u . grad v and so on over the mesh's triangles.

    `places` are (t, 3, 2) parameters by corner. For a map that preserves angles this is a
    multiple of the identity.
    """
    around, own = sheet.points[sheet.triangles[: sheet.own]], places[: sheet.own]
    sides = np.roll(around, 1, axis=1) - np.roll(around, -1, axis=1)
    # Gradients by 2 A: sums of the values times the opposite sides, turned by a right angle.
    turned = np.einsum("tck,tcd->tkd", own - own[:, :1], sides)
    lengths = sheet.lengths[: sheet.own].max(axis=1)
    areas = np.maximum(sheet.doubled_areas[: sheet.own], 1e-6 * lengths**2)
    usable = areas > 0.0
    scaled = turned[usable] / np.sqrt(2.0 * areas[usable])[:, None, None]
    total: Floats = np.einsum("tkd,tld->kl", scaled, scaled)
    return total
