"""Lines as records for the card.

A line is a row of records, one for each point, between two gaps. Segment k lies between records
k and k + 1 and knows its neighbors, so one draw shows any number of lines. The gaps about a closed
line say where it goes on.
"""

from typing import Final

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.scene.items import Dash, Item, Polygon, Polyline, Segments
from plusedit.scene.space_camera import SpaceCamera
from plusedit.views.gl.colors import Palette

STEP: Final = 28
"""Bytes of a record: place and kind in four numbers, color in four bytes, width, length before"""
KIND, COLOR, WIDTH, BEFORE = 3, 4, 5, 6
GAP, GOES_ON = -1.0, -2.0
MET = 1e-9  # of the size of a line: how near its ends are where it is closed
KINDS: Final[dict[Dash, float]] = {"solid": 0.0, "dash": 1.0, "dot": 2.0}
SMOOTH = 1.0  # pixels of line around areas without an outline, so that their edges are smooth

Records = NDArray[np.float32]
"""(n, 7); the fifth column holds bytes, not a number"""


def records_of(item: Item, palette: Palette, origin: Floats, camera: SpaceCamera) -> Records:
    """(n,) the records of the lines of one item, which must come after a gap; a gap is last.

    Places are counted from `origin` (3,). The camera tells how long dashed lines are on the
    screen; solid ones do not depend on it. Of an area they are its outline or, where it has none,
    the edge of its fill.
    """
    match item:
        case Polyline(points, color, width, dash) if len(points) > 1:
            return _line(in_space(points), palette.word(color), width, KINDS[dash], origin, camera)
        case Segments(starts, ends, color, width, dash) if len(starts):
            pairs = in_space(starts) - origin, in_space(ends) - origin
            return _pairs(*pairs, palette.word(color), width, KINDS[dash])
        case Polygon(points, fill, outline, width) if len(points) > 1:
            if outline is None and palette.shade(fill)[3] < 1.0:
                return NOTHING
            closed = np.concatenate([in_space(points), in_space(points[:1])])
            if outline is None:
                outline, width = fill, SMOOTH
            return _line(closed, palette.word(outline), width, 0.0, origin, camera)
    return NOTHING


def in_space(points: Floats) -> Floats:
    """(m, 3) the points; plane ones lie in z = 0."""
    if points.shape[1] == 3:
        return points
    return np.column_stack([points, np.zeros(len(points))])


def _line(
    points: Floats, color: int, width: float, kind: float, origin: Floats, camera: SpaceCamera
) -> Records:
    records = np.empty((len(points) + 2, STEP // 4), dtype=np.float32)
    records[1:-1, :KIND] = points - origin
    _paint(records, color, width, kind)
    is_closed = len(points) > 3 and _is_closed(points)
    records[0, :KIND] = records[-3 if is_closed else 1, :KIND]
    records[-1, :KIND] = records[2 if is_closed else -2, :KIND]
    records[[0, -1], KIND] = GOES_ON if is_closed else GAP
    if kind:
        steps = np.diff(camera.to_screen(points), axis=0)
        records[2:-1, BEFORE] = np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))
    return records


def _is_closed(points: Floats) -> bool:
    gap = float(np.abs(points[-1] - points[0]).max())
    return gap == 0.0 or gap <= MET * float(np.abs(points[len(points) // 2] - points[0]).max())


def _pairs(starts: Floats, ends: Floats, color: int, width: float, kind: float) -> Records:
    records = np.empty((len(starts), 3, STEP // 4), dtype=np.float32)
    records[:, 0, :KIND] = starts
    records[:, 1, :KIND] = ends
    records[:, 2, :KIND] = ends
    rows = records.reshape(-1, STEP // 4)
    _paint(rows, color, width, kind)
    records[:, 2, KIND] = GAP
    return rows


def _paint(records: Records, color: int, width: float, kind: float) -> None:
    records[:, KIND] = kind
    records[:, COLOR].view(np.uint32)[:] = color
    records[:, WIDTH] = width
    records[:, BEFORE] = 0.0


NOTHING: Final = np.zeros((0, STEP // 4), dtype=np.float32)
A_GAP: Final = np.full((1, STEP // 4), GAP, dtype=np.float32)
