"""Polygons in space cut into triangles, without new vertices.

Most polygons are triangles, quads or convex and are cut all at once: a quad along the diagonal
that leaves the larger smallest angle (Delaunay's criterion: the inner angles beside it add up to
no less than those that it cuts off), a larger polygon as a fan from the corner whose smallest
triangle is largest. Where every fan would turn some triangle over, ears are clipped one by one
(Meisters, Polygons Have Ears, 1975), in the plane that fits the polygon best.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

Indices = NDArray[np.intp]

THIN = 1e-9  # of an area to the squared extent of its polygon: less is rounding
FANS_TRIED = 64  # of a polygon with more corners, evenly around
SAME_ANGLE = 1e-9  # radians: both diagonals of a square are as good, and rounding does not choose


def triangulated(points: Floats, starts: NDArray[np.int32]) -> NDArray[np.int32]:
    """(t, 3) corners of triangles that make up polygons, k - 2 of them for k corners.

    `points` (c, 3) are those of the corners, and polygon i has the corners from starts[i] to
    before starts[i + 1], three or more. Triangles come polygon by polygon and turn the same way.
    """
    sizes = np.diff(starts)
    firsts = np.cumsum(sizes - 2) - (sizes - 2)
    triangles = np.empty((int((sizes - 2).sum()), 3), dtype=np.int32)
    for size in np.unique(sizes):
        chosen = np.flatnonzero(sizes == size)
        corners = starts[chosen, None] + np.arange(size, dtype=np.int32)
        if size > 3:
            corners = _cut(points[corners]) + starts[chosen, None, None]
        triangles[firsts[chosen, None] + np.arange(size - 2)] = corners.reshape(-1, size - 2, 3)
    return triangles


def _cut(polygons: Floats) -> Indices:
    """(k, m - 2, 3) corners 0 to m - 1 of the triangles of each polygon (k, m, 3), m > 3."""
    around = polygons - polygons[:, :1]
    normals = np.cross(around[:, 1:-1], around[:, 2:]).sum(axis=1)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0.0)
    if polygons.shape[1] == 4:
        return _fan(_better_diagonal(around, normals), 4)
    apexes, clean = _best_fans(around, normals)
    triangles = _fan(apexes, polygons.shape[1])
    for polygon in np.flatnonzero(~clean & (lengths[:, 0] > 0.0)):
        triangles[polygon] = _ears_clipped(_in_plane(around[polygon], normals[polygon]))
    return triangles


def _fan(apexes: Indices, size: int) -> Indices:
    """(k, size - 2, 3) triangles from one corner of each polygon to every side that is not its."""
    steps = np.arange(1, size - 1)
    rolled = np.stack([np.zeros_like(steps), steps, steps + 1], axis=1)
    fans: Indices = (apexes[:, None, None] + rolled) % size
    return fans


def _better_diagonal(quads: Floats, normals: Floats) -> Indices:
    """(k,) 0 where the diagonal from corner 0 to 2 is taken, 1 where that from 1 to 3 is.

    An inner angle is between 0 and 2 pi as seen against the normal: a diagonal through a reflex
    corner is always the better one.
    """
    after = np.roll(quads, -1, axis=1) - quads
    before = np.roll(quads, 1, axis=1) - quads
    sines = np.einsum("kcd,kd->kc", np.cross(after, before), normals)
    angles = np.arctan2(sines, (after * before).sum(axis=2)) % (2.0 * np.pi)
    better: Indices = (
        angles[:, 1] + angles[:, 3] > angles[:, 0] + angles[:, 2] + SAME_ANGLE
    ).astype(np.intp)
    return better


def _best_fans(polygons: Floats, normals: Floats) -> tuple[Indices, NDArray[np.bool_]]:
    """(k,) the corner whose fan has the largest smallest area, and whether none of it is thin."""
    count, size = polygons.shape[:2]
    best, apexes = np.full(count, -np.inf), np.zeros(count, dtype=np.intp)
    for apex in np.unique(np.linspace(0, size - 1, min(size, FANS_TRIED)).astype(np.intp)):
        spokes = np.roll(polygons, -apex, axis=1)[:, 1:] - polygons[:, apex, None]
        areas = np.einsum("kcd,kd->kc", np.cross(spokes[:, :-1], spokes[:, 1:]), normals)
        least = areas.min(axis=1)
        apexes[least > best] = apex
        best = np.maximum(best, least)
    extents = np.ptp(polygons, axis=1).max(axis=1)
    return apexes, best > THIN * extents**2


def _in_plane(polygon: Floats, normal: Floats) -> Floats:
    """(m, 2) the corners seen against the normal, counter-clockwise, within the unit square."""
    first = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    first /= np.linalg.norm(first)
    flat: Floats = polygon @ np.stack([first, np.cross(normal, first)], axis=1)
    flat -= flat.min(axis=0)
    scaled: Floats = flat / max(float(flat.max()), np.finfo(np.float64).tiny)
    return scaled


def _ears_clipped(polygon: Floats) -> Indices:
    """(m - 2, 3) triangles of a polygon (m, 2), the roundest ear always first.

    Of a polygon that crosses itself there may be no ear at all; then the roundest corner goes.
    """
    left = list(range(len(polygon)))
    ranks = [_rank(polygon, left, place) for place in range(len(left))]
    triangles = []
    while len(left) > 3:
        place = int(np.argmax(ranks))
        triangles.append((left[place - 1], left[place], left[(place + 1) % len(left)]))
        del left[place], ranks[place]
        for beside in (place - 1, place % len(left)):
            ranks[beside] = _rank(polygon, left, beside)
    return np.array([*triangles, left], dtype=np.intp)


def _rank(polygon: Floats, left: list[int], place: int) -> float:
    """How round the triangle of a corner and its neighbors is; less by 4 where it is no ear.

    Area to the mean of the squared sides: at most 1 / sqrt(3), negative at reflex corners.
    """
    three = polygon[[left[place - 1], left[place], left[(place + 1) % len(left)]]]
    sides = np.roll(three, -1, axis=0) - three
    squares = float((sides * sides).sum())
    area = float(sides[0, 0] * sides[1, 1] - sides[0, 1] * sides[1, 0])
    rank = 3.0 * area / squares if squares > 0.0 else 0.0
    if area <= THIN:
        return rank - 2.0
    others = polygon[left][:, None] - three
    heights = sides[:, 0] * others[..., 1] - sides[:, 1] * others[..., 0]
    # A corner in the same place as one of the three is where the polygon touches itself.
    inside = (heights > -THIN * squares).all(axis=1) & (others != 0.0).any(axis=2).all(axis=1)
    return rank - 4.0 if inside.any() else rank
