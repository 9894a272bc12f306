"""Pieces of triangles, and edges between them turned to the other diagonal.

Within one flat triangle that has been cut into pieces, an edge between two of them may be replaced
by the other diagonal of the two. It is where that leaves the larger smallest angle: the angles
opposite the edge add up to more than pi (Lawson, Software for C1 surface interpolation, 1977).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]

KEY = 1 << 32  # more than there can be vertices
SLENDER = 0.3  # 4 pi area / perimeter^2; less is five times as long as wide
FLAT = 1e-9  # of the product of four sides: less is rounding, and no reason to turn an edge
ROUNDS = 50  # of turning, of which a few are needed


class Pieces(NamedTuple):
    """Triangles, and where they lie in the triangles that were there at the beginning."""

    vertices: Indices
    """(t, 3)"""
    roots: Indices
    """(t,) the triangle in which each lies"""
    shares: Floats
    """(t, 3, 3) for each corner, how much of the three corners of the root it has"""

    def taken(self, chosen: Flags | Indices) -> "Pieces":
        """Some of the pieces."""
        return Pieces(self.vertices[chosen], self.roots[chosen], self.shares[chosen])

    def joined(self, *others: "Pieces") -> "Pieces":
        """These pieces, then the others."""
        all_of_them = (self, *others)
        return Pieces(
            np.concatenate([pieces.vertices for pieces in all_of_them]),
            np.concatenate([pieces.roots for pieces in all_of_them]),
            np.concatenate([pieces.shares for pieces in all_of_them]),
        )

    def turned(self, steps: Indices) -> "Pieces":
        """The same pieces counted from another corner (t,), 0 to 2."""
        order = (np.arange(3) + steps[:, None]) % 3
        vertices = np.take_along_axis(self.vertices, order, axis=1)
        return Pieces(
            vertices, self.roots, np.take_along_axis(self.shares, order[:, :, None], axis=1)
        )

    def with_corner(self, place: int, vertices: Indices, shares: Floats) -> "Pieces":
        """The same pieces with other vertices (t,), of shares (t, 3), at corner 0, 1 or 2."""
        moved = Pieces(self.vertices.copy(), self.roots, self.shares.copy())
        moved.vertices[:, place], moved.shares[:, place] = vertices, shares
        return moved


def edge_keys(triangles: Indices) -> Indices:
    """(t, 3) for the edges 0 to 1, 1 to 2, 2 to 0 the lower vertex times KEY plus the other."""
    following = np.roll(triangles, -1, axis=1)
    keys: Indices = np.minimum(triangles, following) * KEY + np.maximum(triangles, following)
    return keys


def slender(points: Floats, triangles: Indices) -> Flags:
    """(t,) true for triangles that are long and thin, but have an area."""
    first, second, third = points[triangles].transpose(1, 0, 2)
    sides = [second - first, third - second, first - third]
    perimeters = sum(np.linalg.norm(side, axis=1) for side in sides)
    areas = 0.5 * np.linalg.norm(np.cross(sides[0], sides[1]), axis=1)
    squares = np.square(perimeters)
    thin: Flags = (4.0 * np.pi * areas < SLENDER * squares) & (areas > FLAT * squares)
    return thin


def flipped(points: Floats, pieces: Pieces) -> Pieces:
    """The pieces with edges turned inside their roots until none is better turned."""
    for _ in range(ROUNDS):
        first, second, sides = _better_turned(points, pieces)
        if not len(first):
            break
        one, other = pieces.taken(first).turned(sides[0]), pieces.taken(second).turned(sides[1])
        # a, b, c and b, a, d become a, d, c and d, b, c.
        new = other.vertices[:, 2], other.shares[:, 2]
        left, right = one.with_corner(1, *new), one.with_corner(0, *new)
        stays = np.ones(len(pieces.roots), dtype=np.bool_)
        stays[first] = stays[second] = False
        pieces = pieces.taken(stays).joined(left, right)
    return pieces


def _better_turned(points: Floats, pieces: Pieces) -> tuple[Indices, Indices, Indices]:
    """Pairs of pieces whose common edge is to be turned, no piece in two of them.

    Then (2, k) which side of each piece the edge is.
    """
    keys = edge_keys(pieces.vertices).ravel()
    slots = np.argsort(keys, kind="stable")
    same = np.flatnonzero(keys[slots[1:]] == keys[slots[:-1]])
    one, other = slots[same], slots[same + 1]
    inner = pieces.roots[one // 3] == pieces.roots[other // 3]
    one, other = one[inner], other[inner]
    gains = _excess(points, pieces, one, other)
    better = gains > FLAT
    one, other, gains = one[better], other[better], gains[better]
    ranks = np.empty(len(gains), dtype=np.intp)
    ranks[np.argsort(gains, kind="stable")] = np.arange(len(gains))
    best = np.full(len(pieces.roots), -1, dtype=np.intp)
    for slot in (one, other):
        np.maximum.at(best, slot // 3, ranks)
    chosen = (best[one // 3] == ranks) & (best[other // 3] == ranks)
    one, other = one[chosen], other[chosen]
    return one // 3, other // 3, np.stack([one % 3, other % 3])


def _excess(points: Floats, pieces: Pieces, one: Indices, other: Indices) -> Floats:
    """(k,) the sine of how much the angles opposite common edges exceed pi; else not positive."""
    parts = []
    for slot in (one, other):
        triangles = pieces.vertices[slot // 3]
        start, end, top = (triangles[np.arange(len(slot)), (slot + k) % 3] for k in (0, 1, 2))
        a, b = points[start] - points[top], points[end] - points[top]
        lengths = np.maximum(np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1), 1e-300)
        sine = np.linalg.norm(np.cross(a, b), axis=1) / lengths
        parts.append((sine, np.einsum("kd,kd->k", a, b) / lengths))
    (sine_one, cosine_one), (sine_other, cosine_other) = parts
    excess: Floats = -(sine_one * cosine_other + cosine_one * sine_other)
    return excess
