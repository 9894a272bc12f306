"""Parameters at which a surface looks smooth when its points are joined by flat triangles.

In every cell of the grid the surface is sampled at five by five places: how far it strays from
the chords along u and along v, and from the flat triangles between its corners, however the cell
is cut in two. A cell that strays too far says into how many parts it wants to be cut by u and by
v (errors fall with the square of the length), all cells of one round together. As the grid is one
of rows and columns, the most that any cell asks for is what a whole row or column of them gets.
"""

from dataclasses import dataclass, replace
from math import ceil, sqrt

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.blend import Grid
from plusedit.geometry.pieces import breaks, surface_pieces
from plusedit.geometry.surface import PlusSurface

ROUNDS = 60  # a jump between two neighboring doubles is found in 52 halvings
PARTS = 8  # at most, of one interval in one round
COARSER = 1.25  # factor by which the tolerance is raised while too many points are asked for
SAFE = 0.8  # of the tolerance: between samples, and in bent cells, the surface strays farther
ENOUGH = 40_000  # cells that tell how far all of them stray
BLOCK = 1 << 18  # points that are worked on at once
START = 4.0  # a first grid of more than this share of what is allowed is made of knots alone
SEEN = Grid.uniform(33)  # where the size of a surface is measured

SAMPLED = np.linspace(0.0, 1.0, 5)
INSIDE = SAMPLED[1:-1]

Split = NDArray[np.intp]
"""(m,) the number of parts of each interval"""


def _fold() -> Floats:
    """(3, 3) how far flat triangles lie from the twisted cell at the samples inside.

    In units of its distance at the center, and for the worse of both ways to cut it in two.
    """
    a, b = INSIDE[:, None], INSIDE
    one = np.minimum(a, b) * (1.0 - np.maximum(a, b))
    other = np.minimum(a * b, (1.0 - a) * (1.0 - b))
    return np.asarray(4.0 * np.maximum(one, other))


FOLD = _fold()


def surface_size(surface: PlusSurface) -> float:
    """The diagonal of the box about samples of the surface: what tolerances are a share of."""
    points = surface.sample(SEEN, SEEN).reshape(-1, 3)
    return float(np.linalg.norm(np.ptp(points, axis=0)))


@dataclass(frozen=True, eq=False)
class Tessellation:
    """Grids for flat triangles, and how far these may lie from the surface."""

    by_u: Grid
    by_v: Grid
    tolerance: float
    """as asked for, or about what is kept where that would have taken too many points"""


def surface_tessellation(
    surface: PlusSurface, tolerance: float, most: int = 1_000_000
) -> tuple[Grid, Grid]:
    """Parameters by u and by v whose flat triangles stay within `tolerance` of the surface.

    Both increase from 0 to 1 and hold every knot. `tolerance` is in the unit of the points; it
    counts for the chords along u and v as well as inside the cells. Where that would ask for a
    grid of more than `most` points it is raised until those do; only for knots alone there may
    be more.

    Raises ValueError if the tolerance is not positive.
    """
    made = affordable_tessellation(surface, tolerance, most)
    return made.by_u, made.by_v


def affordable_tessellation(
    surface: PlusSurface, tolerance: float, most: int = 1_000_000
) -> Tessellation:
    """The same, and to what tolerance."""
    if not tolerance > 0.0:
        raise ValueError(f"tolerance: must be positive, got {tolerance}")
    scale = _scale(surface)
    surface = _scaled(surface, 1.0 / scale)
    allowed = SAFE * tolerance / scale
    u, v = _start(surface, most)
    unsettled = np.ones((len(u) - 1, len(v) - 1), dtype=np.bool_)
    for _ in range(ROUNDS):
        strays = _strays(surface, u, v, unsettled)
        asked = allowed = max(allowed, strays.rounding)
        by_u, by_v = strays.parts(allowed, _narrow(u), _narrow(v))
        while _are_more(by_u, by_v) and _count(by_u, by_v) > most:
            allowed *= COARSER
            by_u, by_v = strays.parts(allowed, _narrow(u), _narrow(v))
        u, v = _cut(u, by_u), _cut(v, by_v)
        unsettled = (strays.most > asked).repeat(by_u, axis=0).repeat(by_v, axis=1)
        if allowed > asked:
            some = unsettled & _spread(unsettled.shape)
            kept = scale * float(_strays(surface, u, v, some).most.max()) / SAFE
            return Tessellation(Grid(u), Grid(v), max(tolerance, kept))
        if not _are_more(by_u, by_v):
            break
    return Tessellation(Grid(u), Grid(v), tolerance)


