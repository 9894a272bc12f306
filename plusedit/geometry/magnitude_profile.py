"""How a shape changes with the magnitude s: distance to its control points, bending, curvature.

Everything is affine in s, derivatives too: with f_i and p_i the classical part and the plus term at
the nodes, the squared distance to a control point is

    |f_i + s p_i - P_i|^2,

a quadratic in s for each i. What depends on curvature is worked out at the same parameters for
every s, by rules of Gauss and Legendre between the breaks of the basis: of curves in parts that are
halved until for all s two halves agree with the whole, of surfaces on one grid.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.curve import terms as curve_terms
from plusedit.geometry.frames import space_curvature
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.natural import best_s_of
from plusedit.geometry.pieces import breaks
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface import terms as surface_terms
from plusedit.geometry.surface_frames import mean_curvature, principal_curvatures

NODES, WEIGHTS = (row / 2.0 for row in np.polynomial.legendre.leggauss(8))
FEW_NODES, FEW_WEIGHTS = (row / 2.0 for row in np.polynomial.legendre.leggauss(4))
STILL = 1e-12  # of the coordinates: a speed that is rounding
FEWEST = 16  # parts of a curve to begin with
AGREED = 1e-3  # of an energy: what halving a part may change it by
ROUNDS, MOST = 14, 1024  # of halving, and parts that are halved at a time
FEWEST_OF_SURFACE, MOST_OF_SURFACE = 4, 10  # parts in each direction


@dataclass(frozen=True, eq=False)
class Distances:
    """How far a shape at its nodes is from its control points, for some values of s."""

    mean: Floats
    """(k,) root of the mean of the squared distances"""
    largest: Floats
    """(k,)"""


@dataclass(frozen=True, eq=False)
class MagnitudeProfile:
    """What a shape would be like for some values of s."""

    s: Floats
    """(k,)"""
    distances: Distances
    energy: Floats
    """(k,) of a curve the integral of its squared curvature by length, of a surface that of its
    squared mean curvature by area"""
    curvature: Floats
    """(k,) the largest curvature; of a surface that of its normal curvatures, without
    sign; nan where the shape stands still"""
    best: float | None
    """s*, for which the mean distance is least; None if s changes nothing"""


def distances_to_points(shape: PlusCurve | PlusSurface, s: Floats) -> Distances:
    """The distances for values of s (k,), in closed form."""
    base, plus = _at_nodes(shape)
    away = base - shape.net.control_points
    # One quadratic for each control point: rows of c + b s + a s^2.
    c, b, a = ((x * y).sum(axis=1) for x, y in ((away, away), (2.0 * away, plus), (plus, plus)))
    squares = np.maximum(c[:, None] + b[:, None] * s + a[:, None] * s**2, 0.0)
    return Distances(np.sqrt(squares.mean(axis=0)), np.sqrt(squares.max(axis=0)))


def magnitude_profile(shape: PlusCurve | PlusSurface, s: Floats) -> MagnitudeProfile:
    """All of it for values of s (k,)."""
    with np.errstate(all="ignore"):
        if isinstance(shape, PlusCurve):
            energy, curvature = _curve_bends(shape, s)
        else:
            energy, curvature = _surface_bends(shape, s)
    return MagnitudeProfile(s, distances_to_points(shape, s), energy, curvature, best_s_of(shape))


def _at_nodes(shape: PlusCurve | PlusSurface) -> tuple[Floats, Floats]:
    """(n, dim) each: the two terms at the nodes, in the order of the control points."""
    if isinstance(shape, PlusCurve):
        return curve_terms(shape.basis, shape.lines, Grid(shape.basis.nodes))
    grids = Grid(shape.basis_u.nodes), Grid(shape.basis_v.nodes)
    base, plus = surface_terms(*shape.bases, shape.planes, *grids)
    return base.reshape(-1, 3), plus.reshape(-1, 3)


def _curve_bends(curve: PlusCurve, s: Floats) -> tuple[Floats, Floats]:
    """(k,) bending energies and (k,) largest curvatures."""
    lines = curve.lines
    nowhere = ControlLines.of(np.zeros_like(lines.points), curve.directions, lines.weights)
    classical, pull = curve.classical, replace(curve, lines=nowhere, s=1.0)
    still = STILL * float(np.abs(lines.points).max())
    largest = np.full(len(s), np.nan)

    def density(u: Floats) -> Floats:
        base, plus = classical.derivatives(u), pull.derivatives(u)
        found = np.empty((len(s), len(u)))
        for row, value in enumerate(s.tolist()):
            _, velocity, acceleration = _sums(base, plus, value)
            speed = np.linalg.norm(velocity, axis=1)
            bend = np.where(speed > still, space_curvature(velocity, acceleration), np.nan)
            largest[row] = np.fmax(largest[row], _largest(bend))
            found[row] = np.nan_to_num(bend**2 * speed)
        return found

    return _integrals(density, _parts(curve.basis, FEWEST)), largest


def _integrals(density: Callable[[Floats], Floats], ends: Floats) -> Floats:
    """(k,) integrals over [0, 1] of a density (m,) -> (k, m), to about a thousandth."""
    low, high = ends[:-1], ends[1:]
    whole = _by_rule(density, low, high)
    total = np.zeros(len(whole))
    for _ in range(ROUNDS):
        middle = (low + high) / 2.0
        halves = _by_rule(density, np.append(low, middle), np.append(middle, high))
        first, second = np.split(halves, 2, axis=1)
        both = first + second
        size = np.abs(total)[:, None] + np.abs(both).sum(axis=1, keepdims=True)
        shares = np.divide(np.abs(both - whole), size, out=np.zeros_like(both), where=size != 0.0)
        change = np.nan_to_num(shares.max(axis=0), nan=np.inf)
        rough = change > AGREED
        if rough.sum() > MOST:
            rough &= change >= np.partition(change, -MOST)[-MOST]
        total += both[:, ~rough].sum(axis=1)
        if not rough.any():
            return total
        low, high = np.append(low[rough], middle[rough]), np.append(middle[rough], high[rough])
        whole = np.concatenate([first[:, rough], second[:, rough]], axis=1)
    found: Floats = total + whole.sum(axis=1)
    return found


def _by_rule(density: Callable[[Floats], Floats], low: Floats, high: Floats) -> Floats:
    """(k, p) integrals from `low` to `high` (p,) by one rule each."""
    width = high - low
    u = (low[:, None] + width[:, None] * (NODES + 0.5)).ravel()
    found = density(u)
    integrals: Floats = width * (found.reshape(len(found), len(low), -1) @ WEIGHTS)
    return integrals


def _surface_bends(surface: PlusSurface, s: Floats) -> tuple[Floats, Floats]:
    """(k,) integrals of the squared mean curvature and (k,) largest normal curvatures."""
    (u, by_u), (v, by_v) = (_rule(_parts(basis, FEWEST_OF_SURFACE)) for basis in surface.bases)
    planes = surface.planes
    along_u, along_v = surface.directions
    nowhere = ControlPlanes.of(np.zeros_like(planes.points), along_u, along_v, planes.weights)
    base = surface.classical.derivatives(u, v)
    plus = replace(surface, planes=nowhere, s=1.0).derivatives(u, v)
    energies, largest = [], []
    for value in s.tolist():
        found = _sums(base, plus, value)
        area = np.linalg.norm(np.cross(found[1], found[2]), axis=-1)
        density = np.where(area > 0.0, mean_curvature(found) ** 2 * area, 0.0)
        energies.append(float(by_u @ np.nan_to_num(density) @ by_v))
        ways = principal_curvatures(found)
        largest.append(_largest(np.maximum(np.abs(ways.largest), np.abs(ways.smallest))))
    return np.array(energies), np.array(largest)


def _sums(base: Sequence[Floats], plus: Sequence[Floats], s: float) -> tuple[Floats, ...]:
    return tuple(one + s * other for one, other in zip(base, plus, strict=True))


def _largest(values: Floats) -> float:
    finite = values[np.isfinite(values)]
    return float(finite.max()) if len(finite) else np.nan


def _parts(basis: Basis, fewest: int) -> Floats:
    """The breaks, and as many parameters between as make `fewest` parts."""
    ends = breaks(basis)
    each = -(-fewest // (len(ends) - 1))
    steps = ends[:-1, None] + np.diff(ends)[:, None] * np.arange(each) / each
    return np.append(steps.ravel(), 1.0)


def _rule(ends: Floats) -> tuple[Floats, Floats]:
    """(m,) parameters, and (m,) how much of the domain each stands for.

    Of very many parts only some are looked at, at even steps, as if they were all.
    """
    rows = np.arange(0, len(ends) - 1, -(-(len(ends) - 1) // MOST_OF_SURFACE))
    low, width = ends[rows], np.diff(ends)[rows]
    shares = (width[:, None] * FEW_WEIGHTS).ravel()
    return (low[:, None] + width[:, None] * (FEW_NODES + 0.5)).ravel(), shares / shares.sum()
