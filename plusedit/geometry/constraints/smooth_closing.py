"""Curves whose end meets their start, with one velocity for both."""

from dataclasses import replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.constraints import Constrained, Numbers, Settled, register
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tangency import closed_smoothly, end_objection

FEWEST = 4


class SmoothClosing:
    """The last control point follows the first, or the first the last where that was moved."""

    title = "Closed smoothly"
    order = 10
    counts: Numbers = "none"
    conflict = (
        "The other constraints leave the lines at the seam no freedom; with more control lines "
        "they do."
    )

    def takes(self, geometry: Constrained) -> bool:
        return isinstance(geometry, PlusCurve)

    def objection(self, geometry: Constrained, numbers: tuple[int, ...]) -> str:
        curve = _curve(geometry)
        if len(curve.lines) < FEWEST:
            return (
                f"Closing smoothly needs at least {FEWEST} control lines, and there are "
                f"{len(curve.lines)}; insert some."
            )
        return end_objection(curve, at_start=True)

    def miss(self, geometry: Constrained, numbers: tuple[int, ...]) -> float:
        curve = _curve(geometry)
        at, velocity = curve.derivatives([0.0, 1.0], highest=1)
        size = float(np.ptp(curve.lines.points, axis=0).max()) or 1.0
        speeds = np.linalg.norm(velocity, axis=1)
        if not speeds.all():
            return np.inf
        gap = float(np.linalg.norm(at[1] - at[0])) / size
        return max(gap, float(np.linalg.norm(velocity[1] - velocity[0]) / speeds.max()))

    def solved(
        self,
        geometry: Constrained,
        numbers: tuple[int, ...],
        settled: Settled,
        before: Constrained | None,
    ) -> Constrained:
        return closed_smoothly(_following_last(_curve(geometry), before))

    def settles(self, geometry: Constrained, numbers: tuple[int, ...]) -> Settled:
        last = len(_curve(geometry).lines) - 1
        nowhere = np.zeros((0, geometry.dimension))
        return {(0, line): nowhere for line in (0, 1, last - 1, last)}

    def places(self, geometry: Constrained, numbers: tuple[int, ...]) -> Floats:
        return _curve(geometry).at([0.0])


def _following_last(curve: PlusCurve, before: Constrained | None) -> PlusCurve:
    """The curve with its first line where the last was put, if only that was edited."""
    if not isinstance(before, PlusCurve) or len(before.lines) != len(curve.lines):
        return curve
    old, new = before.lines, curve.lines
    points, gradients = new.points.copy(), curve.directions.copy()
    moved = (new.points != old.points).any(axis=1)
    if moved[-1] and not moved[0]:
        points[0] = points[-1]
        curve = replace(curve, lines=new.with_points(points))
    turned = (gradients != before.directions).any(axis=1) & ~new.automatic
    if turned[-1] and not turned[0]:
        curve = replace(curve, lines=curve.lines.with_direction(0, gradients[-1]))
    elif turned[0] and not turned[-1]:
        last = len(points) - 1
        curve = replace(curve, lines=curve.lines.with_direction(last, gradients[0]))
    return curve


def _curve(geometry: Constrained) -> PlusCurve:
    if not isinstance(geometry, PlusCurve):
        raise ValueError("Only curves are closed like that.")
    return geometry


register("smooth_closing")(SmoothClosing())