def _spread(shape: tuple[int, int]) -> NDArray[np.bool_]:
    """Some cells of all: every so many rows and columns."""
    step = ceil(sqrt(shape[0] * shape[1] / ENOUGH))
    some = np.zeros(shape, dtype=np.bool_)
    some[::step, ::step] = True
    return some


def _scale(surface: PlusSurface) -> float:
    """A power of two about as large as the coordinates."""
    largest = max(float(np.abs(each).max()) for each in (surface.planes.points, surface.gradients))
    return float(np.ldexp(1.0, int(np.frexp(largest)[1]))) if largest > 0.0 else 1.0


def _scaled(surface: PlusSurface, factor: float) -> PlusSurface:
    """The surface as it is, but larger or smaller: squares of its lengths fit a double."""
    planes = surface.planes.with_points(factor * surface.planes.points)
    return replace(surface, planes=planes, s=factor * surface.s)


def _start(surface: PlusSurface, most: int) -> tuple[Floats, Floats]:
    by_u, by_v = surface_pieces(surface)
    if START * len(by_u) * len(by_v) > most:
        return breaks(surface.basis_u), breaks(surface.basis_v)
    return by_u.parameters, by_v.parameters


@dataclass(frozen=True, eq=False)
class _Strays:
    """How far the surface strays in each cell, (m_u, m_v) each, 0 where nobody has looked."""

    along_u: Floats
    along_v: Floats
    most: Floats
    """inside the cell or from its chords"""
    rounding: float
    """a distance that says nothing"""

    def parts(
        self, allowed: float, narrow_u: NDArray[np.bool_], narrow_v: NDArray[np.bool_]
    ) -> tuple[Split, Split]:
        """Into how many parts each interval by u and by v is to be cut; narrow ones stay whole.

        In a cell the errors along u and v add up, or cancel in part; scaled, or with the twist
        shared among them, they add up to what was found. The fewest cells that bring
        e_u / p_u^2 + e_v / p_v^2 down to what is allowed have half of it from each; or all that
        one needs where the other is less than half of it as it is.
        """
        both = self.along_u + self.along_v
        scale = np.where(both > self.most, self.most / np.where(both > 0.0, both, 1.0), 1.0)
        twist = np.maximum(self.most - both, 0.0) / 2.0
        e_u, e_v = scale * self.along_u + twist, scale * self.along_v + twist
        half = allowed / 2.0
        by_u = np.where(e_u > half, e_u / (allowed - np.minimum(e_v, half)), 1.0)
        by_v = np.where(e_v > half, e_v / (allowed - np.minimum(e_u, half)), 1.0)
        far = self.most > allowed
        by_u, by_v = np.where(far, by_u, 1.0).max(axis=1), np.where(far, by_v, 1.0).max(axis=0)
        first, second = (np.clip(np.ceil(np.sqrt(by)), 1, PARTS) for by in (by_u, by_v))
        return (
            np.where(narrow_u, 1, first).astype(np.intp),
            np.where(narrow_v, 1, second).astype(np.intp),
        )


