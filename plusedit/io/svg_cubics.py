"""Curves as chains of Bezier curves of degree 3 at most, which is all that SVG can draw.

What is of such a degree comes out exactly. Anything else is replaced, on intervals halved until
it fits, by cubics that have its points and tangents at both ends; kinks of the curve are ends of
intervals, so that they stay and nothing else becomes one. How far a cubic follows its tangents,

    Q(t) = P0 (b0 + b1)(t) + P3 (b2 + b3)(t) + alpha b1(t) T0 + beta b2(t) T3,

is fitted by least squares: then the distance falls with the sixth power of the interval, with the
velocities themselves, alpha = beta = 1, only with the fourth.
"""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bernstein import bernstein
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevated
from plusedit.geometry.pieces import pieces as smooth_pieces

Smooth: TypeAlias = Callable[[Floats], tuple[Floats, Floats]]
"""Points and velocities (m, 2) at parameters (m,)"""

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
        return list(_cubics(_seen(curve), seeds, _size(curve) * TOLERANCE))
    points = form.points[:, :, :2]
    if points.shape[1] <= 4 and form.weights is None:
        return [reduced(piece) for piece in points]
    tolerance, seeds = _size(curve) * TOLERANCE, smooth_pieces(curve).parameters
    chain: list[Floats] = []
    for number, piece in enumerate(points):
        weights = None if form.weights is None else form.weights[number]
        start, end = form.breaks[number : number + 2]
        inner = seeds[(seeds > start) & (seeds < end)]
        at = np.concatenate([[0.0], (inner - start) / (end - start), [1.0]])
        chain += bezier_chain(piece, weights, tolerance, at)
    return chain


def bezier_chain(
    points: Floats, weights: Floats | None, tolerance: float, seeds: Floats | None = None
) -> list[Floats]:
    """A Bezier curve (n, 2), rational with weights (n,), as Bezier points (2 to 4, 2).

    `seeds` are parameters from 0 to 1, both among them, between which it changes evenly.
    """
    if weights is None or np.ptp(weights) <= EXACT * weights.max():
        points = reduced(points)
        if len(points) <= 4:
            return [points]
        weights = None
    at = np.array([0.0, 1.0]) if seeds is None else seeds
    return list(_cubics(_bezier(points, weights), at, tolerance))


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


def _seen(curve: PlusCurve) -> Smooth:
    def at(u: Floats) -> tuple[Floats, Floats]:
        points, velocities = curve.derivatives(u, highest=1)
        return points[:, :2], velocities[:, :2]

    return at


def _bezier(points: Floats, weights: Floats | None) -> Smooth:
    """A Bezier curve by its formula; a rational one by the quotient rule."""
    share = np.ones(len(points)) if weights is None else weights / weights.max()
    rows = np.column_stack([points * share[:, None], share])
    degree = len(points) - 1
    slopes = degree * np.diff(rows, axis=0)

    def at(u: Floats) -> tuple[Floats, Floats]:
        top, rate = bernstein(u, degree) @ rows, bernstein(u, degree - 1) @ slopes
        on = top[:, :2] / top[:, 2:]
        return on, (rate[:, :2] - rate[:, 2:] * on) / top[:, 2:]

    return at


def _cubics(curve: Smooth, seeds: Floats, tolerance: float) -> Floats:
    """(m, 4, 2) cubics that follow the curve from 0 to 1 within the tolerance."""
    starts, ends = seeds[:-1], seeds[1:]
    done_at, done = [], []
    count = 0
    for halvings in range(DEEPEST + 1):
        cubics, misses = _fitting(curve, starts, ends)
        fits = misses <= MARGIN * tolerance
        if halvings == DEEPEST or count + 2 * len(starts) > MOST:
            fits[:] = True
        done_at.append(starts[fits])
        done.append(cubics[fits])
        count += int(fits.sum())
        starts, ends = starts[~fits], ends[~fits]
        if not len(starts):
            break
        middles = (starts + ends) / 2.0
        starts, ends = np.concatenate([starts, middles]), np.concatenate([middles, ends])
    order = np.argsort(np.concatenate(done_at))
    in_order: Floats = np.concatenate(done)[order]
    return in_order


def _fitting(curve: Smooth, starts: Floats, ends: Floats) -> tuple[Floats, Floats]:
    """(m, 4, 2) cubics for stretches of the curve, and (m,) by how much each misses."""
    third = ((ends - starts) / 3.0)[:, None]
    first, leaving = curve(starts)
    last, arriving = curve(ends)
    plain = np.stack([first, first + third * leaving, last - third * arriving, last], axis=1)
    u = starts[:, None] + (ends - starts)[:, None] * LOOKED_AT
    there = curve(u.ravel())[0].reshape(len(starts), len(LOOKED_AT), 2)
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
