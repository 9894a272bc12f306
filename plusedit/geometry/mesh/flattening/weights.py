"""Weights of the edges of a sheet, for maps in which every vertex is a mean of its neighbors.

As long as all weights are positive no triangle is turned over, whatever the triangles are like
(Tutte). With the angles alpha, beta at i on both sides of the edge from i to j, and gamma, delta
opposite to it, there are

    tan(alpha / 2) + tan(beta / 2), over the length    Floater's mean values: always positive, and
                                                       a flat sheet keeps its shape (2003),
    cot(gamma) + cot(delta)                            the least energy: keeps angles best, and is
                                                       the same from both ends, but negative where
                                                       gamma + delta > pi (Pinkall, Polthier 1993).

Where a whole rim is given the former are taken. Elsewhere the latter, but at least a thousandth of
the mean of the former from both ends: so they stay positive. More than that would be felt where
the latter are zero, at the diagonals of rectangles, and twist what is made of them.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.sheet import Sheet

STEEPEST = 1e4  # of the tangents of half the angles: those of slivers are kept within reason
SHORTEST = 1e-6  # of the mean edge
LEAST = 1e-3  # of the mean value weights


def half_tangents(sheet: Sheet) -> Floats:
    """(t, 3) tan(angle / 2) of every corner, between 1e-4 and 1e4."""
    around = sheet.points[sheet.triangles]
    after = np.roll(around, -1, axis=1) - around
    along = -np.einsum("tcd,tcd->tc", after, np.roll(after, 1, axis=1))
    product = sheet.lengths * np.roll(sheet.lengths, 1, axis=1)
    across = np.broadcast_to(sheet.doubled_areas[:, None], along.shape)
    # Of the two forms of the tangent the one that doesn't cancel.
    acute = along >= 0.0
    above = np.where(acute, across, product - along)
    below = np.where(acute, product + along, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = above / below
    tangents: Floats = np.clip(np.nan_to_num(ratio, nan=1.0), 1.0 / STEEPEST, STEEPEST)
    return tangents


def mean_value_weights(sheet: Sheet) -> Floats:
    """(t, 3, 2) what every corner adds to the weights from it to the next and to the one before."""
    mean = float(sheet.lengths.mean())
    lengths = np.maximum(sheet.lengths, SHORTEST * mean if mean > 0.0 else 1.0)
    tangents = half_tangents(sheet)
    return np.stack([tangents / lengths, tangents / np.roll(lengths, 1, axis=1)], axis=2)


def conformal_weights(sheet: Sheet) -> Floats:
    """(t, 3, 2) the same of positive cotangent weights, which both ends of an edge share."""
    tangents = half_tangents(sheet)
    cotangents = np.roll(0.5 * (1.0 / tangents - tangents), 1, axis=1)
    floors = 0.5 * LEAST * (tangents + np.roll(tangents, -1, axis=1))
    inside = sheet.opposite >= 0
    shared = np.where(inside, 0.5, 1.0).reshape(-1, 3)
    edges = shared * np.maximum(_both_sides(sheet, cotangents), _both_sides(sheet, floors))
    return np.stack([edges, np.roll(edges, 1, axis=1)], axis=2)


def _both_sides(sheet: Sheet, values: Floats) -> Floats:
    """(t, 3) of every half-edge its value and that of the opposite one together."""
    flat = values.ravel()
    across = np.where(sheet.opposite >= 0, flat[sheet.opposite], 0.0)
    return (flat + across).reshape(-1, 3)


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
