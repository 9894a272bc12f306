"""What control lines and control planes have in common.

A plus curve has control lines, each with one direction; a plus surface has control planes, each
with two, one by u and one by v. Edits that only ask for points, directions and weights treat both
alike: control element `number` has the control point `control_points[number]` and the directions
`given_vectors[k, number]`, k = 0 on a curve, k = 0 (by u) and 1 (by v) on a surface. Plane (i, j)
of a surface has the number i * count_v + j.
"""

from typing import Protocol, Self

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

Flags = NDArray[np.bool_]


class ControlNet(Protocol):
    """Control points, directions and weights of one shape; an immutable value."""

    def __len__(self) -> int:
        """n, the number of control points."""
        ...

    @property
    def dimension(self) -> int:
        """Of the points: 2 or 3."""
        ...

    @property
    def control_points(self) -> Floats:
        """(n, dim)"""
        ...

    @property
    def given_vectors(self) -> Floats:
        """(k, n, dim) the directions set by the user; zero where automatic."""
        ...

    @property
    def automatic_vectors(self) -> Flags:
        """(k, n) true where a direction follows the neighbouring points."""
        ...

    @property
    def weight_row(self) -> Floats | None:
        """(n,) positive, or None where all are one."""
        ...

    def with_control_points(self, points: Floats) -> Self:
        """The same net through other points (n, dim); automatic directions follow them."""
        ...

    def with_vectors(self, given: Floats, automatic: Flags) -> Self:
        """The same points with other directions (k, n, dim), automatic ones marked (k, n)."""
        ...

    def with_weight_row(self, weights: Floats | None) -> Self:
        """The same net with other weights (n,)."""
        ...
