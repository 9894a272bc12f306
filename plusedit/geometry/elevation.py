"""Plus curves in standard form: the same curve as a B-spline or NURBS of one degree more.

A line times a B-spline of order k is piecewise of degree k, so a B-spline+ of order k is a B-spline
of order k + 1 on knots tau, which hold every distinct knot once more. Its control points are

    Q_j = 1/k sum_{r=1..k} sum_i w_i (P_i + (tau_{j+r} - x_i) g_i) = E P + M g,

where w_i are the weights of de Boor's triangle for the arguments tau_{j+1} .. tau_{j+k} without
tau_{j+r}. Begun in the span that holds tau_j and with arguments that rise, every step of the
triangle is a mean with shares from 0 to 1 (it inserts knots): nothing is lost to rounding, whatever
the knots and the order. The parameter stays what it was.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache, singledispatch

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline, weights_of_span
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.matrices import Banded


@dataclass(frozen=True, eq=False)
class BezierPieces:
    """A curve cut into Bezier curves of one degree at its knots."""

    points: Floats
    """(p, degree + 1, dim)"""
    weights: Floats | None
    """(p, degree + 1), or None where all are one"""
    breaks: Floats
    """(p + 1,) piece i is the curve from parameter breaks[i] to breaks[i + 1]"""


@dataclass(frozen=True, eq=False)
class StandardCurve:
    """A clamped B-spline curve, or NURBS, on [0, 1]; with 2 `order` knots a Bezier curve."""

    order: int
    knots: Floats
    """(n + order,) rising from `order` zeros to `order` ones"""
    points: Floats
    """(n, dim)"""
    weights: Floats | None = None
    """(n,) positive, or None where all are one"""

    def __post_init__(self) -> None:
        points = frozen(self.points, shape=(None, None), name="points")
        knots = frozen(self.knots, shape=(len(points) + self.order,), name="knots")
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "knots", knots)
        if self.weights is not None:
            weights = frozen(self.weights, shape=points.shape[:1], name="weights")
            object.__setattr__(self, "weights", weights)

    @property
    def degree(self) -> int:
        """The degree of every piece, order - 1."""
        return self.order - 1

    def at(self, u: ArrayLike) -> Floats:
        """(m, dim) points at the parameters u (m,), which are clamped to [0, 1]."""
        return self._curve.at(u)

    def derivatives(self, u: ArrayLike, *, highest: int = 2) -> tuple[Floats, ...]:
        """(C, C', C''), each (m, dim), up to the `highest` of 0, 1, 2; from the right at knots."""
        return self._curve.derivatives(u, highest=highest)

    def bezier_pieces(self) -> BezierPieces:
        """The curve between neighboring distinct knots as Bezier curves."""
        cut, breaks = cutting(self.order, self.knots)
        points, weights = _projected(cut, None, self.points, None, self.weights)
        points = points.reshape(len(breaks) - 1, self.order, -1)
        points[1:, 0] = points[:-1, -1]  # equal but for rounding; now neighbors touch exactly
        if weights is not None:
            weights = weights.reshape(-1, self.order)
        return BezierPieces(points, weights, breaks)

    @cached_property
    def _curve(self) -> PlusCurve:
        basis = BSpline(len(self.points), self.order, knots=tuple(self.knots.tolist()))
        still = np.zeros_like(self.points)
        return PlusCurve(basis, ControlLines.of(self.points, list(still), self.weights), s=0.0)


def cutting(order: int, knots: Floats) -> tuple[Banded, Floats]:
    """(p order, n) what cuts a clamped B-spline into p Bezier curves, and their breaks (p + 1,)."""
    breaks, degree = np.unique(knots), order - 1
    # Point r of the piece on [a, b] has the arguments a, ..., a, b, ..., b with r times b.
    is_end = np.arange(degree)[:, None] >= degree - np.arange(order)
    ends = np.where(is_end[:, None, :], breaks[1:, None], breaks[:-1, None])
    span = np.searchsorted(knots, breaks[:-1], side="right") - 1
    spans = np.repeat(span, order)
    shares = weights_of_span(ends.reshape(degree, -1), knots, spans)
    columns = spans[:, None] + np.arange(-degree, 1)
    return Banded(columns, shares, len(knots) - order), breaks


@dataclass(frozen=True, eq=False)
class Elevation:
    """What turns control lines into the control points of the standard form: Q = E P + M g."""

    order: int
    knots: Floats
    values: Banded
    """E (N, n)"""
    reaches: Banded
    """M (N, n)"""


def elevated(curve: PlusCurve) -> StandardCurve:
    """The same curve, parameter for parameter, as one B-spline or NURBS of one degree more.

    A closed curve is cut open at u = 0. Raises ValueError where the family has no such form.
    """
    form, lines = elevation(curve.basis), curve.lines
    points, weights = _projected(
        form.values, form.reaches, lines.points, curve.gradients, lines.weights
    )
    return StandardCurve(form.order, form.knots, points, weights)


@lru_cache(maxsize=64)
def elevation(basis: Basis) -> Elevation:
    """The matrices for a basis; kept. Raises ValueError where the family has no standard form."""
    return elevation_of(basis)


@singledispatch
def elevation_of(basis: Basis) -> Elevation:
    """The matrices for a basis, worked out anew: one function for each family that has them."""
    raise ValueError(
        f"a {type(basis).__name__} curve is not piecewise polynomial; it has no standard form"
    )


@elevation_of.register
def _(basis: Bernstein) -> Elevation:
    """Q_j = (1 - a) P_j + a P_{j-1} + b (g_{j-1} - g_j), a = j / n, b = j (n - j) / (n (n - 1))."""
    n = basis.size
    j = np.arange(n + 1)
    a, b = j / n, j * (n - j) / (n * (n - 1.0))
    # What would stand outside the matrix, in its first and last row, is zero.
    columns = np.clip(np.stack([j - 1, j], axis=1), 0, n - 1)
    values = Banded(columns, np.stack([a, 1.0 - a], axis=1), n)
    reaches = Banded(columns, np.stack([b, -b], axis=1), n)
    return Elevation(n + 1, np.repeat([0.0, 1.0], n + 1), values, reaches)


@elevation_of.register
def _(basis: BSpline) -> Elevation:
    return _closed(basis) if basis.closed else _open(basis)


def _open(basis: BSpline) -> Elevation:
    k, n, t = basis.order, basis.size, basis.knot_vector
    distinct, times = np.unique(t, return_counts=True)
    tau = np.repeat(distinct, times + 1)
    span = np.searchsorted(t, tau[: -k - 1], side="right") - 1
    columns = span[:, None] + np.arange(1 - k, 1)
    values, reaches = _rows(tau, t, span, basis.nodes[columns], k)
    return Elevation(k + 1, tau, Banded(columns, values, n), Banded(columns, reaches, n))


def _closed(basis: BSpline) -> Elevation:
    # Measured in knot spans, as the basis does it: the knots are whole numbers, one period is n.
    k, n = basis.order, basis.size
    start = -(k % 2) / 2
    inner = np.arange(1 - k % 2, n, dtype=np.float64)
    tau = np.concatenate([np.full(k + 1, start), np.repeat(inner, 2), np.full(k + 1, n + start)])
    span = np.floor(tau[: -k - 1]).astype(np.intp)
    t = np.arange(-k, n + k + 1, dtype=np.float64)
    unrolled = span[:, None] + np.arange(1 - k, 1) + (k + 1) // 2
    values, reaches = _rows(tau, t, span + k, unrolled + start, k)
    columns = unrolled % n
    knots = np.clip((tau - start) / n, 0.0, 1.0)
    return Elevation(k + 1, knots, Banded(columns, values, n), Banded(columns, reaches / n, n))


def _rows(
    tau: Floats, t: Floats, span: NDArray[np.intp], nodes: Floats, k: int
) -> tuple[Floats, Floats]:
    """(N, k) entries of E and of M, for the lines whose nodes (N, k) are given."""
    windows = np.lib.stride_tricks.sliding_window_view(tau[1:-1], k)
    # Equal arguments give equal summands: one is worked out and counts for all of them.
    is_new = np.diff(windows, axis=1, prepend=-np.inf) > 0.0
    j, r = np.nonzero(is_new)
    count = np.diff(np.append(np.flatnonzero(is_new.ravel()), is_new.size))
    rest = np.arange(k - 1)
    arguments = windows[j[:, None], rest + (rest >= r[:, None])]
    shares = weights_of_span(arguments.T, t, span[j]) * (count / k)[:, None]
    pull = (windows[j, r][:, None] - nodes[j]) * shares
    first = np.flatnonzero(np.diff(j, prepend=-1))
    return np.add.reduceat(shares, first), np.add.reduceat(pull, first)


def _projected(
    values: Banded,
    reaches: Banded | None,
    points: Floats,
    gradients: Floats | None,
    weights: Floats | None,
) -> tuple[Floats, Floats | None]:
    """The points and weights that the matrices make, by way of homogeneous coordinates."""
    if weights is None:
        made = values @ points
        if reaches is not None and gradients is not None:
            made += reaches @ gradients
        return made, None
    largest = weights.max()  # divided out: products of great weights and coordinates overflow
    share = weights[:, None] / largest
    below = (values @ share[:, 0])[:, None]
    made = values @ (share * points)
    if reaches is not None and gradients is not None:
        made += reaches @ (share * gradients)
    return made / below, below[:, 0] * largest
