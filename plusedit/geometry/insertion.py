"""One control line more, with the shape kept as far as the family allows.

Where the functions of the old basis are sums of those of the larger one, b_i = sum_j a_ji b'_j,
each new line is a mean of old ones,

    W'_j = sum_i a_ji W_i,   L'_j(u) = sum_i a_ji W_i L_i(u) / W'_j,

and the curve stays exactly what it was: a Bezier+ curve rises by one degree, an open B-spline+
curve gets a knot. Closed B-splines (whose knots are even) and rational Gaussians have no such
sums. There the lines are fitted to samples of the old curve, from a guess that they leave
unwillingly.
"""

from dataclasses import replace
from functools import singledispatch

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline, uniform_knots, weights_of_span
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.blend import blend_at
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines, automatic_directions
from plusedit.geometry.matrices import Banded, dense

MARGIN = 0.1  # of a gap: a new knot or node keeps this far from its neighbors
NOTHING = 1e-9  # of the extent: less than that is not missing from a curve
PART = 1e-3  # in a curve: lines with less are not fitted
RELUCTANCE = 3e-3  # what leaving the first guess counts beside leaving the old curve
REACH = 150  # lines on each side of the new one that are fitted; those beyond keep the guess
SAMPLES = 6  # of the old curve for each line that is fitted


def insert_line(curve: PlusCurve, u: float) -> tuple[PlusCurve, int]:
    """The curve with one more control line about the parameter u, and the number of that line.

    Bezier+ and open B-spline+ curves, with and without weights, stay exactly as they are. Others
    change as little as they can; a closed B-spline+ curve may begin at another of its points.
    Raises ValueError if u is not finite; outside [0, 1] it is clamped, or wrapped.
    """
    if not np.isfinite(u):
        raise ValueError(f"insert_line: expected a finite parameter, got {u}")
    basis, index = larger_basis(curve.basis, float(u))
    shares = exact_shares(curve.basis, basis)
    if shares is not None:
        return refined(curve, basis, shares), index
    return _fitted(curve, basis, index, shift_of(curve.basis, basis, index, u)), index


def with_basis(curve: PlusCurve, basis: Basis) -> PlusCurve:
    """The curve with another basis and the same lines.

    For a basis of another size they are means of neighboring lines, taken at the new nodes.
    """
    if basis.size == len(curve.lines):
        return replace(curve, basis=basis)
    return PlusCurve(basis, lines_between(curve, basis.nodes), curve.s)


def lines_between(curve: PlusCurve, at: Floats) -> ControlLines:
    """For every parameter in `at` the mean of the two lines on both sides, shares by nearness.

    Outside the nodes of an open curve, the line next to it. A new line is automatic where the
    old ones are.
    """
    old, directions = curve.lines, curve.directions
    rows, weights, distances = neighbors(curve.basis, at)
    on_lines = old.points[rows] + curve.s * distances[..., None] * directions[rows]
    points = (weights[..., None] * on_lines).sum(axis=1)
    given = (weights[..., None] * directions[rows]).sum(axis=1)
    heights = None if old.weights is None else (weights * old.weights[rows]).sum(axis=1)
    automatic = (old.automatic[rows] | (weights == 0.0)).all(axis=1)
    return ControlLines(points, given, automatic, heights)


def neighbors(basis: Basis, at: Floats) -> tuple[NDArray[np.intp], Floats, Floats]:
    """The lines on both sides of parameters (m,), their shares by nearness, and u - x_i.

    Each (m, 2). Outside the nodes of an open basis the share of the line next to it is one.
    """
    nodes = basis.nodes
    if basis.closed:
        at = at % 1.0
        at = np.where(at < nodes[0], at + 1.0, at)
        after = np.searchsorted(nodes, at, side="right")
        gap = np.append(nodes, nodes[0] + 1.0)
    else:
        after = np.clip(np.searchsorted(nodes, at, side="right"), 1, len(nodes) - 1)
        gap = nodes
    rows = np.stack([after - 1, after], axis=1)
    share = np.clip((at - gap[rows[:, 0]]) / (gap[rows[:, 1]] - gap[rows[:, 0]]), 0.0, 1.0)
    return rows % len(nodes), np.stack([1.0 - share, share], axis=1), at[:, None] - gap[rows]


@singledispatch
def larger_basis(basis: Basis, u: float) -> tuple[Basis, int]:
    """A basis for one more line about the parameter u, and the number of the new line."""
    made = type(basis).of_size(basis.size + 1)
    return made, _inner_number(made.nodes, u)


