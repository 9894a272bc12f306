"""Standard curves as plus curves: Bezier curves, chains of them, conics and arcs, all exactly.

A Bezier curve of degree n is a Bezier+ curve of n lines. Its formula, read backwards,

    g_{j-1} - g_j = (Q_j - (1 - a) P_j - a P_{j-1}) / b,   a = j / n,  b = j (n - j) / (n (n - 1)),

leaves the inner P free and one vector that may be added to all g. Here the P lie on the curve at
their nodes, and the g of the ends come as near to half the velocity as they can: then a quadratic
or cubic has lines that are tangent to it at both ends, and s = L / 2 gives directions of about
unit length.
"""

from collections.abc import Iterable
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.bases.bernstein import Bernstein, bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines

LONGEST = 1e3  # of a direction for which half the length of the polygon still serves as s
SHORTEST = 1e-3  # span of a path, of the mean one: pieces shorter than that get this much
QUARTER = np.pi / 2  # the largest angle of one rational quadratic piece


def from_bezier(points: ArrayLike, weights: ArrayLike | None = None) -> PlusCurve:
    """The Bezier curve of degree n with the points (n + 1, dim) as a Bezier+ curve of n lines.

    A straight line, n = 1, has two lines. A rational curve keeps its n + 1 points and weights
    instead, with zero directions: it is the same for every s. Raises ValueError on a single point.
    """
    q = frozen(points, shape=(None, None), name="points")
    if len(q) < 2:
        raise ValueError(f"points: a Bezier curve needs at least 2, got {len(q)}")
    if weights is not None:
        still = list(np.zeros_like(q))
        return PlusCurve(Bernstein(len(q)), ControlLines.of(q, still, weights), s=1.0)
    if len(q) == 2:
        q = np.array([q[0], (q[0] + q[1]) / 2.0, q[1]])
    n = len(q) - 1
    # Seen from the first point: far from the origin the differences below would be rounding.
    ends, q = q[[0, -1]], q - q[0]
    on_curve = bernstein(np.linspace(0.0, 1.0, n), n) @ q
    on_curve[0], on_curve[-1] = q[0], q[-1]
    j = np.arange(1, n)[:, None]
    a, b = j / n, j * (n - j) / (n * (n - 1.0))
    falls = (q[1:-1] - (1.0 - a) * on_curve[1:] - a * on_curve[:-1]) / b
    gradients = -np.cumsum(np.concatenate([np.zeros_like(q[:1]), falls]), axis=0)
    wanted = n / 2.0 * (q[1] - q[0] + q[-1] - q[-2])
    gradients += (wanted - gradients[0] - gradients[-1]) / 2.0
    through = np.concatenate([ends[:1], ends[0] + on_curve[1:-1], ends[1:]])
    return _curve(Bernstein(n), through, gradients)


def from_bezier_path(pieces: ArrayLike, breaks: ArrayLike | None = None) -> PlusCurve:
    """A chain of cubics (p, 4, dim) as one B-spline+ curve of order 3, its inner knots double.

    Piece i runs from parameter `breaks`[i] to `breaks`[i + 1], from 0 to 1; by default each takes
    a share of its length. Where neighbours touch with one velocity, the line of the joint is the
    tangent; at corners it is the mean of both, and the curve has its corner all the same.
    Raises ValueError where a piece does not begin at the end of the piece before.
    """
    q = frozen(pieces, shape=(None, 4, None), name="pieces")
    _check_chain(q)
    at = _breaks(q, breaks)
    span = np.diff(at)[:, None]
    starts, ends = 1.5 * (q[:, 1] - q[:, 0]) / span, 1.5 * (q[:, 3] - q[:, 2]) / span
    joints = np.concatenate([starts[:1], (starts[1:] + ends[:-1]) / 2.0, ends[-1:]])
    # On a span of length h the gradients count h times; there P and g of the middle line follow
    # from the formula of Bezier+ with three lines. Seen from the first point of each piece.
    before, after = joints[:-1], joints[1:]
    first, second, last = (q[:, r] - q[:, 0] for r in (1, 2, 3))
    middle = (3.0 * (first + second) - last - span * (before - after)) / 4.0
    inner = before + (2.0 * middle - 3.0 * first) / span
    middle += q[:, 0]
    points = _alternating(np.concatenate([q[:, 0], q[-1:, 3]]), middle)
    return _curve(_path_basis(at), points, _alternating(joints, inner))


def from_rational_quadratic(points: ArrayLike, weights: ArrayLike) -> PlusCurve:
    """The conic section with three points (3, dim) and weights (3,); the same for every s."""
    q = frozen(points, shape=(3, None), name="points")
    return from_bezier(q, weights)


