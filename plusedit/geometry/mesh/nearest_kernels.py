"""The triangle nearest to a point, in machine code that numba makes. Imported on request only.

A point begins with a triangle that is near already. Then it goes down a tree of boxes, the nearer
child first, and leaves out every box that is farther than the best triangle so far.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.compiling import compiled, inlined

LEAF = 8  # triangles
DEEPEST = 64  # nodes that may wait


@inlined
def square_to_side(
    x: float, y: float, z: float, dx: float, dy: float, dz: float, length: float
) -> float:
    """The squared distance of a place from the segment from zero to d, whose square is `length`."""
    along = x * dx + y * dy + z * dz
    share = min(max(along / length, 0.0), 1.0) if length > 0.0 else 0.0
    x, y, z = x - share * dx, y - share * dy, z - share * dz
    return x * x + y * y + z * z


@compiled
def square_to_triangle(t: Floats, px: float, py: float, pz: float) -> float:
    """The squared distance of a point from a triangle t (9,): a corner and the ways to the others.

    Inside it is taken along the normal, where a difference of places would lose digits.
    """
    x, y, z = px - t[0], py - t[1], pz - t[2]
    bx, by, bz, cx, cy, cz = t[3], t[4], t[5], t[6], t[7], t[8]
    bb, cc = bx * bx + by * by + bz * bz, cx * cx + cy * cy + cz * cz
    bc = bx * cx + by * cy + bz * cz
    along_b, along_c = x * bx + y * by + z * bz, x * cx + y * cy + z * cz
    area = bb * cc - bc * bc
    if area > 1e-24 * (bb + cc) ** 2:
        share_b, share_c = cc * along_b - bc * along_c, bb * along_c - bc * along_b
        if share_b > 0.0 and share_c > 0.0 and share_b + share_c < area:
            nx, ny, nz = by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx
            height, across = x * nx + y * ny + z * nz, nx * nx + ny * ny + nz * nz
            # The area may be nothing but rounding.
            if across > 0.0:
                return height * height / across  # type: ignore[no-any-return]
    dx, dy, dz = cx - bx, cy - by, cz - bz
    least = min(square_to_side(x, y, z, bx, by, bz, bb), square_to_side(x, y, z, cx, cy, cz, cc))
    third = square_to_side(x - bx, y - by, z - bz, dx, dy, dz, dx * dx + dy * dy + dz * dz)
    return min(least, third)


@inlined
def square_to_box(box: Floats, x: float, y: float, z: float) -> float:
    """The squared distance of a place from a box (6,): the least coordinates, then the largest."""
    dx = max(box[0] - x, 0.0, x - box[3])
    dy = max(box[1] - y, 0.0, y - box[4])
    dz = max(box[2] - z, 0.0, z - box[5])
    return dx * dx + dy * dy + dz * dz  # type: ignore[no-any-return]


@compiled
def nearest(
    points: Floats, first: NDArray[np.intp], triangles: Floats, boxes: Floats, found: Floats
) -> None:
    """found (m,) = the distances of points (m, 3) from the nearest of triangles (t, 9).

    `boxes` (2 leaves, 6) are those of the tree, `first` (m,) a triangle to begin with.
    """
    leaves = len(boxes) // 2
    waiting = np.empty(DEEPEST, np.intp)
    squares = np.empty(DEEPEST)
    for k in range(len(points)):
        x, y, z = points[k, 0], points[k, 1], points[k, 2]
        best = square_to_triangle(triangles[first[k]], x, y, z)
        waiting[0], squares[0], count = 1, 0.0, 1
        while count > 0:
            count -= 1
            node = waiting[count]
            if squares[count] >= best:
                continue
            if node >= leaves:
                start = (node - leaves) * LEAF
                for i in range(start, min(start + LEAF, len(triangles))):
                    best = min(best, square_to_triangle(triangles[i], x, y, z))
                continue
            left = square_to_box(boxes[2 * node], x, y, z)
            right = square_to_box(boxes[2 * node + 1], x, y, z)
            nearer = 2 * node if left <= right else 2 * node + 1
            waiting[count], squares[count] = 4 * node + 1 - nearer, max(left, right)
            waiting[count + 1], squares[count + 1] = nearer, min(left, right)
            count += 2
        found[k] = np.sqrt(best)
