"""Simple bodies to begin with: sheet, tube, torus and sphere.

The round ones are a ring of control lines, c_i with gradients h_i around the unit circle, put
together with a profile, (r_j, z_j) with gradients (r'_j, z'_j), in cylindrical coordinates:

    P_ij = (r_j c_i, z_j),   A_ij = (q_j h_i, 0),   B_ij = (r'_j c_i, z'_j),

where q_j are such that sum_j q_j c_j(v) is the radius of the profile at every node. (With r_j in
place of q_j, what the gradients of ring and profile add would be missing where they meet.) S(u, v)
is then the ring times the profile, nearly; and with the s that leads it through its points a cubic
ring of 8 lines keeps within 0.13 % of a circle, one of 12 within 0.03 %.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.magnitude import best_s
from plusedit.geometry.making.refitting import fitted_curve
from plusedit.geometry.making.revolution import revolved
from plusedit.geometry.planes import ControlPlanes, automatic_planes
from plusedit.geometry.sizes import basis_of
from plusedit.geometry.standard import elliptic_arc
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_magnitude import natural_length

Families = tuple[str, str]
"""Of the basis by u and of that by v, by the names of the design file."""

USUAL: Families = ("bspline", "bspline")
ORIGIN = (0.0, 0.0, 0.0)
AS_AUTOMATIC = 1e-9  # of a unit vector: a direction that near to the automatic one is that one


def sheet(
    count_u: int = 4,
    count_v: int = 4,
    *,
    size: tuple[float, float] = (2.0, 2.0),
    center: ArrayLike = ORIGIN,
    families: Families = USUAL,
    order: int = 4,
) -> PlusSurface:
    """A flat rectangle in the plane z = 0: width along u and height along v."""
    x = _straight(families[0], count_u, size[0], order)
    y = _straight(families[1], count_v, size[1], order)
    points = np.zeros((count_u, count_v, 3))
    points[..., 0], points[..., 1] = x.lines.points[:, :1], y.lines.points[:, 0]
    gradients = np.zeros((2, *points.shape))
    gradients[0, ..., 0], gradients[1, ..., 1] = x.gradients[:, :1], y.gradients[:, 0]
    return _surface((x, y), points, gradients, center)


def tube(
    count_u: int = 8,
    count_v: int = 4,
    *,
    radius: float = 1.0,
    height: float = 2.0,
    center: ArrayLike = ORIGIN,
    families: Families = USUAL,
    order: int = 4,
) -> PlusSurface:
    """A tube about a vertical axis, closed around (u), open at its ends (v).

    It passes through its control points, and all directions are automatic.
    """
    rise = _straight(families[1], count_v, height, order)
    walls = np.column_stack([np.full(count_v, radius), rise.lines.points[:, 0]])
    upward = np.column_stack([np.zeros(count_v), rise.gradients[:, 0]])
    profile = PlusCurve(rise.basis, ControlLines.of(walls, list(upward)), 1.0)
    ring = _ring(families[0], count_u, order)
    return around(ring, profile, center, s=ring.s * radius)


def torus(
    count_u: int = 8,
    count_v: int = 6,
    *,
    radius: float = 1.0,
    thickness: float = 0.4,
    center: ArrayLike = ORIGIN,
    families: Families = USUAL,
    order: int = 4,
) -> PlusSurface:
    """A torus about a vertical axis, closed around it (u) and around its own ring (v).

    `radius` is that of the ring's middle, `thickness` that of its cross-section. It passes through
    its control points; the directions are given, of lengths that fit one s. 8 x 6 planes keep the
    cross-section within 0.8 % of a circle, 12 x 8 within 0.2 %.
    """
    section = _ring(families[1], count_v, order)
    points = section.lines.points * thickness + [radius, 0.0]
    lines = ControlLines.of(points, list(section.gradients * thickness))
    profile = PlusCurve(section.basis, lines, 1.0)
    return around(_ring(families[0], count_u, order), profile, center)


def sphere(
    count_u: int = 8,
    count_v: int = 7,
    *,
    radius: float = 1.0,
    center: ArrayLike = ORIGIN,
    families: Families = USUAL,
    order: int = 4,
) -> PlusSurface:
    """A sphere, nearly: closed around the vertical axis (u), from pole to pole (v).

    With 8 x 7 planes its points are within 0.13 % of the radius, with 12 x 7 within 0.1 %; all
    planes of a pole stand in one point, and the surface is smooth there.
    For a sphere to the last bit see `exact_sphere`. Raises ValueError for rational Gaussians by v:
    they would not reach the poles.
    """
    basis = basis_of(families[1], count_v, order=order)
    if not isinstance(basis, Bernstein | BSpline) or count_v < 4:
        raise ValueError("The poles of a sphere ask for at least 4 Bezier or B-spline rows.")
    curve = fitted_curve(basis, _half_circle, 1.0, np.linspace(0.0, 1.0, 24 * count_v))
    points, gradients = curve.lines.points.copy(), curve.gradients.copy()
    # On the axis, and level there: the velocity at the ends goes by the two lines next to them.
    for end, inner in ((0, 1), (-1, -2)):
        points[end, 0] = 0.0
        gradients[end, 1] = 0.0
        step = basis.nodes[inner] - basis.nodes[end]
        gradients[inner, 1] = (points[inner, 1] - points[end, 1]) / step
    profile = PlusCurve(basis, ControlLines.of(points * radius, list(gradients * radius)), 1.0)
    return around(_ring(families[0], count_u, order), profile, center)


def exact_sphere(radius: float = 1.0, center: ArrayLike = ORIGIN) -> PlusSurface:
    """A sphere to the last bit: a rational half circle turned about the vertical axis.

    Its 9 x 5 planes have weights and zero directions: as long as they are, s changes nothing.
    """
    middle = np.asarray(center, dtype=np.float64)
    half = elliptic_arc(
        middle, (radius, 0.0, 0.0), (0.0, 0.0, radius), start=-np.pi / 2, sweep=np.pi
    )
    surface = revolved(half, middle, (0.0, 0.0, 1.0))
    return replace(surface, s=natural_length(surface) / 2.0)


def around(
    ring: PlusCurve, profile: PlusCurve, center: ArrayLike = ORIGIN, *, s: float | None = None
) -> PlusSurface:
    """A plane curve about the unit circle, by u, put together with one of (r, z), by v.

    Without s it is half the natural length. Directions are automatic where they can be.
    """
    c, r, z = ring.lines.points, *profile.lines.points.T
    h, rising = ring.gradients, profile.gradients
    points = np.zeros((len(c), len(r), 3))
    points[..., :2], points[..., 2] = c[:, None] * r[:, None], z
    gradients = np.zeros((2, *points.shape))
    nodes = profile.basis.nodes
    widths = np.linalg.solve(profile.basis.values(nodes), profile.at(nodes)[:, 0])
    gradients[0, ..., :2] = h[:, None] * widths[:, None]
    gradients[1, ..., :2], gradients[1, ..., 2] = c[:, None] * rising[:, :1], rising[:, 1]
    return _surface((ring, profile), points, gradients, center, s)


def _straight(family: str, count: int, length: float, order: int) -> PlusCurve:
    """Lines (x, 0) from -length / 2 to length / 2, along which the curve keeps an even speed.

    The gradients are zero where any that are alike do that.
    """
    basis = basis_of(family, count, order=order)
    x = (basis.nodes - 0.5) * length
    lines = ControlLines.of(np.column_stack([x, np.zeros(count)]))
    s = best_s(PlusCurve(basis, lines))
    return PlusCurve(basis, lines, s or 0.0)


def _ring(family: str, count: int, order: int) -> PlusCurve:
    """A closed curve through `count` points of the unit circle, begun at (1, 0)."""
    angles = 2.0 * np.pi * np.arange(count) / count
    points = np.column_stack([np.cos(angles), np.sin(angles)])
    curve = PlusCurve(basis_of(family, count, order=order, closed=True), ControlLines.of(points))
    return replace(curve, s=best_s(curve) or 0.0)


def _half_circle(v: Floats) -> tuple[Floats, Floats]:
    """(m, 2) points (r, z) of the unit circle from pole to pole, and velocities."""
    angle = np.pi * (v - 0.5)
    cos, sin = np.cos(angle), np.sin(angle)
    return np.column_stack([cos, sin]), np.pi * np.column_stack([-sin, cos])


def _surface(
    along: tuple[PlusCurve, PlusCurve],
    points: Floats,
    gradients: Floats,
    center: ArrayLike,
    s: float | None = None,
) -> PlusSurface:
    """The surface with those gradients, and automatic directions where they are the same.

    A gradient of zero is automatic too: there any along the net would do, or the net has none.
    """
    first, second = along
    points = points + np.asarray(center, dtype=np.float64)
    free = automatic_planes(points, closed_u=first.closed, closed_v=second.closed)
    plain = PlusSurface(first.basis, second.basis, ControlPlanes.of(points))
    s = natural_length(plain) / 2.0 if s is None else s
    given = gradients / s
    automatic = np.abs(given - free).max(axis=-1) <= AS_AUTOMATIC
    automatic |= ~gradients.any(axis=-1)
    return replace(plain, planes=ControlPlanes(points, given, automatic), s=s)
