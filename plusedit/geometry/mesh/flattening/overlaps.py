"""Whether a map to the plane without turned triangles lays one part over another.

Around a point of the plane the border of the map turns as often as the point is covered, if no
triangle is turned over. That number changes at the border only: it is enough to look just inside
of every edge of it, where it is one if nothing overlaps.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.sheet import Indices, Sheet

INSIDE = 1e-6  # of an edge's length: how far beside it is looked
TOGETHER = 512  # edges that are looked at together


def overlaps(sheet: Sheet, places: Floats) -> bool:
    """Whether some place is covered more than once by parameters (t, 3, 2) of the triangles.

    No triangle may be turned over, and neighbors must have the same parameters at common edges.
    """
    return border_overlaps(places, np.flatnonzero(sheet.opposite < 0))


def border_overlaps(places: Floats, border: Indices) -> bool:
    """The same where the border of the map consists of these half-edges."""
    starts = places.reshape(-1, 2)[border]
    ends = np.roll(places, -1, axis=1).reshape(-1, 2)[border]
    step = ends - starts
    inner = 0.5 * (starts + ends) + INSIDE * np.stack([-step[:, 1], step[:, 0]], axis=1)
    inner = inner[(step != 0.0).any(axis=1)]
    low, high = np.minimum(starts[:, 1], ends[:, 1]), np.maximum(starts[:, 1], ends[:, 1])
    for row in np.array_split(np.argsort(inner[:, 1]), max(len(inner) // TOGETHER, 1)):
        x, y = inner[row].T
        near = (high >= y.min(initial=np.inf)) & (low <= y.max(initial=-np.inf))
        if (_turns(x, y, starts[near], ends[near]) > 1).any():
            return True
    return False


def _turns(x: Floats, y: Floats, starts: Floats, ends: Floats) -> Indices:
    """(k,) how often closed lines turn around each point, counter-clockwise: their upward
    crossings of the ray to the right, less the downward ones."""
    upward = (starts[:, 1] <= y[:, None]) & (y[:, None] < ends[:, 1])
    downward = (ends[:, 1] <= y[:, None]) & (y[:, None] < starts[:, 1])
    (dx, dy), (px, py) = (ends - starts).T, (x[:, None] - starts[:, 0], y[:, None] - starts[:, 1])
    left = dx * py - dy * px
    counted: Indices = (upward & (left > 0.0)).sum(axis=1) - (downward & (left < 0.0)).sum(axis=1)
    return counted