def _strays(surface: PlusSurface, u: Floats, v: Floats, wanted: NDArray[np.bool_]) -> _Strays:
    """Of the cells of all rows and columns that have a wanted one."""
    rows, columns = np.flatnonzero(wanted.any(axis=1)), np.flatnonzero(wanted.any(axis=0))
    found = np.zeros((3, *wanted.shape))
    largest, across = 0.0, _within(v, columns)
    step = max(1, BLOCK // (len(SAMPLED) * max(len(across), 1)))
    for start in range(0, len(rows), step):
        some = rows[start : start + step]
        points = surface.at(_within(u, some), across)
        largest = max(largest, float(np.abs(points).max()))
        cells = points.reshape(len(some), len(SAMPLED), len(columns), len(SAMPLED), 3)
        found[:, some[:, None], columns] = _of_cells(np.moveaxis(cells, 1, 2))
    along_u, along_v, farthest = found
    return _Strays(along_u, along_v, farthest, 16.0 * float(np.finfo(np.float64).eps) * largest)


def _within(u: Floats, rows: NDArray[np.intp]) -> Floats:
    """(5 k,) the SAMPLED fractions of those intervals, one after another."""
    low, high = u[rows], u[rows + 1]
    places = low[:, None] + (high - low)[:, None] * SAMPLED
    places[:, -1] = high
    return places.ravel()


def _of_cells(points: Floats) -> Floats:
    """(3, a, b) errors along u, along v, and the largest of all, of cells (a, b, 5, 5, 3)."""
    along_u = _from_chords(points)
    along_v = _from_chords(np.swapaxes(points, 2, 3))
    return np.stack([along_u, along_v, np.maximum(np.maximum(along_u, along_v), _inside(points))])


def _from_chords(points: Floats) -> Floats:
    """(a, b) the farthest that points lie from the chords along the third axis."""
    start, way = points[:, :, :1], points[:, :, -1:] - points[:, :, :1]
    length = np.linalg.norm(way, axis=-1)
    heading = unit(way)
    away = points[:, :, 1:-1] - start
    along = np.clip(np.einsum("abijd,abkjd->abij", away, heading), 0.0, length)
    away -= along[..., None] * heading
    strays: Floats = np.sqrt(np.einsum("abijd,abijd->abij", away, away)).max(axis=(2, 3))
    return strays


def _inside(points: Floats) -> Floats:
    """(a, b) the farthest that a cell lies from flat triangles, across them."""
    corners = points[:, :, :: len(SAMPLED) - 1, :: len(SAMPLED) - 1]
    first, second = corners[:, :, 0, 0], corners[:, :, 1, 1]
    third, fourth = corners[:, :, 1, 0], corners[:, :, 0, 1]
    normal = unit(np.cross(unit(second - first), unit(fourth - third)))
    heights = np.einsum("abijd,abd->abij", points - first[:, :, None, None], normal)
    ends = heights[:, :, :: len(SAMPLED) - 1, :: len(SAMPLED) - 1]
    shares = np.stack([1.0 - INSIDE, INSIDE])
    flat = np.einsum("pi,abpq,qj->abij", shares, ends, shares)
    twist = np.abs(ends[..., 0, 0] + ends[..., 1, 1] - ends[..., 0, 1] - ends[..., 1, 0]) / 4.0
    strays: Floats = np.abs(heights[:, :, 1:-1, 1:-1] - flat) + twist[..., None, None] * FOLD
    return np.asarray(strays.max(axis=(2, 3)))


def _narrow(u: Floats) -> NDArray[np.bool_]:
    """(m,) which intervals hold hardly any numbers between their ends."""
    narrow: NDArray[np.bool_] = np.diff(u) <= 2.0 * PARTS * np.spacing(u[1:])
    return narrow


def _are_more(by_u: Split, by_v: Split) -> bool:
    """Whether any interval is cut."""
    return bool((by_u > 1).any() or (by_v > 1).any())


def _count(by_u: Split, by_v: Split) -> int:
    """Of the points of a grid with intervals cut into so many parts."""
    return (int(by_u.sum()) + 1) * (int(by_v.sum()) + 1)


def _cut(u: Floats, parts: Split) -> Floats:
    """The intervals, each cut into that many equal parts."""
    first = np.repeat(np.cumsum(parts) - parts, parts)
    share = (np.arange(len(first)) - first) / np.repeat(parts, parts)
    inner = np.repeat(u[:-1], parts) + share * np.repeat(np.diff(u), parts)
    return np.unique(np.append(inner, 1.0))
