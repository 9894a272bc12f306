"""What first and second derivatives say of a surface, whatever its parameters.

With unit tangents t_u = S_u / |S_u| and t_v = S_v / |S_v|, the normal n = S_u x S_v / |S_u x S_v|
and the normal curvatures along the parameter lines

    l = n . S_uu / |S_u|^2,    m = n . S_uv / (|S_u| |S_v|),    r = n . S_vv / |S_v|^2,

the second form in the orthonormal frame t_u, n x t_u is, where t_v = (c, d) in that frame,

    [ l  q ]    q = (m - c l) / d,
    [ q  p ],   p = (r - c^2 l - 2 c d q) / d^2;

its eigenvalues are the principal curvatures, and the parameters no longer matter.

A curvature is positive where the surface bends toward its normal: a sphere whose normals point
outward has the mean curvature -1 / radius. Exchanging u and v turns the normal round.

`derivatives` everywhere are those that `PlusSurface.derivatives` or `derivatives_at` gives back:
(S, S_u, S_v, S_uu, S_uv, S_vv), (..., 3) each. Where S_u and S_v have no common normal (at the
pole of a sphere, say) what depends on it is nan.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.net import Flags
from plusedit.geometry.surface import PlusSurface

STILL = 1e-14  # of the longer tangent: a tangent that short is rounding
PARALLEL = 1e-12  # sine of the angle between tangents that have no common normal


def normals(du: Floats, dv: Floats) -> Floats:
    """(..., 3) unit vectors along S_u x S_v; nan where the surface is singular."""
    across = np.cross(unit(du), unit(dv))
    regular = ~_is_singular(du, dv, across)
    return np.where(regular[..., None], unit(across), np.nan)


def first_form(derivatives: Sequence[Floats]) -> Floats:
    """(..., 3) E = S_u . S_u, F = S_u . S_v, G = S_v . S_v."""
    _, du, dv = derivatives[:3]
    return np.stack([_dot(du, du), _dot(du, dv), _dot(dv, dv)], axis=-1)


def second_form(derivatives: Sequence[Floats]) -> Floats:
    """(..., 3) L = n . S_uu, M = n . S_uv, N = n . S_vv; nan where there is no normal."""
    _, du, dv, *second = derivatives
    normal = normals(du, dv)
    return np.stack([_dot(normal, each) for each in second], axis=-1)


def gaussian_curvature(derivatives: Sequence[Floats]) -> Floats:
    """(...,) the product of the principal curvatures: positive on a dome, negative on a saddle."""
    shape = _shape(derivatives)
    return shape.along * shape.across - shape.twist**2


def mean_curvature(derivatives: Sequence[Floats]) -> Floats:
    """(...,) the mean of the principal curvatures; its sign is that of the normal."""
    shape = _shape(derivatives)
    return (shape.along + shape.across) / 2.0


@dataclass(frozen=True, eq=False)
class PrincipalCurvatures:
    """The largest and the smallest normal curvature, and where they lie."""

    largest: Floats
    """(...,)"""
    smallest: Floats
    along_largest: Floats
    """(..., 3) unit tangent; both run at a right angle, and with the normal right-handed"""
    along_smallest: Floats


def principal_curvatures(derivatives: Sequence[Floats]) -> PrincipalCurvatures:
    """Those at sampled parameters; where all directions are alike, S_u counts as the first."""
    shape = _shape(derivatives)
    mean, half = (shape.along + shape.across) / 2.0, (shape.along - shape.across) / 2.0
    spread = np.hypot(half, shape.twist)
    angle = np.arctan2(shape.twist, half)[..., None] / 2.0
    first = np.cos(angle) * shape.tangent + np.sin(angle) * shape.beside
    second = np.cos(angle) * shape.beside - np.sin(angle) * shape.tangent
    return PrincipalCurvatures(mean + spread, mean - spread, first, second)


@dataclass(frozen=True, eq=False)
class SurfaceFrame:
    """A point of a surface, its tangents and normal, and how it bends there."""

    point: Floats
    """(3,), as the other vectors"""
    du: Floats
    dv: Floats
    normal: Floats
    gaussian: float
    mean: float
    principal: PrincipalCurvatures


def frame_at(surface: PlusSurface, u: float, v: float) -> SurfaceFrame:
    """Everything at one place."""
    found = [each[0] for each in surface.derivatives_at([[u, v]])]
    point, du, dv = found[:3]
    gaussian, mean = float(gaussian_curvature(found)), float(mean_curvature(found))
    return SurfaceFrame(point, du, dv, normals(du, dv), gaussian, mean, principal_curvatures(found))


@dataclass(frozen=True, eq=False)
class _Shape:
    """The second form in an orthonormal frame of the tangent plane."""

    tangent: Floats
    """(..., 3) along S_u"""
    beside: Floats
    """(..., 3) a right angle to the left of it, seen from the normal's tip"""
    along: Floats
    """(...,)"""
    twist: Floats
    across: Floats


def _shape(derivatives: Sequence[Floats]) -> _Shape:
    _, du, dv, duu, duv, dvv = derivatives
    normal, tangent, other = normals(du, dv), unit(du), unit(dv)
    speed_u, speed_v = (np.linalg.norm(each, axis=-1) for each in (du, dv))
    beside = np.cross(normal, tangent)
    c, d = _dot(other, tangent), _dot(other, beside)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        # Divided twice: the square of a very small speed would be zero.
        along = _dot(normal, duu) / speed_u / speed_u
        mixed = _dot(normal, duv) / speed_u / speed_v
        second = _dot(normal, dvv) / speed_v / speed_v
        twist = (mixed - c * along) / d
        across = (second - c * (c * along + 2.0 * d * twist)) / d / d
    return _Shape(tangent, beside, along, twist, across)


def _is_singular(du: Floats, dv: Floats, across: Floats) -> Flags:
    speed_u, speed_v = (np.abs(each).max(axis=-1) for each in (du, dv))
    still = np.minimum(speed_u, speed_v) <= STILL * np.maximum(speed_u, speed_v)
    singular: Flags = still | (np.abs(across).max(axis=-1) <= PARALLEL)
    return singular


def _dot(a: Floats, b: Floats) -> Floats:
    dots: Floats = (a * b).sum(axis=-1)
    return dots
