"""The smallest circle around a few points, for many polygons at once.

It passes through two or three of the points. For triangles, quads and other small polygons all
pairs and triples are tried; larger ones go through Welzl's algorithm (Smallest enclosing disks,
1991), one by one.
"""

from itertools import combinations

import numpy as np

from plusedit.geometry.arrays import Floats

MOST_TRIED = 6  # corners: 15 pairs and 20 triples
ROOM = 1e-12  # of a radius: a point no farther outside is on the circle


def enclosing_radii(polygons: Floats) -> Floats:
    """(k,) radii of the smallest circles around the points of each polygon (k, n, 2).

    Zero where all points coincide; as exact for tiny polygons far from the origin as their
    coordinates are.
    """
    around = polygons - polygons[:, :1]
    scales = np.abs(around).max(axis=(1, 2), initial=0.0)
    around = around / np.where(scales > 0.0, scales, 1.0)[:, None, None]
    if polygons.shape[1] == 3:
        radii = _triangle_radii(around)
    elif polygons.shape[1] <= MOST_TRIED:
        radii = _tried_radii(around)
    else:
        radii = np.array([_circle(points)[1] for points in around])
    return np.asarray(radii * scales)


def _triangle_radii(triangles: Floats) -> Floats:
    """Half the longest side of an obtuse triangle, else the radius of its circumcircle."""
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    sides = np.sort([((p - q) ** 2).sum(axis=1) for p, q in ((a, b), (b, c), (c, a))], axis=0)
    p, q = (b - a).T, (c - a).T
    doubled = np.abs(p[0] * q[1] - p[1] * q[0])
    acute = sides[0] + sides[1] > sides[2]
    through_all = np.sqrt(sides.prod(axis=0))
    with np.errstate(divide="ignore", invalid="ignore"):
        through_all = through_all / (2.0 * doubled)
    radii: Floats = np.where(acute & (doubled > 0.0), through_all, 0.5 * np.sqrt(sides[2]))
    return radii


def _tried_radii(polygons: Floats) -> Floats:
    """The least radius of a circle through two or three points that has all others inside."""
    best = np.full(len(polygons), np.inf)
    size = polygons.shape[1]
    for pair in combinations(range(size), 2):
        _try(polygons, polygons[:, pair].mean(axis=1), pair[0], best)
    for triple in combinations(range(size), 3):
        _try(polygons, _circumcenters(polygons[:, triple]), triple[0], best)
    return np.where(np.isfinite(best), best, 0.0)


def _try(polygons: Floats, centers: Floats, through: int, best: Floats) -> None:
    """Lower `best` where the circle about the center through that point contains all."""
    with np.errstate(invalid="ignore"):
        distances = np.sqrt(((polygons - centers[:, None]) ** 2).sum(axis=2))
        radii = distances[:, through]
        # The farthest of all is the radius: whatever rounding says, nothing is left outside.
        farthest = distances.max(axis=1)
        fits = (farthest <= radii * (1.0 + ROOM)) & (farthest < best)
    best[fits] = farthest[fits]


def _circumcenters(triangles: Floats) -> Floats:
    """(k, 2); not finite where the points lie on a line."""
    a = triangles[:, 0]
    p, q = triangles[:, 1] - a, triangles[:, 2] - a
    pp, qq = (p**2).sum(axis=1), (q**2).sum(axis=1)
    doubled = 2.0 * (p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0])
    with np.errstate(divide="ignore", invalid="ignore"):
        x = (q[:, 1] * pp - p[:, 1] * qq) / doubled
        y = (p[:, 0] * qq - q[:, 0] * pp) / doubled
    return np.asarray(a + np.stack([x, y], axis=1))


def _circle(points: Floats) -> tuple[Floats, float]:
    """Center and radius, each new point outside being one that the circle passes through."""
    center, radius = points[0], 0.0
    for i in range(1, len(points)):
        if _outside(points[i], center, radius):
            center, radius = points[i], 0.0
            for j in range(i):
                if _outside(points[j], center, radius):
                    center, radius = _circle_through(points[:j], points[i], points[j])
    return center, radius


def _circle_through(points: Floats, p: Floats, q: Floats) -> tuple[Floats, float]:
    """The smallest circle around the points that passes through p and q."""
    center, radius = 0.5 * (p + q), 0.5 * float(np.linalg.norm(p - q))
    for r in points:
        if _outside(r, center, radius):
            middle = _circumcenters(np.array([[p, q, r]]))[0]
            if np.isfinite(middle).all():
                center, radius = middle, float(np.linalg.norm(p - middle))
    return center, radius


def _outside(point: Floats, center: Floats, radius: float) -> bool:
    return float(np.linalg.norm(point - center)) > radius * (1.0 + ROOM)
