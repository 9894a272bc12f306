"""Lines and areas cut to a box, in pixels.

Rasterizers calculate with narrow numbers: far beyond the view, as at deep zoom, lines would come
out wrong or take seconds. What is cut here lies outside of what is seen.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

ALONG = 1e-9  # pixels across a side, up to which a segment counts as running along it

Box = tuple[Floats, Floats]
"""Lower and upper corner, (2,) each."""


def reaches_beyond(points: Floats, box: Box) -> bool:
    """Whether any of the points (m, 2) lies outside."""
    low, high = box
    # Two numbers for all settle it nearly always, and are found several times faster.
    if points.min() >= low.max() and points.max() <= high.min():
        return False
    return bool((points.min(axis=0) < low).any() or (points.max(axis=0) > high).any())


def clipped_polyline(points: Floats, box: Box) -> list[Floats]:
    """The pieces of a line through points (m, 2) that lie inside, in order."""
    starts, ends = points[:-1], points[1:]
    enter, leave = _inside(starts, ends, box)
    kept = np.flatnonzero(enter < leave)
    if not len(kept):
        return []
    # A segment goes on with its piece where the one before ran to its end, uncut.
    joined = (np.diff(kept) == 1) & (leave[kept[:-1]] == 1.0) & (enter[kept[1:]] == 0.0)
    by = ends - starts
    pieces = []
    for run in np.split(kept, np.flatnonzero(~joined) + 1):
        first = starts[run[0]] + enter[run[0]] * by[run[0]]
        rest = starts[run] + leave[run, None] * by[run]
        pieces.append(np.vstack([first, rest]))
    return pieces


def clipped_segments(starts: Floats, ends: Floats, box: Box) -> tuple[Floats, Floats]:
    """The inner parts of segments between (m, 2) and (m, 2); those outside are left out."""
    enter, leave = _inside(starts, ends, box)
    kept = enter < leave
    by = (ends - starts)[kept]
    return (
        starts[kept] + enter[kept, None] * by,
        starts[kept] + leave[kept, None] * by,
    )


def clipped_polygon(points: Floats, box: Box) -> Floats:
    """The part of an area that lies inside, (k, 2); none if it lies outside.

    Sutherland and Hodgman: cut by one side of the box after the other.
    """
    low, high = box
    for axis in (0, 1):
        for bound, side in ((low[axis], 1.0), (high[axis], -1.0)):
            if not len(points):
                return points
            points = _cut(points, side * (points[:, axis] - bound))
    return points


def _cut(points: Floats, depth: Floats) -> Floats:
    """What of an area lies where `depth`, linear and given at its corners, is not negative."""
    following, depth_after = np.roll(points, -1, axis=0), np.roll(depth, -1)
    crosses = (depth >= 0.0) != (depth_after >= 0.0)
    share = np.divide(depth, depth - depth_after, out=np.zeros_like(depth), where=crosses)
    crossings = points + share[:, None] * (following - points)
    corners = np.stack([points, crossings], axis=1)
    kept: Floats = corners[np.stack([depth >= 0.0, crosses], axis=1)]
    return kept


def _inside(starts: Floats, ends: Floats, box: Box) -> tuple[Floats, Floats]:
    """Where segments enter and leave the box, as shares of their lengths; Liang and Barsky.

    A segment that misses the box has nothing between the two.
    """
    enter, leave = np.zeros(len(starts)), np.ones(len(starts))
    by = ends - starts
    outside: NDArray[np.bool_] = np.zeros(len(starts), dtype=bool)
    for axis in (0, 1):
        for bound, side in ((box[0][axis], 1.0), (box[1][axis], -1.0)):
            depth, slope = side * (starts[:, axis] - bound), side * by[:, axis]
            crosses = np.abs(slope) > ALONG
            outside |= ~crosses & (depth < 0.0)
            crossing = np.divide(-depth, slope, out=np.zeros_like(depth), where=crosses)
            enter = np.where(crosses & (slope > 0.0), np.maximum(enter, crossing), enter)
            leave = np.where(crosses & (slope < 0.0), np.minimum(leave, crossing), leave)
    leave[outside] = -1.0
    return enter, leave
