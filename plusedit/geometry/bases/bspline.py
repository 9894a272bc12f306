"""B-splines on clamped knots (open) or on uniform knots of period 1 (closed).

With weights on the control lines they are NURBS. The node of a function is its Greville
abscissa: the only choice for which adding one vector to all gradients changes nothing.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import register
from plusedit.geometry.domain import clamped, wrapped
from plusedit.geometry.matrices import Banded

HIGHEST_ORDER = 1000  # the work grows with its square


def uniform_knots(size: int, order: int) -> Floats:
    """Clamped knots of `size` functions: `order` zeros, equal spans, `order` ones."""
    spans = size - order + 1
    inner = np.arange(1, spans) / spans
    return np.concatenate([np.zeros(order), inner, np.ones(order)])


@register("bspline")
@dataclass(frozen=True)
class BSpline:
    """n B-splines of order k (degree k - 1), 2 <= k; an open basis has k <= n."""

    size: int
    order: int = 4
    closed: bool = False
    knots: tuple[float, ...] | None = None
    """clamped, size + order numbers from 0 to 1, never falling; None: uniform; open only"""

    def __post_init__(self) -> None:
        if self.size < 2:
            raise ValueError(f"points: a B-spline needs at least 2 of them, got {self.size}")
        if self.order < 2 or (not self.closed and self.order > self.size):
            top = "" if self.closed else f" to {self.size}, the number of control lines"
            raise ValueError(f"order: expected 2{top or ' or more'}, got {self.order}")
        if self.order > HIGHEST_ORDER:
            raise ValueError(f"order: {HIGHEST_ORDER} is the highest that can be calculated with")
        if self.knots is not None:
            if self.closed:
                raise ValueError("knots: a closed B-spline has uniform knots, none can be given")
            _check_knots(self.knots, self.size, self.order)

    @classmethod
    def of_size(cls, size: int) -> "BSpline":
        """Cubic on uniform knots, of lower degree where there are fewer than 4 control lines."""
        return cls(size, min(4, size))

    def __hash__(self) -> int:
        # Asked for with every look into a cache, and there may be thousands of knots.
        return self._hash

    @property
    def nodes(self) -> Floats:
        return self._nodes

    @property
    def knot_vector(self) -> Floats:
        """The clamped knots (size + order,) of an open basis; of a closed one those in [0, 1]."""
        return self._knots

    @property
    def breaks(self) -> Floats:
        """Where pieces meet: the distinct knots, 0 and 1 among them."""
        return np.unique(np.concatenate([[0.0], self._knots, [1.0]]))

    def values(self, u: Floats, *, derivative: int = 0) -> Floats:
        place = self._place(u)
        return Banded(place.columns, place.functions(derivative), self.size).dense()

    def reaches(self, u: Floats, *, derivative: int = 0) -> Floats:
        return self.banded(u, derivative=derivative)[1].dense()

    def banded(self, u: Floats, *, derivative: int = 0) -> tuple[Banded, Banded]:
        place = self._place(u)
        value = place.functions(derivative)
        reach = place.distances * value
        if derivative:
            reach += derivative * place.functions(derivative - 1)
        return Banded(place.columns, value, self.size), Banded(place.columns, reach, self.size)

    def banded_jet(self, u: Floats, highest: int) -> list[tuple[Banded, Banded]]:
        place = self._place(u)
        values = [place.functions(r) for r in range(highest + 1)]
        reaches = [place.distances * value for value in values]
        for r in range(1, highest + 1):
            reaches[r] += r * values[r - 1]
        return [
            (Banded(place.columns, value, self.size), Banded(place.columns, reach, self.size))
            for value, reach in zip(values, reaches, strict=True)
        ]

    def active(self, u: Floats) -> tuple[NDArray[np.intp], Floats]:
        """(m, order) each: the lines whose functions are not zero about u, and u - x_i."""
        place = self._place(u)
        return place.columns, place.distances

    def _place(self, u: Floats) -> "_Place":
        return (self._closed if self.closed else self._open)(u)

    def _open(self, u: Floats) -> "_Place":
        u, t, k = clamped(u), self._knots, self.order
        span = np.clip(np.searchsorted(t, u, side="right") - 1, k - 1, self.size - 1)
        columns = span + np.arange(1 - k, 1)[:, None]
        return _Place(u, t, span, k, 1.0, columns.T, (u - self._nodes[columns]).T)

    def _closed(self, u: Floats) -> "_Place":
        # Measured in knot spans the knots are whole numbers: no rounding, and one period is n.
        n, k = self.size, self.order
        u = wrapped(u)
        span = np.searchsorted(self._knots, u, side="right") - 1
        at = np.clip(n * u - (k % 2) / 2, span, span + 1)
        t = np.arange(-k, n + k + 1, dtype=np.float64)
        unrolled = span + (np.arange(1 - k, 1) + (k + 1) // 2)[:, None]
        return _Place(at, t, span + k, k, float(n), (unrolled % n).T, (u - unrolled / n).T)

    @cached_property
    def _hash(self) -> int:
        return hash((self.size, self.order, self.closed, self.knots))

    @cached_property
    def _knots(self) -> Floats:
        if self.closed:
            offset = (self.order % 2) / 2
            return (np.arange(self.size) + offset) / self.size
        if self.knots is None:
            return uniform_knots(self.size, self.order)
        return np.array(self.knots)

    @cached_property
    def _nodes(self) -> Floats:
        if self.closed:
            return np.arange(self.size) / self.size
        inner = np.lib.stride_tricks.sliding_window_view(self._knots[1:-1], self.order - 1)
        nodes: Floats = inner.mean(axis=1)
        return nodes


@dataclass(frozen=True, eq=False)
class _Place:
    """Where parameters lie among knots."""

    at: Floats
    """(m,) the parameters in units of the knots"""
    knots: Floats
    span: NDArray[np.intp]
    """(m,) knots[span] <= at < knots[span + 1]"""
    order: int
    unit: float
    """how many units of the knots one of the parameter is"""
    columns: NDArray[np.intp]
    """(m, order) the lines that are active there"""
    distances: Floats
    """(m, order) u - x_i"""

    def functions(self, derivative: int) -> Floats:
        """(m, order) the functions of those lines, or a derivative by the parameter."""
        entries = functions_of_span(self.at, self.knots, self.span, self.order, derivative)
        return entries * self.unit**derivative if derivative else entries


def functions_of_span(
    u: Floats, t: Floats, span: NDArray[np.intp], order: int, derivative: int
) -> Floats:
    """(m, order) the B-splines, or a derivative of them, that are not zero on the given spans.

    Cox and de Boor's recursion, upwards from order 1; the last `derivative` steps take
    N'_{i,k} = (k - 1) (N_{i,k-1} / (t_{i+k-1} - t_i) - N_{i+1,k-1} / (t_{i+k} - t_{i+1})).
    Spans are not empty, so no denominator here is zero.
    """
    m = len(u)
    if derivative >= order:
        return np.zeros((m, order))
    near = t[span + np.arange(2 - order, order)[:, None]]
    rows = np.zeros((order + 1, m))
    rows[0] = 1.0
    for q in range(1, order):
        upper, lower = near[order - 1 : order - 1 + q], near[order - 1 - q : order - 1]
        share = rows[:q] / (upper - lower)
        rows[: q + 1] = 0.0
        if q < order - derivative:
            rows[:q] += (upper - u) * share
            rows[1 : q + 1] += (u - lower) * share
        else:
            rows[:q] -= q * share
            rows[1 : q + 1] += q * share
    return rows[:order].T


def weights_of_span(arguments: Floats, t: Floats, span: NDArray[np.intp]) -> Floats:
    """(m, order) the shares of control points in de Boor's triangle with its own argument a column.

    `arguments` is (order - 1, m). With all of a column equal to u these are the B-splines at u;
    with the knots of a refined B-spline, rising, those of the old points in its new point.
    """
    steps, m = arguments.shape
    rows = np.zeros((steps + 1, m))
    rows[0] = 1.0
    for q in range(1, steps + 1):
        upper = t[span + np.arange(1, q + 1)[:, None]]
        lower = t[span + np.arange(1 - q, 1)[:, None]]
        share = rows[:q] / (upper - lower)
        rows[: q + 1] = 0.0
        rows[:q] += (upper - arguments[q - 1]) * share
        rows[1 : q + 1] += (arguments[q - 1] - lower) * share
    return rows.T


def _check_knots(knots: tuple[float, ...], size: int, order: int) -> None:
    t = np.array(knots, dtype=np.float64)
    if len(t) != size + order:
        raise ValueError(f"knots: expected {size + order} numbers, got {len(t)}")
    if not np.isfinite(t).all():
        raise ValueError("knots: has a value that is not finite")
    if (np.diff(t) < 0.0).any():
        raise ValueError("knots: must never fall")
    if (t[:order] != 0.0).any() or (t[-order:] != 1.0).any():
        raise ValueError(f"knots: must begin with {order} zeros and end with {order} ones")
    inner, times = np.unique(t[order:-order], return_counts=True)
    if len(inner) and (inner[0] <= 0.0 or inner[-1] >= 1.0):
        raise ValueError("knots: inner knots must lie between 0 and 1")
    if (times > order - 1).any():
        most = "once" if order == 2 else f"{order - 1} times"
        raise ValueError(f"knots: {inner[times.argmax()]:g} stands more than {most}")
