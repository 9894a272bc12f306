"""Lines as records for the card: of items that stay, from one frame to the next.

A line is a row of records, one for each point, between two gaps. Segment k lies between records
k and k + 1 and knows its neighbors, so one draw shows any number of lines. The gaps about a closed
line say where it goes on.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.scene.items import Polygon, Polyline, Segments
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.theme import Theme
from plusedit.views.gl.colors import word_of

RECORD: Final = np.dtype(
    [("at", "<f4", 3), ("kind", "<f4"), ("color", "<u4"), ("width", "<f4"), ("before", "<f4")]
)
GAP, GOES_ON = -1.0, -2.0
MET = 1e-9  # of the size of a line: how near its ends are where it is closed
KINDS = {"solid": 0.0, "dash": 1.0, "dot": 2.0}

Records = NDArray[Any]


@dataclass(frozen=True, eq=False)
class Stroke:
    """A line as one color draws it, or many separate segments."""

    points: Floats
    """(m, 3) of a line; (2 k, 3) starts and ends of segments, by turns"""
    color: str
    width: float
    dash: str
    is_apart: bool
    """whether they are segments"""


def strokes_of(items: Iterable[Polyline | Segments | Polygon]) -> list[Stroke]:
    """The lines of items; of a polygon its outline, or, to be smooth, the edge of its fill."""
    found = []
    for item in items:
        match item:
            case Polyline(points, color, width, dash) if len(points) > 1:
                found.append(Stroke(in_space(points), color, width, dash, False))
            case Segments(starts, ends, color, width, dash) if len(starts):
                pairs = np.stack([in_space(starts), in_space(ends)], axis=1).reshape(-1, 3)
                found.append(Stroke(pairs, color, width, dash, True))
            case Polygon(points, _, str(outline), width) if len(points) > 1:
                closed = in_space(points)
                closed = np.concatenate([closed, closed[:1]])
                found.append(Stroke(closed, outline, width, "solid", False))
    return found


def in_space(points: Floats) -> Floats:
    """(m, 3) the points; plane ones lie in z = 0."""
    if points.shape[1] == 3:
        return points
    return np.column_stack([points, np.zeros(len(points))])


def records_of(
    strokes: Sequence[Stroke], theme: Theme, origin: Floats, camera: SpaceCamera
) -> Records:
    """(n,) the records of all lines, gaps first, between and last.

    Places are counted from `origin` (3,). The camera tells how long dashed lines are on the
    screen; solid ones do not depend on it.
    """
    records = np.zeros(2 + sum(_count(stroke) for stroke in strokes), dtype=RECORD)
    records["kind"] = GAP
    at = 1
    for stroke in strokes:
        count = _count(stroke)
        _fill(records[at : at + count], stroke, theme, origin, camera)
        at += count
    return records


def _count(stroke: Stroke) -> int:
    return len(stroke.points) // 2 * 3 if stroke.is_apart else len(stroke.points) + 2


def _fill(
    records: Records, stroke: Stroke, theme: Theme, origin: Floats, camera: SpaceCamera
) -> None:
    points = stroke.points - origin
    records["color"] = word_of(theme, stroke.color)
    records["width"] = stroke.width
    kind = KINDS[stroke.dash]
    if stroke.is_apart:
        triples = records.reshape(-1, 3)
        triples["at"][:, :2] = points.reshape(-1, 2, 3)
        triples["kind"][:, :2] = kind
        return
    records["at"][1:-1] = points
    records["kind"][1:-1] = kind
    if len(points) > 3 and np.abs(points[0] - points[-1]).max() <= MET * np.ptp(points):
        records["at"][[0, -1]] = points[[-2, 1]]
        records["kind"][[0, -1]] = GOES_ON
    if kind:
        steps = np.diff(camera.to_screen(stroke.points), axis=0)
        records["before"][2:-1] = np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))
