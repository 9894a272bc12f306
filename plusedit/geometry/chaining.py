"""Curves that meet end to end, as one row of points."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.making.compatible import in_space
from plusedit.geometry.tessellate import tessellation

MEETS = 1e-6  # of the size: ends nearer than that are one
CORNER = np.cos(np.radians(3.0))  # tangents that turn by more make a corner


@dataclass(frozen=True, eq=False)
class Chain:
    """Points along some curves in turn."""

    points: Floats
    """(m, dim); of a closed chain the first stands at the end as well"""
    corners: tuple[int, ...]
    """numbers of the points at which it turns sharply"""
    closed: bool
    """whether it ends where it begins"""


def chained(curves: Sequence[PlusCurve], tolerance: float, gap: float = 0.0) -> Chain:
    """The points of curves that meet end to end, in the order in which they do.

    Each is sampled so finely that chords stray no farther than the tolerance. Ends that are no
    farther apart than `gap` meet in their middle. Plane curves lie at z = 0 among those of space.
    ValueError, in a sentence for people, where they make no single chain.
    """
    if any(curve.closed for curve in curves):
        raise ValueError("Only open curves make a chain.")
    if len({curve.dimension for curve in curves}) > 1:
        curves = [in_space(curve) for curve in curves]
    pieces = [_Piece.of(curve, tolerance) for curve in curves]
    size = float(np.ptp(np.concatenate([piece.points for piece in pieces]), axis=0).max()) or 1.0
    near = max(MEETS * size, gap)
    row, left = [pieces[0]], pieces[1:]
    while left:
        found = _next(row, left, near)
        if found is None:
            raise ValueError("The curves do not all meet end to end.")
        left.remove(found)
    return _chain(row, near)


@dataclass(eq=False)
class _Piece:
    """One curve as points, with the directions in which it starts and ends."""

    points: Floats
    leaving: Floats
    arriving: Floats

    @classmethod
    def of(cls, curve: PlusCurve, tolerance: float) -> "_Piece":
        points = curve.sample(tessellation(curve, tolerance))
        steps = np.diff(points, axis=0)
        velocity = curve.derivatives([0.0, 1.0], highest=1)[1]
        # A curve that stands still at an end leaves along its first chord.
        first, last = (
            unit(v if v.any() else step)
            for v, step in zip(velocity, (steps[0], steps[-1]), strict=True)
        )
        return cls(points, first, last)

    def reverse(self) -> None:
        self.points = self.points[::-1]
        self.leaving, self.arriving = -self.arriving, -self.leaving


def _next(row: list[_Piece], left: list[_Piece], near: float) -> _Piece | None:
    """The piece that goes on nearest at either end of the row, put there."""
    ways = [
        (float(np.linalg.norm(piece.points[start] - row[end].points[end])), number, start, end)
        for number, piece in enumerate(left)
        for end in (-1, 0)
        for start in (0, -1)
    ]
    apart, number, start, end = min(ways)
    if apart > near:
        return None
    piece = left[number]
    if (start == 0) != (end == -1):
        piece.reverse()
    row.insert(len(row) if end == -1 else 0, piece)
    return piece


def _chain(row: list[_Piece], near: float) -> Chain:
    rows, corners, count = [row[0].points], [], len(row[0].points)
    for before, after in pairwise(row):
        if before.arriving @ after.leaving < CORNER:
            corners.append(count - 1)
        rows[-1] = np.concatenate([rows[-1][:-1], [(rows[-1][-1] + after.points[0]) / 2.0]])
        rows.append(after.points[1:])
        count += len(after.points) - 1
    points = np.concatenate(rows)
    closed = len(points) > 3 and bool(np.linalg.norm(points[-1] - points[0]) <= near)
    if closed:
        points[0] = points[-1] = (points[0] + points[-1]) / 2.0
        if row[-1].arriving @ row[0].leaving < CORNER:
            corners.insert(0, 0)
    return Chain(points, tuple(corners), closed)
