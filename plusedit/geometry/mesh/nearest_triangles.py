"""How far points are from the nearest of many triangles, each point knowing one that is near.

By compiled loops the triangle found is the nearest of all. Where numba is missing it is looked for
among those around the corner that a point comes from, and those whose middles are nearest; where
none of them is the nearest of all the distance comes out too large.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

AROUND, NEARBY = 8, 8  # triangles looked at around the corner itself, and by their middles
SHARE = 8192  # points worked on at a time
LEAF = 8  # triangles of a leaf of the tree
BITS = 10  # of each coordinate, by which triangles are brought into an order

Indices = NDArray[np.intp]


def distances(points: Floats, vertices: Floats, corners: Indices, own: Indices) -> Floats:
    """(m,) of points[own] from the triangles whose `corners` (t, 3) are among the vertices.

    Point i comes from vertex i: it is expected near the triangles that have it for a corner, of
    which there is one at least.
    """
    return distances_from(points[own], vertices, corners, own)


def distances_from(points: Floats, vertices: Floats, corners: Indices, near: Indices) -> Floats:
    """(m,) of points (m, 3) from the triangles whose `corners` (t, 3) are among the vertices.

    Vertex near[i], the corner of some triangle, is expected near point i.
    """
    try:
        from plusedit.geometry.mesh import nearest_kernels
    except ImportError:
        return distances_by_trying(points, vertices, corners, near)
    at = vertices[corners]
    order = _in_order(at.mean(axis=1))
    first = np.zeros(len(vertices), dtype=np.intp)
    first[corners[order].ravel()] = np.repeat(np.arange(len(order)), 3)
    at = at[order]
    found = np.empty(len(points))
    ways = at[:, 1:] - at[:, :1]
    triangles = np.concatenate([at[:, 0], ways[:, 0], ways[:, 1]], axis=1)
    nearest_kernels.nearest(points, first[near], triangles, _boxes(at), found)
    return found


def _in_order(middles: Floats) -> Indices:
    """(t,) numbers of triangles so that neighbors are close together: by Morton, bits in turn."""
    low, high = middles.min(axis=0), middles.max(axis=0)
    extent = float((high - low).max()) or 1.0
    steps = ((middles - low) * ((2**BITS - 1) / extent)).astype(np.int64)
    codes = np.zeros(len(middles), dtype=np.int64)
    for bit in range(BITS):
        for axis in range(3):
            codes |= (steps[:, axis] >> bit & 1) << (3 * bit + axis)
    order: Indices = np.argsort(codes, kind="stable")
    return order


def _boxes(triangles: Floats) -> Floats:
    """(2 leaves, 6) least and largest coordinates of every node of the tree over (t, 3, 3).

    Node 1 is the root, the children of node k are 2 k and 2 k + 1, leaf i is node `leaves` + i.
    Boxes of nodes without triangles are inverted, infinitely far from everything.
    """
    starts = np.arange(0, len(triangles), LEAF)
    leaves = 1 << max(0, (len(starts) - 1).bit_length())
    low, high = np.full((2 * leaves, 3), np.inf), np.full((2 * leaves, 3), -np.inf)
    filled = slice(leaves, leaves + len(starts))
    low[filled] = np.minimum.reduceat(triangles.min(axis=1), starts)
    high[filled] = np.maximum.reduceat(triangles.max(axis=1), starts)
    level = leaves
    while level > 1:
        children = slice(level, 2 * level)
        level //= 2
        low[level : 2 * level] = low[children].reshape(-1, 2, 3).min(axis=1)
        high[level : 2 * level] = high[children].reshape(-1, 2, 3).max(axis=1)
    return np.concatenate([low, high], axis=1)


def distances_by_trying(
    points: Floats, vertices: Floats, corners: Indices, near: Indices
) -> Floats:
    """What `distances_from` gives, or more: without compiled loops, by the likeliest triangles."""
    from scipy.spatial import cKDTree

    triangles = _Triangles.of(vertices[corners])
    around = _around(corners, len(vertices), near)
    tree = cKDTree(triangles.middles)
    nearby = min(NEARBY, len(corners))
    found = np.empty(len(points))
    for first in range(0, len(points), SHARE):
        rows = slice(first, first + SHARE)
        at = points[rows]
        _, close = tree.query(at, nearby)
        candidates = np.concatenate([around[rows], close.reshape(len(at), -1)], axis=1)
        best = triangles.squares(at, candidates).argmin(axis=1)
        found[rows] = triangles.distances(at, candidates[np.arange(len(at)), best])
    return found


def _around(corners: Indices, count: int, own: Indices) -> Indices:
    """(m, 8) triangles around vertices; where there are fewer, the last stands repeatedly."""
    by_vertex = np.argsort(corners.ravel(), kind="stable") // 3
    counts = np.bincount(corners.ravel(), minlength=count)
    starts = np.cumsum(counts) - counts
    steps = np.minimum(np.arange(AROUND), np.maximum(counts[own, None] - 1, 0))
    found: Indices = by_vertex[starts[own, None] + steps]
    return found


@dataclass(frozen=True, eq=False)
class _Triangles:
    """Triangles a, a + b, a + c with what distances from them take."""

    a: Floats
    b: Floats
    c: Floats
    middles: Floats
    bb: Floats
    """(t,) b . b, and so on"""
    bc: Floats
    cc: Floats
    thickness: Floats
    """(t,) 1 / (bb cc - bc^2), zero for triangles without area"""

    @classmethod
    def of(cls, at: Floats) -> "_Triangles":
        """Of corners (t, 3, 3)."""
        a, b, c = at[:, 0], at[:, 1] - at[:, 0], at[:, 2] - at[:, 0]
        bb, bc, cc = (np.einsum("td,td->t", x, y) for x, y in ((b, b), (b, c), (c, c)))
        area = bb * cc - bc**2
        flat = area <= 1e-24 * (bb + cc) ** 2
        thickness = np.where(flat, 0.0, 1.0 / np.where(flat, 1.0, area))
        return cls(a, b, c, at.mean(axis=1), bb, bc, cc, thickness)

    def squares(self, points: Floats, numbers: Indices) -> Floats:
        """(m, k) squared distances of points (m, 3) from k triangles each, to half the digits."""
        away = points[:, None] - self.a[numbers]
        along_b = np.einsum("mkd,mkd->mk", away, self.b[numbers])
        along_c = np.einsum("mkd,mkd->mk", away, self.c[numbers])
        square = np.einsum("mkd,mkd->mk", away, away)
        bb, bc, cc = self.bb[numbers], self.bc[numbers], self.cc[numbers]
        share_b = (cc * along_b - bc * along_c) * self.thickness[numbers]
        share_c = (bb * along_c - bc * along_b) * self.thickness[numbers]
        inside = (share_b > 0.0) & (share_c > 0.0) & (share_b + share_c < 1.0)
        flat = square - share_b * along_b - share_c * along_c
        sides = np.minimum(
            np.minimum(_to_side(square, along_b, bb), _to_side(square, along_c, cc)),
            _to_side(square - 2.0 * along_b + bb, along_c - along_b + bb - bc, bb + cc - 2.0 * bc),
        )
        found: Floats = np.where(inside, flat, sides)
        return found

    def distances(self, points: Floats, numbers: Indices) -> Floats:
        """(m,) distances of points (m, 3) from one triangle each, to all digits."""
        a, b, c = self.a[numbers], self.b[numbers], self.c[numbers]
        away = points - a
        zero = np.zeros_like(away)
        sides = [(zero, b), (zero, c), (b, c - b)]
        found = np.minimum.reduce([_from_side(away - start, side) for start, side in sides])
        along_b, along_c = (np.einsum("md,md->m", away, side) for side in (b, c))
        bb, bc, cc = self.bb[numbers], self.bc[numbers], self.cc[numbers]
        share_b = (cc * along_b - bc * along_c) * self.thickness[numbers]
        share_c = (bb * along_c - bc * along_b) * self.thickness[numbers]
        inside = (share_b > 0.0) & (share_c > 0.0) & (share_b + share_c < 1.0)
        across = np.cross(b, c)
        length = np.linalg.norm(across, axis=1)
        height = np.abs(np.einsum("md,md->m", away, across)) / np.where(length > 0.0, length, 1.0)
        # Where the sides are parallel there is no inside but by rounding.
        closest: Floats = np.where(inside & (length > 0.0), np.minimum(height, found), found)
        return closest


def _to_side(square: Floats, along: Floats, length: Floats) -> Floats:
    """Squared distances from segments, by those from their starts and the products with them."""
    share = np.clip(along / np.where(length > 0.0, length, 1.0), 0.0, 1.0)
    found: Floats = square - share * (2.0 * along - share * length)
    return found


def _from_side(away: Floats, side: Floats) -> Floats:
    """(m,) distances from segments of points `away` (m, 3) from their starts."""
    length = np.einsum("md,md->m", side, side)
    along = np.einsum("md,md->m", away, side)
    share = np.clip(along / np.where(length > 0.0, length, 1.0), 0.0, 1.0)
    found: Floats = np.linalg.norm(away - share[:, None] * side, axis=1)
    return found
