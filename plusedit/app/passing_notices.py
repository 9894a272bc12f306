"""What is told once a curve was led through its control points, and swings far out between them."""

import numpy as np

from plusedit.document.design import Design, changed
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.views.desk import Desk

FAR = 0.05  # of the size of a curve: less is seen by itself
FEW = 2  # points: a single one more may be an accident
ROUNDING = 1e-6  # of the size
EACH = 16  # places of a curve that are looked at, for each control line


class PassingNotices:
    """Says how far a step moved curves so that they pass through their points."""

    def __init__(self, desk: Desk) -> None:
        self._desk = desk
        self._settled = desk.session.design
        desk.session.changed.listen(self._look)

    def _look(self, old: Design, new: Design) -> None:
        if self._desk.session.is_previewing:
            return
        old, self._settled = self._settled, new
        for shape_id in changed(old, new):
            before, after = old.shapes.get(shape_id), new.shapes.get(shape_id)
            if before is None or after is None or before.curve is None or after.curve is None:
                continue
            if words := swing(before.curve, after.curve):
                self._desk.say(f"{after.name}: {words}")


def swing(before: PlusCurve, after: PlusCurve) -> str:
    """How far a curve swung out to pass through more of its points; empty where that is little."""
    points = after.lines.points
    if before.basis != after.basis or not np.array_equal(before.lines.points, points):
        return ""
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    if size == 0.0 or _met(after, size) < _met(before, size) + FEW:
        return ""
    grid = Grid.uniform(EACH * len(points) + 1)
    moved = float(_lengths(after.sample(grid) - before.sample(grid)).max()) / size
    if moved <= FAR:
        return ""
    longer = _longest(after) / max(_longest(before), ROUNDING * size)
    return (
        f"it passes through its points, but moved by up to {moved:.0%} of its size, with "
        f"directions up to {longer:.2g} times as long. Ctrl+Z takes that back."
    )


def _met(curve: PlusCurve, size: float) -> int:
    """How many of its control points a curve passes through."""
    misses = _lengths(curve.at(curve.basis.nodes) - curve.lines.points)
    return int((misses <= ROUNDING * size).sum())


def _longest(curve: PlusCurve) -> float:
    return float(_lengths(curve.directions).max())


def _lengths(vectors: Floats) -> Floats:
    found: Floats = np.linalg.norm(vectors, axis=1)
    return found
