"""Turning directions in space, by a rotation about any axis."""

from dataclasses import dataclass

import numpy as np

from plusedit.commands.base import Landing, NetCommand, Side
from plusedit.commands.directions import quarter_exact, redirected, unchanged
from plusedit.document.design import Design
from plusedit.document.shape import Geometry
from plusedit.geometry.arrays import Floats

ROUNDING = 1e-12  # of the largest entry: a matrix that deviates by less keeps the plane z = 0


def keeps_the_plane(matrix: Floats) -> bool:
    """Whether a map (3, 3) takes the plane z = 0 to itself, and z along; true of a (2, 2)."""
    if len(matrix) == 2:
        return True
    mixed = max(np.abs(matrix[2, :2]).max(), np.abs(matrix[:2, 2]).max())
    return bool(mixed <= ROUNDING * np.abs(matrix).max())


def rotation(axis: Floats, angle: float) -> Floats:
    """(3, 3) the turn by `angle` in radians about a unit vector, free of rounding at quarters.

    Counter-clockwise seen from where the vector points to: cos I + sin [a]x + (1 - cos) a a'.
    """
    c, s = quarter_exact(angle)
    x, y, z = axis
    across = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    matrix: Floats = c * np.eye(3) + s * across + (1.0 - c) * np.outer(axis, axis)
    return matrix


@dataclass(frozen=True, eq=False)
class Rotate(NetCommand):
    """Turn directions by a rotation in space, and stretch them by a factor if one is given.

    With both directions of a control plane their lengths and the angle between them stay: it
    turns like a rigid plate. A plane curve can only turn in its plane.
    """

    matrix: Floats
    """(3, 3) a rotation: vectors become matrix @ vector"""
    side: Side = "both"
    factor: float = 1.0
    landings: tuple[Landing, ...] = ()
    """where some of the directions are to point exactly"""

    @property
    def verb(self) -> str:
        return "Rotate" if self.factor == 1.0 else "Stretch"

    def apply(self, design: Design) -> Design:
        if self.factor == 1.0 and not self.landings and np.array_equal(self.matrix, np.eye(3)):
            return unchanged(design, self.targets)

        def changed(geometry: Geometry, directions: Floats) -> Floats:
            if geometry.dimension == 2 and not keeps_the_plane(self.matrix):
                raise ValueError("a plane curve can be turned in the top view only")
            size = geometry.dimension
            image: Floats = directions @ (self.factor * self.matrix[:size, :size]).T
            return image

        return redirected(design, self.targets, changed, self.side, self.landings)
