"""What encloses a plus surface: its control planes at the four corners of the square.

A control plane is bilinear in u and v, so it is the mean of its own points at the corners,

    L_ij(u, v) = (1-u)(1-v) L_ij(0,0) + u (1-v) L_ij(1,0) + (1-u) v L_ij(0,1) + u v L_ij(1,1),

and the surface is the same mean of the classical surfaces of four nets of points. It lies in the
convex hull of all four; no two of them are enough. A B-spline plane has a part in the surface only
where its function is not zero: there the corners of that region do, and enclose a closed surface.
"""

from dataclasses import replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.convex_hull import HullMesh, hull_mesh
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.supports import supports
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_elevation import elevated_surface


def corner_nets(surface: PlusSurface) -> Floats:
    """(4, n_u, n_v, 3) the points L_ij at (0, 0), (1, 0), (0, 1) and (1, 1).

    ValueError where the surface closes: then it is no mean of four closed ones.
    """
    if any(surface.closed):
        raise ValueError("a closed surface has no corner nets")
    return _corners(surface, *(_whole(basis) for basis in surface.bases))


def corner_surfaces(surface: PlusSurface) -> tuple[PlusSurface, ...]:
    """The classical surfaces of the four corner nets, in their order.

    ValueError where the surface closes.
    """
    weights = surface.planes.weights
    return tuple(
        replace(surface, planes=ControlPlanes.of(net, weights=weights), s=0.0)
        for net in corner_nets(surface)
    )


def corner_hull(surface: PlusSurface) -> HullMesh:
    """The convex hull of all four corner nets; the surface lies in it.

    Where it closes, planes are taken where their part in the surface begins and ends.
    ValueError for a direction that is closed and not of B-splines: there every plane comes back
    shifted everywhere.
    """
    ends = (_support(basis) if basis.closed else _whole(basis) for basis in surface.bases)
    return hull_mesh(_corners(surface, *ends).reshape(-1, 3))


def support_hull(surface: PlusSurface) -> HullMesh:
    """The convex hull of each plane over the region where it has a part in the surface.

    Of B-splines much tighter than `corner_hull`, of other open families the same. ValueError as
    there.
    """
    ends = (_support(basis) for basis in surface.bases)
    return hull_mesh(_corners(surface, *ends).reshape(-1, 3))


def elevated_surface_hull(surface: PlusSurface) -> HullMesh:
    """The convex hull of the control points in standard form, the tightest of the three.

    ValueError where a family has no standard form.
    """
    return hull_mesh(elevated_surface(surface).points.reshape(-1, 3))


def _corners(surface: PlusSurface, ends_u: Floats, ends_v: Floats) -> Floats:
    """(4, n_u, n_v, 3) the planes at distances (2, n_u) and (2, n_v) from their nodes."""
    along_u, along_v = surface.gradients
    return np.stack(
        [
            surface.planes.points + by_u[:, None, None] * along_u + by_v[:, None] * along_v
            for by_v in ends_v
            for by_u in ends_u
        ]
    )


def _whole(basis: Basis) -> Floats:
    """(2, n) the distances of 0 and of 1 from each node."""
    return np.array([[0.0], [1.0]]) - basis.nodes


def _support(basis: Basis) -> Floats:
    """(2, n) the distances from each node at which its function becomes zero."""
    if basis.closed and not isinstance(basis, BSpline):
        raise ValueError("only closed B-splines have hulls")
    return supports(basis) - basis.nodes