def from_rational_quadratic_path(
    points: ArrayLike, weights: ArrayLike, breaks: ArrayLike | None = None
) -> PlusCurve:
    """A chain of conic sections (p, 3, dim), weights (p, 3), as one NURBS+ curve of order 3.

    Its inner knots are double and its directions zero: it is the same for every s. `breaks` as in
    `from_bezier_path`. The weights of a piece are scaled so that they go on from the piece before.
    """
    q = frozen(points, shape=(None, 3, None), name="points")
    w = frozen(weights, shape=q.shape[:2], name="weights").copy()
    _check_chain(q)
    for before, after in pairwise(w):
        after *= before[2] / after[0]
    at = _breaks(q, breaks)
    rows = _alternating(np.concatenate([q[:, 0], q[-1:, 2]]), q[:, 1])
    heights = _alternating(np.append(w[:, 0], w[-1, 2]), w[:, 1])
    lines = ControlLines.of(rows, list(np.zeros_like(rows)), heights)
    return PlusCurve(_path_basis(at), lines, s=1.0)


def elliptic_arc(
    center: ArrayLike,
    first: ArrayLike,
    second: ArrayLike,
    *,
    start: float = 0.0,
    sweep: float = 2.0 * np.pi,
) -> PlusCurve:
    """center + cos(t) first + sin(t) second for t from `start` over `sweep` radians, exactly.

    With `first` and `second` at right angles and of one length it is a circle. One NURBS+ curve of
    order 3, for each quarter two lines. Raises ValueError on a sweep of zero or beyond one turn.
    """
    if not 0.0 < abs(sweep) <= 2.0 * np.pi * (1.0 + 1e-12):
        raise ValueError(f"sweep: must be more than 0 and up to one turn, got {sweep}")
    axes = np.array([first, second], dtype=np.float64)
    count = int(np.ceil(abs(sweep) / QUARTER - 1e-9))
    half = sweep / count / 2.0
    joints = np.linspace(start, start + sweep, count + 1)
    on = _directions(joints) @ axes + np.asarray(center, dtype=np.float64)
    if abs(abs(sweep) - 2.0 * np.pi) < 1e-12:
        on[-1] = on[0]
    between = _directions(joints[:-1] + half) / np.cos(half) @ axes + np.asarray(center)
    pieces = np.stack([on[:-1], between, on[1:]], axis=1)
    weights = np.broadcast_to([1.0, np.cos(half), 1.0], (count, 3))
    return from_rational_quadratic_path(pieces, weights, np.arange(count + 1) / count)


def _directions(angles: Floats) -> Floats:
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _curve(basis: Bernstein | BSpline, points: Floats, gradients: Floats) -> PlusCurve:
    """The curve with those gradients and the s that makes its directions about unit vectors."""
    s = 0.5 * float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    # Points that almost coincide would need directions without measure.
    if s * LONGEST <= np.abs(gradients).max():
        s = 1.0
    return PlusCurve(basis, ControlLines.of(points, list(gradients / s)), s)


def _check_chain(pieces: Floats) -> None:
    if not len(pieces):
        raise ValueError("pieces: a path needs at least one")
    gaps = np.abs(pieces[1:, 0] - pieces[:-1, -1]).max(axis=1, initial=0.0)
    size = np.ptp(pieces.reshape(-1, pieces.shape[2]), axis=0).max()
    if (gaps > 1e-9 * size).any():
        after = int(np.argmax(gaps))
        raise ValueError(f"pieces: piece {after + 1} does not begin where piece {after} ends")


def _breaks(pieces: Floats, given: ArrayLike | None) -> Floats:
    """(p + 1,) where pieces begin and end; by default shares of the lengths of their polygons."""
    count = len(pieces)
    if given is not None:
        at = frozen(given, shape=(count + 1,), name="breaks")
        if at[0] != 0.0 or at[-1] != 1.0 or (np.diff(at) <= 0.0).any():
            raise ValueError("breaks: must increase from 0 to 1")
        return at
    lengths = np.linalg.norm(np.diff(pieces, axis=1), axis=2).sum(axis=1)
    mean = lengths.mean() or 1.0
    ends = np.cumsum(np.maximum(lengths / mean, SHORTEST))
    return np.concatenate([[0.0], ends[:-1] / ends[-1], [1.0]])


def _path_basis(breaks: Floats) -> BSpline:
    inner: Iterable[float] = np.repeat(breaks[1:-1], 2).tolist()
    knots = (0.0, 0.0, 0.0, *inner, 1.0, 1.0, 1.0)
    return BSpline(len(knots) - 3, 3, knots=knots)


def _alternating(outer: Floats, inner: Floats) -> Floats:
    """outer[0], inner[0], outer[1], ..., outer[-1]"""
    rows = np.empty((len(outer) + len(inner), *outer.shape[1:]))
    rows[::2], rows[1::2] = outer, inner
    return rows
