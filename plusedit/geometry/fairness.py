"""How fair a surface is, in two numbers: how much it bends, and how much that changes.

    bending    the integral of kappa_1^2 + kappa_2^2, the energy of a thin plate: 8 pi for a sphere
               of any size, zero for a plane
    variation  the integral of |grad H|^2, H the mean curvature: zero where that is the same all
               over, on planes, spheres and cylinders

Both are integrals over the area. Between knots a surface is smooth: there H is differentiated as
the polynomial through its values at the nodes of Gauss and Legendre.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.pieces import surface_pieces
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_frames import first_form, principal_curvatures

COUNT = 8  # nodes of the rule in each piece, each way
FEWEST = 6  # pieces each way: where knots are few, polynomials of that degree may not do
NODES, WEIGHTS = np.polynomial.legendre.leggauss(COUNT)
NODES, WEIGHTS = (NODES + 1.0) / 2.0, WEIGHTS / 2.0


@dataclass(frozen=True)
class Fairness:
    """Both numbers, and the area that they are taken over."""

    area: float
    """in the square of the unit"""
    bending: float
    """a plain number"""
    variation: float
    """in one over the square of the unit"""


_KNOWN: "WeakKeyDictionary[PlusSurface, Fairness]" = WeakKeyDictionary()


def fairness(surface: PlusSurface) -> Fairness:
    """That of a plus surface, kept as long as it lives.

    To 1e-6, the variation to 1e-4, where the surface is regular; places without a normal count for
    nothing.
    """
    found = _KNOWN.get(surface)
    if found is None:
        found = _KNOWN[surface] = _fairness(surface)
    return found


def known_fairness(surface: PlusSurface) -> Fairness | None:
    """The same without working it out: None while it is not known."""
    return _KNOWN.get(surface)


def _fairness(surface: PlusSurface) -> Fairness:
    ends = [_finer(grid.parameters) for grid in surface_pieces(surface)]
    u, v = ((a[:-1, None] + np.diff(a)[:, None] * NODES).ravel() for a in ends)
    with np.errstate(all="ignore"):
        found = surface.derivatives(u, v)
        bends = principal_curvatures(found)
        e, f, g = np.moveaxis(first_form(found), -1, 0)
        square = np.maximum(e * g - f * f, 0.0)
        heights = (bends.largest + bends.smallest) / 2.0
        by_u, by_v = _slopes(heights, *ends)
        steep = (g * by_u**2 - 2.0 * f * by_u * by_v + e * by_v**2) / square
        area = np.sqrt(square) * np.outer(*(_weights(each) for each in ends))
        bending = bends.largest**2 + bends.smallest**2
    return Fairness(
        float(area.sum()), *(float(np.nansum(area * each)) for each in (bending, steep))
    )


def fairness_of_triangles(
    points: Floats, triangles: NDArray[np.integer], largest: Floats, smallest: Floats
) -> Fairness:
    """The same of a surface that is known at points (n, 3), its principal curvatures (n,) too.

    Triangles (k, 3) join the points; what is not a number counts for nothing. As exact as the
    triangles are small.
    """
    corners = points[triangles]
    one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(one, other)
    twice = np.linalg.norm(across, axis=1)
    bending = (largest**2 + smallest**2)[triangles].mean(axis=1)
    heights = ((largest + smallest) / 2.0)[triangles]
    # The gradient of what is linear in a triangle: turned edges times the opposite values.
    edges = corners[:, [2, 0, 1]] - corners[:, [1, 2, 0]]
    with np.errstate(all="ignore"):
        slopes = np.linalg.norm(np.einsum("kc,kcd->kd", heights, edges), axis=1) / twice
    area = twice / 2.0
    sums = (float(np.nansum(area * each)) for each in (bending, slopes**2))
    return Fairness(float(area.sum()), *sums)


def _slopes(values: Floats, by_u: Floats, by_v: Floats) -> tuple[Floats, Floats]:
    """Derivatives by u and by v of values at the nodes of all pieces between those ends."""
    shape = len(by_u) - 1, COUNT, len(by_v) - 1, COUNT
    pieces = values.reshape(shape)
    along_u = np.einsum("ij,ajbk->aibk", DIFFERENTIATION, pieces)
    along_v = np.einsum("kl,aibl->aibk", DIFFERENTIATION, pieces)
    along_u /= np.diff(by_u)[:, None, None, None]
    along_v /= np.diff(by_v)[:, None]
    return along_u.reshape(values.shape), along_v.reshape(values.shape)


def _weights(ends: Floats) -> Floats:
    weights: Floats = (np.diff(ends)[:, None] * WEIGHTS).ravel()
    return weights


def _finer(ends: Floats) -> Floats:
    """The ends of pieces, each cut into as many as make few pieces enough."""
    parts = max(1, -(-FEWEST // (len(ends) - 1)))
    shares = np.arange(parts) / parts
    return np.append((ends[:-1, None] + np.diff(ends)[:, None] * shares).ravel(), ends[-1])


def _differentiation(nodes: Sequence[float] | Floats) -> Floats:
    """(n, n) from values at nodes to slopes there, exact for polynomials of degree n - 1."""
    at = np.asarray(nodes)
    apart = at[:, None] - at
    np.fill_diagonal(apart, 1.0)
    products = apart.prod(axis=1)
    matrix = products[:, None] / products / apart
    np.fill_diagonal(apart, np.inf)
    np.fill_diagonal(matrix, (1.0 / apart).sum(axis=1))
    found: Floats = matrix
    return found


DIFFERENTIATION = _differentiation(NODES)
