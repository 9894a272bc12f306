"""Where a surface turns away from the eye: the outline of what is seen, and its inner folds.

The cosine between normal and view is known where the surface is sampled; where it changes its sign
within a triangle of the grid, a line runs through. Normals are kept with the surface, so that a
turn of the view takes one product to the sample.
"""

from collections.abc import Hashable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_kernels import points_and_normals
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.drawn_surface import Grids
from plusedit.scene.space_camera import SpaceCamera

LIFT = 12.0  # pixels toward the eye: beside its silhouette a surface rises steeply and hides it

MANY = 65  # parameters by u or v

TRIANGLES = np.array([[[0, 0], [1, 0], [1, 1]], [[0, 0], [1, 1], [0, 1]]])
"""(2, 3, 2) steps from the first corner of a cell of the grid to those of its triangles"""

Singles = NDArray[np.float32]
Lines = tuple[Floats, ...]


@dataclass(frozen=True, eq=False)
class Sampled:
    """A surface at the samples of its grids."""

    points: Singles
    """(m_u, m_v, 3)"""
    normals: Singles
    """(m_u, m_v, 3)"""
    middle: Floats
    """(3,) where the surface is, about"""
    heights: Singles
    """(m_u, m_v) of the tangent planes above the middle, along the normals"""


_SAMPLED: "WeakKeyDictionary[PlusSurface, tuple[Grids, Sampled]]" = WeakKeyDictionary()
_SEEN: "WeakKeyDictionary[PlusSurface, tuple[Hashable, Lines]]" = WeakKeyDictionary()


def silhouette(surface: PlusSurface, camera: Camera, grids: Grids) -> Lines:
    """Lines (m, 3) in the world, of the surface drawn with those grids.

    In space they lie before the surface, where they are seen at the same pixels.
    """
    key = (_direction(camera), grids)
    seen = _SEEN.get(surface)
    if seen is None or seen[0] != key:
        sampled = _sampled(surface, grids)
        lines = tuple(_contours(sampled.points, _facing(sampled, camera)))
        if isinstance(camera, SpaceCamera):
            lines = tuple(lifted(points, camera) for points in lines)
        seen = _SEEN[surface] = key, lines
    return seen[1]


def _direction(camera: Camera) -> Hashable:
    """What of a camera a silhouette depends on."""
    return camera.projection if isinstance(camera, PlaneCamera) else camera


def lifted(points: Floats, camera: SpaceCamera) -> Floats:
    """The points moved toward the eye, each along the ray on which it is seen."""
    if camera.perspective:
        ways = camera.eye - points
        ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    else:
        ways = camera.toward
    lifted: Floats = points + LIFT * camera.pixel_at(points)[:, None] * ways
    return lifted


def _sampled(surface: PlusSurface, grids: Grids) -> Sampled:
    kept = _SAMPLED.get(surface)
    if kept is None or kept[0] != grids:
        points, normals = points_and_normals(surface, *(_thinned(grid) for grid in grids))
        middle = surface.planes.control_points.mean(axis=0)
        heights = np.einsum("ijd,ijd->ij", normals, points - middle.astype(np.float32))
        kept = _SAMPLED[surface] = grids, Sampled(points, normals, middle, heights)
    return kept[1]


@lru_cache(maxsize=64)
def _thinned(grid: Grid) -> Grid:
    """Every second parameter where there are many: a line is smooth with half as many points."""
    many = len(grid) > MANY and len(grid) % 2 == 1
    return Grid(grid.parameters[::2]) if many else grid


def _facing(sampled: Sampled, camera: Camera) -> Singles:
    """(m_u, m_v) positive where the surface is seen from its front."""
    if isinstance(camera, SpaceCamera) and camera.perspective:
        # n . (eye - p) without the ways from every point to the eye.
        to_eye = (camera.eye - sampled.middle).astype(np.float32)
        facing: Singles = sampled.normals @ to_eye - sampled.heights
    else:
        facing = sampled.normals @ camera.axes_of_view[2].astype(np.float32)
    return facing


def _contours(points: Singles, values: Singles) -> Iterator[Floats]:
    """Lines (m, 3) where values (m_u, m_v) at points (m_u, m_v, 3) are zero.

    They are straight within triangles, and run on from one triangle to the next.
    """
    front = values > 0.0
    corners = front[:-1, :-1].astype(np.int8) + front[1:, :-1] + front[:-1, 1:] + front[1:, 1:]
    cells = np.argwhere((corners > 0) & (corners < 4))
    # (k, 3) numbers of the corners of all triangles of those cells
    triangles = (cells[:, None, None] + TRIANGLES) @ np.array([values.shape[1], 1])
    return zero_lines(points.reshape(-1, 3), triangles.reshape(-1, 3), values.ravel())


def zero_lines(
    points: Floats | Singles, triangles: NDArray[np.integer], values: Floats | Singles
) -> Iterator[Floats]:
    """Lines (m, 3) where values (n,) at points (n, 3) are zero, straight within triangles (k, 3).

    They run on from one triangle to the next; none are drawn twice.
    """
    value = values.astype(np.float64)
    front = (value > 0.0)[triangles]
    crosses = front != np.roll(front, -1, axis=1)
    # Few triangles of many are crossed; all else is done for these alone.
    crossed = crosses.any(axis=1)
    starts, crosses = triangles[crossed].astype(np.int64), crosses[crossed]
    ends = np.roll(starts, -1, axis=1)
    starts, ends = starts[crosses], ends[crosses]
    share = (value[starts] / (value[starts] - value[ends]))[:, None]
    places = (1.0 - share) * points[starts] + share * points[ends]
    sides = np.minimum(starts, ends) * value.size + np.maximum(starts, ends)
    for run in _runs(sides):
        yield places[run]


def _runs(sides: NDArray[np.intp]) -> Iterator[list[int]]:
    """Crossings of sides of triangles (2 k,) in the order in which lines run through them.

    A triangle has none or two such sides; so crossing 2 i and crossing 2 i + 1 are joined, and so
    are the two crossings of a side that two triangles share.
    """
    order = np.argsort(sides, kind="stable")
    same = np.flatnonzero(sides[order[1:]] == sides[order[:-1]])
    partners = np.full(len(sides), -1)
    partners[order[same]], partners[order[same + 1]] = order[same + 1], order[same]
    others, left = partners.tolist(), [True] * len(sides)
    # Lines that end at an edge of the surface first: from its end on each is one run.
    for start in (*np.flatnonzero(partners < 0).tolist(), *range(len(sides))):
        at, run = start, [start]
        while at >= 0 and left[at]:
            left[at] = left[at ^ 1] = False
            run.append(at ^ 1)
            at = others[at ^ 1]
        if len(run) > 1:
            yield run
