"""What control lines look like: a dot, a segment through it, a grip at each end.

Grips of automatic directions are hollow, the user's solid; the grip on the side of +d is the
larger one. What a segment has been lengthened by, or goes on for, is dashed.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import Camera
from plusedit.scene.handles import handles
from plusedit.scene.items import Item, Markers, Segments

DOT = 7.0  # pixels, as all sizes here
GRIPS = (10.0, 7.5)  # on the sides of +d and -d
GOES_ON = 16.0  # how far a segment that was cut is shown to go on
RING = 17.0  # around the dot of the active line

Rows = NDArray[np.intp]


@dataclass(frozen=True)
class Strokes:
    """Color and width of some control lines."""

    color: str
    width: float
    fill: str | None = None
    """of solid marks, where it is not `color`"""


NORMAL = Strokes("line", 1.25)
QUIET = Strokes("line@60", 1.0)
SELECTED = Strokes("selected", 2.0)


@dataclass(frozen=True, eq=False)
class Parts:
    """Control lines in the world, ready to be drawn in any of the strokes."""

    points: Floats
    arms: Floats
    full: Floats
    beyond: Floats
    """(n, dim) from P_i to where the dashed part ends"""
    drawn: NDArray[np.bool_]
    automatic: NDArray[np.bool_]


def control_line_items(
    curve: PlusCurve,
    camera: Camera,
    *,
    selected: tuple[int, ...] = (),
    active: int | None = None,
    quiet: bool = False,
) -> Iterator[Item]:
    """The control lines of one curve, the selected ones in front."""
    parts = _parts(curve, camera)
    chosen = np.zeros(len(curve.lines), dtype=bool)
    chosen[list(selected)] = True
    yield from _lines(parts, np.flatnonzero(~chosen), QUIET if quiet else NORMAL)
    if active is not None:
        at = parts.points[[active]]
        yield Markers(at, "circle", RING, "selected@22", "selected@22")
    yield from _lines(parts, np.flatnonzero(chosen), SELECTED)


def _parts(curve: PlusCurve, camera: Camera) -> Parts:
    at = handles(curve, camera)
    arm = np.linalg.norm(at.arms, axis=1, keepdims=True)
    full = np.linalg.norm(at.full, axis=1, keepdims=True)
    per_arm = np.divide(1.0, arm, out=np.zeros_like(arm), where=arm > 0.0)
    # Pixels of this line per unit of the world: seen at a slant there are fewer.
    along = np.linalg.norm(at.tips[0] - at.points, axis=1, keepdims=True) * per_arm
    more = np.divide(GOES_ON, along, out=np.zeros_like(arm), where=along > 0.0)
    beyond = np.where(full > arm, np.minimum(full, arm + more), arm)
    solid = np.minimum(full, arm)
    way = at.arms * per_arm
    return Parts(
        curve.lines.points,
        at.arms,
        way * solid,
        way * beyond,
        at.drawn,
        curve.lines.automatic,
    )


def _lines(parts: Parts, rows: Rows, strokes: Strokes) -> Iterator[Item]:
    if not len(rows):
        return
    seen = rows[parts.drawn[rows]]
    if len(seen):
        yield from _segments(parts, seen, strokes)
        solid, hollow = seen[~parts.automatic[seen]], seen[parts.automatic[seen]]
        for size, side in zip(GRIPS, (1.0, -1.0), strict=True):
            yield from _grips(parts.points[solid] + side * parts.arms[solid], size, strokes, True)
            yield from _grips(
                parts.points[hollow] + side * parts.arms[hollow], size, strokes, False
            )
    yield Markers(parts.points[rows], "circle", DOT + 3.0, "canvas", "canvas")
    yield Markers(parts.points[rows], "circle", DOT, strokes.color, strokes.color)


def _segments(parts: Parts, rows: Rows, strokes: Strokes) -> Iterator[Item]:
    points, full, beyond = parts.points[rows], parts.full[rows], parts.beyond[rows]
    yield Segments(points - full, points + full, strokes.color, strokes.width)
    dashed = np.flatnonzero((full != beyond).any(axis=1))
    if len(dashed):
        starts = np.concatenate([(points + full)[dashed], (points - full)[dashed]])
        ends = np.concatenate([(points + beyond)[dashed], (points - beyond)[dashed]])
        yield Segments(starts, ends, strokes.color, strokes.width, "dot")


def _grips(at: Floats, size: float, strokes: Strokes, solid: bool) -> Iterator[Item]:
    if len(at):
        fill = strokes.color if solid else None
        yield Markers(at, "circle", size, fill, strokes.color)
