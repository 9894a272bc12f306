"""Curves that leave and reach their ends along the control lines there."""

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.constraints import Constrained, Numbers, Settled, register
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tangency import end_objection, tangent_at_ends


class TangentEnd:
    """The neighboring line turns so that the velocity runs along the end line, forwards."""

    counts: Numbers = "none"
    conflict = (
        "The line beside this end serves the other end as well; with one more control line between "
        "them both can be tangent."
    )

    def __init__(self, title: str, order: int, *, at_start: bool) -> None:
        self.title, self.order, self._at_start = title, order, at_start

    def takes(self, geometry: Constrained) -> bool:
        return isinstance(geometry, PlusCurve)

    def objection(self, geometry: Constrained, numbers: tuple[int, ...]) -> str:
        return end_objection(_curve(geometry), at_start=self._at_start)

    def miss(self, geometry: Constrained, numbers: tuple[int, ...]) -> float:
        curve = _curve(geometry)
        end, line = (0.0, 0) if self._at_start else (1.0, -1)
        velocity, gradient = curve.derivatives([end], highest=1)[1][0], curve.gradients[line]
        speed = float(np.linalg.norm(velocity) * np.linalg.norm(gradient))
        if speed == 0.0:
            return np.inf
        along = float(velocity @ gradient)
        across = np.linalg.norm(velocity * float(gradient @ gradient) - along * gradient)
        return float(across / (speed * np.linalg.norm(gradient))) if along > 0.0 else np.inf

    def solved(
        self,
        geometry: Constrained,
        numbers: tuple[int, ...],
        settled: Settled,
        before: Constrained | None,
    ) -> Constrained:
        curve = _curve(geometry)
        if (0, self._beside(curve)) in settled and (0, self._end(curve)) not in settled:
            raise ValueError(self.conflict)
        return tangent_at_ends(curve, start=self._at_start, end=not self._at_start)

    def settles(self, geometry: Constrained, numbers: tuple[int, ...]) -> Settled:
        curve = _curve(geometry)
        end = self._end(curve)
        # What runs along the end line changes the speed there and nothing else.
        heading = unit(curve.gradients[[end]])
        return {(0, end): heading, (0, self._beside(curve)): heading}

    def places(self, geometry: Constrained, numbers: tuple[int, ...]) -> Floats:
        curve = _curve(geometry)
        return curve.at([0.0 if self._at_start else 1.0])

    def _end(self, curve: PlusCurve) -> int:
        return 0 if self._at_start else len(curve.lines) - 1

    def _beside(self, curve: PlusCurve) -> int:
        return 1 if self._at_start else len(curve.lines) - 2


def _curve(geometry: Constrained) -> PlusCurve:
    if not isinstance(geometry, PlusCurve):
        raise ValueError("Only curves have ends.")
    return geometry


register("tangent_start")(TangentEnd("Tangent at the start", 20, at_start=True))
register("tangent_end")(TangentEnd("Tangent at the end", 21, at_start=False))