@larger_basis.register
def _(basis: BSpline, u: float) -> tuple[Basis, int]:
    size, order = basis.size + 1, basis.order
    if basis.closed:
        # Just below 0, or below 1, the product may round up to the size itself.
        span = min(int(np.floor(u % 1.0 * basis.size)), basis.size - 1)
        return replace(basis, size=size), span + 1
    old = basis.knot_vector
    span = int(np.clip(np.searchsorted(old, u, side="right"), order, basis.size))
    knots = np.insert(old, span, _between(u, old[span - 1], old[span]))
    is_even = np.array_equal(knots, uniform_knots(size, order))
    made = BSpline(size, order, knots=None if is_even else tuple(knots.tolist()))
    return made, _inner_number(made.nodes, u)


@larger_basis.register
def _(basis: RationalGaussian, u: float) -> tuple[Basis, int]:
    x, n = basis.nodes, basis.size
    if basis.closed:
        u %= 1.0
        gaps = np.concatenate([[x[-1] - 1.0], x, [x[0] + 1.0]])
    else:
        gaps = np.unique(np.concatenate([[0.0], x, [1.0]]))
    after = int(np.clip(np.searchsorted(gaps, u, side="right"), 1, len(gaps) - 1))
    node = _between(u, gaps[after - 1], gaps[after])
    if basis.closed:
        node %= 1.0
    index = int(np.searchsorted(x, node))
    sigma = basis.sigma
    if isinstance(sigma, tuple):
        here = (sigma[index - 1] if index or basis.closed else sigma[0], sigma[min(index, n - 1)])
        sigma = (*sigma[:index], (here[0] + here[1]) / 2.0, *sigma[index:])
    nodes = np.insert(x, index, node)
    return RationalGaussian(n + 1, sigma, basis.closed, tuple(nodes.tolist())), index


@singledispatch
def exact_shares(basis: Basis, larger: Basis) -> Banded | None:
    """(n', n) the a_ji of the module; None where the larger basis lacks some of the curves."""
    return None


@exact_shares.register
def _(basis: Bernstein, larger: Basis) -> Banded | None:
    if not isinstance(larger, Bernstein) or larger.size != basis.size + 1:
        return None
    n = basis.size
    j = np.arange(n + 1)
    columns = np.clip(np.stack([j - 1, j], axis=1), 0, n - 1)
    return Banded(columns, np.stack([j / n, 1.0 - j / n], axis=1), n)


@exact_shares.register
def _(basis: BSpline, larger: Basis) -> Banded | None:
    if basis.closed or not isinstance(larger, BSpline) or larger.order != basis.order:
        return None
    k, old, new = basis.order, basis.knot_vector, larger.knot_vector
    arguments = np.lib.stride_tricks.sliding_window_view(new[1:-1], k - 1)
    span = np.searchsorted(old, new[: larger.size], side="right") - 1
    columns = span[:, None] + np.arange(1 - k, 1)
    return Banded(columns, weights_of_span(arguments.T, old, span), basis.size)


def shift_of(old: Basis, larger: Basis, index: int, u: float) -> float:
    """By how much later than before a curve begins when it gets line `index` for the place u.

    Where old lines keep their nodes the new one stands at u. On a closed curve with even nodes
    all lines move along it; begun at another point it has a node at u too.
    """
    moved = old.closed and not np.isin(old.nodes, larger.nodes).all()
    return u - float(larger.nodes[index]) if moved else 0.0


def _between(u: float, low: float, high: float) -> float:
    """u, brought between both ends of a gap and not too near to either."""
    margin = MARGIN * (high - low)
    return float(min(max(u, low + margin), high - margin))


def _inner_number(nodes: Floats, u: float) -> int:
    """The line, neither the first nor the last, whose node is nearest to u."""
    return int(np.abs(nodes[1:-1] - u).argmin()) + 1


