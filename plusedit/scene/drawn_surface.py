"""Surfaces as grids of facets that look smooth: no farther than half a pixel from the surface.

A surface is first sampled at every knot and some parameters between. How far each interval strays
from its chord tells in how many parts, a power of two, it has to be cut: a chord half as long
strays a quarter as far. What is far outside of the view is left coarse.

A new grid is finer than it has to be, and one that was made for the same bases serves on while it
is fine enough: so the same grid, and the same matrices, last through a drag and while s changes.
What was worked out is kept with its surface, for as long as that lives.
"""

from dataclasses import dataclass, field
from functools import lru_cache
from math import ceil
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid
from plusedit.geometry.pieces import breaks, degree
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.camera import Camera

TOLERANCE = 0.5  # pixels
DRAFT = 4.0  # times the tolerance while there is no time
AHEAD = 0.4  # of the tolerance: a new grid is that fine, so that it lasts through a drag
MOST, MOST_OF_DRAFT = 1 << 16, 1 << 13  # points of one grid, unless its knots alone are more
FEWEST = 8  # intervals that are looked at in each direction
PARTS = 4  # of an interval, a power of two: where they end it is compared with its chord
BESIDE = 0.5  # of the view, around it: what lies there is as fine as what is seen
NEAR = 24.0  # pixels that control planes may move before grids are looked at anew
WASTE = 2.5  # times as many points as there have to be, up to which a grid serves on

Cuts = NDArray[np.int8]
"""(m,) the exponents of two of the parts of each interval"""

Grids = tuple[Grid, Grid]


@dataclass(frozen=True, eq=False)
class Strays:
    """The intervals of a surface, and how far it strays from their chords."""

    points: Floats
    """(m_u + 1, m_v + 1, 3) where intervals meet"""
    along_u: Floats
    """(m_u, m_v + 1) distances in the world"""
    along_v: Floats
    """(m_u + 1, m_v)"""


@dataclass(frozen=True, eq=False)
class _Recent:
    """The last grids that were made for surfaces of two bases, and where they were found to do."""

    cuts: tuple[Cuts, Cuts]
    camera: Camera
    points: Floats
    gradients: Floats


@dataclass(eq=False)
class _Kept:
    """What is known of one surface. It holds as long as the surface: neither ever changes."""

    strays: Strays | None = None
    grids: dict[tuple[Camera, bool], Grids] = field(default_factory=dict)


_KEPT: "WeakKeyDictionary[PlusSurface, _Kept]" = WeakKeyDictionary()
_RECENT: dict[tuple[Basis, Basis, bool], _Recent] = {}


def surface_grids(surface: PlusSurface, camera: Camera, *, draft: bool = False) -> Grids:
    """Parameters by u and by v at which the surface is drawn in that view, 0 and 1 among them.

    The very same grids as before wherever they do; with `draft` coarser ones.
    """
    kept = _kept(surface)
    found = kept.grids.get((camera, draft))
    if found is None:
        found = _grids(surface, camera, draft)
        while len(kept.grids) > 3:
            del kept.grids[next(iter(kept.grids))]
        kept.grids[camera, draft] = found
    return found


def coarse_points(surface: PlusSurface) -> Floats:
    """(m, 3) points all over a surface: at its knots and some parameters between."""
    return _strays_of(surface).points.reshape(-1, 3)


def _kept(surface: PlusSurface) -> _Kept:
    kept = _KEPT.get(surface)
    if kept is None:
        kept = _KEPT[surface] = _Kept()
    return kept


def _strays_of(surface: PlusSurface) -> Strays:
    kept = _kept(surface)
    if kept.strays is None:
        kept.strays = _strays(surface)
    return kept.strays


def _grids(surface: PlusSurface, camera: Camera, draft: bool) -> Grids:
    """Grids fine enough for that view; those of the frame before if they are."""
    key = (*surface.bases, draft)
    recent = _RECENT.get(key)
    if recent is None or not _is_near(recent, surface, camera):
        cuts = _cuts_for(surface, camera, draft, None if recent is None else recent.cuts)
        recent = _Recent(cuts, camera, surface.planes.points, surface.gradients)
        _remember(key, recent)
    by_u, by_v = (
        _cut(basis, cuts.tobytes()) for basis, cuts in zip(surface.bases, recent.cuts, strict=True)
    )
    return by_u, by_v


def _is_near(recent: _Recent, surface: PlusSurface, camera: Camera) -> bool:
    """Whether so little has moved since grids were found to do that they still must.

    A facet strays much less than the control planes move that it follows.
    """
    if camera != recent.camera:
        return False
    moved = float(np.abs(surface.planes.points - recent.points).max())
    turned = float(np.abs(surface.gradients - recent.gradients).max()) * max(surface.spacings)
    return moved + turned <= NEAR * camera.pixel


def _cuts_for(
    surface: PlusSurface, camera: Camera, draft: bool, recent: tuple[Cuts, Cuts] | None
) -> tuple[Cuts, Cuts]:
    in_pixels = _in_pixels(_strays_of(surface), camera)
    tolerance = TOLERANCE * DRAFT if draft else TOLERANCE
    most = MOST_OF_DRAFT if draft else MOST
    if recent is not None and _serves(recent, _afforded(in_pixels, tolerance, most)):
        return recent
    return _afforded(in_pixels, AHEAD * tolerance, most)


def _strays(surface: PlusSurface) -> Strays:
    by_u, by_v = surface.bases
    along_u = surface.sample(_looked_at(by_u), _intervals(by_v))
    along_v = surface.sample(_intervals(by_u), _looked_at(by_v)).swapaxes(0, 1)
    return Strays(along_u[::PARTS], _sagitta(along_u), _sagitta(along_v).swapaxes(0, 1))


