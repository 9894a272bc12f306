"""Plus curves.

    C(u) = sum_i W_i L_i(u) b_i(u) / sum_i W_i b_i(u),   L_i(u) = P_i + s (u - x_i) d_i.

For a fixed basis the curve is linear in the points and the directions, and affine in s:
C = base + s plus. With s = 0 it is the classical curve of the control points.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import LARGEST, Floats
from plusedit.geometry.bases import Basis, is_local
from plusedit.geometry.blend import Blend, Grid, blend, blends_at, parameters_of
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.net import ControlNet

BLOCK = 1 << 15  # entries of one matrix, 256 KB: longer rows of parameters go through the cache


@dataclass(frozen=True, eq=False)
class PlusCurve:
    """A basis, control lines and the magnitude s; an immutable value, compared by identity."""

    basis: Basis
    lines: ControlLines
    s: float = 1.0
    """a length per unit of parameter; any finite number, 0 for the classical curve"""

    def __post_init__(self) -> None:
        if len(self.lines.points) != self.basis.size:
            raise ValueError(
                f"points: {len(self.lines)} control lines for a basis of {self.basis.size}"
            )
        if not abs(self.s) <= LARGEST:
            raise ValueError(f"s: must be a finite number up to {LARGEST:g}, got {self.s}")

    @property
    def dimension(self) -> int:
        """2 for a plane curve, 3 for a space curve."""
        return self.lines.dimension

    @property
    def closed(self) -> bool:
        """Whether C(u + 1) = C(u)."""
        return self.basis.closed

    @property
    def directions(self) -> Floats:
        """(n, dim) the d_i, automatic ones worked out."""
        return self.lines.directions(closed=self.basis.closed)

    @property
    def gradients(self) -> Floats:
        """(n, dim) the g_i = s d_i."""
        return self.s * self.directions

    @property
    def net(self) -> ControlLines:
        """The control lines, as edits see them."""
        return self.lines

    @property
    def vectors(self) -> Floats:
        """(1, n, dim) the directions d_i."""
        return self.directions[None]

    def with_net(self, net: ControlNet) -> "PlusCurve":
        """The same basis and s with other control lines."""
        if not isinstance(net, ControlLines):
            raise TypeError("a curve has control lines")
        return replace(self, lines=net)

    @cached_property
    def classical(self) -> "PlusCurve":
        """The curve of the control points alone, s = 0."""
        return replace(self, s=0.0)

    @property
    def spacing(self) -> float:
        """h, the mean distance of nodes: 1 / (n - 1) on an open curve, 1 / n on a closed one."""
        return 1.0 / (self.basis.size if self.closed else self.basis.size - 1)

    def sample(self, grid: Grid) -> Floats:
        """(m, dim) points at the parameters of `grid`, by cached matrices."""
        base, plus = terms(self.basis, self.lines, grid)
        points: Floats = self.s * plus
        points += base
        return points

    def jets(self, grid: Grid) -> tuple[Floats, Floats, Floats]:
        """(C, C', C'') at the parameters of `grid`, (m, dim) each, by cached matrices.

        What `derivatives` gives, in a tenth of the time where only points and directions are new.
        """
        blends = [blend(self.basis, grid, r) for r in range(3)]
        at, velocity, acceleration = quotient(blends, self.lines, self.directions, self.s)
        return at, velocity, acceleration

    def at(self, u: ArrayLike) -> Floats:
        """(m, dim) points at the parameters u (m,)."""
        return self.derivatives(u, highest=0)[0]

    def derivatives(self, u: ArrayLike, *, highest: int = 2) -> tuple[Floats, ...]:
        """(C, C', C''), each (m, dim), up to the `highest` of 0, 1, 2.

        At a knot where a derivative jumps it is that of the span to the right, at u = 1 that of
        the last span. Outside [0, 1] open curves are clamped, closed ones wrap.
        """
        parts = [self._quotient(block, highest) for block in self._blocks(parameters_of(u))]
        if len(parts) == 1:
            return parts[0]
        return tuple(np.concatenate(rows) for rows in zip(*parts, strict=True))

    def _blocks(self, u: Floats) -> Iterator[Floats]:
        width = self.basis.order if is_local(self.basis) else self.basis.size
        step = max(1, BLOCK // width)
        if len(u) <= step:
            yield u
            return
        for start in range(0, len(u), step):
            yield u[start : start + step]

    def _quotient(self, u: Floats, highest: int) -> tuple[Floats, ...]:
        return quotient(blends_at(self.basis, u, highest), self.lines, self.directions, self.s)


def quotient(
    blends: list[Blend], lines: ControlLines, directions: Floats, s: float
) -> tuple[Floats, ...]:
    """The curve and its derivatives from the matrices of B and D and theirs.

    With A and w the numerator and denominator:
    C' = (A' - w' C) / w, C'' = (A'' - 2 w' C' - w'' C) / w.
    """
    if lines.weights is None:
        gradients = s * directions
        return tuple(b.values @ lines.points + b.reaches @ gradients for b in blends)
    weights = lines.unit_weights
    points, gradients = weights[:, None] * lines.points, weights[:, None] * (s * directions)
    tops = [b.values @ points + b.reaches @ gradients for b in blends]
    below = [(b.values @ weights)[:, None] for b in blends]
    at = tops[0] / below[0]
    if len(blends) == 1:
        return (at,)
    first = (tops[1] - below[1] * at) / below[0]
    if len(blends) == 2:
        return at, first
    return at, first, (tops[2] - 2.0 * below[1] * first - below[2] * at) / below[0]


@lru_cache(maxsize=256)
def terms(basis: Basis, lines: ControlLines, grid: Grid) -> tuple[Floats, Floats]:
    """The two terms that s weighs, (m, dim) each: the classical curve and the plus term."""
    matrices = blend(basis, grid)
    directions = lines.directions(closed=basis.closed)
    if lines.weights is None:
        return matrices.values.dot(lines.points), matrices.reaches.dot(directions)
    weights = lines.unit_weights
    below = (matrices.values @ weights)[:, None]
    base = matrices.values @ (weights[:, None] * lines.points) / below
    plus = matrices.reaches @ (weights[:, None] * directions) / below
    return base, plus
