"""Two shapes of a design against each other: how far each is from the other.

Curves are compared with curves; surfaces and surfaces of meshes with each other. What was found is
kept for as long as both shapes live. Curves of some lines are compared at once; all else takes a
while: windows draw what was known before the last change, and have the rest found beside.
"""

from collections import OrderedDict
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.apart import Gap, SurfacePoints, curve_gap, parts_of, surface_gap
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.making.compatible import in_space
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.drawn_surface import Grids
from plusedit.scene.mesh_drawing import MeshDrawing

QUICK = 100  # lines of two curves together that are compared within a frame
RECENT = 8  # pairs of which the last comparison is kept

Party: TypeAlias = PlusCurve | PlusSurface | MeshDrawing
"""What is compared: of a mesh its surface as it is drawn."""


class Pair(NamedTuple):
    """Two shapes; the first one is colored, and has the hairs."""

    first: ShapeId
    second: ShapeId


@dataclass(frozen=True, eq=False)
class Compared:
    """How far two shapes are from each other."""

    there: Gap
    """from points of the first to the second"""
    back: Gap
    grid: SurfacePoints | None = None
    """where the points of the first lie, if it is a surface with a net"""

    @property
    def hausdorff(self) -> float:
        """The estimate of the Hausdorff distance, from below."""
        return max(self.there.largest, self.back.largest)


_KNOWN: "WeakKeyDictionary[Party, WeakKeyDictionary[Party, Compared]]" = WeakKeyDictionary()
_LATEST: "OrderedDict[Pair, Compared]" = OrderedDict()
_VALUES: "WeakKeyDictionary[Compared, dict[Grids, Floats]]" = WeakKeyDictionary()


def pair_of(design: Design, chosen: frozenset[ShapeId]) -> Pair | None:
    """The two selected shapes; a single one with the first other of its kind that is seen.

    Without a selection the first two of one kind, those in front of all others first. None where
    there are no two.
    """
    visible = [shape_id for shape_id in reversed(list(design)) if design[shape_id].visible]
    selected = [shape_id for shape_id in visible if shape_id in chosen]
    if len(selected) > 2:
        return None
    for first in selected[:1] or visible:
        is_curve = design[first].curve is not None
        others = [i for i in selected[1:] or visible if i != first]
        for second in others:
            if (design[second].curve is not None) == is_curve:
                return Pair(first, second)
    return None


def comparison(design: Design, pair: Pair, *, wait: bool = True) -> Compared | None:
    """How far the shapes of a pair are from each other.

    Without `wait` what is known by now, which may be of before the last change; None if nothing is.
    """
    parties = parties_of(design, pair, wait=wait)
    known = known_comparison(*parties)
    if known is None and (wait or _is_quick(*parties)):
        known = compare(*parties)
    if known is None:
        return _LATEST.get(pair)
    _LATEST[pair] = known
    while len(_LATEST) > RECENT:
        _LATEST.popitem(last=False)
    return known


def parties_of(design: Design, pair: Pair, *, wait: bool = False) -> tuple[Party, Party]:
    """What is to be compared, as it is now."""
    first, second = (_party(design[shape_id].geometry, wait) for shape_id in pair)
    return first, second


def known_comparison(first: Party, second: Party) -> Compared | None:
    """What was found of just these."""
    found = _KNOWN.get(first)
    return None if found is None else found.get(second)


def compare(first: Party, second: Party) -> Compared:
    """Compare them, in whatever thread, and keep what was found."""
    with np.errstate(all="ignore"):
        grid = SurfacePoints.of(first) if isinstance(first, PlusSurface) else None
        found = Compared(_gap(first, second), _gap(second, first), grid)
    _KNOWN.setdefault(first, WeakKeyDictionary())[second] = found
    return found


def values_at(found: Compared, drawn: Grids | MeshDrawing) -> Floats | None:
    """The distances of the first shape at the points that are drawn of it.

    (m_u, m_v) of a surface, by straight lines between those that are known; (n,) of a mesh. None
    where they are of other points.
    """
    if isinstance(drawn, MeshDrawing):
        distances = found.there.distances
        return distances if len(distances) == len(drawn.points) else None
    if found.grid is None:
        return None
    kept = _VALUES.setdefault(found, {})
    if drawn not in kept:
        u, v = (grid.parameters for grid in drawn)
        rows = found.there.distances.reshape(found.grid.points.shape[:2])
        by_u = np.stack([np.interp(u, found.grid.u, row) for row in rows.T], axis=1)
        kept[drawn] = np.stack([np.interp(v, found.grid.v, row) for row in by_u], axis=0)
    return kept[drawn]


def _party(geometry: Geometry, wait: bool) -> Party:
    if isinstance(geometry, PlusCurve | PlusSurface):
        return geometry
    return drawing_of(geometry, wait=wait)


def _is_quick(first: Party, second: Party) -> bool:
    if not isinstance(first, PlusCurve) or not isinstance(second, PlusCurve):
        return False
    return len(first.lines) + len(second.lines) <= QUICK


def _gap(first: Party, second: Party) -> Gap:
    if isinstance(first, PlusCurve) and isinstance(second, PlusCurve):
        if first.dimension != second.dimension:
            first, second = in_space(first), in_space(second)
        return curve_gap(first, second)
    points, shares = _spread(first)
    if isinstance(second, PlusSurface):
        return surface_gap(points, shares, second)
    if isinstance(second, MeshDrawing):
        return Gap(points, _from_mesh(points, second), shares)
    raise TypeError("a curve is compared with curves only")


def _spread(party: Party) -> tuple[Floats, Floats]:
    """(m, 3) points all over a surface, and (m,) their parts of its area."""
    if isinstance(party, PlusSurface):
        grid = SurfacePoints.of(party)
        return grid.points.reshape(-1, 3), grid.shares
    if isinstance(party, PlusCurve):
        raise TypeError("a curve is compared with curves only")
    corners = party.net.triangles
    a, b, c = (party.points[corners[:, k]] for k in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    around = np.bincount(corners.ravel(), np.repeat(areas, 3), len(party.points))
    return party.points, parts_of(around.astype(np.float64))


def _from_mesh(points: Floats, drawing: MeshDrawing) -> Floats:
    from scipy.spatial import cKDTree

    from plusedit.geometry.mesh.nearest_triangles import distances_from

    corners = drawing.net.triangles.astype(np.intp)
    used = np.unique(corners)
    _, nearest = cKDTree(drawing.points[used]).query(points)
    return distances_from(points, drawing.points, corners, used[nearest])
