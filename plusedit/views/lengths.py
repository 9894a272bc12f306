"""L, the length of the control polygon, as it is remembered for the s slider.

It is measured when a curve is first met, when it is drawn on, closed or opened, and when the
slider is reset. In between it stays: if it followed every drag of a point, s / L would
change though nobody touched s.
"""

from collections.abc import Container

from plusedit.document.shape import ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.magnitude import polygon_length


class Lengths:
    """L of every curve of a design that was asked for."""

    def __init__(self) -> None:
        self._known: dict[ShapeId, tuple[tuple[int, bool], float]] = {}

    def of(self, shape_id: ShapeId, curve: PlusCurve) -> float:
        """L of a curve, as it was measured last."""
        kind, length = self._known.get(shape_id, (None, 0.0))
        return length if kind == _kind(curve) else self.measure(shape_id, curve)

    def measure(self, shape_id: ShapeId, curve: PlusCurve) -> float:
        """L of a curve as it is now, remembered from here on."""
        length = polygon_length(curve)
        self._known[shape_id] = (_kind(curve), length)
        return length

    def ratio(self, shape_id: ShapeId, curve: PlusCurve) -> float:
        """s / L of a curve; 0 where L is 0."""
        length = self.of(shape_id, curve)
        return curve.s / length if length else 0.0

    def keep_only(self, shape_ids: Container[ShapeId]) -> None:
        """Forget the curves that are not among these."""
        self._known = {i: known for i, known in self._known.items() if i in shape_ids}

    def forget(self) -> None:
        """Forget all: another design has been opened."""
        self._known = {}


def _kind(curve: PlusCurve) -> tuple[int, bool]:
    """What L can't be compared across: how many control lines, and whether they close."""
    return len(curve.lines), curve.closed
