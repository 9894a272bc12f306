"""Curves as chains of Bezier curves of degree 3 at most, which is all that SVG can draw.

What is of such a degree comes out exactly. Anything else is replaced, on intervals halved until
it fits, by cubics that have its points and tangents at both ends; kinks of the curve are ends of
intervals, so that they stay and nothing else becomes one. How far a cubic follows its tangents,

    Q(t) = P0 (b0 + b1)(t) + P3 (b2 + b3)(t) + alpha b1(t) T0 + beta b2(t) T3,

is fitted by least squares: then the distance falls with the sixth power of the interval, with the
velocities themselves, alpha = beta = 1, only with the fourth.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bernstein import bernstein
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevated
from plusedit.geometry.pieces import pieces as smooth_pieces

TOLERANCE = 1e-7  # of the size of a curve: by what a cubic may miss it
MARGIN = 0.5  # of the tolerance: errors are looked at in a few places only
LOOKED_AT: Floats = np.linspace(0.0, 1.0, 9)[1:-1]
EXACT = 1e-13  # of the largest coordinate: what rounding alone may do
ROUNDS = 3  # of fitting, each with parameters taken from the one before
STRETCH = 1.0  # the logarithm of the factor by which one round may change a tangent
LONGEST_STEP = 0.05  # of a parameter, in looking for a nearest point
DEEPEST = 16  # halvings
MOST = 20_000  # cubics of one curve

HIGHEST_REDUCED = 8  # degrees above are not tried for being lower ones in truth


def chain_of(curve: PlusCurve) -> list[Floats]:
    """The curve, seen from above, as Bezier points (2 to 4, 2); each begins where one ends."""
    try:
        form = elevated(curve).bezier_pieces()
    except ValueError:  # rational Gaussians have no standard form
        seeds = smooth_pieces(curve).parameters
        stretches = Stretches(np.zeros(len(seeds) - 1, dtype=np.intp), seeds[:-1], seeds[1:])
        return list(_cubics(_Seen(curve), stretches, _size(curve) * TOLERANCE))
    points = form.points[:, :, :2]
    if form.weights is None or np.ptp(form.weights) <= EXACT * form.weights.max():
        least = [reduced(piece) for piece in points]
        if all(len(piece) <= 4 for piece in least):
            return least
    seeds = np.union1d(smooth_pieces(curve).parameters, form.breaks)
    number = np.searchsorted(form.breaks, seeds[:-1], side="right") - 1
    start, span = form.breaks[number], np.diff(form.breaks)[number]
    stretches = Stretches(number, (seeds[:-1] - start) / span, (seeds[1:] - start) / span)
    return list(_cubics(_Beziers(points, form.weights), stretches, _size(curve) * TOLERANCE))


def conic_chain(points: Floats, weights: Floats, tolerance: float) -> list[Floats]:
    """An arc of a conic, (3, 2) with weights (3,), as cubics (4, 2)."""
    whole = Stretches(np.zeros(1, dtype=np.intp), np.zeros(1), np.ones(1))
    return list(_cubics(_Beziers(points[None], weights[None]), whole, tolerance))


def reduced(points: Floats) -> Floats:
    """The same Bezier curve with as few points as it needs, but two at least."""
    limit = EXACT * max(float(np.abs(points).max()), 1e-300)
    while 2 < len(points) <= HIGHEST_REDUCED + 1:
        degree = len(points) - 1
        lower = points[:1]
        for i in range(1, degree):
            following = (degree * points[i] - i * lower[-1]) / (degree - i)
            lower = np.concatenate([lower, following[None]])
        lower[-1] = points[-1]
        share = np.arange(1, degree)[:, None] / degree
        again = share * lower[:-1] + (1.0 - share) * lower[1:]
        if np.abs(again - points[1:-1]).max() > limit:
            break
        points = lower
    return points


def _size(curve: PlusCurve) -> float:
    """The larger side of the box about the curve."""
    at = curve.at(np.linspace(0.0, 1.0, 65))[:, :2]
    return float(np.ptp(at, axis=0).max())


@dataclass(frozen=True, eq=False)
class Stretches:
    """Intervals of a curve that is made of numbered pieces, each with parameters of its own."""

    numbers: NDArray[np.intp]
    starts: Floats
    ends: Floats

    def __len__(self) -> int:
        return len(self.numbers)

    def taken(self, rows: NDArray[np.bool_]) -> "Stretches":
        """Those of them."""
        return Stretches(self.numbers[rows], self.starts[rows], self.ends[rows])

    def halved(self) -> "Stretches":
        """Both halves of each."""
        middles = (self.starts + self.ends) / 2.0
        return Stretches(
            np.tile(self.numbers, 2),
            np.concatenate([self.starts, middles]),
            np.concatenate([middles, self.ends]),
        )


class Smooth(Protocol):
    """A curve of smooth pieces, to be copied."""

    def points(self, numbers: NDArray[np.intp], u: Floats) -> Floats:
        """(m, 2) points of the pieces of those numbers at u (m,)."""
        ...

    def velocities(self, numbers: NDArray[np.intp], u: Floats) -> Floats:
        """(m, 2) their derivatives by u."""
        ...


@dataclass(frozen=True, eq=False)
class _Seen:
    """A curve that is smooth from 0 to 1, from above."""

    curve: PlusCurve

    def points(self, numbers: NDArray[np.intp], u: Floats) -> Floats:
        return self.curve.at(u)[:, :2]

    def velocities(self, numbers: NDArray[np.intp], u: Floats) -> Floats:
        return self.curve.derivatives(u, highest=1)[1][:, :2]


class _Beziers:
    """Bezier curves of one degree by their formula; rational ones by the quotient rule."""

    def __init__(self, points: Floats, weights: Floats | None) -> None:
        share = np.ones(points.shape[:2]) if weights is None else weights / weights.max()
        self._rows = np.concatenate([points * share[..., None], share[..., None]], axis=2)
        self._degree = points.shape[1] - 1
        self._slopes = self._degree * np.diff(self._rows, axis=1)

    def points(self, numbers: NDArray[np.intp], u: Floats) -> Floats:
        top = _at(self._rows[numbers], bernstein(u, self._degree))
        on: Floats = top[:, :2] / top[:, 2:]
        return on

    def velocities(self, numbers: NDArray[np.intp], u: Floats) -> Floats:
        top = _at(self._rows[numbers], bernstein(u, self._degree))
        rate = _at(self._slopes[numbers], bernstein(u, self._degree - 1))
        on = top[:, :2] / top[:, 2:]
        velocities: Floats = (rate[:, :2] - rate[:, 2:] * on) / top[:, 2:]
        return velocities


def _at(rows: Floats, shares: Floats) -> Floats:
    """(m, dim) sums of rows (m, n, dim) with shares (m, n)."""
    sums: Floats = (shares[:, None, :] @ rows)[:, 0]
    return sums


def _cubics(curve: Smooth, stretches: Stretches, tolerance: float) -> Floats:
    """(m, 4, 2) cubics that follow all stretches of the curve within the tolerance."""
    order, done = [], []
    count = 0
    for halvings in range(DEEPEST + 1):
        cubics, misses = _fitting(curve, stretches)
        fits = misses <= MARGIN * tolerance
        if halvings == DEEPEST or count + 2 * len(stretches) > MOST:
            fits[:] = True
        order.append(stretches.numbers[fits] + stretches.starts[fits])
        done.append(cubics[fits])
        count += int(fits.sum())
        if fits.all():
            break
        stretches = stretches.taken(~fits).halved()
    in_order: Floats = np.concatenate(done)[np.argsort(np.concatenate(order), kind="stable")]
    return in_order


def _fitting(curve: Smooth, stretches: Stretches) -> tuple[Floats, Floats]:
    """(m, 4, 2) cubics for stretches of the curve, and (m,) by how much each misses."""
    numbers, starts, ends = stretches.numbers, stretches.starts, stretches.ends
    u = np.concatenate([[starts], starts + LOOKED_AT[:, None] * (ends - starts), [ends]])
    on = curve.points(np.tile(numbers, len(u)), u.ravel()).reshape(len(u), -1, 2)
    there, first, last = on[1:-1].transpose(1, 0, 2), on[0], on[-1]
    both = curve.velocities(np.tile(numbers, 2), u[[0, -1]].ravel()).reshape(2, -1, 2)
    third = ((ends - starts) / 3.0)[:, None] * both
    plain = np.stack([first, first + third[0], last - third[1], last], axis=1)
    t = np.broadcast_to(LOOKED_AT, there.shape[:2])
    better = plain
    for _ in range(ROUNDS):
        t = _nearer(better, there, t)
        better = _stretched(better, there, t)
    misses = np.stack([_miss(cubics, there, t) for cubics in (plain, better)])
    is_better = misses[1] < misses[0]
    return np.where(is_better[:, None, None], better, plain), misses.min(axis=0)


def _stretched(cubics: Floats, there: Floats, t: Floats) -> Floats:
    """The cubics with tangents longer or shorter, so that they come near `there` (m, T, 2).

    Only what is across the cubic at t (m, T) counts: along it, t would follow.
    """
    b = _weights_at(t)
    across = _velocities_at(cubics, t)[..., ::-1] * (-1.0, 1.0)
    leaving, arriving = cubics[:, 1] - cubics[:, 0], cubics[:, 2] - cubics[:, 3]
    left = b[1] * (across * leaving[:, None]).sum(axis=2)
    right = b[2] * (across * arriving[:, None]).sum(axis=2)
    rest = (across * (there - _points_at(cubics, t))).sum(axis=2)
    ll, lr, rr = (left * left).sum(axis=1), (left * right).sum(axis=1), (right * right).sum(axis=1)
    l_rest, r_rest = (left * rest).sum(axis=1), (right * rest).sum(axis=1)
    determinant = ll * rr - lr * lr
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        alpha = 1.0 + (l_rest * rr - r_rest * lr) / determinant
        beta = 1.0 + (r_rest * ll - l_rest * lr) / determinant
        sound = (np.abs(np.log(alpha)) < STRETCH) & (np.abs(np.log(beta)) < STRETCH)
    stretched = cubics.copy()
    stretched[:, 1] = cubics[:, 0] + np.where(sound, alpha, 1.0)[:, None] * leaving
    stretched[:, 2] = cubics[:, 3] + np.where(sound, beta, 1.0)[:, None] * arriving
    return stretched


def _nearer(cubics: Floats, there: Floats, t: Floats) -> Floats:
    """The parameters t (m, T) moved towards those of the points nearest to `there` (m, T, 2)."""
    velocity = _velocities_at(cubics, t)
    speed = (velocity * velocity).sum(axis=2)
    ahead = ((there - _points_at(cubics, t)) * velocity).sum(axis=2)
    step = np.divide(ahead, speed, out=np.zeros_like(t), where=speed > 0.0)
    moved: Floats = np.clip(t + np.clip(step, -LONGEST_STEP, LONGEST_STEP), 0.0, 1.0)
    return moved


def _miss(cubics: Floats, there: Floats, t: Floats) -> Floats:
    """(m,) the largest distance of `there` (m, T, 2) from the cubic, sought about t."""
    for _ in range(2):
        t = _nearer(cubics, there, t)
    distances: Floats = np.linalg.norm(_points_at(cubics, t) - there, axis=2).max(axis=1)
    return distances


def _points_at(cubics: Floats, t: Floats) -> Floats:
    on: Floats = np.einsum("kmt,mkd->mtd", _weights_at(t), cubics)
    return on


def _velocities_at(cubics: Floats, t: Floats) -> Floats:
    one = 1.0 - t
    b = np.stack([one * one, 2.0 * one * t, t * t])
    velocities: Floats = np.einsum("kmt,mkd->mtd", b, 3.0 * np.diff(cubics, axis=1))
    return velocities


def _weights_at(t: Floats) -> Floats:
    """(4, *t.shape) Bernstein polynomials of degree 3."""
    one = 1.0 - t
    return np.stack([one**3, 3.0 * one * one * t, 3.0 * one * t * t, t**3])