def refined(
    curve: PlusCurve, basis: Basis, shares: Banded, distances: Floats | None = None
) -> PlusCurve:
    """The same curve in a larger basis, by the a_ji of the module.

    `distances`, shaped as the entries of `shares`, are those of the new nodes from the nodes of
    the old lines; to be given where images of a closed curve take part.
    """
    old, directions = curve.lines, curve.directions
    if distances is None:
        distances = basis.nodes[:, None] - curve.basis.nodes[shares.columns]
    weights = None
    if old.weights is not None:
        largest = old.weights.max()
        parts = shares.entries * old.unit_weights[shares.columns]
        weights = parts.sum(axis=1)
        shares = replace(shares, entries=parts / weights[:, None])
        weights *= largest
    pulls = replace(shares, entries=shares.entries * distances)
    points = shares @ old.points + pulls @ (curve.s * directions)
    turned = shares @ directions
    # Lines that are only renumbered stay to the last bit.
    new, entry = np.nonzero(shares.entries == 1.0)
    same = shares.columns[new, entry]
    points[new], turned[new] = old.points[same], directions[same]
    if weights is not None and old.weights is not None:
        weights[new] = old.weights[same]
    was_automatic = np.zeros(len(points), dtype=bool)
    was_automatic[new] = old.automatic[same]
    lines = _lines(basis.closed, points, turned, was_automatic, weights)
    return PlusCurve(basis, lines, curve.s)


def _fitted(curve: PlusCurve, basis: Basis, index: int, shift: float) -> PlusCurve:
    """The curve of lines for the basis that comes closest to C(u + shift).

    Least squares for what is added to the points and the directions of a guess. Lines without
    part in what the guess lacks stay to the last bit.
    """
    guess = lines_between(curve, basis.nodes + shift)
    near = PlusCurve(basis, guess.with_directions(guess.directions(closed=curve.closed)), curve.s)
    u = samples_about(basis, index)
    values, reaches = _rational(near, u)
    missing = curve.at(u + shift) - near.at(u)
    free = involved(values, missing, float(np.ptp(curve.lines.points)))
    # A direction counts as what it moves the curve by; without s it moves nothing and stays.
    pull = near.spacing * max(abs(near.s), float(np.ptp(curve.lines.points))) or 1.0
    columns = np.concatenate([values[:, free], near.s / pull * reaches[:, free]], axis=1)
    change_of_points, change_of_directions = np.split(
        reluctantly_solved(columns, missing, basis.size), 2
    )
    points, directions = near.lines.points.copy(), near.directions.copy()
    points[free] += change_of_points
    directions[free] += change_of_directions / pull
    return PlusCurve(
        basis, _lines(curve.closed, points, directions, guess.automatic, guess.weights), near.s
    )


def reluctantly_solved(columns: Floats, missing: Floats, size: int) -> Floats:
    """(f, dim) what brings `columns` (m, f) near `missing` (m, dim), itself kept small.

    `size` is the number of lines that the m samples are spread over.
    """
    normal = columns.T @ columns
    normal += np.eye(len(normal)) * (RELUCTANCE**2 * len(columns) / size)
    return np.asarray(np.linalg.solve(normal, columns.T @ missing))


def samples_about(basis: Basis, index: int) -> Floats:
    """Parameters all over a curve of that basis, of a long one about the line `index`."""
    size, closed, nodes = basis.size, basis.closed, basis.nodes
    reach = min(0.5 if closed else 1.0, REACH / size)
    count = SAMPLES * min(size, REACH)
    about = np.linspace(-reach, reach, 2 * count + 1)
    away = nodes - nodes[index]
    if closed:
        away -= np.round(away)
    u: Floats = nodes[index] + np.union1d(about, away[np.abs(away) <= reach])
    return u if closed else u[(u >= 0.0) & (u <= 1.0)]


def _rational(curve: PlusCurve, u: Floats) -> tuple[Floats, Floats]:
    """(m, n) each: what the points, and the gradients, are multiplied by at u."""
    matrices = blend_at(curve.basis, u)
    values, reaches = dense(matrices.values), dense(matrices.reaches)
    if curve.lines.weights is None:
        return values, reaches
    weights = curve.lines.unit_weights
    share: Floats = weights / (values @ weights)[:, None]
    return values * share, reaches * share


def involved(values: Floats, missing: Floats, extent: float) -> NDArray[np.intp]:
    """The lines with a part in the curve where anything is missing."""
    is_off = np.abs(missing).max(axis=1) > NOTHING * extent
    return np.flatnonzero((values[is_off] > PART).any(axis=0))


def _lines(
    closed: bool,
    points: Floats,
    directions: Floats,
    was_automatic: NDArray[np.bool_],
    weights: Floats | None,
) -> ControlLines:
    """Lines with those directions, automatic where they were and would be the same."""
    automatic = automatic_directions(points, closed=closed)
    kept = was_automatic & (automatic == directions).all(axis=1)
    return ControlLines(points, directions, kept, weights)
