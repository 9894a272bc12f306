"""Where a ray meets a surface, and the place of a surface that is nearest to a point or a ray.

The surface is first taken for cells of flat triangles that stray from it by less than a small
part of its size. What these say decides where to look: on the surface over the cells that may hold
the answer, it is found by Newton's method.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plusedit.geometry.arrays import Floats, frozen, unit
from plusedit.geometry.candidates import candidates, firsts, sifted
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_cells import Cells, Piercings, cells_of, piercings
from plusedit.geometry.surface_descent import Goal, PointGoal, RayGoal, least_in_boxes

CANDIDATES = 24  # cells looked at closely
STEPS = 8  # of Newton's method, which doubles the digits with each
CLOSE = 3e-8  # of the size: that near to a ray, Newton's next step is exact
FAR = 2.0  # cells: a hit that far from where it was looked for is on another layer
BLOCK = 1 << 18  # pairs of points and cells at most, at once
TIES = 4  # layers of a surface closer together than the triangles can tell apart


@dataclass(frozen=True, eq=False)
class RayHit:
    """Where a ray meets a surface."""

    u: float
    v: float
    point: Floats
    """(3,)"""
    distance: float
    """from the origin of the ray, a length"""


def hit_by_ray(surface: PlusSurface, origin: ArrayLike, direction: ArrayLike) -> RayHit | None:
    """The first place where a ray meets the surface, or None.

    The ray begins at `origin` (3,) and runs along `direction` (3,), of any length, without end.
    At the very edge of a surface, or of its outline as seen from the origin, it may be missed, or
    hit just beside, by a thousandth of its size. Raises ValueError if the direction is zero or a
    number is not finite.
    """
    start, heading = _ray(origin, direction)
    cells = cells_of(surface)
    # From a point near the surface, however far away the eye: there nothing is lost to rounding.
    shift = float((cells.middles.mean(axis=0) - start) @ heading)
    near = start + shift * heading
    pierced = piercings(near, heading, cells, _in_reach(cells, near, heading))
    left = np.flatnonzero(pierced.along + shift + cells.stray >= 0.0)
    left = left[np.argsort(pierced.along[left], kind="stable")]
    while len(left):
        along = pierced.along[left[:TIES]]
        count = np.count_nonzero(along <= along[0] + 2.0 * cells.stray)
        places, along = _met(surface, cells, pierced.taken(left[:count]), near, heading)
        along = np.where(along + shift >= 0.0, along, np.inf)
        best = along.argmin()
        if np.isfinite(along[best]):
            u, v = _in_period(surface, places[best]).tolist()
            return RayHit(u, v, near + along[best] * heading, float(along[best]) + shift)
        # All of these turned out to lie just behind the origin.
        left = left[count:]
    return None


def nearest_on_surface(surface: PlusSurface, point: ArrayLike) -> tuple[float, float]:
    """The parameters u and v of the point of the surface nearest to `point` (3,).

    Of all the surface, its boundary included; where several are equally near it is one of them.
    Raises ValueError if a number is not finite.
    """
    at = frozen(point, shape=(3,), name="point")
    u, v = nearest_places(surface, at[None])[0]
    return float(u), float(v)


def nearest_places(surface: PlusSurface, points: Floats) -> Floats:
    """(m, 2) what `nearest_on_surface` says for each of some finite points (m, 3)."""
    step = max(1, BLOCK // len(cells_of(surface).low))
    goals = [PointGoal(surface, points[i : i + step]) for i in range(0, len(points), step)]
    return np.concatenate([np.zeros((0, 2)), *(_nearest(surface, goal) for goal in goals)])


def nearest_to_ray(
    surface: PlusSurface, origin: ArrayLike, direction: ArrayLike
) -> tuple[float, float]:
    """The parameters u and v of the point of the surface nearest to a ray.

    That of `hit_by_ray` where they meet. Where several points are equally near it is one of them.
    """
    hit = hit_by_ray(surface, origin, direction)
    if hit is not None:
        return hit.u, hit.v
    u, v = _nearest(surface, RayGoal(surface, *_ray(origin, direction)))[0]
    return float(u), float(v)


def _ray(origin: ArrayLike, direction: ArrayLike) -> tuple[Floats, Floats]:
    """The origin and the unit vector along the direction."""
    start = frozen(origin, shape=(3,), name="origin")
    heading = unit(frozen(direction, shape=(3,), name="direction"))
    if not heading.any():
        raise ValueError("direction: a ray needs one that is not zero")
    return start, heading


def _in_reach(cells: Cells, origin: Floats, heading: Floats) -> NDArray[np.intp]:
    """Cells whose balls a line comes into."""
    away = cells.middles - origin
    squares = np.einsum("kd,kd->k", away, away) - (away @ heading) ** 2
    return np.flatnonzero(squares <= cells.radii**2)


def _met(
    surface: PlusSurface, cells: Cells, pierced: Piercings, origin: Floats, heading: Floats
) -> tuple[Floats, Floats]:
    """(k, 2) places where a line meets the surface near those of the triangles, and how far along.

    Those of the triangles again where there is none about there.
    """
    across, at, step = _frame(heading), pierced.places, np.zeros((1, 2))
    size = cells.largest + float(np.abs(origin).max())
    for _ in range(STEPS):
        at = _inside(surface, at - step)
        point, du, dv = surface.derivatives_at(at, highest=1)
        away = point - origin
        off = away @ across.T
        step = _solved(du @ across.T, dv @ across.T, off)
        missed = np.abs(off).max(axis=1)
        if (missed <= CLOSE * size).all():
            break
    # One more step squares what is left, and needs no look at where it leads.
    at = _inside(surface, at - step)
    along = (away - step[:, :1] * du - step[:, 1:] * dv) @ heading
    width = (cells.high - cells.low)[pierced.rows]
    met = (missed <= CLOSE * size) & (np.abs(at - pierced.places) <= FAR * width).all(axis=1)
    places = np.where(met[:, None], at, pierced.places)
    return places, np.where(met, along, pierced.along)


def _frame(heading: Floats) -> Floats:
    """(2, 3) unit vectors at right angles to it."""
    aside = unit(np.cross(heading, np.eye(3)[np.abs(heading).argmin()]))
    return np.stack([aside, np.cross(heading, aside)])


def _solved(by_u: Floats, by_v: Floats, off: Floats) -> Floats:
    """(k, 2) x and y with x by_u + y by_v = off, (k, 2) each; zero where there are none."""
    below = by_u[:, 0] * by_v[:, 1] - by_u[:, 1] * by_v[:, 0]
    usable = below != 0.0
    below = np.where(usable, below, 1.0)
    x = (off[:, 0] * by_v[:, 1] - off[:, 1] * by_v[:, 0]) / below
    y = (by_u[:, 0] * off[:, 1] - by_u[:, 1] * off[:, 0]) / below
    return np.where(usable[:, None], np.stack([x, y], axis=1), 0.0)


def _inside(surface: PlusSurface, places: Floats) -> Floats:
    """The places, moved into the domain where the surface is open."""
    open_ways = ~np.array(surface.closed)
    kept = np.where(np.isfinite(places), places, 0.0)
    return np.where(open_ways, np.clip(kept, 0.0, 1.0), kept)


def _in_period(surface: PlusSurface, places: Floats) -> Floats:
    """From 0 to 1, below 1 where the surface closes."""
    return np.where(np.array(surface.closed), places % 1.0, places)


def _nearest(surface: PlusSurface, goal: Goal) -> Floats:
    """(m, 2) the best place for each thing."""
    cells = cells_of(surface)
    held = candidates(cells.balls, len(goal), goal.from_balls)
    close = sifted(held.row, cells, held.place, goal.from_cells).nearest(CANDIDATES)
    low, high = cells.low[close.place], cells.high[close.place]
    places, values = least_in_boxes(goal, close.row, low, high, (low + high) / 2.0)
    return _in_period(surface, places[np.lexsort((values, close.row))[firsts(close.row)]])
