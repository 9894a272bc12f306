"""Plus surfaces in single precision, as they are drawn, and as fast as that goes.

With B, D the matrices of the basis by u and C, E those of the one by v (`blend`), and their
derivatives B', D', C', E', the two terms of a surface and of its tangents are

    base   = B  P C^T      plus   = B  d^v E^T + D  d^u C^T
    base_u = B' P C^T      plus_u = B' d^v E^T + D' d^u C^T
    base_v = B  P C'^T     plus_v = B  d^v E'^T + D d^u C'^T.

The products by v come first: they are of few rows. Those by u then add up long rows, (x, y, z)
after (x, y, z), which is what is uploaded. Coordinates are measured from the middle of the
control points on the way, so that a shape far from the origin keeps its tangents.

What is sampled or exported comes from `PlusSurface`, in double precision.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import unit
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid, blend
from plusedit.geometry.matrices import dense
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.row_products import NEGLIGIBLE, Singles, crossed, single
from plusedit.geometry.surface import PlusSurface, tangent_terms
from plusedit.geometry.surface_terms import (
    Bases,
    BasisTaps,
    Grids,
    Nets,
    Part,
    basis_taps,
    beside_points,
    extent,
    is_even,
)

BLOCK = 1 << 15  # samples for which tangents and normals stay in the cache together
STILL = 1e-18  # of the square of the size: cross products of tangents; the square of less is zero
SMALLEST = 1e-100  # size that can be divided by

# The C library hands free blocks of some megabytes back to the system, and fresh memory costs
# more time than what is computed into it; unless it has seen a larger block come and go.
np.empty(31 << 20, dtype=np.uint8)


@dataclass(frozen=True, eq=False)
class SurfaceBuffers:
    """Points and tangents as two terms each: S = base + s plus, S_u = base_u + s plus_u, ...

    Each is (m_u, m_v, 3) in single precision, C-contiguous, and finite.
    """

    base: Singles
    plus: Singles
    base_u: Singles
    plus_u: Singles
    base_v: Singles
    plus_v: Singles


@lru_cache(maxsize=4)
def surface_buffers(
    basis_u: Basis, basis_v: Basis, planes: ControlPlanes, grid_u: Grid, grid_v: Grid
) -> SurfaceBuffers:
    """What a view uploads of a surface; another s leaves it as it is.

    To single precision, but for coordinates beyond 1e30, which are cut. Along a border that is
    drawn together to a point the tangents are those just beside it, which have a normal.
    """
    return _buffers((basis_u, basis_v), planes, (grid_u, grid_v), None)


@dataclass(frozen=True, eq=False)
class ChangedRows:
    """The rows of buffers that differ from earlier ones."""

    rows: slice
    """of the samples by u"""
    buffers: SurfaceBuffers
    """(rows, m_v, 3) each"""


def changed_rows(
    basis_u: Basis,
    basis_v: Basis,
    planes: ControlPlanes,
    before: ControlPlanes,
    grid_u: Grid,
    grid_v: Grid,
) -> ChangedRows | None:
    """What has to be uploaded again where there are the buffers of `before`; None if nothing.

    A moved control plane reaches as far as its blending function, its neighbors with automatic
    directions included: on a B-spline of many planes a few rows only.
    """
    moved = _moved(basis_u, basis_v, planes, before)
    reach = _reach(basis_u, grid_u)
    rows = _span((reach & moved).any(axis=1))
    if rows is None:
        return None
    reached = _span(reach[rows[0] : rows[1]].any(axis=0)) or (0, 0)
    buffers = _buffers((basis_u, basis_v), planes, (grid_u, grid_v), (*rows, *reached))
    return ChangedRows(slice(*rows), buffers)


def _span(flags: NDArray[np.bool_] | np.bool_) -> tuple[int, int] | None:
    """The first and the end of what is true; None if nothing is."""
    found = np.flatnonzero(flags)
    return (int(found[0]), int(found[-1]) + 1) if len(found) else None


def _moved(
    basis_u: Basis, basis_v: Basis, planes: ControlPlanes, before: ControlPlanes
) -> NDArray[np.bool_]:
    """(n_u,) which rows of control planes differ."""
    if (planes.weights is None) != (before.weights is None):
        return np.ones(planes.shape[0], dtype=np.bool_)
    here, there = (
        each.directions(closed_u=basis_u.closed, closed_v=basis_v.closed)
        for each in (planes, before)
    )
    moved = ((planes.points != before.points) | (here != there).any(axis=0)).any(axis=(1, 2))
    if planes.weights is not None:
        moved |= (planes.unit_weights != before.unit_weights).any(axis=1)
    return np.asarray(moved)


@lru_cache(maxsize=32)
def _reach(basis: Basis, grid: Grid) -> NDArray[np.bool_]:
    """(m, n) where a control plane counts for a sample or its tangents."""
    values, slopes = (np.abs(dense(blend(basis, grid, r).values)) for r in (0, 1))
    steepest = slopes.max(initial=0.0) or 1.0
    counts: NDArray[np.bool_] = np.maximum(values, slopes / steepest) > NEGLIGIBLE
    return counts


def surface_points(surface: PlusSurface, grid_u: Grid, grid_v: Grid) -> Singles:
    """(m_u, m_v, 3) points in single precision; the quickest there is."""
    if not is_even(surface.planes):
        return single(surface.sample(grid_u, grid_v))
    by_u, by_v = basis_taps(surface.basis_u, grid_u), basis_taps(surface.basis_v, grid_v)
    nets = Nets.of(surface.bases, surface.planes, s=surface.s)
    found = by_u.both.along(nets.lines_by_u(by_v))
    if nets.weights is not None:
        found /= by_u.values.along(by_v.values.across(nets.weights))
    return found.reshape(len(grid_u), len(grid_v), 3)


def points_and_normals(surface: PlusSurface, grid_u: Grid, grid_v: Grid) -> tuple[Singles, Singles]:
    """(m_u, m_v, 3) points and unit normals S_u x S_v in single precision.

    Along a border that is drawn together to a point it is the one just beside; elsewhere, where
    the surface has no normal, some vector no longer than one.
    """
    points = surface_points(surface, grid_u, grid_v)
    normals = np.empty_like(points)
    height = max(1, BLOCK // len(grid_v))
    for rows, by_u, by_v in _tangents(surface, grid_u, grid_v, height):
        crossed(by_u, by_v, STILL, normals[rows].reshape(by_u.shape))
    return points, normals


def _tangents(
    surface: PlusSurface, grid_u: Grid, grid_v: Grid, height: int
) -> Iterator[tuple[slice, Singles, Singles]]:
    """So many rows of samples at a time: S_u and S_v, (rows, 3 m_v), in units of the size.

    Where there are weights, times the denominator: only the directions count.
    """
    bases, planes = surface.bases, surface.planes
    beside = beside_points(bases, planes, (grid_u, grid_v))
    if not is_even(planes):
        by_u, by_v = _exact_tangents(surface, *beside)
        yield slice(None), by_u, by_v
        return
    pull = float(np.abs(surface.directions).max()) * abs(surface.s)
    scale = 1.0 / max(extent(planes), pull, SMALLEST)
    nets = Nets.of(bases, planes, s=surface.s, middle=planes.points[0, 0], factor=scale)
    (u, u_slope), (v, v_slope) = _both_taps(bases, beside)
    lines, slopes = nets.lines_by_u(v), nets.lines_by_u(v_slope)
    for start in range(0, len(grid_u), height):
        rows = slice(start, start + height)
        by_u, by_v = u_slope.both.along(lines, rows), u.both.along(slopes, rows)
        if nets.weights is not None:
            shares, share_slopes = (taps.values.across(nets.weights) for taps in (v, v_slope))
            at = u.both.along(lines, rows) / u.values.along(shares, rows)
            by_u -= at * u_slope.values.along(shares, rows)
            by_v -= at * u.values.along(share_slopes, rows)
        yield rows, by_u, by_v


def _exact_tangents(surface: PlusSurface, grid_u: Grid, grid_v: Grid) -> tuple[Singles, ...]:
    """The directions of S_u and S_v by double precision, (m_u, 3 m_v) each."""
    _, by_u, by_v = surface.derivatives(grid_u.parameters, grid_v.parameters, highest=1)
    return tuple(single(unit(way)).reshape(len(grid_u), -1) for way in (by_u, by_v))


def _both_taps(
    bases: Bases, grids: Grids, part: Part | None = None
) -> list[tuple[BasisTaps, BasisTaps]]:
    """By u, of a part or all, then by v: those of the values and those of the slopes."""
    return [
        (basis_taps(basis, grid, 0, some), basis_taps(basis, grid, 1, some))
        for basis, grid, some in zip(bases, grids, (part, None), strict=True)
    ]


def _buffers(
    bases: Bases, planes: ControlPlanes, grids: Grids, part: Part | None
) -> SurfaceBuffers:
    """The buffers at some rows of samples, or all."""
    beside = beside_points(bases, planes, grids)
    if is_even(planes):
        found = _terms(bases, planes, grids, beside, part)
    else:
        at = tangent_terms(*bases, planes, *grids)
        near = tangent_terms(*bases, planes, *beside)
        exact = (at.base, at.plus, near.base_u, near.plus_u, near.base_v, near.plus_v)
        rows = slice(None) if part is None else slice(*part[:2])
        found = [single(term[rows]) for term in exact]
    return SurfaceBuffers(*(term.reshape(len(term), -1, 3) for term in found))


def _terms(
    bases: Bases, planes: ControlPlanes, grids: Grids, beside: Grids, part: Part | None
) -> list[Singles]:
    """The six of them in single precision, (rows, 3 m_v) each."""
    rows = slice(None) if part is None else slice(*part[2:])
    (by_u, _), (by_v, _) = _both_taps(bases, grids, part)
    at = Nets.of(bases, planes, rows=rows).terms(by_u, by_v).divided()
    # From one of the points on: far from the origin differences would be lost.
    nets = Nets.of(bases, planes, middle=planes.points[0, 0], rows=rows)
    (u, u_slope), (v, v_slope) = _both_taps(bases, beside, part)
    ways = [nets.terms(u_slope, v), nets.terms(u, v_slope)]
    if nets.weights is not None:
        near = nets.terms(u, v).divided()
        ways = [way.derived(near) for way in ways]
    return [at.base, at.plus, *(term for way in ways for term in (way.base, way.plus))]
