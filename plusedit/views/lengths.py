"""L, the length of the control polygon, as it is remembered for the s slider.

It is measured when a shape is first met, when it gets more or fewer control points, is closed or
opened, and when the slider is reset. In between it stays: if it followed every drag of a point,
s / L would change though nobody touched s.
"""

from collections.abc import Container

from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.natural import natural_length_of


class Lengths:
    """L of every curve and surface of a design that was asked for."""

    def __init__(self) -> None:
        self._known: dict[ShapeId, tuple[tuple[object, ...], float]] = {}

    def of(self, shape_id: ShapeId, geometry: PlusGeometry) -> float:
        """L of a shape, as it was measured last."""
        kind, length = self._known.get(shape_id, (None, 0.0))
        return length if kind == _kind(geometry) else self.measure(shape_id, geometry)

    def measure(self, shape_id: ShapeId, geometry: PlusGeometry) -> float:
        """L of a shape as it is now, remembered from here on."""
        length = natural_length_of(geometry)
        self._known[shape_id] = (_kind(geometry), length)
        return length

    def ratio(self, shape_id: ShapeId, geometry: PlusGeometry) -> float:
        """s / L of a shape; 0 where L is 0."""
        length = self.of(shape_id, geometry)
        return geometry.s / length if length else 0.0

    def keep_only(self, shape_ids: Container[ShapeId]) -> None:
        """Forget the shapes that are not among these."""
        self._known = {i: known for i, known in self._known.items() if i in shape_ids}

    def forget(self) -> None:
        """Forget all: another design has been opened."""
        self._known = {}


def _kind(geometry: PlusGeometry) -> tuple[object, ...]:
    """What L can't be compared across: how many control points, and whether they close."""
    return geometry.net.points.shape, geometry.closed
