"""Lines on a surface: those of constant u and constant v, and its edges.

They run at the nodes of both bases, and halfway between where there are few nodes, along the same
parameters as the facets of the surface.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.blend import Grid
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.drawn_surface import Grids
from plusedit.scene.items import Item, Polyline

FEW, MANY = 6, 24  # lines: of fewer there are some between, of more some are left out
WIDTH = 1.0  # pixels


@dataclass(frozen=True, eq=False)
class Isolines:
    """Lines on one surface in the world, (m, 3) each."""

    along_u: tuple[Floats, ...]
    """with v constant, at nodes"""
    along_v: tuple[Floats, ...]
    between_u: tuple[Floats, ...]
    """with v constant, between nodes"""
    between_v: tuple[Floats, ...]
    edges: tuple[Floats, ...]
    """where an open direction begins and ends"""


@dataclass(eq=False)
class _Kept:
    lines: Isolines
    items: dict[str, tuple[Item, ...]] = field(default_factory=dict)


_KEPT: "WeakKeyDictionary[PlusSurface, dict[Grids, _Kept]]" = WeakKeyDictionary()
VIEWS = 4  # grids whose lines are kept: those of the plane and of space, drafts of both


def isolines(surface: PlusSurface, grids: Grids) -> Isolines:
    """The lines of a surface that is drawn with those grids; the same ones for the same grids."""
    return _kept(surface, grids).lines


def isoline_items(surface: PlusSurface, grids: Grids, fade: str = "") -> tuple[Item, ...]:
    """The lines but for edges: yellow where u runs, magenta where v runs, fainter between nodes.

    `fade` is the opacity of all of them, such as "@25". The same items while they stay the same.
    """
    kept = _kept(surface, grids)
    if fade not in kept.items:
        kept.items[fade] = tuple(_items(kept.lines, fade))
    return kept.items[fade]


def _kept(surface: PlusSurface, grids: Grids) -> _Kept:
    by_grids = _KEPT.setdefault(surface, {})
    if grids not in by_grids:
        while len(by_grids) >= VIEWS:
            del by_grids[next(iter(by_grids))]
        by_grids[grids] = _Kept(_lines(surface, grids))
    return by_grids[grids]


def _items(lines: Isolines, fade: str) -> Iterator[Item]:
    for opacity, rows_u, rows_v in (
        ("@35", lines.between_u, lines.between_v),
        ("@80", lines.along_u, lines.along_v),
    ):
        for color, rows in (("u", rows_u), ("v", rows_v)):
            for points in rows:
                yield Polyline(points, color + (fade or opacity), WIDTH)


def _lines(surface: PlusSurface, grids: Grids) -> Isolines:
    by_u, by_v = grids
    (nodes_u, more_u, ends_u), (nodes_v, more_v, ends_v) = map(_places, surface.bases)
    along_u = surface.sample(by_u, _together(nodes_v, more_v, ends_v)).swapaxes(0, 1)
    along_v = surface.sample(_together(nodes_u, more_u, ends_u), by_v)
    nodal_u, between_u, first = _parted(along_u, len(nodes_v), len(more_v))
    nodal_v, between_v, second = _parted(along_v, len(nodes_u), len(more_u))
    return Isolines(nodal_u, nodal_v, between_u, between_v, (*first, *second))


def _parted(lines: Floats, nodes: int, more: int) -> tuple[tuple[Floats, ...], ...]:
    rows = tuple(np.ascontiguousarray(row) for row in lines)
    return rows[:nodes], rows[nodes : nodes + more], rows[nodes + more :]


def _together(*parameters: tuple[float, ...]) -> Grid:
    return Grid(np.concatenate(parameters))


@lru_cache(maxsize=128)
def _places(basis: Basis) -> tuple[tuple[float, ...], ...]:
    """Parameters of the lines at nodes, between nodes, and of the edges."""
    ends = () if basis.closed else (0.0, 1.0)
    nodes = np.unique(basis.nodes)
    inner = nodes if basis.closed else nodes[(nodes > 0.0) & (nodes < 1.0)]
    if len(inner) > MANY:
        inner = inner[:: -(-len(inner) // MANY)]
    all_of_them = np.unique(np.concatenate([inner, ends]))
    if basis.closed:
        all_of_them = np.append(all_of_them, all_of_them[0] + 1.0)
    more = (all_of_them[:-1] + all_of_them[1:]) / 2.0 % 1.0 if len(inner) < FEW else inner[:0]
    return tuple(inner.tolist()), tuple(more.tolist()), ends
