"""Bodies as implicit functions, negative inside.

Ellipsoids and round cones run into each other smoothly; `surface_nets` makes meshes of them.
"""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats

Body: TypeAlias = Callable[[Floats], Floats]
"""From points (n, 3) to about how far outside they are (n,)."""

AXES = np.eye(3)


def ellipsoid(center: ArrayLike, radii: ArrayLike, turn: Floats = AXES) -> Body:
    """An ellipsoid; `turn` (3, 3) has the directions of its axes as rows."""
    middle, sizes = np.asarray(center), np.asarray(radii)

    def outside(points: Floats) -> Floats:
        local = (points - middle) @ turn.T / sizes
        far = np.linalg.norm(local, axis=1)
        steep = np.linalg.norm(local / sizes, axis=1)
        return far * (far - 1.0) / np.maximum(steep, 1e-9)

    return outside


def cone(start: ArrayLike, end: ArrayLike, first: float, last: float) -> Body:
    """A round cone: balls of radii from `first` to `last` along a segment."""
    a, b = np.asarray(start), np.asarray(end)

    def outside(points: Floats) -> Floats:
        along = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
        away = points - a - along[:, None] * (b - a)
        return np.linalg.norm(away, axis=1) - (first + (last - first) * along)

    return outside


def below(point: ArrayLike, normal: ArrayLike) -> Body:
    """The half space away from the normal."""
    at, way = np.asarray(point), np.asarray(normal) / np.linalg.norm(normal)
    return lambda points: (points - at) @ way


def union(soft: float, *bodies: Body) -> Body:
    """Bodies that run into each other, rounded over about `soft`."""

    def outside(points: Floats) -> Floats:
        total = bodies[0](points)
        for body in bodies[1:]:
            total = _least(total, body(points), soft)
        return total

    return outside


def without(soft: float, body: Body, *others: Body) -> Body:
    """A body with others taken away, rounded over about `soft`."""

    def outside(points: Floats) -> Floats:
        total = body(points)
        for other in others:
            total = -_least(-total, other(points), soft)
        return total

    return outside


def both(soft: float, body: Body, other: Body) -> Body:
    """What lies in both, rounded over about `soft`."""
    return lambda points: -_least(-body(points), -other(points), soft)


def mirrored(body: Body) -> Body:
    """The body with y and -y changed."""
    return lambda points: body(points * [1.0, -1.0, 1.0])


def turned(about: int, degrees: float) -> Floats:
    """(3, 3) rows: the axes turned counterclockwise about one of them."""
    a, (i, j) = np.radians(degrees), [(1, 2), (2, 0), (0, 1)][about]
    rows = np.eye(3)
    rows[i, i] = rows[j, j] = np.cos(a)
    rows[i, j], rows[j, i] = np.sin(a), -np.sin(a)
    return rows


def _least(one: Floats, other: Floats, soft: float) -> Floats:
    share = np.maximum(soft - np.abs(one - other), 0.0) / soft
    least: Floats = np.minimum(one, other) - share**3 * soft / 6.0
    return least
