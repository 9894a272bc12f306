"""Triangles that fill polygons, and that join the samples of a surface."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

Triples = NDArray[np.int64]


def triangulated(points: Floats) -> Triples:
    """(k, 3) corners of triangles that fill a polygon (m, 3), which should be nearly plane.

    Ears are cut off where it is not convex.
    """
    count = len(points)
    fan = np.stack([np.zeros(count - 2, int), np.arange(1, count - 1), np.arange(2, count)], axis=1)
    normal = np.cross(points - points[0], np.roll(points, -1, axis=0) - points[0]).sum(axis=0)
    steps = np.roll(points, -1, axis=0) - points
    turns = np.cross(np.roll(steps, 1, axis=0), steps) @ normal
    if count < 5 and (turns >= 0.0).all():
        return fan
    if (turns >= 0.0).all() and _turns_once(points, normal):
        return fan
    return _ears(points, normal)


def _flat(points: Floats, normal: Floats) -> Floats:
    """(m, 2) the coordinates that show most of the polygon, counter-clockwise."""
    axis = int(np.argmax(np.abs(normal)))
    kept = points[:, [(axis + 1) % 3, (axis + 2) % 3]]
    return kept if normal[axis] >= 0.0 else kept[:, ::-1]


def _turns_once(points: Floats, normal: Floats) -> bool:
    steps = np.diff(np.append(_flat(points, normal), _flat(points, normal)[:1], axis=0), axis=0)
    angles = np.unwrap(np.append(*2 * [np.arctan2(steps[:, 1], steps[:, 0])]))
    return bool(abs(angles[len(points)] - angles[0]) < 3.0 * np.pi)


def _ears(points: Floats, normal: Floats) -> Triples:
    flat = _flat(points, normal)
    left = list(range(len(points)))
    found: list[tuple[int, int, int]] = []
    while len(left) > 3:
        ear = next((k for k in range(len(left)) if _is_ear(flat, left, k)), 0)
        found.append((left[ear - 1], left[ear], left[(ear + 1) % len(left)]))
        del left[ear]
    found.append((left[0], left[1], left[2]))
    return np.array(found)


def _is_ear(flat: Floats, left: list[int], k: int) -> bool:
    a, b, c = flat[left[k - 1]], flat[left[k]], flat[left[(k + 1) % len(left)]]
    if _doubled(a, b, c[None])[0] <= 0.0:
        return False
    corners = {left[k - 1], left[k], left[(k + 1) % len(left)]}
    others = flat[[i for i in left if i not in corners]]
    inside = (_doubled(a, b, others) > 0) & (_doubled(b, c, others) > 0)
    return not bool((inside & (_doubled(c, a, others) > 0)).any())


def _doubled(a: Floats, b: Floats, points: Floats) -> Floats:
    """(m,) twice the areas of triangles a, b, p; positive where p lies to the left."""
    area: Floats = (b[0] - a[0]) * (points[:, 1] - a[1]) - (b[1] - a[1]) * (points[:, 0] - a[0])
    return area


@lru_cache(maxsize=16)
def grid_triangles(rows: int, columns: int) -> NDArray[np.uint32]:
    """(k, 3) two triangles for each cell of a grid, point (i, j) being number i * columns + j."""
    corner = np.arange(rows * columns, dtype=np.uint32).reshape(rows, columns)
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    cells = np.stack([a, b, c, a, c, d], axis=-1)
    return np.ascontiguousarray(cells.reshape(-1, 3))
