"""The magnitude s of surfaces: the lengths it is measured by, and the value that serves best.

A useful gradient along u is about half as long as the rows of the control net along u, and so for
v. One s for both is right where both lengths are alike; `balanced` makes up for it where not.

The surface is S = base + s plus. With f_ij = base(x_i, y_j), p_ij = plus(x_i, y_j) at the nodes,
the sum of |f_ij + s p_ij - P_ij|^2 is least for

    s* = sum p_ij . (P_ij - f_ij) / sum p_ij . p_ij.
"""

from dataclasses import replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.magnitude import NO_EFFECT
from plusedit.geometry.surface import PlusSurface, terms


def natural_lengths(surface: PlusSurface) -> tuple[float, float]:
    """L_u and L_v, the mean lengths of the control polygons along u and along v.

    With the closing edge where the surface closes.
    """
    closed_u, closed_v = surface.closed
    points = surface.planes.points
    return _mean_length(points, closed_u), _mean_length(np.swapaxes(points, 0, 1), closed_v)


def natural_length(surface: PlusSurface) -> float:
    """L, the mean of L_u and L_v: the natural unit of s, as of a curve its polygon's length."""
    return sum(natural_lengths(surface)) / 2.0


def best_surface_s(surface: PlusSurface) -> float | None:
    """s*, which brings the surface closest to its control points; None if s changes nothing.

    Closest at the nodes and in the sense of least squares, for the directions the surface has;
    it may be negative where they run against the control net.
    """
    largest = float(np.abs(surface.directions).max())
    if largest == 0.0:
        return None
    basis_u, basis_v = surface.bases
    at_nodes = Grid(basis_u.nodes), Grid(basis_v.nodes)
    base, plus = terms(basis_u, basis_v, surface.planes, *at_nodes)
    pull = plus / largest
    effect = float((pull * pull).sum())
    if effect <= NO_EFFECT**2:
        return None
    return float((pull * (surface.planes.points - base)).sum() / effect / largest)


def balanced(surface: PlusSurface) -> PlusSurface:
    """The surface with d^u and d^v scaled so that their mean lengths are as L_u to L_v.

    Then one s / L suits both. Directions of length one get the lengths L_u / L and L_v / L; those
    of other lengths keep their ratios to others of the same way, and all together their mean
    length. All become given. Balanced twice is balanced; so is a surface without any extent or
    directions along u or v, which comes back as it is.
    """
    wanted = np.array(natural_lengths(surface))
    found = np.array([_mean_of_nonzero(way) for way in surface.directions])
    if not (wanted.all() and found.all()):
        return surface
    factors = (wanted / wanted.mean()) * (found.mean() / found)
    directions = factors[:, None, None, None] * surface.directions
    return replace(surface, planes=surface.planes.with_directions(directions))


def _mean_length(points: Floats, closed: bool) -> float:
    """Of the polygons that run along the first axis of the points (n, m, 3)."""
    ahead = np.roll(points, -1, axis=0) if closed else points[1:]
    return float(np.linalg.norm(ahead - points[: len(ahead)], axis=2).sum(axis=0).mean())


def _mean_of_nonzero(vectors: Floats) -> float:
    """The mean length of the vectors (n, m, 3) that have one; 0 if none has."""
    lengths = np.linalg.norm(vectors, axis=2)
    return float(lengths[lengths > 0.0].mean()) if lengths.any() else 0.0