def _sagitta(points: Floats) -> Floats:
    """(m, k) how far points (PARTS m + 1, k, 3) stray from chords from each PARTS-th to the next.

    Compared with where a straight line has them: on a curve that is run through unevenly that is
    more than its distance, and asks for shorter chords there.
    """
    starts, ends = points[:-1:PARTS], points[PARTS::PARTS]
    most = np.zeros(starts.shape[:2])
    for part in range(1, PARTS):
        share = part / PARTS
        off = points[part::PARTS] - ((1.0 - share) * starts + share * ends)
        np.maximum(most, np.einsum("ijd,ijd->ij", off, off), out=most)
    strays: Floats = np.sqrt(most)
    return strays


def _in_pixels(strays: Strays, camera: Camera) -> tuple[Floats, Floats]:
    """(m_u,) and (m_v,) the most that any facet strays in each interval, in pixels of the view.

    Of facets that are far outside of it, nothing counts.
    """
    flat = strays.points.reshape(-1, 3)
    shape = strays.points.shape[:2]
    pixel = np.broadcast_to(camera.pixel_at(flat), len(flat)).reshape(shape)
    seen = _seen(camera.to_screen(flat).reshape(*shape, 2), camera)
    by_u = strays.along_u / np.minimum(pixel[:-1], pixel[1:])
    by_v = strays.along_v / np.minimum(pixel[:, :-1], pixel[:, 1:])
    across_u = np.where(seen, np.maximum(by_u[:, :-1], by_u[:, 1:]), 0.0)
    across_v = np.where(seen, np.maximum(by_v[:-1], by_v[1:]), 0.0)
    return across_u.max(axis=1), across_v.max(axis=0)


def _seen(screen: Floats, camera: Camera) -> NDArray[np.bool_]:
    """(m_u, m_v) whether facets with corners at pixels (m_u + 1, m_v + 1, 2) come near the view."""
    corners = np.stack([screen[:-1, :-1], screen[1:, :-1], screen[:-1, 1:], screen[1:, 1:]])
    low, high = corners.min(axis=0), corners.max(axis=0)
    size = np.array(camera.size)
    # A facet may reach as far beyond its corners as they are apart.
    more = BESIDE * size + (high - low)
    near: NDArray[np.bool_] = ((high > -more) & (low < size + more)).all(axis=-1)
    return near


def _cuts(strays: Floats, tolerance: float) -> Cuts:
    """The exponents that bring each interval within the tolerance."""
    with np.errstate(divide="ignore", invalid="ignore"):
        halvings = np.ceil(np.log2(strays / tolerance) / 2.0)
    return np.nan_to_num(halvings, nan=0.0, neginf=0.0, posinf=12.0).clip(0, 12).astype(np.int8)


def _afforded(strays: tuple[Floats, Floats], tolerance: float, most: int) -> tuple[Cuts, Cuts]:
    """The exponents for that, the largest of them lowered until the grid has no more points."""
    by_u, by_v = _cuts(strays[0], tolerance), _cuts(strays[1], tolerance)
    while _count(by_u) * _count(by_v) > most and max(by_u.max(), by_v.max()) > 0:
        if by_u.max() >= by_v.max():
            by_u = np.minimum(by_u, by_u.max() - 1)
        else:
            by_v = np.minimum(by_v, by_v.max() - 1)
    return by_u, by_v


def _count(cuts: Cuts) -> int:
    return int((1 << cuts.astype(np.int64)).sum()) + 1


def _serves(recent: tuple[Cuts, Cuts], need: tuple[Cuts, Cuts]) -> bool:
    """Whether a grid is fine enough, and not much finer than that."""
    if any(len(have) != len(want) for have, want in zip(recent, need, strict=True)):
        return False
    if any((have < want).any() for have, want in zip(recent, need, strict=True)):
        return False
    have, want = (_count(by_u) * _count(by_v) for by_u, by_v in (recent, need))
    # Twice ahead in each direction is how it begins.
    return have <= max(4.0 * WASTE * want, MOST_OF_DRAFT / 4.0)


def _remember(key: tuple[Basis, Basis, bool], recent: _Recent) -> None:
    _RECENT.pop(key, None)
    _RECENT[key] = recent
    if len(_RECENT) > 64:
        del _RECENT[next(iter(_RECENT))]


@lru_cache(maxsize=128)
def _looked_at(basis: Basis) -> Grid:
    """Parameters where intervals meet, and between them those that divide each into PARTS."""
    exponents = np.full(len(_intervals(basis)) - 1, PARTS.bit_length() - 1, dtype=np.int8)
    return _cut(basis, exponents.tobytes())


@lru_cache(maxsize=128)
def _intervals(basis: Basis) -> Grid:
    """The breaks, and between them as many parameters as the degree asks for."""
    ends = breaks(basis)
    parts = max(ceil(degree(basis) / 4.0), ceil(FEWEST / (len(ends) - 1)))
    inside = np.arange(parts) / parts
    steps = ends[:-1, None] + np.diff(ends)[:, None] * inside
    return Grid(np.unique(np.append(steps, 1.0)))


@lru_cache(maxsize=128)
def _cut(basis: Basis, exponents: bytes) -> Grid:
    """The intervals of a basis, each cut into two to the power of its exponent."""
    u = _intervals(basis).parameters
    parts = 1 << np.frombuffer(exponents, dtype=np.int8).astype(np.int64)
    first = np.repeat(np.cumsum(parts) - parts, parts)
    share = (np.arange(len(first)) - first) / np.repeat(parts, parts)
    inner = np.repeat(u[:-1], parts) + share * np.repeat(np.diff(u), parts)
    return Grid(np.append(inner, 1.0))
